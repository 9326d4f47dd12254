/* The pieces of the page a talk is made of, built from the <template>s of chat.html. Text is only ever set as text. */

import { withoutName } from "./sentences.js";

/** What was said in one reply, in the order it is said. */
export function spoken(reply) {
  return [reply.first_sentence, reply.plan_sentence, reply.dialogue_sentence]
    .filter((part) => typeof part === "string" && part.trim())
    .map(withoutName);
}

/** A sentence of the person. */
export function yours(text, { say, tag }) {
  const article = copy("yours");
  article.querySelector(".who").textContent = say("you");
  set(article.querySelector(".bubble"), text, tag);
  return article;
}

/** A reply: plan sentence, plan, dialogue sentence, and the folded "Why this reply?" where `explain` is given. */
export function reply(entry, { say, tag, explain, hear }) {
  const article = copy("reply");
  const part = (selector) => article.querySelector(selector);
  const plan = plainText(entry.plan_sentence);
  const dialogue = plainText(entry.first_sentence) || plainText(entry.dialogue_sentence);
  part(".who").textContent = say("robot");
  orRemove(part(".plan-sentence"), plan, tag);
  orRemove(part(".dialogue-sentence"), dialogue || (plan ? "" : say("silent")), tag);
  fillPlan(part(".plan"), entry.plan_actions, say);
  fillHear(part(".hear"), say, hear);
  fillWhy(part(".why"), say, explain);
  return article;
}

/** A kind word about what went wrong, with one button that helps. */
export function trouble(error, { say, kept, onretry }) {
  const box = copy("trouble");
  const part = (selector) => box.querySelector(selector);
  part(".kind-words").textContent = say(`trouble_${error.kind}`) || say("trouble_server");
  part(".kept").textContent = kept ? say("kept") : "";
  const button = part(".retry");
  button.textContent = say(error.kind === "thread" ? "fresh" : "retry");
  button.addEventListener("click", onretry);
  part("summary span").textContent = say("technical");
  part(".told").textContent = [error.code || error.kind, error.message, error.hint].filter(Boolean).join(" · ");
  return box;
}

/** A round choice, e.g. a language: a radio button that looks like a large pill. */
export function pill({ group, value, text, lang, checked }) {
  const label = element("label", "pill");
  const input = Object.assign(element("input"), { type: "radio", name: group, value, checked, required: true });
  const span = element("span", "", text);
  if (lang) span.lang = lang;
  label.append(input, span);
  return label;
}

function fillPlan(box, actions, say) {
  const known = (Array.isArray(actions) ? actions : []).filter((item) => item && item.action);
  if (!known.length) return box.remove();
  box.querySelector(".plan-title span").textContent = say("plan_title");
  box.querySelector("ol").replaceChildren(...known.map((item) => actionItem(item, say)));
}

function actionItem({ action, parameters }, say) {
  const item = element("li");
  item.append(element("code", "action", action));
  const rows = Object.entries(parameters ?? {});
  if (rows.length) {
    const list = element("dl");
    rows.forEach(([key, value]) => list.append(element("dt", "", key), parameterValue(value, say)));
    item.append(list);
  }
  return item;
}

function parameterValue(value, say) {
  const missing = value === null || value === undefined || value === "" || value === "None";
  return element("dd", missing ? "missing" : "", missing ? say("not_given") : String(value));
}

function fillHear(button, say, hear) {
  button.querySelector("span").textContent = say("hear");
  button.hidden = !hear;
  if (hear) button.addEventListener("click", hear);
}

function fillWhy(details, say, explain) {
  if (!explain) return details.remove();
  details.querySelector("summary span").textContent = say("why");
  const notes = details.querySelector(".notes");
  const load = async () => {
    notes.replaceChildren(element("p", "note", say("why_loading")));
    try {
      notes.replaceChildren(...explanation(await explain(), say));
    } catch {
      notes.replaceChildren(element("p", "note", say("why_failed")), retryButton(say, load));
    }
    details.scrollIntoView({ block: "nearest" });
  };
  const first = () => {
    details.removeEventListener("toggle", first);
    load();
  };
  details.addEventListener("toggle", first);
}

function retryButton(say, load) {
  const button = element("button", "plain", say("retry"));
  button.type = "button";
  button.addEventListener("click", load);
  return button;
}

/** The answer of dialogue/explain/ as nodes; every key may be missing. */
function explanation({ answer, differs }, say) {
  const nodes = [];
  if (differs) nodes.push(element("p", "note", say("why_differs", { sentence: differs })));
  const facts = element("dl", "facts");
  fact(facts, say("why_topic"), nameOf(answer.topic));
  fact(facts, say("why_type"), say(`type_${answer.sentence_type}`) || answer.sentence_type);
  if (facts.children.length) nodes.push(facts);
  const steps = (Array.isArray(answer.steps) ? answer.steps : []).filter(Boolean);
  if (!steps.length) return [...nodes, element("p", "note", say("why_empty"))];
  const list = element("ol", "steps");
  list.append(...steps.map((step) => stepItem(step, say)));
  return [...nodes, list];
}

function fact(list, name, value) {
  if (value === undefined || value === null || value === "") return;
  list.append(element("dt", "", name), element("dd", "", String(value)));
}

function stepItem(step, say) {
  const item = element("li");
  // The steps quote the algorithm, so they are English in every talk.
  item.lang = "en";
  if (typeof step === "string") return Object.assign(item, { textContent: step });
  if (step.rule) item.append(element("code", "rule", step.rule), " ");
  if (step.text) item.append(element("span", "step-text", step.text));
  if (Array.isArray(step.candidates) && step.candidates.length) item.append(candidates(step.candidates, say));
  return item;
}

function candidates(rows, say) {
  const table = element("ul", "candidates");
  table.setAttribute("aria-label", say("candidates"));
  rows.filter(Boolean).forEach((row) => table.append(candidate(row, say)));
  return table;
}

function candidate(row, say) {
  const item = element("li");
  item.append(element("span", "topic", nameOf(row.topic) ?? ""));
  const likeliness = Number(row.likeliness);
  if (row.likeliness === undefined || row.likeliness === null || Number.isNaN(likeliness)) return item;
  const shown = likeliness.toFixed(2);
  const meter = Object.assign(element("meter"), { min: 0, max: 1, value: likeliness });
  meter.setAttribute("aria-label", say("likeliness", { value: shown }));
  const number = element("span", "number", shown);
  number.setAttribute("aria-hidden", "true");
  item.append(meter, number);
  return item;
}

const nameOf = (topic) => (topic && typeof topic === "object" ? topic.name : topic);

const plainText = (text) => (typeof text === "string" ? withoutName(text.trim()) : "");

function orRemove(node, text, tag) {
  if (text) set(node, text, tag);
  else node.remove();
}

function set(node, text, tag) {
  node.textContent = text;
  node.lang = tag;
}

export function element(name, className = "", text = "") {
  const node = document.createElement(name);
  if (className) node.className = className;
  node.textContent = text;
  return node;
}

function copy(name) {
  return document.getElementById(`${name}-template`).content.firstElementChild.cloneNode(true);
}

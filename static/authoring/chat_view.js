/* How a turn looks: the templates of the page, filled with what the server says. */

const copy = (id) => document.getElementById(id).content.cloneNode(true).firstElementChild;
const slot = (node, name) => node.querySelector(`[data-slot="${name}"]`);

/** One turn as a list item; `onelse` is called by "say something else here". */
export function turnNode(turn, { opening, language, silence, onelse }) {
  const node = copy("turn-template");
  for (const name of ["heard", "plan_sentence", "sentence"]) {
    slot(node, name).textContent = turn[name];
    slot(node, name).lang = language;
  }
  if (opening) node.querySelector(".chat-person").remove();
  else if (!turn.heard) slot(node, "heard").textContent = silence;
  if (opening) node.querySelector(".chat-else").parentElement.remove();
  else node.querySelector(".chat-else").addEventListener("click", onelse);
  if (!turn.sentence) slot(node, "sentence").textContent = silence;
  part(node, "plan_sentence", turn.plan_sentence);
  part(node, "actions", turn.actions.length)?.append(...turn.actions.map(actionNode));
  part(node, "marks", turn.changed);
  slot(node, "marks")?.append(...(turn.marks ?? []).map(markNode));
  part(node, "topic", turn.topic.text);
  slot(node, "topic")?.append(linked(turn.topic));
  part(node, "type", turn.type);
  if (slot(node, "type")) slot(node, "type").textContent = turn.type;
  slot(node, "why").append(...turn.why.map(stepNode));
  part(node, "learned", turn.learned.length);
  slot(node, "learned")?.append(...turn.learned.map(learnedNode));
  return node;
}

/** Keep a part of a template where there is something to show, else remove it. */
function part(node, name, shown) {
  const found = node.querySelector(`[data-part="${name}"]`);
  if (shown) return found;
  found.remove();
  return null;
}

/** A piece of text, a link where it has an address; links open beside the talk. */
export function linked({ text, url }) {
  if (!url) return document.createTextNode(text);
  const link = document.createElement("a");
  Object.assign(link, { href: url, target: "_blank", rel: "noopener", textContent: text });
  return link;
}

function actionNode({ action, meaning, parameters }) {
  const node = document.createElement("li");
  const name = document.createElement("code");
  name.textContent = action;
  node.append(`${meaning} `, name, parameters ? ` ${parameters}` : "");
  return node;
}

export function markNode({ kind, text }) {
  if (kind === "same") return document.createTextNode(text);
  const node = document.createElement(kind === "gone" ? "del" : "ins");
  node.textContent = text;
  return node;
}

function stepNode(step) {
  const node = copy("step-template");
  if (step.title) {
    slot(node, "title").textContent = step.title;
    if (part(node, "lines", step.lines)) slot(node, "lines").textContent = step.lines;
  } else {
    slot(node, "title").parentElement.remove();
  }
  slot(node, "pieces").append(...step.pieces.map(linked));
  if (part(node, "candidates", step.candidates.length)) {
    node.querySelector("tbody").append(...step.candidates.map(likelyNode));
    const more = part(node, "more", step.more);
    if (more) more.textContent = `+ ${step.more}`;
  }
  return node;
}

function likelyNode({ topic, likeliness, chosen }) {
  const node = copy("likely-template");
  node.querySelector("th").append(linked(topic));
  node.querySelector("meter").value = likeliness;
  slot(node, "value").textContent = likeliness.toFixed(2);
  part(node, "chosen", chosen);
  return node;
}

function learnedNode({ topic, before, now, changed }) {
  const node = copy("learned-template");
  slot(node, "topic").append(linked(topic));
  slot(node, "value").textContent = changed ? `${before} → ${now}` : now;
  part(node, "changed", changed);
  return node;
}

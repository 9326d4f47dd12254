// The page of an intent: rows, languages, actions, checks while it is written, trying sentences.
import { prepareRows, addLine, renumber, refreshRows } from "./intent_rows.js";
import { prepareActions } from "./intent_actions.js";

const page = document.getElementById("intent-page");
const form = document.getElementById("intent_form");
const words = page.dataset;

function formData(more) {
  const data = new FormData(form);
  data.set("intent", words.intent);
  for (const [name, value] of Object.entries(more)) data.set(name, value);
  return data;
}

async function ask(url, more) {
  renumber(form);
  const answer = await fetch(url, { method: "POST", body: formData(more), credentials: "same-origin" });
  if (!answer.ok) throw new Error(String(answer.status));
  return answer.json();
}

// Languages shown

function prepareLanguages() {
  const field = form.querySelector("[data-switch]");
  if (!field) return;
  field.hidden = false;
  const remembered = (() => { try { return localStorage.getItem("cair.intent.language"); } catch { return null; } })();
  const show = (code) => {
    form.dataset.shown = code;
    for (const one of form.querySelectorAll(".language")) {
      one.hidden = code !== "all" && one.dataset.language !== code;
    }
    try { localStorage.setItem("cair.intent.language", code); } catch { /* private window */ }
    const select = document.querySelector("#try-form select[name=language]");
    if (code !== "all") select.value = code;
  };
  const faulty = form.querySelector(".line.faulty");
  const boxes = [...field.querySelectorAll("input")];
  const fits = boxes.find((one) => one.value === remembered) || boxes[0];
  if (!faulty) fits.checked = true;
  for (const one of field.querySelectorAll("input")) one.addEventListener("change", () => show(one.value));
  show(field.querySelector("input:checked").value);
}

// Faults and marks

function showFaults(faults) {
  for (const box of form.querySelectorAll(".faults")) box.replaceChildren();
  for (const line of form.querySelectorAll(".faulty, .doubtful")) line.classList.remove("faulty", "doubtful");
  for (const fault of faults) {
    const input = form.elements[fault.name];
    const row = input?.closest("[data-row]");
    if (!row) continue;
    row.classList.add(fault.level === "error" ? "faulty" : "doubtful");
    const box = row.querySelector(".faults");
    const message = document.createElement("p");
    message.className = `fault ${fault.level}`;
    message.textContent = fault.message;
    box.append(message);
    if (fault.position >= 0) box.append(echo(input.value, fault.position));
  }
}

function echo(text, position) {
  const line = document.createElement("p");
  line.className = "echo";
  line.setAttribute("aria-hidden", "true");
  const mark = document.createElement("mark");
  mark.textContent = text.slice(position, position + 1) || " ";
  line.append(text.slice(0, position), mark, text.slice(position + 1));
  return line;
}

function showMarks(marks) {
  for (const box of form.querySelectorAll("[data-mark]")) box.replaceChildren();
  for (const mark of marks) {
    const row = form.elements[mark.name]?.closest("[data-row]");
    if (!row) continue;
    const badge = document.createElement("span");
    badge.className = `badge ${mark.reason ? "bad" : "good"}`;
    badge.textContent = mark.reason ? `✗ ${words.failed}` : "✓";
    const rest = document.createElement("span");
    if (!mark.reason) rest.className = "visually-hidden";
    rest.textContent = ` ${mark.reason || words.passed}`;
    row.querySelector("[data-mark]").append(badge, rest);
  }
}

let waiting = 0;
let asked = 0;

function checkSoon() {
  clearTimeout(waiting);
  waiting = setTimeout(() => check({}), 800);
}

async function check(more) {
  const mine = ++asked;
  const box = document.getElementById("checks");
  if (more.tests && box) box.textContent = words.running;
  try {
    const answer = await ask(words.check, more);
    if (mine !== asked && !more.tests) return;
    showFaults(answer.faults);
    if (answer.marks) {
      showMarks(answer.marks);
      box.innerHTML = answer.html;
    }
  } catch {
    if (more.tests && box) box.textContent = words.broken;
  }
}

// Trying a sentence

function prepareTrying() {
  const trying = document.getElementById("try-form");
  const box = document.getElementById("try-answer");
  const keep = page.querySelector("[data-keep]");
  let last = null;
  trying.addEventListener("submit", async (event) => {
    event.preventDefault();
    const sentence = trying.elements.sentence.value;
    const language = trying.elements.language.value;
    try {
      const answer = await ask(words.try, { sentence, language });
      box.innerHTML = answer.html;
      last = answer.tried && { sentence, language, tried: answer.tried };
      if (keep) keep.hidden = !last;
    } catch {
      box.textContent = words.broken;
    }
  });
  keep?.addEventListener("click", (event) => {
    const how = event.target.dataset.keepAs;
    if (!how || !last) return;
    if (how === "trigger") {
      const text = last.sentence.replace(/[.,;:!?。、！？…()[\]{}<>|]+/g, " ").replace(/\s+/g, " ").trim();
      addLine(form.querySelector("[data-part=triggers]"), last.language, text);
      refreshRows(form);
      checkSoon();
      return;
    }
    const winner = last.tried.winner;
    const own = winner && last.tried.number === Number(words.intent);
    const line = own ? winner.parameters.map((one) => `${one.name} = ${one.value}`).join(" | ") : "";
    const row = addLine(form.querySelector("[data-part=tests]"), last.language, last.sentence);
    row.querySelector("select[name$=_must]").value = how;
    row.querySelector("input[name$=_line]").value = how === "match" ? line : "";
    refreshRows(form);
    checkSoon();
  });
}

function preparePriority() {
  const select = form.elements.priority;
  const number = form.elements.priority_number;
  if (!select || !number) return;
  const show = () => { number.hidden = select.value !== "other"; };
  select.addEventListener("change", show);
  show();
}

if (form && form.querySelector("[data-part] [data-add]")) {
  prepareRows(form, words);
  prepareActions(form, words);
  preparePriority();
  form.addEventListener("input", () => { refreshRows(form); checkSoon(); });
  form.addEventListener("rows-changed", checkSoon);
  form.addEventListener("submit", () => renumber(form));
  const run = form.querySelector("[data-run-tests]");
  run.hidden = false;
  run.addEventListener("click", () => check({ tests: "1" }));
  refreshRows(form);
  if (words.intent !== "0" && !form.querySelector(".fault")) check({ tests: "1" });
}
prepareLanguages();
prepareTrying();

// Rows of Django formsets: add, remove, put back, move, paste many lines at once.

const SENTENCE = ".sentence";

function partOf(node) {
  return node.closest("[data-part]");
}

function total(part) {
  return part.querySelector(`input[name="${part.dataset.part}-TOTAL_FORMS"]`);
}

function listOf(part, language) {
  return language ? part.querySelector(`.by-language > [data-language="${language}"] .lines`) : part.querySelector(".cards");
}

function fresh(part, language) {
  const number = total(part).value;
  const holder = document.createElement("div");
  holder.innerHTML = part.querySelector("template").innerHTML.replaceAll("__prefix__", number);
  total(part).value = Number(number) + 1;
  const row = holder.firstElementChild;
  const list = listOf(part, language);
  const input = row.querySelector(SENTENCE);
  if (language) {
    row.querySelector("input[name$='-language']").value = language;
    input.lang = language;
    input.placeholder = list.dataset.example || "";
    input.setAttribute("aria-label", input.getAttribute("aria-label") + list.dataset.name);
  }
  showTools(row);
  return row;
}

function showTools(row) {
  for (const button of row.querySelectorAll(".tool")) button.hidden = false;
  const box = row.querySelector(".delete");
  if (box) box.hidden = true;
}

export function addRow(part, language, text = "", after = null) {
  const row = fresh(part, language);
  const list = listOf(part, language);
  if (after) after.after(row);
  else list.append(row);
  const input = row.querySelector(SENTENCE);
  if (input && text) input.value = text;
  return row;
}

// Fill the first empty line of the language, or add one.
export function addLine(part, language, text) {
  const rows = [...listOf(part, language).children];
  const empty = rows.find((row) => !row.classList.contains("removed") && !row.querySelector(SENTENCE).value.trim());
  if (!empty) return addRow(part, language, text);
  empty.querySelector(SENTENCE).value = text;
  return empty;
}

export function renumber(form) {
  for (const list of form.querySelectorAll("[data-part] .lines:not(.read), [data-part] .cards")) {
    let place = 0;
    for (const row of list.children) {
      const position = row.querySelector("input[name$='-position']");
      const text = row.querySelector(SENTENCE) || row.querySelector("select[name$='-action']");
      const gone = row.classList.contains("removed") || (text && !text.value.trim());
      if (position && !gone) position.value = place++;
    }
  }
}

export function refreshRows(form) {
  const declared = [...form.querySelectorAll("[data-part=slots] .card:not(.removed) input[name$='-name']")];
  form.classList.toggle("without-parameters", !declared.some((one) => one.value.trim()));
  for (const must of form.querySelectorAll("select[name$=_must]")) {
    must.closest("[data-row]").classList.toggle("must-not", must.value === "not");
  }
  for (const language of form.querySelectorAll(".by-language > .language")) {
    const lines = [...language.querySelectorAll(`.line:not(.removed) ${SENTENCE}`)];
    const heading = language.querySelector("h3");
    let count = heading.querySelector(".count");
    if (!count) {
      count = document.createElement("span");
      count.className = "count quiet";
      heading.append(" ", count);
    }
    count.textContent = lines.filter((one) => one.value.trim()).length;
    for (const one of lines) fit(one);
  }
}

// Where the browser does not make the field as high as its text by itself.
function fit(field) {
  if (CSS.supports("field-sizing", "content")) return;
  field.style.height = "auto";
  field.style.height = `${field.scrollHeight + 2}px`;
}

function remove(row, words) {
  const box = row.querySelector("input[name$='-DELETE']");
  const gone = !row.classList.contains("removed");
  row.classList.toggle("removed", gone);
  if (box) box.checked = gone;
  const button = row.querySelector("[data-remove]");
  button.textContent = gone ? "↺" : "✕";
  button.setAttribute("aria-label", gone ? words.undo : words.remove);
  button.setAttribute("aria-pressed", String(gone));
}

function move(row, step) {
  const other = step < 0 ? row.previousElementSibling : row.nextElementSibling;
  if (!other) return;
  if (step < 0) other.before(row);
  else other.after(row);
}

function onEnter(event) {
  const input = event.target.closest(`.line ${SENTENCE}`);
  if (event.key !== "Enter" || event.isComposing || !input) return;
  event.preventDefault();
  const row = input.closest(".line");
  const next = row.nextElementSibling;
  const empty = next && !next.querySelector(SENTENCE).value.trim() ? next : null;
  const language = row.closest(".language").dataset.language;
  (empty || addRow(partOf(row), language, "", row)).querySelector(SENTENCE).focus();
}

function onPaste(event) {
  const input = event.target.closest(`.line ${SENTENCE}`);
  const text = event.clipboardData?.getData("text/plain") || "";
  const lines = text.split(/\r?\n/).map((one) => one.trim()).filter(Boolean);
  if (!input || lines.length < 2) return;
  event.preventDefault();
  let row = input.closest(".line");
  const language = row.closest(".language").dataset.language;
  if (!input.value.trim()) input.value = lines.shift();
  for (const line of lines) row = addRow(partOf(row), language, line, row);
  input.dispatchEvent(new Event("input", { bubbles: true }));
}

export function prepareRows(form, words) {
  for (const row of form.querySelectorAll("[data-row]")) {
    // On a page with actions already, a spare card would only be in the way.
    if (row.dataset.spare !== undefined && !(row.dataset.row === "plan_actions-0")) {
      const part = partOf(row);
      row.remove();
      total(part).value = Number(total(part).value) - 1;
    } else showTools(row);
  }
  for (const button of form.querySelectorAll("[data-add]")) button.hidden = false;
  form.addEventListener("keydown", onEnter);
  form.addEventListener("paste", onPaste);
  form.addEventListener("click", (event) => {
    const button = event.target.closest("button");
    const part = button && partOf(button);
    if (!part) return;
    const row = button.closest("[data-row]");
    if (button.dataset.add !== undefined) {
      const language = button.closest(".language")?.dataset.language;
      addRow(part, language).querySelector(`${SENTENCE}, select`).focus();
    } else if (button.dataset.move) {
      move(row, Number(button.dataset.move));
      button.focus();
    } else if (button.dataset.remove !== undefined) remove(row, words);
    else return;
    refreshRows(form);
    form.dispatchEvent(new Event("rows-changed"));
  });
}

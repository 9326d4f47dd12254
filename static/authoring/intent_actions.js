// Actions of a plan: the inputs of the parameters of the action that is chosen.

const table = JSON.parse(document.getElementById("action-table")?.textContent || "{}");

function slots(form) {
  return [...form.querySelectorAll("[data-part=slots] .card:not(.removed) input[name$='-name']")]
    .map((one) => one.value.trim()).filter(Boolean).map((name) => `{${name}}`);
}

function inputsOf(row, form, words) {
  const part = row.closest("[data-part]").dataset.part;
  const select = row.querySelector("select");
  const box = row.querySelector("[data-parameters]");
  const known = table[part]?.[select.value];
  if (!known && select.value) return;
  const given = new Map([...box.querySelectorAll("input")].map((one) => [one.name, one.value]));
  box.replaceChildren();
  for (const parameter of known || []) {
    const name = `${box.dataset.parameters}.${parameter.name}`;
    const label = document.createElement("label");
    label.className = "parameter";
    const title = document.createElement("span");
    title.className = "of";
    title.textContent = parameter.name;
    const input = document.createElement("input");
    input.type = "text";
    input.maxLength = 200;
    input.name = name;
    input.value = given.get(name) || "";
    input.setAttribute("list", `list-${name}`);
    const list = document.createElement("datalist");
    list.id = `list-${name}`;
    for (const value of [...slots(form), ...parameter.values]) {
      const option = document.createElement("option");
      option.value = value;
      list.append(option);
    }
    label.append(title, input, list);
    if (parameter.values.length) {
      const hint = document.createElement("span");
      hint.className = "quiet";
      hint.textContent = `${words.values} ${parameter.values.join(", ")}`;
      label.append(hint);
    }
    box.append(label);
  }
}

export function prepareActions(form, words) {
  const rows = () => form.querySelectorAll("[data-part=plan_actions] .card, [data-part=kbplan_actions] .card");
  for (const row of rows()) inputsOf(row, form, words);
  form.addEventListener("change", (event) => {
    const row = event.target.closest(".card");
    const part = row?.closest("[data-part]").dataset.part;
    if (event.target.tagName === "SELECT" && part in table) inputsOf(row, form, words);
    else if (part === "slots") for (const each of rows()) inputsOf(each, form, words);
  });
}

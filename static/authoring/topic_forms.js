// The forms of a name while it is being written.
export function startForms() {
  const group = document.querySelector("[data-forms]");
  if (!group) return;
  for (const card of group.querySelectorAll(".name-card")) {
    let waiting = 0;
    card.addEventListener("input", () => {
      clearTimeout(waiting);
      waiting = setTimeout(() => show(card, group.dataset.forms), 300);
    });
  }
}

async function show(card, address) {
  const sent = new FormData();
  sent.set("csrfmiddlewaretoken", document.querySelector("[name=csrfmiddlewaretoken]").value);
  sent.set("language", card.dataset.language);
  for (const field of card.querySelectorAll("input[name], select[name]")) {
    const name = field.name.split("-").pop();
    if (name === "name") sent.set("name", field.value);
    else if (name.startsWith("form_")) sent.set(name.slice(5), field.value);
  }
  const answer = await fetch(address, { method: "POST", body: sent });
  if (!answer.ok) return;
  const found = await answer.json();
  card.querySelector(".forms-problem").textContent = sent.get("name") ? found.problem : "";
  const list = card.querySelector("dl");
  list.replaceChildren(...found.forms.map(row));
}

function row(form) {
  const line = document.createElement("div");
  const asked = document.createElement("dt");
  const text = document.createElement("dd");
  asked.textContent = form.asked;
  text.textContent = form.text;
  line.append(asked, text);
  return line;
}

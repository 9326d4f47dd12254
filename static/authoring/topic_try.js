// Words that are being written, as the robot will say them.
export function watchTexts(form) {
  let waiting = 0;
  const later = () => {
    clearTimeout(waiting);
    waiting = setTimeout(() => tryAll(form), 350);
  };
  form.addEventListener("input", later);
  form.addEventListener("change", later);
  const page = form.closest("form");
  if (page && page !== form) {
    for (const name of ["topic", "type", "scope", "pool"]) {
      const field = page.elements[name];
      if (field && window.django) window.django.jQuery(field).on("change", later);
      else if (field) field.addEventListener("change", later);
    }
  }
}

// Each form sends what stands in it; an older answer never replaces a newer one.
const latest = new WeakMap();

export async function tryAll(form) {
  const number = (latest.get(form) || 0) + 1;
  latest.set(form, number);
  const answer = await fetch(form.dataset.try, { method: "POST", body: written(form) });
  if (!answer.ok || latest.get(form) !== number) return;
  const found = await answer.json();
  for (const place of form.querySelectorAll("[data-tried]")) {
    const language = found.languages[place.dataset.tried];
    place.replaceChildren(...(language ? shown(form, language) : []));
  }
  offer(form, found.choices);
}

function written(form) {
  const sent = new FormData();
  const page = form.closest("form");
  sent.set("csrfmiddlewaretoken", document.querySelector("[name=csrfmiddlewaretoken]").value);
  for (const name of ["topic", "about", "type", "scope", "culture", "pool"]) {
    const field = page && page !== form && page.elements[name];
    sent.set(name, field ? field.value : form.dataset[name] || "");
  }
  const about = form.querySelector("#about");
  if (about) sent.set("about", about.value);
  for (const text of form.querySelectorAll("textarea[data-language]")) {
    sent.set(text.dataset.language, text.value);
  }
  return sent;
}

function shown(form, language) {
  if (language.problem) return [line("cannot", "", language.problem)];
  return language.said.flatMap((one) => {
    if (one.problem) return [line("cannot", one.about, one.problem)];
    const warnings = one.warnings.map((warning) =>
      line("look", "", `${form.dataset.look}: ${warning.message} ${warning.hint}`),
    );
    return [line("", `${form.dataset.says} (${one.about})`, one.text), ...warnings];
  });
}

function line(kind, about, text) {
  const row = document.createElement("p");
  if (kind) row.className = kind;
  if (about) {
    const small = document.createElement("span");
    small.className = "about";
    small.textContent = about;
    row.append(small);
  }
  row.append(text);
  return row;
}

function offer(form, choices) {
  const select = form.querySelector("#about");
  if (!select) return;
  select.closest(".about-choice").hidden = choices.length < 2;
  const chosen = select.value;
  const options = choices.map((one) => new Option(one.name, one.number));
  select.replaceChildren(select.options[0], ...options);
  select.value = choices.some((one) => String(one.number) === chosen) ? chosen : "";
}

// The pages of topics and sentences: tabs, who listens, editing in place, previews, sliders.
import { startForms } from "./topic_forms.js";
import { startSliders } from "./topic_likeliness.js";
import { startTabs } from "./topic_tabs.js";
import { tryAll, watchTexts } from "./topic_try.js";

async function part(address) {
  const answer = await fetch(address, { headers: { Accept: "text/html" } });
  if (!answer.ok) throw new Error(String(answer.status));
  return answer.text();
}

function withPart(address) {
  const url = new URL(address, location.href);
  url.searchParams.set("part", "1");
  url.hash = "";
  return url;
}

// Who listens: the panel is fetched anew; without a script the links open the page anew.
async function chooseListener(link) {
  const panel = document.getElementById("says");
  try {
    panel.innerHTML = await part(link.dataset.part);
    history.replaceState(null, "", link.href);
    const chosen = panel.querySelector('.hearers a[aria-current="true"]');
    if (chosen) chosen.focus();
  } catch {
    location.assign(link.href);
  }
}

async function editHere(link) {
  const row = link.closest("li");
  if (row.querySelector("form.in-place")) return;
  try {
    const holder = document.createElement("div");
    holder.innerHTML = await part(withPart(link.href));
    row.append(holder);
    openForm(holder, link);
  } catch {
    location.assign(link.href);
  }
}

function openForm(holder, link) {
  const form = holder.querySelector("form.in-place");
  watchTexts(form);
  tryAll(form);
  holder.querySelector("textarea").focus();
  form.querySelector(".cancel").addEventListener("click", (event) => {
    event.preventDefault();
    holder.remove();
    link.focus();
  });
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    save(form, holder, link);
  });
}

async function save(form, holder, link) {
  const answer = await fetch(withPart(form.action), { method: "POST", body: new FormData(form) });
  if ((answer.headers.get("content-type") || "").includes("json")) {
    await chosenAgain(form.closest("li").id);
  } else if (answer.ok || answer.status === 409) {
    // What is wrong, or what somebody else has written meanwhile.
    holder.innerHTML = await answer.text();
    if (holder.querySelector("form.in-place")) openForm(holder, link);
    const wrong = holder.querySelector(".errorlist ~ textarea, .errornote");
    if (wrong) wrong.focus();
  } else {
    form.submit();
  }
}

async function chosenAgain(id) {
  const panel = document.getElementById("says");
  const here = panel.querySelector('.hearers a[aria-current="true"]');
  panel.innerHTML = await part(here.dataset.part);
  const link = panel.querySelector(`#${id} .edit-here`);
  if (link) link.focus();
}

async function showPicture(section) {
  if (section.dataset.shown) return;
  section.dataset.shown = "yes";
  try {
    section.innerHTML = await part(withPart(section.dataset.from));
  } catch {
    delete section.dataset.shown;
  }
}

document.addEventListener("click", (event) => {
  if (event.ctrlKey || event.metaKey || event.shiftKey) return;
  const listener = event.target.closest(".hearers a[data-part]");
  const edit = event.target.closest("a.edit-here");
  if (listener && document.getElementById("says")) {
    event.preventDefault();
    chooseListener(listener);
  } else if (edit && edit.closest("#says")) {
    event.preventDefault();
    editHere(edit);
  }
});

startTabs((section) => section.id === "picture" && showPicture(section));
startSliders();
startForms();
for (const form of document.querySelectorAll("form.in-place, .sentences-form")) {
  watchTexts(form);
  tryAll(form);
}

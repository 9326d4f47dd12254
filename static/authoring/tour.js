// The quick tour: a dialog that points at places of the menu. Once seen it opens only on demand.
const SEEN = "cair.tour";
const GAP = 12;
const dialog = document.getElementById("tour");
const start = document.getElementById("start-tour");
const [ring, card] = [dialog.querySelector(".tour-ring"), dialog.querySelector(".tour-card")];
const steps = [...dialog.querySelectorAll("section")];
const button = (name) => dialog.querySelector(`[data-tour=${name}]`);
const next = button("next").textContent;
let at = 0;

function remembered() {
  try {
    return localStorage.getItem(SEEN) !== null;
  } catch {
    return true; // Where nothing can be kept the tour must not open again and again.
  }
}

function remember() {
  try {
    localStorage.setItem(SEEN, "seen");
  } catch {
    // Nothing can be kept here.
  }
}

function place() {
  const address = steps[at].dataset.at;
  const target = address && document.querySelector(`#menu a[href="${CSS.escape(address)}"]`);
  ring.hidden = !target;
  card.classList.toggle("middle", !target);
  card.style.left = card.style.top = "";
  if (!target) return;
  target.scrollIntoView({ block: "nearest" });
  const box = target.getBoundingClientRect();
  Object.assign(ring.style, {
    left: `${box.left - 2}px`,
    top: `${box.top - 2}px`,
    width: `${box.width + 4}px`,
    height: `${box.height}px`,
  });
  const most = document.documentElement.clientWidth - card.offsetWidth - GAP;
  card.style.left = `${Math.max(GAP, Math.min(box.left, most))}px`;
  card.style.top = `${box.bottom + GAP}px`;
}

function show(number) {
  at = number;
  steps.forEach((step, index) => (step.hidden = index !== at));
  const title = steps[at].querySelector("h2");
  dialog.setAttribute("aria-labelledby", title.id);
  dialog.setAttribute("aria-describedby", title.nextElementSibling.id);
  button("back").hidden = at === 0;
  const last = at === steps.length - 1;
  button("next").textContent = last ? button("next").dataset.last : next;
  button("close").hidden = last;
  place();
  title.focus();
}

function open() {
  dialog.showModal();
  show(0);
}

button("back").addEventListener("click", () => show(at - 1));
button("next").addEventListener("click", () =>
  at < steps.length - 1 ? show(at + 1) : dialog.close(),
);
button("close").addEventListener("click", () => dialog.close());
dialog.addEventListener("keydown", (event) => {
  if (event.key === "ArrowRight" && at < steps.length - 1) show(at + 1);
  if (event.key === "ArrowLeft" && at > 0) show(at - 1);
});
dialog.addEventListener("close", () => {
  remember();
  start.focus();
});
addEventListener("resize", () => dialog.open && place());

start.hidden = false;
start.addEventListener("click", open);
if (document.body.classList.contains("dashboard") && !remembered()) open();

// Bringing an ontology in: the size of the file told before it is sent, the steps while it is read.
const upload = document.querySelector("#upload");
const progress = document.querySelector("#progress");
const PAUSE = 1000;
const MOST_MISSES = 10;

if (upload) {
  const file = upload.querySelector("[type=file]");
  const told = upload.querySelector("#owl-file-told");
  const check = () => {
    const size = file.files[0]?.size ?? 0;
    const words = size > Number(upload.dataset.most) ? upload.dataset.tooLarge : "";
    told.textContent = words;
    file.toggleAttribute("aria-invalid", Boolean(words));
    return !words;
  };
  file.addEventListener("change", check);
  upload.addEventListener("submit", (event) => {
    if (!check()) {
      event.preventDefault();
      file.focus();
      return;
    }
    upload.querySelector("[type=submit]").disabled = true;
    upload.querySelector("#owl-sending").textContent = upload.dataset.sending;
  });
  // Coming back with the browser's button must not find the form closed.
  addEventListener("pageshow", () => {
    upload.querySelector("[type=submit]").disabled = false;
    upload.querySelector("#owl-sending").textContent = "";
  });
}

if (progress?.dataset.status) {
  watch(progress.dataset.status);
}

const later = document.querySelector("#changes-later");
if (later) {
  compare();
}

// A large draft is compared after the page is there.
async function compare() {
  try {
    const answer = await fetch(later.dataset.from);
    if (!answer.ok) {
      throw new Error(`Status ${answer.status}`);
    }
    const whole = new DOMParser().parseFromString(await answer.text(), "text/html");
    document.querySelector(".what").replaceWith(whole.querySelector(".what"));
  } catch {
    later.textContent = later.dataset.failed;
  }
}

async function watch(address) {
  for (let misses = 0; misses < MOST_MISSES; ) {
    await new Promise((done) => setTimeout(done, PAUSE));
    try {
      const said = await (await fetch(address, { headers: { Accept: "application/json" } })).json();
      misses = 0;
      if (!said.running) {
        location.reload();
        return;
      }
      show(said);
    } catch {
      misses += 1;
    }
  }
  const live = progress.querySelector("[data-live]");
  live.className = "told bad";
  live.textContent = progress.dataset.failed;
}

function show(said) {
  progress.querySelectorAll("li").forEach((item, place) => {
    item.className = place < said.place ? "over" : place === said.place ? "now" : "";
    item.toggleAttribute("aria-current", false);
    if (place === said.place) {
      item.setAttribute("aria-current", "step");
    }
  });
  const live = progress.querySelector("[data-live]");
  if (live.textContent !== said.words) {
    live.textContent = said.words;
  }
}

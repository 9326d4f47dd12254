// Publishing step by step: the form is sent in the background, the status asked for each second.
const form = document.querySelector("#publish-form");
const progress = document.querySelector("#progress");
const PAUSE = 1000;
const MOST_MISSES = 10;

if (form) {
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    send();
  });
  if (form.dataset.busyUrl) {
    watch(form.dataset.busyUrl);
  }
}

const later = document.querySelector("#changes-later");
if (later) {
  compare();
}

// A large draft is compared after the page is there; then the page is shown anew, with everything.
async function compare() {
  try {
    const answer = await fetch(later.dataset.from);
    if (!answer.ok) {
      throw new Error(`Status ${answer.status}`);
    }
    const whole = new DOMParser().parseFromString(await answer.text(), "text/html");
    document.querySelector(".publish .what").replaceWith(whole.querySelector(".publish .what"));
    if (!whole.querySelector("#publish-form")) {
      document.querySelector(".publish .side").replaceWith(whole.querySelector(".publish .side"));
    }
  } catch {
    later.textContent = later.dataset.failed;
  }
}

async function send() {
  const data = new FormData(form);
  form.querySelector("button").disabled = true;
  try {
    const answer = await fetch(form.action, { method: "POST", body: data, headers: { Accept: "application/json" } });
    if (!answer.headers.get("Content-Type")?.startsWith("application/json")) {
      throw new Error(`Status ${answer.status}`);
    }
    const said = await answer.json();
    if (said.trouble) {
      stop(said.trouble);
    } else {
      watch(said.status);
    }
  } catch {
    stop(form.dataset.failed);
  }
}

async function watch(address) {
  form.hidden = true;
  progress.hidden = false;
  progress.querySelector("ol").hidden = false;
  progress.querySelector("[data-live]").className = "visually-hidden";
  for (let misses = 0; misses < MOST_MISSES; ) {
    try {
      const said = await (await fetch(address, { headers: { Accept: "application/json" } })).json();
      misses = 0;
      if (!said.running) {
        location.assign(said.url);
        return;
      }
      show(said);
    } catch {
      misses += 1;
    }
    await new Promise((done) => setTimeout(done, PAUSE));
  }
  stop(form.dataset.failed);
}

function show(said) {
  progress.querySelectorAll("li").forEach((item, place) => {
    item.className = place < said.place ? "over" : place === said.place ? "now" : "";
    if (place === said.place) {
      item.setAttribute("aria-current", "step");
    } else {
      item.removeAttribute("aria-current");
    }
  });
  tell(said.words);
}

function tell(words) {
  const live = progress.querySelector("[data-live]");
  if (live.textContent !== words) {
    live.textContent = words;
  }
}

function stop(words) {
  form.hidden = false;
  form.querySelector("button").disabled = false;
  progress.hidden = false;
  progress.querySelector("ol").hidden = true;
  progress.querySelector("[data-live]").className = "told bad";
  tell(words);
}

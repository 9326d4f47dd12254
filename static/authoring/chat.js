/* The test chat: a talk kept in this browser tab only; the server answers each turn and keeps nothing. */

import { ask } from "./chat_ask.js";
import { listenToKeep } from "./chat_keep.js";
import { linked, turnNode } from "./chat_view.js";

const STORE = "cair.try";
const byId = (id) => document.getElementById(id);
const words = byId("chat").dataset;
const settings = byId("chat-settings");
let session = null; // {talk, language, content, turns}: the opening is turn 0
let busy = false;

/* The talk ------------------------------------------------------------------------------------- */

function wished() {
  const form = settings.elements;
  const able = [...settings.querySelectorAll("[name=able]:checked")].map((box) => box.value);
  return {
    content: form.content.value,
    language: form.language.value,
    culture: form.culture.value,
    seed: Number(form.seed.value) || 1,
    topic: form.topic.value.trim(),
    capabilities: form.robot.value === "usual" ? null : able,
  };
}

function begin(talk) {
  return attempt(async () => {
    const answer = await ask(words.turn, { talk }, words);
    session = { talk, language: answer.language, content: answer.content, turns: [answer.turn] };
    showAll();
  });
}

function say(sentence) {
  if (!session || session.turns.length > Number(words.mostTurns)) {
    tell(session ? words.full : "");
    return session ? null : begin(wished());
  }
  return attempt(async () => {
    const { state } = session.turns.at(-1);
    const answer = await ask(words.turn, { talk: session.talk, state, sentence }, words);
    byId("chat-newer").hidden = answer.content.version === session.content.version;
      session.turns.push(answer.turn);
    byId("chat-sentence").value = "";
    byId("chat-log").append(nodeOf(answer.turn, session.turns.length - 1));
    showEnd();
  });
}

/** Drop the turns from this place on; what was said there can be said otherwise. */
function undoFrom(place) {
  if (busy || !session || place < 1 || place >= session.turns.length) return;
  byId("chat-sentence").value = session.turns[place].heard;
  session.turns.length = place;
  showAll();
  byId("chat-sentence").focus();
  byId("chat-sentence").select();
}

/** Have the whole talk again on the content as it is now, and mark what has changed. */
function again(talk, turns) {
  return attempt(async () => {
    const heard = turns.map(({ heard, reply, plan }) => ({ heard, reply, plan }));
    const answer = await ask(words.replay, { talk, turns: heard }, words);
    session = { talk, language: talk.language, content: answer.content, turns: answer.turns };
    showAll();
    const changed = answer.turns.filter((turn) => turn.changed).length;
    tell(changed ? `${words.changed} ${changed}` : words.same);
    document.querySelector(".chat-changed")?.scrollIntoView({ block: "center" });
  });
}

/* What is shown ---------------------------------------------------------------------------------- */

function nodeOf(turn, place) {
  const opening = place === 0;
  const onelse = () => undoFrom(place);
  return turnNode(turn, { opening, language: session.language, silence: words.silence, onelse });
}

function showAll() {
  byId("chat-log").replaceChildren(...session.turns.map(nodeOf));
  byId("chat-newer").hidden = true;
  tell("");
  showEnd();
}

function showEnd() {
  byId("chat-with").textContent = `${words.with} ${session.content.name}`;
  byId("chat-say").scrollIntoView({ block: "nearest" });
  remember();
  allow();
}

function allow() {
  const length = session?.turns.length ?? 0;
  byId("chat-undo").disabled = busy || length < 2;
  for (const id of ["chat-restart", "chat-again", "chat-keep"]) {
    if (byId(id)) byId(id).disabled = busy || !length;
  }
}

function tell(text) {
  byId("chat-status").textContent = text;
}

/** Try some work; what goes wrong is told in its place, and nothing of the talk is lost. */
async function attempt(work) {
  if (busy) return;
  busy = true;
  allow();
  byId("chat-trouble").replaceChildren();
  byId("chat-unbuilt").hidden = true;
  const waiting = setTimeout(() => tell(words.thinking), 400);
  try {
    tell("");
    await work();
  } catch (error) {
    showTrouble(error);
  } finally {
    clearTimeout(waiting);
    if (byId("chat-status").textContent === words.thinking) tell("");
    busy = false;
    allow();
  }
}

function showTrouble(error) {
  const note = document.createElement("p");
  Object.assign(note, { className: "errornote", textContent: error.message });
  byId("chat-trouble").replaceChildren(note);
  if (error.code !== "draft") return;
  const rows = (error.findings ?? []).map(({ where, message, hint, url, more }) => {
    const row = document.createElement("li");
    row.append(linked({ text: where, url }), `: ${message} ${hint} ${more}`);
    return row;
  });
  byId("chat-findings").replaceChildren(...rows);
  byId("chat-unbuilt").hidden = false;
}

/* What this tab remembers ---------------------------------------------------------------------- */

function remember() {
  try {
    sessionStorage.setItem(STORE, JSON.stringify(session));
  } catch {
    // Without room the talk goes on; only reloading the page would end it.
    forget();
  }
}

function forget() {
  try {
    sessionStorage.removeItem(STORE);
  } catch {
    // Nothing can be stored here, so nothing is left.
  }
}

function remembered() {
  try {
    const found = JSON.parse(sessionStorage.getItem(STORE));
    return Array.isArray(found?.turns) && found.turns.length && found.talk && found.content ? found : null;
  } catch {
    return null;
  }
}

/** Let the form say how the remembered talk is had. */
function showSettings(talk) {
  const form = settings.elements;
  for (const name of ["content", "culture", "language", "seed", "topic"]) form[name].value = talk[name];
  form.robot.value = talk.capabilities === null ? "usual" : "chosen";
  settings.querySelectorAll("[name=able]").forEach((box) => (box.checked = (talk.capabilities ?? []).includes(box.value)));
}

/* Beginning ---------------------------------------------------------------------------------------- */

function useUsualLanguage() {
  const usual = settings.elements.culture.selectedOptions[0]?.dataset.language;
  if (usual) settings.elements.language.value = usual;
}

function tick(all) {
  settings.querySelectorAll("[name=able]").forEach((box) => (box.checked = all));
  settings.elements.robot.value = "chosen";
}

function listen() {
  settings.addEventListener("submit", (event) => {
    event.preventDefault();
    begin(wished());
  });
  settings.elements.culture.addEventListener("change", useUsualLanguage);
  settings.addEventListener("change", ({ target }) => target.name === "able" && (settings.elements.robot.value = "chosen"));
  settings.addEventListener("change", ({ target }) => target.name === "robot" && (byId("chat-actions").open = target.value === "chosen"));
  byId("all-actions").addEventListener("click", () => tick(true));
  byId("no-actions").addEventListener("click", () => tick(false));
  byId("chat-say").addEventListener("submit", (event) => {
    event.preventDefault();
    say(byId("chat-sentence").value);
  });
  byId("chat-undo").addEventListener("click", () => undoFrom(session.turns.length - 1));
  byId("chat-restart").addEventListener("click", () => begin(session.talk));
  byId("chat-again").addEventListener("click", () => again({ ...session.talk, content: settings.elements.content.value }, session.turns));
  byId("chat-newer").querySelector("button").addEventListener("click", () => again(session.talk, session.turns));
  byId("use-published").addEventListener("click", () => {
    settings.elements.content.value = "published";
    begin(wished());
  });
  byId("try-draft").addEventListener("click", () => begin({ ...wished(), content: "draft" }));
  listenToKeep({
    talk: () => session ?? { turns: [] },
    send: (body) => ask(words.save, body, words),
    saved: ({ title, url }) => byId("chat-status").replaceChildren(`${words.saved} `, linked({ text: title, url })),
  });
}

function open() {
  const opened = JSON.parse(byId("chat-opened").textContent);
  if (!settings.elements.language.dataset.chosen) useUsualLanguage();
  const stored = remembered();
  if (opened.length) again(wished(), opened);
  else if (stored && !location.search) {
    session = stored;
    showSettings(session.talk);
    showAll();
  } else begin(wished());
  if (location.search) history.replaceState(null, "", location.pathname);
}

listen();
allow();
open();

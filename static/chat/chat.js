/* The web chat: chooses a language, keeps the talk in this browser, and sends each sentence to the Hub. */

import * as bubbles from "./bubbles.js";
import { Hub, Trouble } from "./hub.js";
import * as memory from "./memory.js";
import { Ear, Mouth } from "./voice.js";
import { say as sayIn } from "./words.js";

const SIZES = 5;
const byId = (id) => document.getElementById(id);
const listed = (id) => JSON.parse(byId(id).textContent) ?? [];

const hub = new Hub(document.body.dataset.api);
const languages = listed("languages");
const cultures = listed("cultures");
const settings = memory.readSettings();
const mouth = new Mouth(showTalking, showVoiceChoices);
const ear = new Ear({ onwords: showHeard, onstop: stopListening });

let talk = memory.readTalk(); // language, culture, dialogue_state, transcript; null before the first word
let language = talk?.language ?? preferredLanguage();
let busy = false;

/* Words ------------------------------------------------------------------------------------ */

const say = (key, values) => sayIn(language, key, values);
const tagOf = (code) => languages.find((one) => one.code === code)?.tag ?? code;
const ownNameOf = (code) => languages.find((one) => one.code === code)?.own_name ?? code;
const cultureName = (culture) => culture?.names?.[language] ?? culture?.names?.en ?? culture?.code ?? "";

const capital = (text) => text.charAt(0).toLocaleUpperCase(tagOf(language)) + text.slice(1);

function preferredLanguage() {
  const wished = (navigator.languages ?? []).map((tag) => tag.split("-")[0]);
  const known = languages.map((one) => one.code);
  return wished.find((code) => known.includes(code)) ?? known[0] ?? "en";
}

function translatePage() {
  document.documentElement.lang = tagOf(language);
  document.title = say("title");
  document.querySelectorAll("[data-words]").forEach((node) => (node.textContent = say(node.dataset.words)));
  document.querySelectorAll("[data-label]").forEach((node) => node.setAttribute("aria-label", say(node.dataset.label)));
  const culture = cultures.find((one) => one.code === talk?.culture);
  byId("speaking").textContent = say("speaking", { language: ownNameOf(language), culture: cultureName(culture) });
  showVoiceChoices();
  showListening();
}

/* The two views ---------------------------------------------------------------------------- */

function show(view) {
  document.body.dataset.view = view;
  byId("welcome").hidden = view !== "welcome";
  byId("talk").hidden = view !== "talk";
  document.querySelector(".skip").hidden = view !== "talk";
  openSettings(false);
  translatePage();
}

function showWelcome() {
  show("welcome");
  const pill = ({ code, own_name, tag }) =>
    bubbles.pill({ group: "language", value: code, text: own_name, lang: tag, checked: code === language });
  byId("language-pills").replaceChildren(...languages.map(pill));
  showCultures(cultures.find((one) => one.language === language)?.code ?? cultures[0]?.code);
}

function showCultures(chosen) {
  const pill = (culture) =>
    bubbles.pill({ group: "culture", value: culture.code, text: capital(cultureName(culture)), checked: culture.code === chosen });
  byId("culture-pills").replaceChildren(...cultures.map(pill));
}

function chooseLanguage(code) {
  language = code;
  translatePage();
  byId("welcome-trouble").replaceChildren();
  showCultures(cultures.find((one) => one.language === code)?.code ?? byId("choose").elements.culture?.value);
}

function showTalk() {
  show("talk");
  const log = byId("log");
  // Old lines are no news: only what is added from now on is announced.
  log.setAttribute("aria-live", "off");
  log.replaceChildren(...talk.transcript.map(nodeOf));
  setTimeout(() => log.setAttribute("aria-live", "polite"), 500);
  byId("sentence").value = memory.readDraft();
  showLatest();
}

function nodeOf(entry) {
  const tag = tagOf(talk.language);
  if (entry.kind === "pause") return document.createElement("hr");
  if (entry.kind === "you") return bubbles.yours(entry.text, { say, tag });
  const explain = entry.before ? () => explainReply(entry) : null;
  return bubbles.reply(entry, { say, tag, explain, hear: mouth.voices.length ? () => readAloud(entry) : null });
}

function showLatest() {
  byId("log").lastElementChild?.scrollIntoView({ block: "nearest" });
}

function add(entry) {
  const node = nodeOf(entry);
  byId("log").append(node);
  showLatest();
  return node;
}

/* The talk --------------------------------------------------------------------------------- */

async function begin(culture) {
  byId("start").textContent = say("starting");
  await attempt("welcome-trouble", () => begin(culture), async () => {
    const answer = await hub.start(language, culture, seed());
    talk = { language, culture, dialogue_state: answer.dialogue_state, transcript: [] };
    showTalk();
    accept({ ...answer, sentence_type: answer.sentence_type ?? "start" });
    focusComposer();
  });
  byId("start").textContent = say("start");
}

/** The seed of the page's address; without one a drawn one, so that "Why this reply?" explains this very reply. */
function seed() {
  const wished = new URLSearchParams(location.search).get("seed");
  return /^\d{1,10}$/.test(wished ?? "") ? wished : 1 + Math.floor(Math.random() * (2 ** 31 - 1));
}

function greetAgain() {
  return attempt("talk-trouble", greetAgain, async () => {
    const before = talk.dialogue_state;
    const answer = await hub.turn("", before);
    forgetGreeting();
    if (talk.transcript.length) record({ kind: "pause" });
    accept(answer, { before, heard: "", greeting: true });
  });
}

/** Reloading twice in a row shows one greeting, not two. */
function forgetGreeting() {
  if (!talk.transcript.at(-1)?.greeting) return;
  talk.transcript.splice(talk.transcript.at(-2)?.kind === "pause" ? -2 : -1);
  byId("log").replaceChildren(...talk.transcript.map(nodeOf));
}

function send() {
  const box = byId("sentence");
  const text = box.value.trim();
  if (!text || busy) return;
  mouth.hush();
  const bubble = add({ kind: "you", text });
  write("");
  const turn = async () => {
    const before = talk.dialogue_state;
    const answer = await hub.turn(text, before);
    talk.transcript.push({ kind: "you", text });
    accept(answer, { before, heard: text });
  };
  return attempt("talk-trouble", send, turn, () => {
    bubble.remove();
    write([text, box.value].filter(Boolean).join(" "));
  });
}

function accept(answer, more = {}) {
  const { first_sentence, plan_sentence, dialogue_sentence, plan_actions, sentence_type, topic } = answer;
  talk.dialogue_state = answer.dialogue_state || talk.dialogue_state;
  const entry = { kind: "reply", first_sentence, plan_sentence, dialogue_sentence, plan_actions, sentence_type, topic, ...more };
  record(entry);
  if (settings.aloud) readAloud(entry);
}

function record(entry) {
  talk.transcript.push(entry);
  memory.writeTalk(talk);
  add(entry);
}

/** After a damaged or outdated state: a new thread of talk below the old lines. */
function newThread() {
  return attempt("talk-trouble", newThread, async () => {
    const answer = await hub.start(talk.language, talk.culture, seed());
    record({ kind: "pause" });
    accept({ ...answer, sentence_type: answer.sentence_type ?? "start" });
    focusComposer();
  });
}

/** Try `work`; on trouble say so kindly in the place, with a button that tries again. */
async function attempt(place, again, work, undo = () => {}) {
  if (busy) return;
  wait(true);
  byId(place).replaceChildren();
  try {
    await work();
  } catch (error) {
    undo();
    showTrouble(byId(place), error, again);
  } finally {
    wait(false);
  }
}

function showTrouble(place, error, again) {
  const known = error instanceof Trouble ? error : new Trouble("server", { message: String(error) });
  const onretry = known.kind === "thread" && talk ? newThread : again;
  const kept = talk !== null && byId("sentence").value !== "";
  place.replaceChildren(bubbles.trouble(known, { say, kept, onretry }));
  place.firstElementChild.scrollIntoView({ block: "nearest" });
}

function wait(waiting) {
  busy = waiting;
  byId("talk").setAttribute("aria-busy", String(waiting));
  byId("send").setAttribute("aria-disabled", String(waiting));
  byId("start").setAttribute("aria-disabled", String(waiting));
  document.documentElement.dataset.robot = waiting ? "thinking" : "calm";
  clearTimeout(wait.timer);
  byId("thinking").hidden = true;
  if (waiting) wait.timer = setTimeout(showThinking, 500);
}

function showThinking() {
  if (byId("talk").hidden) return;
  byId("thinking").hidden = false;
  byId("thinking").scrollIntoView({ block: "nearest" });
  tell(say("thinking"));
}

async function explainReply({ heard, before, ...shown }) {
  const answer = await hub.explain(heard, before);
  const [then, now] = [shown, answer].map((reply) => bubbles.spoken(reply).join(" "));
  return { answer, differs: now && now !== then ? now : "" };
}

function startAgain() {
  mouth.hush();
  ear.stop();
  memory.deleteTalk();
  talk = null;
  byId("log").replaceChildren();
  byId("talk-trouble").replaceChildren();
  byId("welcome-trouble").replaceChildren();
  write("");
  showWelcome();
  byId("welcome-title").focus();
  scrollTo(0, 0);
}

/* Writing ---------------------------------------------------------------------------------- */

function write(text) {
  byId("sentence").value = text;
  memory.writeDraft(text);
}

/** Lines scroll to a stop above the box for writing, however tall it has become. */
function watchComposer() {
  const style = document.documentElement.style;
  const tell = () => style.setProperty("--composer-height", `${byId("composer").offsetHeight + 24}px`);
  new ResizeObserver(tell).observe(byId("composer"));
}

function focusComposer() {
  // On a touch screen the keyboard would cover the first words.
  const target = matchMedia("(pointer: fine)").matches ? "sentence" : "talk-title";
  byId(target).focus({ preventScroll: true });
}

function onKey(event) {
  // While a Japanese word is being composed, Enter only confirms it.
  if (event.key !== "Enter" || event.shiftKey || event.isComposing || event.keyCode === 229) return;
  event.preventDefault();
  send();
}

/* Settings --------------------------------------------------------------------------------- */

function openSettings(open) {
  byId("open-settings").setAttribute("aria-expanded", String(open));
  byId("settings").classList.toggle("open", open);
}

function changeSize(step) {
  const size = Math.min(SIZES - 1, Math.max(0, settings.size + step));
  remember({ size });
  showSize();
  tell(say("size_now", { now: size + 1, all: SIZES }));
}

function showSize() {
  document.documentElement.dataset.size = settings.size;
  byId("smaller").setAttribute("aria-disabled", String(settings.size === 0));
  byId("larger").setAttribute("aria-disabled", String(settings.size === SIZES - 1));
}

function remember(change) {
  memory.writeSettings(Object.assign(settings, change));
}

function tell(text) {
  byId("status").textContent = text;
}

/* Voice ------------------------------------------------------------------------------------ */

function showVoiceChoices() {
  const canSpeak = mouth.voices.length > 0;
  const hasVoice = Boolean(mouth.voiceFor(tagOf(language)));
  byId("voice").hidden = !canSpeak && !Ear.possible;
  byId("open-settings").hidden = byId("voice").hidden && !talk; // the panel would be empty
  byId("aloud-choice").hidden = !canSpeak;
  byId("microphone-choice").hidden = !Ear.possible;
  byId("aloud").disabled = byId("slowly").disabled = !hasVoice;
  byId("no-voice").hidden = hasVoice;
  byId("no-voice").textContent = say("no_voice", { language: ownNameOf(language) });
  document.querySelectorAll(".hear").forEach((button) => (button.hidden = !hasVoice));
  byId("listen").hidden = !(Ear.possible && settings.microphone);
}

function readAloud(reply) {
  mouth.say(bubbles.spoken(reply).join(" "), tagOf(talk.language), { slowly: settings.slowly });
}

function showTalking(talking) {
  byId("hush").hidden = !talking;
  document.documentElement.dataset.robot = talking ? "talking" : "calm";
}

function toggleListening() {
  mouth.hush();
  if (ear.listening) return ear.stop();
  try {
    ear.listen(tagOf(language));
  } catch {
    tellMicrophone("failed");
  }
  showListening();
}

function showHeard(text, final) {
  write(text);
  if (final) send();
}

function stopListening(trouble) {
  showListening();
  if (trouble) tellMicrophone(trouble);
}

function tellMicrophone(trouble) {
  byId("talk-trouble").replaceChildren(bubbles.element("p", "note", say(`microphone_${trouble}`)));
}

function showListening() {
  byId("listen").classList.toggle("on", ear.listening);
  byId("listen-word").textContent = say(ear.listening ? "done_speaking" : "speak");
  byId("say-hint").textContent = say(ear.listening ? "listening" : "say_hint");
  if (!busy) document.documentElement.dataset.robot = ear.listening ? "listening" : "calm";
}

/* Beginning -------------------------------------------------------------------------------- */

function listenToPage() {
  byId("language-pills").addEventListener("change", (event) => chooseLanguage(event.target.value));
  byId("choose").addEventListener("submit", (event) => {
    event.preventDefault();
    begin(byId("choose").elements.culture?.value ?? "");
  });
  byId("composer").addEventListener("submit", (event) => {
    event.preventDefault();
    send();
  });
  byId("sentence").addEventListener("keydown", onKey);
  byId("sentence").addEventListener("input", ({ target }) => memory.writeDraft(target.value));
  byId("open-settings").addEventListener("click", () => openSettings(!byId("settings").classList.contains("open")));
  byId("smaller").addEventListener("click", () => changeSize(-1));
  byId("larger").addEventListener("click", () => changeSize(+1));
  byId("again").addEventListener("click", () => byId("again-dialog").showModal());
  byId("again-dialog").addEventListener("close", ({ target }) => {
    if (target.returnValue === "yes") startAgain();
    target.returnValue = "";
  });
}

function listenToVoice() {
  for (const name of ["aloud", "slowly", "microphone"]) {
    byId(name).checked = settings[name];
    byId(name).addEventListener("change", ({ target }) => {
      remember({ [name]: target.checked });
      if (name !== "slowly" && !target.checked) mouth.hush();
      if (name === "microphone" && !target.checked) ear.stop();
      showVoiceChoices();
    });
  }
  byId("hush").addEventListener("click", () => mouth.hush());
  byId("listen").addEventListener("click", toggleListening);
  document.addEventListener("keydown", (event) => event.key === "Escape" && mouth.hush());
  addEventListener("pagehide", () => mouth.hush());
}

history.scrollRestoration = "manual"; // a reload shows the latest line
showSize();
listenToPage();
listenToVoice();
watchComposer();
if (talk) {
  showTalk();
  greetAgain();
} else {
  showWelcome();
}

/* What this browser remembers: the talk and the settings. Without localStorage everything works until the page closes. */

const TALK = "cair.talk";
const DRAFT = "cair.draft";
const SETTINGS = "cair.settings";
const VERSION = 1;
const LONGEST = 300; // entries of the transcript
const EXPLAINED = 20; // latest replies that keep the state before them, to be explained

export const DEFAULTS = { size: 1, aloud: false, slowly: false, microphone: false };

/** The stored talk, or null where there is none that can be read. */
export function readTalk() {
  const talk = read(TALK);
  return talk?.version === VERSION && talk.dialogue_state && Array.isArray(talk.transcript) ? talk : null;
}

/** Store the talk; where room is short, the oldest lines and explanations go first. */
export function writeTalk(talk) {
  talk.transcript = shortened(talk.transcript, LONGEST, EXPLAINED);
  if (write(TALK, { ...talk, version: VERSION })) return;
  write(TALK, { ...talk, version: VERSION, transcript: shortened(talk.transcript, 40, 2) });
}

export function deleteTalk() {
  remove(TALK);
  remove(DRAFT);
}

export const readDraft = () => String(read(DRAFT) ?? "");
export const writeDraft = (text) => (text ? write(DRAFT, text) : remove(DRAFT));
export const readSettings = () => ({ ...DEFAULTS, ...read(SETTINGS) });
export const writeSettings = (settings) => write(SETTINGS, settings);

function shortened(transcript, longest, explained) {
  const kept = transcript.slice(-longest);
  const withState = kept.filter((entry) => entry.before);
  withState.slice(0, Math.max(0, withState.length - explained)).forEach((entry) => delete entry.before);
  return kept;
}

function read(key) {
  try {
    return JSON.parse(localStorage.getItem(key));
  } catch {
    return null;
  }
}

function write(key, value) {
  try {
    localStorage.setItem(key, JSON.stringify(value));
    return true;
  } catch {
    return false;
  }
}

function remove(key) {
  try {
    localStorage.removeItem(key);
  } catch {
    // Nothing can be stored here, so nothing is left.
  }
}

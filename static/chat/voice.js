/* Speaking and listening through the Web Speech API, where the browser has it. */

import { sentencesOf } from "./sentences.js";

const Recognition = window.SpeechRecognition ?? window.webkitSpeechRecognition;
const synthesis = window.speechSynthesis;

/** Read texts aloud. `onchange(talking)` tells when it begins and ends. */
export class Mouth {
  #left = 0;
  #round = 0;

  constructor(onchange, onvoices) {
    this.onchange = onchange;
    synthesis?.addEventListener?.("voiceschanged", onvoices);
  }

  get voices() {
    return synthesis?.getVoices() ?? [];
  }

  get talking() {
    return this.#left > 0;
  }

  /** The best voice for "it-IT": the same region first, then one that lives on this device. */
  voiceFor(tag) {
    const language = tag.split("-")[0];
    const rank = (voice) => (dashed(voice) === tag.toLowerCase() ? 2 : 0) + (voice.localService ? 1 : 0);
    return this.voices
      .filter((voice) => dashed(voice).split("-")[0] === language)
      .sort((one, other) => rank(other) - rank(one))[0];
  }

  say(text, tag, { slowly = false } = {}) {
    this.hush();
    const voice = this.voiceFor(tag);
    if (!voice) return;
    this.#round += 1;
    const parts = sentencesOf(text);
    parts.forEach((part) => synthesis.speak(this.#utterance(part, voice, slowly)));
    this.#left = parts.length;
    this.onchange(this.talking);
  }

  hush() {
    if (!this.talking) return;
    this.#left = 0;
    synthesis.cancel();
    this.onchange(false);
  }

  #utterance(text, voice, slowly) {
    const utterance = new SpeechSynthesisUtterance(text);
    Object.assign(utterance, { voice, lang: voice.lang, rate: slowly ? 0.7 : 0.95 });
    const round = this.#round;
    utterance.onend = utterance.onerror = () => this.#finished(round);
    return utterance;
  }

  #finished(round) {
    // A cancelled piece reports itself late, when the next text may already be read.
    if (!this.talking || round !== this.#round) return;
    this.#left -= 1;
    if (this.#left === 0) this.onchange(false);
  }
}

/** Listen to one sentence. `onwords(text, final)`, `onstop(trouble)`; trouble is "", "denied", "silent" or "failed". */
export class Ear {
  static possible = Boolean(Recognition);
  #recognition = null;

  constructor({ onwords, onstop }) {
    Object.assign(this, { onwords, onstop });
  }

  get listening() {
    return this.#recognition !== null;
  }

  listen(tag) {
    this.stop();
    const recognition = new Recognition();
    Object.assign(recognition, { lang: tag, interimResults: true, continuous: false, maxAlternatives: 1 });
    let heard = false;
    let trouble = "";
    recognition.onresult = ({ results }) => {
      const parts = Array.from(results);
      heard = true;
      this.onwords(parts.map((part) => part[0].transcript).join(""), parts.every((part) => part.isFinal));
    };
    recognition.onerror = ({ error }) => (trouble = TROUBLES[error] ?? "failed");
    recognition.onend = () => {
      if (this.#recognition !== recognition) return;
      this.#recognition = null;
      this.onstop(heard ? "" : trouble);
    };
    this.#recognition = recognition;
    recognition.start();
  }

  stop() {
    this.#recognition?.stop();
  }
}

const TROUBLES = { "not-allowed": "denied", "service-not-allowed": "denied", "no-speech": "silent", aborted: "" };

function dashed(voice) {
  return voice.lang.replace("_", "-").toLowerCase();
}

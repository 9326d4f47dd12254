/* The three calls of the native API, and one kind of trouble for everything that can go wrong with them. */

const PATIENCE = 20_000; // milliseconds
const KINDS = { 413: "large", 429: "busy", 503: "unpublished" };

/** A call that failed: `kind` chooses the kind words, `code`, `message` and `hint` are for the technician. */
export class Trouble extends Error {
  constructor(kind, { code = "", message = "", hint = "" } = {}) {
    super(message || kind);
    Object.assign(this, { name: "Trouble", kind, code, hint });
  }
}

export class Hub {
  /** `base` is the address of the API, e.g. "/api/v1/". */
  constructor(base) {
    this.base = base;
  }

  /** Begin a talk: the answer has `first_sentence` and `dialogue_state`. */
  async start(language, culture, seed) {
    const answer = await this.#call(`hub/?${new URLSearchParams({ language, culture, seed })}`);
    if (!answer.dialogue_state) throw new Trouble("unpublished", { code: "state.missing" });
    return answer;
  }

  /** One turn; an empty sentence asks for the words that welcome somebody back. */
  turn(client_sentence, dialogue_state) {
    return this.#call("hub/", { client_sentence, dialogue_state });
  }

  /** The same turn with the `steps` that led to the reply. */
  explain(client_sentence, dialogue_state) {
    return this.#call("dialogue/explain/", { client_sentence, dialogue_state });
  }

  async #call(path, body) {
    let response = await this.#fetch(this.base + path, body);
    if (response.status === 401) {
      // Where calls need a key, the page brings a pass of a few minutes with it: a new page, a new pass.
      await this.#fetch(location.pathname);
      response = await this.#fetch(this.base + path, body);
    }
    const answer = await response.json().catch(() => null);
    if (!response.ok) throw troubleOf(response.status, answer);
    if (!answer || typeof answer !== "object") throw new Trouble("server", { code: "answer.unreadable" });
    return answer;
  }

  async #fetch(address, body) {
    const options = { headers: { Accept: "application/json" }, signal: AbortSignal.timeout(PATIENCE) };
    if (body) {
      options.method = "POST";
      options.headers["Content-Type"] = "application/json";
      options.body = JSON.stringify(body);
    }
    try {
      return await fetch(address, options);
    } catch (error) {
      throw new Trouble(error.name === "TimeoutError" ? "slow" : "network", { message: error.message });
    }
  }
}

function troubleOf(status, answer) {
  const error = answer?.error ?? {};
  const told = { code: String(error.code ?? status), message: error.message, hint: error.hint };
  if (told.code.startsWith("state.")) return new Trouble("thread", told);
  if (told.code.startsWith("service.")) return new Trouble("server", told);
  return new Trouble(KINDS[status] ?? (status < 500 ? "refused" : "server"), told);
}

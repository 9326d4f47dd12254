/* What the test chat asks the server, and one kind of trouble for all that can go wrong. */

const PATIENCE = 60_000; // milliseconds: building a large draft takes a while

/** `code` names the trouble, `message` tells it; `findings` are what forbids building the draft. */
export class Trouble extends Error {
  constructor(code, message, findings = []) {
    super(message);
    Object.assign(this, { name: "Trouble", code, findings });
  }
}

/** Post JSON and return the answer; `words` has `failed` and `session` for what has no words of its own. */
export async function ask(address, body, words) {
  let response;
  try {
    response = await fetch(address, {
      method: "POST",
      headers: { "Content-Type": "application/json", "X-CSRFToken": token(), Accept: "application/json" },
      body: JSON.stringify(body),
      signal: AbortSignal.timeout(PATIENCE),
    });
  } catch {
    throw new Trouble("network", words.failed);
  }
  const answer = await response.json().catch(() => null);
  if (response.ok && answer) return answer;
  const error = answer?.error;
  if (error?.message) throw new Trouble(error.code, error.message, error.findings);
  throw new Trouble("server", response.status === 403 || response.redirected || response.ok ? words.session : words.failed);
}

function token() {
  return document.querySelector("#csrf input").value;
}

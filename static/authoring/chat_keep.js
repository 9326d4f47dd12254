/* "Save as a conversation": what must hold of each turn is chosen in a dialog. */

const byId = (id) => document.getElementById(id);
const byDefault = { topic: (turn) => turn.topic_key, plan: (turn) => turn.plan, words: () => "" };

/** Let the button open the dialog; `talk()` gives {talk, turns}, `send(body)` saves and returns {title, url}. */
export function listenToKeep({ talk, send, saved }) {
  if (!byId("chat-keep")) return;
  byId("chat-keep").addEventListener("click", () => open(talk()));
  byId("save-cancel").addEventListener("click", () => byId("save-dialog").close());
  byId("save-form").addEventListener("submit", async (event) => {
    event.preventDefault();
    const button = event.submitter ?? byId("save-form").querySelector("[type=submit]");
    button.disabled = true;
    byId("save-trouble").replaceChildren();
    try {
      saved(await send(body(talk())));
      byId("save-dialog").close();
    } catch (error) {
      const note = document.createElement("p");
      Object.assign(note, { className: "errornote", textContent: error.message });
      byId("save-trouble").replaceChildren(note);
      note.scrollIntoView({ block: "nearest" });
    } finally {
      button.disabled = false;
    }
  });
}

function open({ turns }) {
  if (!turns.length) return;
  byId("save-trouble").replaceChildren();
  byId("save-turns").replaceChildren(...turns.map(turnNode));
  byId("save-dialog").showModal();
}

function turnNode(turn) {
  const node = byId("keep-template").content.cloneNode(true).firstElementChild;
  node.querySelector('[data-slot="heard"]').textContent = turn.heard;
  node.querySelector('[data-slot="reply"]').textContent = turn.reply || turn.plan;
  const kind = node.querySelector("select");
  kind.addEventListener("change", () => {
    const proposed = byDefault[kind.value];
    node.querySelector(".save-value").hidden = !proposed;
    if (proposed) node.querySelector("input").value = proposed(turn);
  });
  return node;
}

function body({ talk, turns }) {
  const chosen = [...byId("save-turns").children];
  return {
    talk,
    title: byId("save-name").value,
    note: byId("save-note").value,
    turns: turns.map(({ heard, reply, plan }, place) => ({
      heard,
      reply,
      plan,
      kind: chosen[place].querySelector("select").value,
      value: chosen[place].querySelector("input").value,
    })),
  };
}

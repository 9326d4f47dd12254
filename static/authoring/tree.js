// The tree browser: keys and pointer, levels and the panel fetched as they are opened, search.
import { watchDragging } from "./tree_drag.js";

const tree = document.getElementById("tree");
const told = document.getElementById("tree-told");
const form = document.getElementById("tree-search");

async function fetched(address) {
  const response = await fetch(address, { credentials: "same-origin" });
  if (!response.ok || response.redirected) throw new Error(String(response.status));
  return response.text();
}

if (form) searchAsOneTypes();
if (tree) browse();

function searchAsOneTypes() {
  const hits = document.getElementById("tree-hits");
  const field = form.elements.q;
  let waiting = 0;
  let last = 0;
  field.addEventListener("input", () => {
    clearTimeout(waiting);
    waiting = setTimeout(find, 250);
  });
  // Words typed while this page was still loading, or put back by the browser.
  if (field.value !== field.defaultValue) find();
  async function find() {
    const mine = (last += 1);
    const asked = new URLSearchParams(new FormData(form));
    try {
      const html = await fetched(`${form.dataset.found}?${asked}`);
      if (mine !== last) return;
      hits.innerHTML = html;
      told.textContent = hits.querySelector(".told")?.textContent ?? "";
    } catch {
      told.textContent = form.dataset.trouble;
    }
  }
}

function browse() {
  const panel = document.getElementById("tree-panel");
  let typed = "";
  let typedAt = 0;
  let asked = "";

  const all = () => [...tree.querySelectorAll('[role="treeitem"]')].filter(isShown);
  const isShown = (node) => node.closest("ul[hidden]") === null;
  const below = (node) => node.parentElement.querySelector(":scope > ul");
  const above = (node) => node.parentElement.parentElement.parentElement.querySelector(":scope > a");
  const named = (node) => node.querySelector(".tree-name").textContent.trim();
  const address = (name, key) => tree.dataset[name].replace("KEY", encodeURIComponent(key));

  function focus(node) {
    if (!node) return;
    for (const other of tree.querySelectorAll('[tabindex="0"]')) other.tabIndex = -1;
    node.tabIndex = 0;
    node.focus();
  }

  function prepare(nodes) {
    for (const node of nodes) node.tabIndex = -1;
  }

  async function open(node) {
    if (node.getAttribute("aria-expanded") !== "false" || node.classList.contains("busy")) return;
    let group = below(node);
    if (!group) {
      node.classList.add("busy");
      told.textContent = tree.dataset.fetching;
      try {
        const html = await fetched(address("below", node.dataset.key));
        group = document.createElement("ul");
        group.setAttribute("role", "group");
        group.id = `g-${node.dataset.number}`;
        group.innerHTML = html;
        node.after(group);
        node.setAttribute("aria-owns", group.id);
        prepare(group.querySelectorAll('[role="treeitem"]'));
        told.textContent = "";
      } catch {
        told.textContent = tree.dataset.trouble;
        told.classList.remove("visually-hidden");
        return;
      } finally {
        node.classList.remove("busy");
      }
    }
    group.hidden = false;
    node.setAttribute("aria-expanded", "true");
  }

  function close(node) {
    if (node.getAttribute("aria-expanded") !== "true") return;
    if (below(node).contains(document.activeElement)) focus(node);
    below(node).hidden = true;
    node.setAttribute("aria-expanded", "false");
  }

  async function select(node) {
    for (const other of tree.querySelectorAll('[aria-selected="true"]')) {
      other.setAttribute("aria-selected", "false");
      other.removeAttribute("aria-current");
    }
    node.setAttribute("aria-selected", "true");
    node.setAttribute("aria-current", "true");
    const key = (asked = node.dataset.key);
    history.replaceState(null, "", `${tree.dataset.page}?open=${encodeURIComponent(key)}`);
    try {
      const html = await fetched(address("panel", key));
      if (asked === key) panel.innerHTML = html;
    } catch {
      panel.textContent = tree.dataset.trouble;
    }
  }

  function seek(letter) {
    const now = Date.now();
    typed = now - typedAt < 700 ? typed + letter : letter;
    typedAt = now;
    const nodes = all();
    const here = nodes.indexOf(document.activeElement);
    const from = typed.length > 1 ? here : here + 1;
    const turned = [...nodes.slice(from), ...nodes.slice(0, from)];
    const wanted = typed.toLocaleLowerCase();
    focus(turned.find((node) => named(node).toLocaleLowerCase().startsWith(wanted)));
  }

  const keys = {
    ArrowDown: (node) => focus(all()[all().indexOf(node) + 1]),
    ArrowUp: (node) => focus(all()[all().indexOf(node) - 1]),
    ArrowRight: (node) => {
      if (node.getAttribute("aria-expanded") === "true") focus(below(node).querySelector("a"));
      else open(node);
    },
    ArrowLeft: (node) => {
      if (node.getAttribute("aria-expanded") === "true") close(node);
      else focus(above(node));
    },
    Home: () => focus(all()[0]),
    End: () => focus(all().at(-1)),
    Enter: select,
    " ": select,
    "*": (node) => {
      for (const one of node.parentElement.parentElement.children) open(one.querySelector("a"));
    },
  };

  tree.addEventListener("keydown", (event) => {
    const node = event.target.closest('[role="treeitem"]');
    if (!node || event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return;
    if (keys[event.key]) keys[event.key](node);
    else if (event.key.length === 1) seek(event.key);
    else return;
    event.preventDefault();
  });

  tree.addEventListener("click", (event) => {
    const node = event.target.closest('[role="treeitem"]');
    if (!node || event.ctrlKey || event.metaKey || event.shiftKey || event.button) return;
    event.preventDefault();
    focus(node);
    if (event.target.closest(".twist")) {
      if (node.getAttribute("aria-expanded") === "true") close(node);
      else open(node);
      return;
    }
    select(node);
    open(node);
  });

  prepare(all());
  const selected = tree.querySelector('[aria-selected="true"]');
  const first = selected ?? all()[0];
  if (first) first.tabIndex = 0;
  selected?.scrollIntoView({ block: "center" });
  if (tree.dataset.move) watchDragging(tree, { open, address });
}

// Dragging a topic onto its new place: by mouse from anywhere on it, by touch or pen by its handle.
const FAR = 6;
const EDGE = 60;
const OPENS_AFTER = 700;

export function watchDragging(tree, { open, address }) {
  const root = document.getElementById("drop-root");
  let drag = null;
  let justDropped = false;

  tree.addEventListener("pointerdown", (event) => {
    const node = event.target.closest('[role="treeitem"]');
    const byHandle = event.target.closest(".handle");
    if (!node || event.button || (event.pointerType !== "mouse" && !byHandle)) return;
    drag = { node, x: event.clientX, y: event.clientY, begun: false, target: null, opens: 0 };
    addEventListener("pointermove", onMove);
    addEventListener("pointerup", onUp);
    addEventListener("pointercancel", end);
    addEventListener("keydown", onKey, true);
  });
  tree.addEventListener("dragstart", (event) => event.preventDefault());
  tree.addEventListener(
    "click",
    (event) => {
      if (!justDropped) return;
      justDropped = false;
      event.preventDefault();
      event.stopImmediatePropagation();
    },
    true,
  );

  function begin() {
    drag.begun = true;
    drag.node.classList.add("dragged");
    document.body.classList.add("dragging");
    if (drag.node.getAttribute("aria-level") !== "1") root.hidden = false;
    drag.told = document.createElement("div");
    drag.told.className = "drag-told";
    const name = drag.node.querySelector(".tree-name").textContent;
    drag.told.textContent = tree.dataset.dragging.replace("%s", name);
    document.body.append(drag.told);
  }

  function onMove(event) {
    if (!drag.begun) {
      if (Math.hypot(event.clientX - drag.x, event.clientY - drag.y) < FAR) return;
      begin();
    }
    drag.told.style.left = `${Math.min(event.clientX + 14, innerWidth - 260)}px`;
    drag.told.style.top = `${event.clientY + 14}px`;
    if (event.clientY < EDGE) scrollBy(0, -12);
    if (event.clientY > innerHeight - EDGE) scrollBy(0, 12);
    aim(under(event));
  }

  function under(event) {
    const found = document.elementFromPoint(event.clientX, event.clientY);
    const place = found?.closest('#drop-root, #tree [role="treeitem"]');
    if (!place || place === drag.node || drag.node.parentElement.contains(place)) return null;
    return place;
  }

  function aim(place) {
    if (place === drag.target) return;
    drag.target?.classList.remove("target");
    clearTimeout(drag.opens);
    drag.target = place;
    place?.classList.add("target");
    if (place && place !== root) drag.opens = setTimeout(() => open(place), OPENS_AFTER);
  }

  function onKey(event) {
    if (event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    end();
  }

  function onUp(event) {
    const { begun, node } = drag;
    if (begun) aim(under(event));
    const target = drag.target;
    if (begun) {
      justDropped = true;
      setTimeout(() => (justDropped = false), 0);
    }
    end();
    if (!begun || !target) return;
    const to = target === root ? "-" : target.dataset.key;
    location.assign(`${address("move", node.dataset.key)}?to=${encodeURIComponent(to)}`);
  }

  function end() {
    aim(null);
    drag.told?.remove();
    drag.node.classList.remove("dragged");
    document.body.classList.remove("dragging");
    if (root) root.hidden = true;
    drag = null;
    removeEventListener("pointermove", onMove);
    removeEventListener("pointerup", onUp);
    removeEventListener("pointercancel", end);
    removeEventListener("keydown", onKey, true);
  }
}

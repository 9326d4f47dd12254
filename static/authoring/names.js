// Names for what the stock widgets of the admin leave nameless to screen readers.
const $ = window.django?.jQuery;

function nameSelect(select) {
  const box = select.nextElementSibling?.querySelector(".select2-selection");
  const label = select.labels[0];
  const name = label?.textContent.replace(/:\s*$/, "").trim() || select.ariaLabel || column(select);
  if (!box || !name) return;
  const shown = box.querySelector(".select2-selection__rendered");
  box.setAttribute("aria-label", name);
  shown?.setAttribute("aria-label", name);
  if (box.matches("[aria-labelledby]") && label && shown) {
    label.id ||= `${select.id}-label`;
    box.setAttribute("aria-labelledby", `${label.id} ${shown.id}`);
  }
  box.querySelector(".select2-search__field")?.setAttribute("aria-label", name);
}

// In a table of rows the name stands at the head of the column.
function column(select) {
  const cell = select.closest("td");
  const head = cell?.closest("table")?.tHead?.rows[0];
  const place = [...(cell?.parentElement.cells ?? [])].indexOf(cell);
  return head?.cells[place]?.textContent.trim() ?? "";
}

function nameAll() {
  document.querySelectorAll("select.admin-autocomplete").forEach(nameSelect);
  document
    .querySelectorAll(".help-tooltip[aria-label]:not([role])")
    .forEach((one) => one.setAttribute("role", "img"));
}

if (document.readyState === "complete") nameAll();
else addEventListener("load", () => setTimeout(nameAll));
document.addEventListener("formset:added", () => setTimeout(nameAll));
$?.(document).on("select2:open", (event) => {
  const select = event.target;
  const name = select.labels[0]?.textContent.replace(/:\s*$/, "").trim() || column(select);
  const field = document.querySelector(".select2-dropdown .select2-search__field");
  if (name) field?.setAttribute("aria-label", name);
});

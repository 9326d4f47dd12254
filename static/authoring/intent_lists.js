// Value lists: one more row when the last is used up.
addEventListener("DOMContentLoaded", () => {
  for (const button of document.querySelectorAll("[data-more]")) {
    button.hidden = false;
    button.addEventListener("click", () => {
      const body = button.parentElement.querySelector("tbody");
      const name = button.parentElement.querySelector("table").dataset.name;
      const row = body.lastElementChild.cloneNode(true);
      for (const field of row.querySelectorAll("input, textarea")) {
        field.value = "";
        field.name = field.name.replace(/^(.*)_\d+_(\w+)$/, (_all, _name, rest) => `${name}_${body.children.length}_${rest}`);
      }
      body.append(row);
      row.querySelector("input").focus();
    });
  }
});

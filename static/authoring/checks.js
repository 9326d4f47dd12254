// Checking takes a few seconds: say so, and send the form once only. Filters act when chosen.
for (const form of document.querySelectorAll("form[data-busy]")) {
  form.addEventListener("submit", () => {
    form.querySelector("button").disabled = true;
    form.querySelector("[data-live]").textContent = form.dataset.busy;
  });
}

// A page that comes back from the browser's memory can be sent again.
addEventListener("pageshow", () => {
  for (const form of document.querySelectorAll("form[data-busy]")) {
    form.querySelector("button").disabled = false;
    form.querySelector("[data-live]").textContent = "";
  }
});

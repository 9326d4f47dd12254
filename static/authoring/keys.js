// Copies the new key, where the browser lets us.
const button = document.getElementById("key-copy");
const told = document.getElementById("key-told");

if (button && navigator.clipboard) {
  button.hidden = false;
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(document.getElementById("key-text").textContent);
      told.textContent = button.dataset.copied;
    } catch {
      told.textContent = button.dataset.failed;
    }
  });
}

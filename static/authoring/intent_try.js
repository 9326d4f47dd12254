// The page "Try a sentence": answers without loading the page anew.
const form = document.getElementById("try-form");
const box = document.getElementById("try-answer");

form.addEventListener("submit", async (event) => {
  event.preventDefault();
  try {
    const answer = await fetch(form.dataset.try, { method: "POST", body: new FormData(form), credentials: "same-origin" });
    if (!answer.ok) throw new Error(String(answer.status));
    box.innerHTML = (await answer.json()).html;
  } catch {
    box.textContent = form.dataset.broken;
  }
  form.elements.sentence.select();
});

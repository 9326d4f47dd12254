// Sliders beside the numbers of likeliness, and what a number means in words.
export function startSliders() {
  const data = document.getElementById("liking-steps");
  const steps = data ? JSON.parse(data.textContent) || [] : [];
  for (const slider of document.querySelectorAll(".slider[data-for]")) {
    const number = document.getElementById(slider.dataset.for);
    if (!number) continue;
    const words = slider.closest(".liking").querySelector(".liking-words");
    const tell = () => {
      const value = Number.parseFloat(number.value);
      const step = steps.find((one) => value < one.below);
      words.textContent = step && value >= 0 ? step.words[0].toUpperCase() + step.words.slice(1) : "";
      slider.setAttribute("aria-valuetext", `${number.value} ${words.textContent}`);
    };
    slider.hidden = false;
    slider.value = number.value;
    slider.addEventListener("input", () => {
      number.value = slider.value;
      tell();
    });
    number.addEventListener("input", () => {
      slider.value = number.value;
      tell();
    });
    tell();
  }
}

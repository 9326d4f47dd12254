// The list of intents: how many stored tests of each fail.
const words = document.getElementById("intent-list-script").dataset;
const badges = [...document.querySelectorAll("[data-tests-of]")];

if (badges.length) {
  const answer = await fetch(words.url, { credentials: "same-origin" });
  const failing = answer.ok ? (await answer.json()).failing : {};
  for (const badge of badges) {
    const number = failing[badge.dataset.testsOf];
    badge.className = number === undefined ? "quiet" : `badge ${number ? "bad" : "good"}`;
    badge.textContent = number === undefined ? words.none : number ? `✗ ${words.failing}${number}` : `✓ ${words.passed}`;
  }
}

// Sections become tabs; without this script they stand one below the other.
export function startTabs(opened) {
  const row = document.querySelector(".tab-row");
  if (!row) return;
  const tabs = [...row.querySelectorAll("a")];
  const sections = tabs.map((tab) => document.getElementById(tab.hash.slice(1)));
  row.setAttribute("role", "tablist");
  tabs.forEach((tab, place) => dress(tab, sections[place], row.parentElement.dataset.wrong));

  function choose(place, focus) {
    tabs.forEach((tab, other) => {
      tab.setAttribute("aria-selected", String(other === place));
      tab.tabIndex = other === place ? 0 : -1;
      sections[other].hidden = other !== place;
    });
    const inForm = Boolean(sections[place].closest("form"));
    for (const buttons of document.querySelectorAll(".submit-row")) buttons.hidden = !inForm;
    if (focus) tabs[place].focus();
    opened(sections[place]);
  }

  tabs.forEach((tab, place) => {
    tab.addEventListener("click", (event) => {
      event.preventDefault();
      choose(place, true);
      history.replaceState(null, "", tab.hash);
    });
    tab.addEventListener("keydown", (event) => {
      const count = tabs.length;
      const to = {
        ArrowRight: (place + 1) % count,
        ArrowLeft: (place - 1 + count) % count,
        Home: 0,
        End: count - 1,
      };
      if (!(event.key in to)) return;
      event.preventDefault();
      choose(to[event.key], true);
    });
  });

  choose(firstPlace(sections), false);
  const target = location.hash && document.getElementById(location.hash.slice(1));
  if (target && !sections.includes(target)) target.scrollIntoView({ block: "center" });
}

// What is wrong comes first, then what the address names.
function firstPlace(sections) {
  const wrong = sections.findIndex((section) => section.querySelector(".errorlist"));
  if (wrong >= 0) return wrong;
  const target = location.hash && document.getElementById(location.hash.slice(1));
  const named = target ? sections.findIndex((section) => section.contains(target)) : -1;
  return Math.max(named, 0);
}

function dress(tab, section, word) {
  tab.setAttribute("role", "tab");
  tab.setAttribute("aria-controls", section.id);
  section.setAttribute("role", "tabpanel");
  section.setAttribute("aria-labelledby", tab.id);
  section.tabIndex = 0;
  const wrong = section.querySelectorAll(".errorlist").length;
  if (wrong) {
    const badge = document.createElement("span");
    badge.className = "badge bad";
    badge.textContent = `${wrong} ${word}`;
    tab.append(badge);
  }
}

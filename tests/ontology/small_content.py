# ruff: noqa: E501 - one line a leaf is the format
"""A small content folder: drinks that people love, one intent, a line in every pool."""

from pathlib import Path

from dialogue.engine.pools import POOLS

CULTURES = """\
cultures:
- {code: EN, language: en, names: {en: English, it: inglese, ja: イギリス}}
- {code: JP, language: ja, names: {en: Japanese, it: giapponese, ja: 日本}}
"""

DRINK = """\
classes:
- id: Drink
  is_a: Topic
  pattern: "q r w c [g] | c q r"
  vars: {en.unit: a cup of, it.unit: una tazza di}
  en: {name: drinks, n: p, bare: drink}
  it: {name: bevande, g: f, n: p, sg: bevanda}
  ja: {name: 飲み物, kana: のみもの}
  kw: {en: drink|beverage / *, it: bevanda|bere / *, ja: 飲み物 / *}
  s:
    q1:
      en: Do you like $hasName?
      it: Ti {piace|piacciono} $hasName?
      ja: $hasNameはお好きですか？
    p1:
      scope: below
      en: Lovely. There is always a good moment for $unit $hasName.bare.
      it: Bello! Ci sta sempre bene $unit $hasName.bare.
      ja: いいですね。$hasNameを一杯いただくと、ほっとします。
    g1:
      do: playsong title=$hasName.bare
      en: Shall I play a song about $hasName?
      it: Vuoi sentire una canzone $hasName.su?
      ja: $hasNameの歌をおかけしましょうか？
- id: Tea
  is_a: Drink
  en: {name: tea, count: no}
  it: {name: tè, g: m}
  ja: {name: お茶, kana: おちゃ}
  kw: {en: tea|cuppa / *, it: tè / *, ja: お茶 / *}
leaves:
- {id: Milk, is_a: Drink, en: {name: milk, count: no}, it: {name: latte, g: m}, ja: {name: 牛乳, kana: ぎゅうにゅう}, kw: {en: milk / *, it: latte / *, ja: 牛乳 / *}, see: [Tea]}
- {id: GreenTea, is_a: Tea, of: JP, en: {name: green tea, count: no}, it: {name: tè verde, g: m}, ja: {name: 緑茶, kana: りょくちゃ}, kw: {en: green / ^, it: verde / ^, ja: 緑茶 / *}, like: EN .4, see: [Milk], note: "Checked: by Aiko"}
lines:
- {at: GreenTea, id: c1, only: [JP], en: "In Japan, visitors are often served green tea.", it: In Giappone agli ospiti si offre spesso tè verde., ja: 日本では、お客様に緑茶をお出しすることが多いですね。}
"""

FLOWER = """\
leaves:
- {id: Flower, is_a: Topic, gentle: yes, stop: [q, g], en: {name: flowers, n: p, bare: flower}, it: {name: fiori, g: m, n: p, sg: fiore}, ja: {name: 花, kana: はな}, kw: {en: flower / *, it: fiore / *, ja: 花 / *}, see: [Drink]}
"""

INTENTS = """\
phrases:
- {id: really, en: really|truly, it: davvero}
values:
- id: volume_level
  en: {louder: louder|up, quieter: quieter|down}
  it: {louder: più forte, quieter: più piano}
  ja: {louder: 大きく, quieter: 小さく}
intents:
- id: playsong
  priority: 50
  slots: {title: text required}
  ask: {title: {en: "Which song?", it: "Quale canzone?", ja: どの曲ですか？}}
  plan: "#action=playsong title={title}"
  note: The song of Mrs Smith.
  en:
    can: play a song
    triggers:
    - (play|put on) [the song] {title}
    says:
    - Let us listen to {title}.
    - {only: [EN], text: Here comes your song.}
    tests:
    - Play Hey Brother -> title=Hey Brother
    - I like tea -> no
  it:
    triggers:
    - metti la canzone {title}
    says:
    - Ascoltiamo {title}.
  ja:
    triggers:
    - "{title}をかけて"
    says:
    - では、おかけします。
"""


def _pools() -> str:
    lines = ["pools:"]
    for pool in POOLS.values():
        names = "".join(f" ${name}" for name in sorted(pool.variables))
        lines += [f"- id: {pool.name}", "  s:", "    1:"]
        lines += [f"      {code}: Well{names}." for code in ("en", "it")]
        lines += [f"      ja: さて{names}。"]
    return "\n".join(lines) + "\n"


FILES = {
    "cultures.yaml": CULTURES,
    "drink.yaml": DRINK,
    "flower.yaml": FLOWER,
    "intents.yaml": INTENTS,
    "pools.yaml": _pools(),
}


def write_files(path: Path, **changed: str) -> Path:
    """Write the folder; `drink=…` gives another text for drink.yaml, or "" leaves it out."""
    for name, text in (FILES | {f"{stem}.yaml": text for stem, text in changed.items()}).items():
        if text:
            (path / name).write_text(text, encoding="utf-8")
    return path

/* What is done to a sentence of the robot before it is shown or spoken. */

const NAME = "\\$(?:name|desspk|prevspk)(?![A-Za-z0-9_])(?:さん|様|さま|ちゃん|くん|君)?";
const COMMA = "[,、，]";
const BETWEEN_COMMAS = new RegExp(`${COMMA}\\s*${NAME}\\s*(?=${COMMA})`, "gu");
const JAPANESE_SUBJECT = new RegExp(`(^|[。！？!?、，]\\s*)${NAME}(?:に?は|も|の|が)${COMMA}?`, "gu");
const AT_THE_BEGINNING = new RegExp(`(^|[.!?…。！？]\\s*)${NAME}\\s*[,、，!！]?\\s*(\\p{L}?)`, "gu");
const ANYWHERE = new RegExp(`\\s*${COMMA}?\\s*${NAME}`, "gu");

/** Drop the client's placeholders with their comma: "Hello, $name!" is "Hello!" here, where nobody has a name. */
export function withoutName(sentence) {
  if (!sentence.includes("$")) return sentence;
  return sentence
    .replace(BETWEEN_COMMAS, "")
    .replace(JAPANESE_SUBJECT, "$1")
    .replace(AT_THE_BEGINNING, (_whole, before, letter) => before + letter.toUpperCase())
    .replace(ANYWHERE, "")
    .replace(/ {2,}/g, " ")
    .trim();
}

/** Split a text into sentences: browsers cut long speech off, short pieces they finish. */
export function sentencesOf(text) {
  return (text.match(/[^.!?…。！？]+[.!?…。！？]*[)」』"”»]*\s*/gu) ?? []).map((part) => part.trim()).filter(Boolean);
}

/** Yarn counts as mills write them, in tex; see `src/loomlight/weave/textile.py`. */
import { InputError } from "./errors.ts";

const NUMBER = "([0-9]{1,12}(?:[.,][0-9]{1,12})?)";
const WHOLE = "([0-9]{1,12})";
const FILAMENTS = `(?: ?(/|/? ?f) ?${WHOLE} ?(f?))?`;
const whole = (pattern: string): RegExp => new RegExp(`^(?:${pattern})$`);
const DIRECT = whole(
  `${NUMBER}(?: ?[x×] ?${NUMBER})?${FILAMENTS} ?(dtex|tex|ktex|denier|den|d)${FILAMENTS}(?: ?[x×] ?${WHOLE})?`,
);
const UNIT_FIRST = whole(`(nec|ne|nm) ?${NUMBER}(?: ?/ ?${WHOLE})?`);
const NE_LAST = whole(`${NUMBER}(?: ?/ ?${WHOLE})? ?(?:nec|ne)`);
const NM_LAST = whole(`(?:${WHOLE} ?/ ?)?${NUMBER} ?nm`);
/** The s stands with the count, so plies come before the count or after the s. */
const PLIES_BEFORE_S = whole(`${WHOLE} ?/ ?${NUMBER} ?s`);
const PLIES_AFTER_S = whole(`${NUMBER} ?s(?: ?/ ?${WHOLE})?`);
const UNITLESS = whole(`${NUMBER}(?: ?/ ?[0-9]{1,12})?`);

const TEX_PER: Readonly<Record<string, number>> = { tex: 1, dtex: 0.1, ktex: 1000, denier: 1 / 9, den: 1 / 9, d: 1 / 9 };
/** Ne counts hanks of 840 yd a pound, Nm kilometres a kilogram. */
const TEX_OF_COUNT = { Ne: (1000 * 453.59237) / (840 * 0.9144), Nm: 1000 } as const;
/** Cords have more, but far more often the numbers were swapped. */
const MAX_PLIES = 12;
/** So few filaments after a slash may also be plies. */
const MIN_FILAMENTS = 5;

/**
 * Linear density in tex (g/km) of a yarn count: "30 tex", "2x20 tex", "75/36 dtex", "150 denier"; unit first "Ne 40/2",
 * "Nm 28/2"; unit last "40/2 Ne" (count/plies), "2/28 Nm" (plies/count); "20s", "40s/2" and "2/40s" are cotton counts.
 *
 * @throws InputError none of these, more than 12 plies, or a count outside 0.1 to 100 000 tex.
 *
 * Source: ISO 1144 (tex system); ISO 2947 (conversion); ISO 1139 (designation of plies and filaments).
 */
export function yarnTex(count: string): number {
  const said = `The yarn count "${count.trim().slice(0, 40)}"`;
  const text = count.toLowerCase().trim().split(/\s+/).join(" ");
  const tex = directTex(text, said) ?? indirectTex(text, said);
  if (tex === null) throw new InputError(`${said} ${advice(text)}`);
  if (!(0.1 <= tex && tex <= 100_000))
    throw new InputError(`${said} is ${tex < 0.1 ? "below 0.1" : "above 100000"} tex; yarns have 0.1 to 100000 tex.`);
  return tex;
}

/** Tex of a count in tex, dtex, ktex or denier; null of another text. */
function directTex(text: string, said: string): number | null {
  const match = DIRECT.exec(text);
  if (match === null) return null;
  const [, first, second, , , , unit, , , , third] = match;
  const [sign, filaments, f] = match[4] === undefined ? match.slice(7, 10) : match.slice(3, 6);
  if (sign === "/" && !f && 1 < Number(filaments) && Number(filaments) < MIN_FILAMENTS)
    throw new InputError(
      `${said} may mean ${filaments} plies or ${filaments} filaments; ` +
        `write "${filaments}x${first} ${unit}" or "${first}f${filaments} ${unit}".`,
    );
  return numberOf(first!) * numberOf(second ?? "1") * numberOf(third ?? "1") * TEX_PER[unit!]!;
}

/** Tex of a count in Ne or Nm, in whichever order it is written; null of another text. */
function indirectTex(text: string, said: string): number | null {
  const found = indirectOf(text);
  if (found === null || numberOf(found.single) === 0) return null;
  const { unit, single, plies } = found;
  if (!(1 <= Number(plies) && Number(plies) <= MAX_PLIES)) {
    const isSwapped = Number(plies) > 0 && /^[0-9]+$/.test(single) && Number(single) <= MAX_PLIES;
    const meant = isSwapped ? `; for ${single} plies of ${unit} ${plies} write "${unit} ${plies}/${single}"` : "";
    throw new InputError(`${said} is ${plies} plies of ${unit} ${single}; yarns have 1 to ${MAX_PLIES} plies${meant}.`);
  }
  return (TEX_OF_COUNT[unit] / numberOf(single)) * Number(plies);
}

interface Indirect {
  readonly unit: "Ne" | "Nm";
  /** The count of a single yarn, and how many are twisted together, as they are written. */
  readonly single: string;
  readonly plies: string;
}

function indirectOf(text: string): Indirect | null {
  const first = UNIT_FIRST.exec(text);
  if (first !== null) return { unit: first[1] === "nm" ? "Nm" : "Ne", single: first[2]!, plies: first[3] ?? "1" };
  const cotton = NE_LAST.exec(text) ?? PLIES_AFTER_S.exec(text);
  if (cotton !== null) return { unit: "Ne", single: cotton[1]!, plies: cotton[2] ?? "1" };
  const metric = NM_LAST.exec(text);
  if (metric !== null) return { unit: "Nm", single: metric[2]!, plies: metric[1] ?? "1" };
  const folded = PLIES_BEFORE_S.exec(text);
  return folded === null ? null : { unit: "Ne", single: folded[2]!, plies: folded[1]! };
}

/** The end of the sentence about a text that is no count: what would be right. */
function advice(text: string): string {
  const number = UNITLESS.exec(text)?.[1];
  if (number !== undefined) return `has no unit; write "${number} tex", "${number} den", "Ne ${number}" or "Nm ${number}".`;
  return 'is not known; write it like "30 tex", "150 den", "75/36 dtex", "20s", "Ne 40/2" or "2/28 Nm".';
}

function numberOf(text: string): number {
  return Number(text.replace(",", "."));
}

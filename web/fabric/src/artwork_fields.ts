/** [weaves] and [artwork] of a fabric file: what they may say; see `fabric/fields.py` and `weave/bitmaps.py`. */
import { MAXIMUM_THREADS } from "./draft.ts";
import { InputError } from "./errors.ts";
import type { ArtworkWeaves } from "./fields.ts";
import { MAX_COLOURS, MAX_WEFTS } from "./generated.ts";

const HEX = /^#(?:[0-9a-f]{3}|[0-9a-f]{6})$/;
/** "2", or "40x2" for a run. */
const RUN = /^(?:([0-9]{1,5})[x×])?([0-9]{1,2})$/i;

/** The colour "#rrggbb" in small letters of one that is written with three digits or in capitals. */
export function plainHex(colour: string): string {
  const text = colour.trim().toLowerCase();
  return text.length === 4 ? `#${[...text.slice(1)].map((digit) => digit + digit).join("")}` : text;
}

/** Names of weaves by colour, "#rrggbb" in small letters, one a weft. */
export function weaveLists(weaves: ArtworkWeaves): ReadonlyMap<string, readonly string[]> {
  return new Map(Object.entries(weaves).map(([colour, given]) => [plainHex(colour), typeof given === "string" ? [given] : given]));
}

/**
 * Weaves by colour, each a text or a list of as many texts as there are wefts.
 *
 * @throws InputError anything else; the message names the colour.
 */
export function requireWeaves(weaves: Readonly<Record<string, unknown>>, name: string): ArtworkWeaves {
  const count = Object.keys(weaves).length;
  if (count > MAX_COLOURS) throw new InputError(`${name} has ${count} colours; an artwork has at most ${MAX_COLOURS}.`);
  const wefts = new Map<string, number>();
  for (const [colour, given] of Object.entries(weaves)) {
    const place = `${name}."${colour.slice(0, 40)}"`;
    if (!HEX.test(colour.trim().toLowerCase())) throw new InputError(`${place} is no colour of a picture: write it as "#c00000".`);
    if (wefts.has(plainHex(colour))) throw new InputError(`${place} is there twice: keep one of them.`);
    const listed: readonly unknown[] = Array.isArray(given) ? given : [given];
    if (listed.length < 1 || listed.length > MAX_WEFTS)
      throw new InputError(`${place} lists ${listed.length} weaves, one a weft; 1 to ${MAX_WEFTS} wefts can be woven.`);
    if (!listed.every((weave) => typeof weave === "string" && weave.trim() !== ""))
      throw new InputError(`${place} names no weave: write one in quotes, "satin 8/3", or a list of one a weft.`);
    const [first, number] = [...wefts][0] ?? [plainHex(colour), listed.length];
    if (listed.length !== number)
      throw new InputError(`${place} has ${listed.length} weaves and "${first}" ${number}: each colour has one a weft.`);
    wefts.set(plainHex(colour), listed.length);
  }
  return weaves as ArtworkWeaves;
}

/**
 * The 1-based wefts of the picks of a row, from text such as "1 1 2" or "40x1 2"; commas do as well as spaces.
 *
 * @throws InputError anything else, or more than 16384 picks.
 */
export function weftOrder(text: string, field: string): number[] {
  const order: number[] = [];
  for (const part of text.replaceAll(",", " ").split(/\s+/).filter((word) => word !== "")) {
    const [, times = "1", weft = "0"] = RUN.exec(part) ?? [];
    if (Number(times) < 1 || Number(weft) < 1 || Number(weft) > MAX_WEFTS)
      throw new InputError(
        `${field} "${text.slice(0, 60)}" is not understood: write the numbers of wefts, 1 to ${MAX_WEFTS}, in the ` +
          "order of picks, such as 1 1 2, or 40x1 2 for runs.",
      );
    if (order.length + Number(times) > MAXIMUM_THREADS)
      throw new InputError(`${field} has more than ${MAXIMUM_THREADS} picks, which no repeat may have.`);
    for (let pick = 0; pick < Number(times); pick++) order.push(Number(weft));
  }
  if (order.length === 0)
    throw new InputError(`${field} "" is empty: write the numbers of wefts in the order of picks, as 1 1 2.`);
  return order;
}

/** An order of wefts as text: "1 1 2", runs of three and more as "40x1 2". */
export function orderText(order: readonly number[]): string {
  const runs: [number, number][] = [];
  for (const weft of order) {
    const last = runs.at(-1);
    if (last !== undefined && last[1] === weft) last[0]++;
    else runs.push([1, weft]);
  }
  return runs.map(([count, weft]) => (count > 2 ? `${count}x${weft}` : Array<number>(count).fill(weft).join(" "))).join(" ");
}

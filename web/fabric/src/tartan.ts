/**
 * Tartan by its sett, in the notation of the Scottish Register of Tartans: "B/24 W4 B24 R2 K24 G24 W/2".
 *
 * Each stripe is a colour's letters and its threads. The first and last stripe are pivots, at which the order turns
 * back, and are written with "/" or without; "..." before or after the sett makes it repeat instead. Warp and weft have
 * the same order, in 2/2 twill.
 */
import type { Effect } from "./effects.ts";
import { lcm } from "./numbers.ts";
import { runs } from "./palette.ts";
import { MAXIMUM_NAMED_THREADS, twill } from "./structures.ts";

/** The register's letters in shades that are typical of it; each tartan of it states its own. */
const SHADES: Readonly<Record<string, string>> = {
  A: "#5c8ca8",
  B: "#2c2c80",
  DB: "#000064",
  LB: "#98c8e8",
  C: "#d05054",
  G: "#006818",
  DG: "#004028",
  LG: "#86c67c",
  K: "#101010",
  N: "#888888",
  DN: "#585858",
  LN: "#c8c8c8",
  O: "#d87c00",
  DO: "#b84c00",
  P: "#780078",
  DP: "#440044",
  LP: "#b468ac",
  R: "#c80000",
  DR: "#880000",
  LR: "#e87878",
  T: "#603800",
  DT: "#441800",
  LT: "#a08858",
  W: "#f8f8f8",
  Y: "#e8c000",
  DY: "#bc8c00",
  LY: "#f8e38c",
};
const STRIPE = /([a-z]+) ?(\/?) ?([0-9]+)/g;

/** The cloth of a sett in small letters, and its title; a text that says what is wrong where it is no sett. */
export function tartan(sett: string): { effect: Effect; title: string } | string {
  let text = sett.replaceAll("…", "...").replaceAll(",", " ").trim();
  const repeats = text.startsWith("...") || text.endsWith("...");
  text = text.replace(/^\.\.\./, "").replace(/\.\.\.$/, "").trim();
  const stripes = [...text.matchAll(STRIPE)].map((match) => [match[1]!.toUpperCase(), match[2]!, match[3]!] as const);
  const rest = text.replace(STRIPE, "").split(/\s+/).filter((word) => word !== "");
  if (rest.length > 0) return `"${rest[0]!.slice(0, 20)}" is no stripe`;
  if (stripes.length < 2) return "a sett has two or more stripes";
  for (const [letters, , count] of stripes) {
    if (!Object.hasOwn(SHADES, letters))
      return `${letters.slice(0, 20)} is none of the colours ${Object.keys(SHADES).join(", ")}`;
    if (count.length > 4 || Number(count) < 1 || Number(count) > MAXIMUM_NAMED_THREADS)
      return `${letters}${count.slice(0, 20)} is not a number of threads from 1 to ${MAXIMUM_NAMED_THREADS}`;
  }
  const isMarked = stripes.some(([, slash]) => slash !== "");
  if (stripes.slice(1, -1).some(([, slash]) => slash !== "") || (isMarked && repeats))
    return '"/" marks the first and last stripe of a sett that turns back there';
  const colours = [...new Set(stripes.map(([letters]) => letters))];
  const order = stripes.map(([letters, , count]): [number, number] => [colours.indexOf(letters), Number(count)]);
  const whole = repeats ? order : [...order, ...order.slice(1, -1).reverse()];
  const threads = lcm(4, whole.reduce((sum, [, count]) => sum + count, 0));
  if (threads > MAXIMUM_NAMED_THREADS)
    return `one repeat has ${threads} ends, and at most ${MAXIMUM_NAMED_THREADS} can be used`;
  const index = runs(...whole);
  const mark = repeats ? "..." : "";
  return {
    effect: {
      structure: twill([2, 2]),
      warpOrder: index,
      weftOrder: index,
      palette: colours.map((letters) => SHADES[letters]!),
    },
    title: `tartan ${mark}${stripes.map((stripe) => stripe.join("")).join(" ")}${mark}`,
  };
}

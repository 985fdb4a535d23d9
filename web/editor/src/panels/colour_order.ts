/** An order of colours as weavers write it: "4a 4b" is four threads of the first colour and four of the second. */
import { InputError, MAXIMUM_THREADS } from "loomlight-fabric";

/** Letters of palette colours; z stands for the colour that is painted with. */
const LETTERS = "abcdefghijklmnopqrstuvwxy";
/** Longer orders are shown by their beginning. */
const MAX = 400;

/** One repeat of the order of threads' colours; colours are lettered as they first occur. */
export function orderText(hexes: readonly string[]): string {
  const letters = lettersOf(hexes);
  const runs: [string, number][] = [];
  for (const hex of hexes.slice(0, periodOf(hexes))) {
    const last = runs.at(-1);
    if (last !== undefined && last[0] === hex) last[1]++;
    else runs.push([hex, 1]);
  }
  const text = runs.map(([hex, count]) => `${count}${letters.get(hex) ?? "z"}`).join(" ");
  return text.length > MAX ? `${text.slice(0, MAX)} …` : text;
}

/** The shortest order that makes all threads when it is repeated; all of them where they have one colour. */
function periodOf(hexes: readonly string[]): number {
  if (hexes.every((hex) => hex === hexes[0])) return hexes.length;
  const repeats = (period: number): boolean => hexes.every((hex, thread) => hex === hexes[thread % period]);
  let period = 1;
  while (hexes.length % period !== 0 || !repeats(period)) period++;
  return period;
}

function lettersOf(hexes: readonly string[]): Map<string, string> {
  const letters = new Map<string, string>();
  for (const hex of hexes) if (!letters.has(hex) && letters.size < LETTERS.length) letters.set(hex, LETTERS[letters.size]!);
  return letters;
}

/**
 * The colours of an order, whose letters are those of `orderText` for the same threads.
 *
 * @param brush the colour that z stands for.
 * @throws InputError no order, a letter without a colour, or too many threads.
 */
export function parseOrder(text: string, hexes: readonly string[], brush: string): string[] {
  const colours = new Map([...lettersOf(hexes)].map(([hex, letter]) => [letter, hex]));
  colours.set("z", brush);
  const order: string[] = [];
  const parts = text.toLowerCase().match(/\d*\s*[a-z]|\S+/g) ?? [];
  for (const part of parts) {
    const match = /^(\d*)\s*([a-z])$/.exec(part);
    const hex = match === null ? undefined : colours.get(match[2]!);
    if (match === null || hex === undefined)
      throw new InputError(`"${part}" is no run of threads: write a number and a letter of ${[...colours.keys()].join(", ")}.`);
    const count = match[1] === "" ? 1 : Number(match[1]);
    if (count < 1 || order.length + count > MAXIMUM_THREADS)
      throw new InputError(`"${part}" makes no order: it has 1 to ${MAXIMUM_THREADS} threads.`);
    for (let thread = 0; thread < count; thread++) order.push(hex);
  }
  if (order.length === 0) throw new InputError('Write an order such as "4a 4b".');
  return order;
}

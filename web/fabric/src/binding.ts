/** Binding points in floats that are too long, as where two structures of figured cloth meet; see `weave/binding.py`. */
import type { Structure } from "./draft.ts";
import { InputError } from "./errors.ts";

/** A float is halved each time; the longest of 16384 threads is as short as any limit after 14. */
const ROUNDS = 16;

/** One thread of a cloth: its crossings are `first + k·step` in the drawdown, k < count; it repeats. */
interface Line {
  readonly first: number;
  readonly step: number;
  readonly count: number;
}

const endLine = (cloth: Structure, end: number): Line => ({ first: end, step: cloth.ends, count: cloth.picks });
const pickLine = (cloth: Structure, pick: number): Line => ({ first: pick * cloth.ends, step: 1, count: cloth.ends });

/**
 * Adds binding points, in place, to floats longer than `limit` on either face.
 *
 * Each is put as near the middle of its float as it can be without making a float of the other family too long.
 *
 * @param loose [picks·ends], 1 where an extra weft lies free on the back of the cloth: no binding is put there, and
 *   floats of that weft that reach it stay as long as they are. Null for nowhere.
 * @throws InputError a float that no binding point can shorten.
 */
export function bindFloats(cloth: Structure, limit: number, loose: Uint8Array | null = null): void {
  const families = [
    { threads: cloth.ends, along: endLine, across: pickLine, isWeft: false },
    { threads: cloth.picks, along: pickLine, across: endLine, isWeft: true },
  ];
  for (let round = 0; round < ROUNDS; round++) {
    let count = 0;
    for (const { threads, along, across, isWeft } of families)
      for (let thread = 0; thread < threads; thread++) {
        const line = along(cloth, thread);
        for (const [start, length] of longFloats(cloth.drawdown, line, limit)) {
          if (isWeft && loose !== null && isLoose(cloth.drawdown, loose, line, start, length)) continue;
          count++;
          bind(cloth.drawdown, loose, line, start, length, (crossing) => isShort(cloth.drawdown, across(cloth, crossing), thread, limit));
        }
      }
    if (count === 0) return;
  }
  throw new InputError(`No binding keeps every float of the figure to ${limit} threads; allow longer ones.`);
}

/** Start and length of each run of equal crossings of a thread that is longer than `limit`. */
function longFloats(drawdown: Uint8Array, { first, step, count }: Line, limit: number): [number, number][] {
  if (count <= limit) return [];
  const found: [number, number][] = [];
  const take = (from: number, length: number): unknown => length > limit && found.push([from, length]);
  let [begin, start] = [-1, -1];
  let before = drawdown[first + (count - 1) * step]!;
  for (let index = 0, at = first; index < count; index++, at += step) {
    const value = drawdown[at]!;
    if (value === before) continue;
    if (start < 0) begin = index;
    else take(start, index - start);
    [start, before] = [index, value];
  }
  // The last one goes on around the edge, up to where the first change is.
  if (start < 0) take(0, count);
  else take(start, begin + count - start);
  return found;
}

/** Whether a float of a pick lies on the back and reaches where it is free. */
function isLoose(drawdown: Uint8Array, loose: Uint8Array, { first, count }: Line, start: number, length: number): boolean {
  if (drawdown[first + start] === 0) return false;
  for (let index = start; index < start + length; index++) if (loose[first + (index % count)] === 1) return true;
  return false;
}

/** Flips one crossing of a long float, unless `allows` refuses all. */
function bind(
  drawdown: Uint8Array,
  loose: Uint8Array | null,
  { first, step, count }: Line,
  start: number,
  length: number,
  allows: (crossing: number) => boolean,
): void {
  for (const index of fromMiddle(start + 1, start + length - 1, start + Math.floor(length / 2))) {
    const crossing = index % count;
    const at = first + crossing * step;
    if (loose?.[at] === 1) continue;
    drawdown[at] = 1 - drawdown[at]!;
    if (allows(crossing)) return;
    drawdown[at] = 1 - drawdown[at]!;
  }
}

/** The numbers from `first` to before `end`, those next to `middle` first, of two the smaller. */
function* fromMiddle(first: number, end: number, middle: number): Generator<number> {
  if (first <= middle && middle < end) yield middle;
  for (let away = 1; away <= Math.max(end - middle, middle - first); away++) {
    if (first <= middle - away && middle - away < end) yield middle - away;
    if (first <= middle + away && middle + away < end) yield middle + away;
  }
}

/** Whether the float of a thread that holds its crossing `at` is no longer than `limit`. */
function isShort(drawdown: Uint8Array, { first, step, count }: Line, at: number, limit: number): boolean {
  if (count <= limit) return true;
  const value = (index: number): number => drawdown[first + (index % count) * step]!;
  const here = value(at);
  let [after, before] = [1, 0];
  while (after <= limit && value(at + after) === here) after++;
  while (before < limit && value(at - before - 1 + count) === here) before++;
  return after + before <= limit;
}

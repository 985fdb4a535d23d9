/**
 * Weave structures as periodic matrices.
 *
 * Diagonals are named as they are drawn on the face, pick 1 at the bottom: Z rises to the right, S to the left.
 * The notation a/b counts along a pick from end 1: a ends up, then b ends down.
 */
import { gcd, modulo } from "./numbers.ts";
import { structureOf, type Structure } from "./draft.ts";

/** Ends, and picks, of a weave that is made from its name. */
export const MAXIMUM_NAMED_THREADS = 4096;

/** Plain weave, also called tabby: over one, under one. */
export function plain(): Structure {
  return structureOf(2, 2, (pick, end) => pick === end);
}

function upAndDown(parts: readonly number[]): boolean[] {
  return parts.flatMap((length, index) => Array<boolean>(length).fill(index % 2 === 0));
}

const sum = (parts: readonly number[]): number => parts.reduce((total, part) => total + part, 0);
const range = (count: number): number[] => Array.from({ length: count }, (_, index) => index);

/** A twill whose pick 1 goes up, down, up, down by `parts` (an even number of lengths ≥ 1). */
export function twill(parts: readonly number[], z = true): Structure {
  const order = range(sum(parts));
  return twillOf(order, order, parts, z);
}

/** A twill threaded and treadled in another order: entry (j, i) is entry (treadling[j], threading[i]) of the straight one. */
export function twillOf(
  threading: readonly number[],
  treadling: readonly number[],
  parts: readonly number[],
  z = true,
): Structure {
  const firstPick = upAndDown(parts);
  return structureOf(treadling.length, threading.length, (pick, end) => {
    const shift = z ? treadling[pick]! : -treadling[pick]!;
    return firstPick[modulo(threading[end]! - shift, firstPick.length)]!;
  });
}

/** The steps that make a regular satin: coprime with the ends, neither 1 nor ends − 1. */
export function satinSteps(ends: number): number[] {
  return range(Math.max(ends - 1, 0)).filter((step) => step >= 2 && gcd(step, ends) === 1);
}

/** The step whose binding points lie furthest apart; null if no regular satin has so many ends. */
export function spreadSatinStep(ends: number): number | null {
  let best: number | null = null;
  let furthest = -1;
  for (const step of satinSteps(ends)) {
    let nearest = Infinity;
    for (let rise = 1; rise < ends; rise++) {
      const half = Math.floor(ends / 2);
      const run = ((rise * step + half) % ends) - half;
      nearest = Math.min(nearest, Math.min(rise, ends - rise) ** 2 + run ** 2);
    }
    if (nearest > furthest) [best, furthest] = [step, nearest];
  }
  return best;
}

/** Weft-faced satin: one end up on each pick, each next pick `step` ends further. */
export function sateen(ends: number, step: number): Structure {
  return structureOf(ends, ends, (pick, end) => modulo(end - step * pick, ends) === 0);
}

/** Warp-faced satin: one end down on each pick, each next pick `step` ends further. */
export function satin(ends: number, step: number): Structure {
  return inverted(sateen(ends, step));
}

function inverted(structure: Structure): Structure {
  return { ...structure, drawdown: structure.drawdown.map((up) => 1 - up) };
}

/** Plain weave of groups: so many neighbouring ends work as one, and so many picks. */
export function basket(endsTogether: number, picksTogether: number): Structure {
  return structureOf(
    2 * picksTogether,
    2 * endsTogether,
    (pick, end) => Math.floor(pick / picksTogether) === Math.floor(end / endsTogether),
  );
}

/** Every end floats over so many picks and under so many; neighbouring ends are opposite. */
export function warpRib(over: number, under: number): Structure {
  return structureOf(over + under, 2, (pick, end) => pick < over === (end === 0));
}

/** Every pick floats over so many ends and under so many; neighbouring picks are opposite. */
export function weftRib(over: number, under: number): Structure {
  return structureOf(2, over + under, (pick, end) => end < over !== (pick === 0));
}

/** A twill that turns every `leg` ends, with a cut: the ends that meet at a turn are opposite. */
export function herringbone(parts: readonly number[], leg: number): Structure {
  const period = sum(parts);
  const up = range(leg);
  const down = up.map((end) => leg - 1 + Math.floor(period / 2) - end);
  return twillOf([...up, ...down], range(period), parts);
}

/** The numbers 0 to `leg` and back to 1: a point draw, or a point treadling. */
export function pointed(leg: number): number[] {
  return range(2 * leg).map((thread) => Math.abs(((thread + leg) % (2 * leg)) - leg));
}

/** A twill that turns every `leg` ends and every `leg` picks, on a single thread each time. */
export function diamondTwill(parts: readonly number[], leg: number): Structure {
  return twillOf(pointed(leg), pointed(leg), parts);
}

/**
 * Waffle weave: cells of 2·`half` ends and picks, plain in the middle, floats around the rim.
 *
 * Point draw on half + 1 shafts; pick t lifts shaft 0 to t − 1 and the one after its own.
 */
export function waffle(half: number): Structure {
  const shafts = pointed(half);
  return structureOf(shafts.length, shafts.length, (pick, end) => {
    const treadle = shafts[pick]!;
    const shaft = shafts[end]!;
    return shaft < treadle || shaft === treadle + 1;
  });
}

/** An eight-shaft crêpe: plain weave with four crossings a quadrant turned about, no float over 3. */
const CREPE = ["x.x..x.x", ".xx.x.x.", "x..x.xx.", ".x.xx..x", "x.x.x.x.", ".x.x..xx", ".xx.xx..", "x..x.x.x"];

/** A crêpe: short floats scattered so that no line shows. */
export function crepe(): Structure {
  return structureOf(8, 8, (pick, end) => CREPE[7 - pick]![end] === "x");
}


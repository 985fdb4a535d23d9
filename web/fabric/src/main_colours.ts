/** A picture in its main colours: what a photograph or a drawing with smooth edges needs before each colour can be a weave. */
import { srgbToLinear } from "./colour.ts";

/** Oklab of a colour (Ottosson 2020): distances are as an eye sees them. */
type Lab = readonly [number, number, number];

/** Colours are counted in boxes of so many bits a channel: of 12 million pixels 32,768 boxes are left. */
const BITS = 5;
const BOXES = 1 << (3 * BITS);
/** Steps of k-means; most pictures stand still after ten. */
const MAX_STEPS = 24;

/**
 * The picture with at most so many colours, those that are nearest to all of its pixels (k-means in Oklab); what is
 * transparent counts as white. Pixels unlike all around them take the colour that most of these have: a single crossing
 * is no weave.
 *
 * @param rgba pixels [height·width·4], sRGB-encoded, 0 to 255.
 * @param count from 2.
 */
export function inMainColours(rgba: Uint8ClampedArray, width: number, height: number, count: number): Uint8ClampedArray<ArrayBuffer> {
  const boxes = boxesOf(rgba);
  const boxColours = clusters(boxes, count);
  const index = new Uint8Array(width * height);
  for (let at = 0; at < index.length; at++) index[at] = boxColours.of[boxOf(rgba, at)]!;
  withoutSpecks(index, width, height);
  const found = new Uint8ClampedArray(4 * index.length).fill(255);
  for (let at = 0; at < index.length; at++) found.set(boxColours.rgb[index[at]!]!, 4 * at);
  return found;
}

/** Colours of a picture, by box. */
interface Boxes {
  readonly pixels: Float64Array;
  /** Sums of the pixels' levels [box·3]. */
  readonly sums: Float64Array;
}

function boxesOf(rgba: Uint8ClampedArray): Boxes {
  const [pixels, sums] = [new Float64Array(BOXES), new Float64Array(3 * BOXES)];
  for (let at = 0; at < rgba.length / 4; at++) {
    const box = boxOf(rgba, at);
    pixels[box]!++;
    for (let channel = 0; channel < 3; channel++) sums[3 * box + channel]! += onWhite(rgba, at, channel);
  }
  return { pixels, sums };
}

function boxOf(rgba: Uint8ClampedArray, at: number): number {
  const level = (channel: number): number => onWhite(rgba, at, channel) >> (8 - BITS);
  return (level(0) << (2 * BITS)) | (level(1) << BITS) | level(2);
}

function onWhite(rgba: Uint8ClampedArray, at: number, channel: number): number {
  const alpha = rgba[4 * at + 3]!;
  return alpha === 255 ? rgba[4 * at + channel]! : Math.round(255 + (rgba[4 * at + channel]! - 255) * (alpha / 255));
}

/** Which of the main colours each box belongs to, and these as levels. */
interface Clusters {
  readonly of: Uint8Array;
  readonly rgb: readonly (readonly [number, number, number])[];
}

function clusters({ pixels, sums }: Boxes, count: number): Clusters {
  const used = [...pixels.keys()].filter((box) => pixels[box]! > 0);
  const labs = used.map((box) => labOf([0, 1, 2].map((channel) => sums[3 * box + channel]! / pixels[box]!)));
  const weights = used.map((box) => pixels[box]!);
  let centres = firstCentres(labs, weights, count);
  let nearest: number[] = [];
  for (let step = 0; step < MAX_STEPS; step++) {
    const next = labs.map((lab) => nearestOf(lab, centres));
    if (nearest.every((centre, at) => centre === next[at]) && nearest.length > 0) break;
    nearest = next;
    centres = centres.map((centre, number) => meanOf(labs, weights, nearest, number) ?? centre);
  }
  const of = new Uint8Array(BOXES);
  const totals = centres.map((): [number, number, number, number] => [0, 0, 0, 0]);
  for (const [at, box] of used.entries()) {
    of[box] = nearest[at]!;
    const total = totals[nearest[at]!]!;
    for (let channel = 0; channel < 3; channel++) total[channel]! += sums[3 * box + channel]!;
    total[3] += pixels[box]!;
  }
  return { of, rgb: totals.map(([red, green, blue, all]) => [Math.round(red / all), Math.round(green / all), Math.round(blue / all)] as const) };
}

/** The commonest colour, then ever the one of which most is farthest from those before; fewer where there are fewer. */
function firstCentres(labs: readonly Lab[], weights: readonly number[], count: number): Lab[] {
  const away = labs.map(() => Infinity);
  const centres: Lab[] = [];
  let next = weights.indexOf(Math.max(...weights));
  while (centres.length < count && away[next]! > 0) {
    const centre = labs[next]!;
    centres.push(centre);
    let most = -1;
    for (const [at, lab] of labs.entries()) {
      away[at] = Math.min(away[at]!, squared(lab, centre));
      const missed = away[at]! * weights[at]!;
      if (missed > most) [most, next] = [missed, at];
    }
  }
  return centres;
}

function nearestOf(lab: Lab, centres: readonly Lab[]): number {
  let [found, least] = [0, Infinity];
  for (const [number, centre] of centres.entries()) {
    const away = squared(lab, centre);
    if (away < least) [found, least] = [number, away];
  }
  return found;
}

function meanOf(labs: readonly Lab[], weights: readonly number[], nearest: readonly number[], number: number): Lab | null {
  let [lightness, a, b, all] = [0, 0, 0, 0];
  for (const [at, lab] of labs.entries()) {
    if (nearest[at] !== number) continue;
    const weight = weights[at]!;
    lightness += weight * lab[0];
    a += weight * lab[1];
    b += weight * lab[2];
    all += weight;
  }
  return all === 0 ? null : [lightness / all, a / all, b / all];
}

function squared(one: Lab, other: Lab): number {
  return (one[0] - other[0]) ** 2 + (one[1] - other[1]) ** 2 + (one[2] - other[2]) ** 2;
}

function labOf(levels: readonly number[]): Lab {
  const [red, green, blue] = levels.map((level) => srgbToLinear(level / 255)) as [number, number, number];
  const long = Math.cbrt(0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue);
  const middle = Math.cbrt(0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue);
  const short = Math.cbrt(0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue);
  return [
    0.2104542553 * long + 0.793617785 * middle - 0.0040720468 * short,
    1.9779984951 * long - 2.428592205 * middle + 0.4505937099 * short,
    0.0259040371 * long + 0.7827717662 * middle - 0.808675766 * short,
  ];
}

/** Gives pixels that none beside, above or below is like the number that most of the eight around them have. */
function withoutSpecks(index: Uint8Array, width: number, height: number): void {
  const before = index.slice();
  for (let row = 0, at = 0; row < height; row++)
    for (let column = 0; column < width; column++, at++) {
      const own = before[at]!;
      if (column > 0 && before[at - 1] === own) continue;
      if (column < width - 1 && before[at + 1] === own) continue;
      if (row > 0 && before[at - width] === own) continue;
      if (row < height - 1 && before[at + width] === own) continue;
      index[at] = commonestAround(before, width, height, row, column) ?? own;
    }
}

function commonestAround(index: Uint8Array, width: number, height: number, row: number, column: number): number | null {
  const around = new Map<number, number>();
  for (let y = Math.max(row - 1, 0); y <= Math.min(row + 1, height - 1); y++)
    for (let x = Math.max(column - 1, 0); x <= Math.min(column + 1, width - 1); x++)
      if (x !== column || y !== row) around.set(index[y * width + x]!, (around.get(index[y * width + x]!) ?? 0) + 1);
  return [...around].reduce<[number, number] | null>((best, each) => (best === null || each[1] > best[1] ? each : best), null)?.[0] ?? null;
}

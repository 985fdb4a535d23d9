/**
 * How open cloth is: view rays over one repeat, and the numbers that light between yarns follows from.
 *
 * The twin of `scattering/openness.py`; a kernel casts the rays (`gpu/openness_baker.ts`).
 */
import { clamp } from "loomlight-fabric";

import {
  OPENNESS_FACING_COSINE,
  OPENNESS_FACING_RAYS,
  MEAN_THROUGH,
  MEAN_TURNED,
  OPENNESS_OBLIQUE_RAYS,
  RAY_RESULTS,
  OPENNESS_MIN_SHARE,
  OPENNESS_MIN_VIEW_COSINE,
} from "../generated.ts";
import type { Openness } from "./between_yarns.ts";

type Pair = readonly [number, number];

/** Rays of a face. */
export const RAYS = OPENNESS_OBLIQUE_RAYS + OPENNESS_FACING_RAYS;
const RAY_NUMBERS = 5;
const IS_WARP = 1;
const IS_HOLE = 2;
const IS_BLOCKED = 4;
const MEETS_WARP = 8;

/** Of each ray x and y on the plane z = 0 of a repeat of that size, millimetres, and the unit vector of the view [RAYS·5]. */
export function viewRays([width, height]: readonly [number, number]): Float64Array {
  const rays = new Float64Array(RAYS * RAY_NUMBERS);
  for (let number = 0; number < RAYS; number++) {
    const [across, along, tilt, turn] = [
      0.8566748838545029, 0.733891856627126, 0.6287067210378087, 0.5385972572236101,
    ].map((share) => (number * share + 0.5) % 1) as [number, number, number, number];
    const cosine = number < OPENNESS_OBLIQUE_RAYS ? 1 - (1 - OPENNESS_MIN_VIEW_COSINE) * tilt : OPENNESS_FACING_COSINE;
    const sine = Math.sqrt(1 - cosine ** 2);
    const azimuth = 2 * Math.PI * turn;
    rays.set([across * width, along * height, sine * Math.cos(azimuth), sine * Math.sin(azimuth), cosine], number * RAY_NUMBERS);
  }
  return rays;
}

/**
 * The openness that the kernel's words say [2·RAYS·RAY_RESULTS], front first.
 *
 * @param highest height of the highest yarn, millimetres.
 * @param roughness α of warp and weft.
 */
export function opennessOf(
  words: Uint32Array,
  highest: number,
  roughness: readonly [number, number],
  opticalDepth: number,
): Openness {
  const numbers = new Float32Array(words.buffer, words.byteOffset, words.length);
  const of = (ray: number, field: number): number => numbers[ray * RAY_RESULTS + field]!;
  const bits = (ray: number): number => words[ray * RAY_RESULTS]!;
  const relief = Math.max(highest, 1e-6);
  const views = viewRays([1, 1]);
  const viewTerms = (ray: number): number[] => {
    const [x, y, z] = views.subarray((ray % RAYS) * RAY_NUMBERS + 2) as unknown as [number, number, number];
    const squared = (1 - z) ** 2;
    return [1, Math.sqrt(x * x + y * y), squared, squared * squared, x * x - y * y];
  };
  const pointTerms = (ray: number): number[] => {
    const [cosine, height] = [of(ray, 1), of(ray, 2) / relief];
    return [1, cosine, height, cosine * cosine, cosine * height, height * height];
  };
  const near = (ray: number): number => (of(ray, 3) + of(ray, 4)) / 2;
  const cosineOf = (ray: number): number => views[(ray % RAYS) * RAY_NUMBERS + 4]!;
  const meetsWarp = (ray: number): number => (bits(ray) & MEETS_WARP ? 1 : 0);
  const isOblique = (ray: number): boolean => ray % RAYS < OPENNESS_OBLIQUE_RAYS;
  const byView: number[] = [];
  const byPoint: number[] = [];
  const warpSeen: number[] = [];
  const interior: Pair[] = [];
  const meets: [Pair, Pair][] = [];
  const blocks: Pair[] = [];
  for (const face of [0, 1]) {
    const yarn = Array.from({ length: RAYS }, (_, ray) => face * RAYS + ray).filter((ray) => !(bits(ray) & IS_HOLE));
    const open: number[] = [];
    const blocked: number[] = [];
    const to: Pair[] = [];
    for (const flag of [IS_WARP, 0]) {
      const seen = yarn.filter((ray) => (bits(ray) & IS_WARP) === flag);
      const meeting = seen.filter((ray) => bits(ray) & IS_BLOCKED);
      for (const [table, terms] of [[byView, viewTerms], [byPoint, pointTerms]] as const) {
        table.push(...fitted(seen, terms, (ray) => 1 - near(ray)));
        table.push(...fitted(seen, terms, (ray) => 1 - of(ray, 5)));
        table.push(...fitted(meeting, terms, meetsWarp));
      }
      const oblique = meeting.filter(isOblique);
      const share = sum(oblique, (ray) => cosineOf(ray) * meetsWarp(ray)) / Math.max(sum(oblique, cosineOf), 1e-9);
      to.push([share, 1 - share]);
      const points = seen.filter(isOblique);
      // Two halves of the lights: their errors are independent, so the mean of the product is unbiased.
      const ofBlocked = (ray: number): number => cosineOf(ray) * (1 - of(ray, 3));
      const total = sum(points, ofBlocked);
      blocked.push(Math.max(total, 0));
      open.push(sum(points, (ray) => ofBlocked(ray) * of(ray, 4)) / Math.max(total, 1e-9));
    }
    const all = Math.max(blocked[0]! + blocked[1]!, 1e-9);
    blocks.push([blocked[0]! / all, blocked[1]! / all]);
    interior.push(open.map((share) => clamp(share, OPENNESS_MIN_SHARE, 1)) as unknown as Pair);
    meets.push([to[0]!, to[1]!]);
    warpSeen.push(...fitted(yarn, viewTerms, (ray) => (bits(ray) & IS_WARP ? 1 : 0)));
  }
  const facing = Array.from({ length: OPENNESS_FACING_RAYS }, (_, ray) => OPENNESS_OBLIQUE_RAYS + ray).filter((ray) => !(bits(ray) & IS_HOLE));
  const mean = (value: (ray: number) => number): number => sum(facing, value) / facing.length;
  const field = (number: number) => mean((ray) => of(ray, number));
  return {
    by_view: byView,
    by_point: byPoint,
    warp_seen: warpSeen,
    interior: interior.flat(),
    meets: meets.flat(2),
    blocks: blocks.flat(),
    per_relief: [1 / relief],
    layers: roughness.flatMap((alpha) => meanLayerShares(alpha, opticalDepth)),
    facing: [mean(near), field(5)],
    facing_layer: [field(6), field(7), field(8), field(9)],
  };
}

/** Shares of diffuse light that a fibre layer of albedo 1 scatters back and through; see `scattering/fibre.py`. */
export function meanLayerShares(roughness: number, opticalDepth: number): Pair {
  const turned = MEAN_TURNED[0] + MEAN_TURNED[1] * roughness;
  const through = MEAN_THROUGH[0] + MEAN_THROUGH[1] * roughness;
  return [
    turned * (1 - Math.exp(MEAN_TURNED[2] * opticalDepth)),
    through * opticalDepth * Math.exp(MEAN_THROUGH[2] * opticalDepth ** MEAN_THROUGH[3]),
  ];
}

function sum(rays: readonly number[], value: (ray: number) => number): number {
  return rays.reduce((total, ray) => total + value(ray), 0);
}

/** Coefficients of terms by least squares; of a family hardly seen, the mean. */
function fitted(rays: readonly number[], terms: (ray: number) => number[], value: (ray: number) => number): number[] {
  const count = terms(0).length;
  if (rays.length < 8 * count) {
    const flat = new Array<number>(count).fill(0);
    flat[0] = rays.length > 0 ? sum(rays, value) / rays.length : 0.5;
    return flat;
  }
  // Modified Gram-Schmidt: normal equations would square the condition of terms that go together.
  const columns = Array.from({ length: count }, () => new Float64Array(rays.length));
  rays.forEach((ray, row) => terms(ray).forEach((term, column) => (columns[column]![row] = term)));
  const rest = Float64Array.from(rays, value);
  const upper = columns.map(() => new Array<number>(count).fill(0));
  const projected = new Array<number>(count).fill(0);
  const isKept = columns.map((column, i) => {
    const length = Math.sqrt(dot(column, column));
    for (let j = 0; j < i; j++) subtract(column, columns[j]!, (upper[j]![i] = dot(columns[j]!, column)));
    upper[i]![i] = Math.sqrt(dot(column, column));
    // What follows from the terms before it adds nothing, such as heights of threads that are flat.
    if (upper[i]![i]! <= 1e-9 * Math.max(length, 1e-30)) return (column.fill(0), false);
    column.forEach((entry, row) => (column[row] = entry / upper[i]![i]!));
    subtract(rest, column, (projected[i] = dot(column, rest)));
    return true;
  });
  const found = new Array<number>(count).fill(0);
  for (let i = count - 1; i >= 0; i--) {
    if (!isKept[i]) continue;
    let left = projected[i]!;
    for (let j = i + 1; j < count; j++) left -= upper[i]![j]! * found[j]!;
    found[i] = left / upper[i]![i]!;
  }
  return found;
}

function dot(one: Float64Array, other: Float64Array): number {
  let total = 0;
  for (let i = 0; i < one.length; i++) total += one[i]! * other[i]!;
  return total;
}

function subtract(from: Float64Array, column: Float64Array, share: number): void {
  for (let i = 0; i < from.length; i++) from[i]! -= share * column[i]!;
}

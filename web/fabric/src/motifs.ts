/**
 * Motifs for figured cloth: which crossings belong to the figure, repeating both ways; row 0 is the lowest.
 *
 * Shapes are given by formulas in units of half the repeat's width, sampled finer than the cloth and thresholded,
 * so that they keep their outline at every size.
 */
import { clamp, rint } from "./numbers.ts";

/** Which crossings belong to the figure [height·width], 1 = figure. */
export interface Mask {
  readonly width: number;
  readonly height: number;
  readonly inside: Uint8Array;
}

type Shape = (x: number, y: number) => boolean;

/** Samples that are spent on one motif. */
const SAMPLES = 3e6;
/** Height of the ogee damask's repeat over its width. */
export const OGEE_ASPECT = 1.5;

/** Diamonds within diamonds: a filled one, a ring around it, and half-drop neighbours. */
export function lozenges(width: number, height: number): Mask {
  return sampled(width, height, 1, (x, y) => {
    const distance = Math.abs(x) + Math.abs(y);
    return distance < 0.36 || (distance > 0.56 && distance < 0.78) || distance > 0.98;
  });
}

/** Large diamonds point to point, under a net of thin lines that change sides inside a diamond. */
export function argyle(width: number, height: number): Mask {
  return sampled(width, height, 1, (x, y) => {
    const diamond = Math.abs(x) + Math.abs(y) < 1;
    const line = Math.min(Math.abs(fold(x + y, 2)), Math.abs(fold(x - y, 2))) < 0.07;
    return diamond !== line;
  });
}

/** A damask: palmettes on leafy stems in a net of ogees, neighbours half a repeat higher. Sizes are even. */
export function ogeeDamask(width: number, height: number): Mask {
  const finer = finerOf(width, height);
  const [columns, rows] = [width * finer, height * finer];
  const x = axis(columns, 1);
  const y = axis(rows, OGEE_ASPECT);
  const flower = mirrored(x, y, palmette);
  const net = mirrored(x, y, ogeeNet);
  const fine = new Uint8Array(columns * rows);
  for (let row = 0; row < rows; row++) {
    const dropped = (row + rows - Math.floor(rows / 2)) % rows;
    for (let column = 0; column < columns; column++) {
      const shifted = (column + columns - Math.floor(columns / 2)) % columns;
      const at = row * columns + column;
      fine[at] = flower[at]! | flower[dropped * columns + shifted]! | net[at]!;
    }
  }
  return coarsened(fine, width, height, finer);
}

/** The distance to the nearest multiple of `period`, signed. */
function fold(value: number, period: number): number {
  return value - period * rint(value / period);
}

const length = (x: number, y: number): number => Math.sqrt(x * x + y * y);

/** Samples a crossing along one side: four, fewer where the cloth itself is fine enough. */
function finerOf(width: number, height: number): number {
  return Math.floor(clamp(Math.sqrt(SAMPLES / (width * height)), 1, 4));
}

function axis(count: number, extent: number): number[] {
  return Array.from({ length: count }, (_, index) => (((index + 0.5) / count) * 2 - 1) * extent);
}

/** A shape that is symmetric about x = 0, of which the right half is computed. */
function mirrored(x: readonly number[], y: readonly number[], shape: Shape): Uint8Array {
  const columns = x.length;
  const half = columns / 2;
  const inside = new Uint8Array(columns * y.length);
  y.forEach((height, row) => {
    for (let column = half; column < columns; column++) {
      if (!shape(x[column]!, height)) continue;
      inside[row * columns + column] = 1;
      inside[row * columns + columns - 1 - column] = 1;
    }
  });
  return inside;
}

function coarsened(fine: Uint8Array, width: number, height: number, finer: number): Mask {
  const inside = new Uint8Array(width * height);
  for (let row = 0; row < height; row++)
    for (let column = 0; column < width; column++) {
      let count = 0;
      for (let dy = 0; dy < finer; dy++)
        for (let dx = 0; dx < finer; dx++)
          count += fine[(row * finer + dy) * width * finer + column * finer + dx]!;
      inside[row * width + column] = 2 * count >= finer * finer ? 1 : 0;
    }
  return { width, height, inside };
}

function sampled(width: number, height: number, extent: number, shape: Shape): Mask {
  const finer = finerOf(width, height);
  const x = axis(width * finer, extent);
  const y = axis(height * finer, extent);
  const fine = new Uint8Array(x.length * y.length);
  y.forEach((v, row) => x.forEach((u, column) => (fine[row * x.length + column] = shape(u, v) ? 1 : 0)));
  return coarsened(fine, width, height, finer);
}

/** A ribbon along the ogees x = (1 + cos(π y / aspect)) / 2, with a row of beads in its middle. */
function ogeeNet(x: number, y: number): boolean {
  for (const [nodeX, nodeY] of [
    [1, 0],
    [0, OGEE_ASPECT],
  ] as const) {
    const u = fold(x - nodeX, 2);
    const v = fold(y - nodeY, 2 * OGEE_ASPECT);
    const radius = length(u, v);
    if (radius > 0.235) continue;
    const petals = radius < 0.13 + 0.07 * Math.abs(Math.cos(4 * Math.atan2(v, u)));
    return (petals && radius > 0.085) || radius < 0.055;
  }
  const phase = (Math.PI * y) / OGEE_ASPECT;
  const slope = ((0.5 * Math.PI) / OGEE_ASPECT) * Math.sin(phase);
  const across = (x - 0.5 * (1 + Math.cos(phase))) / length(1, slope);
  const ribbon = Math.abs(across) < 0.085 && Math.abs(across) > 0.052;
  return ribbon || length(across, fold(y, OGEE_ASPECT / 14)) < 0.034;
}

interface Leaf {
  /** Where it begins. */
  readonly root: readonly [number, number];
  /** Where it points, from the vertical towards the right. */
  readonly degrees: number;
  /** From root to tip. */
  readonly length: number;
  /** Half of its greatest breadth. */
  readonly breadth: number;
  /** How far its tip is pushed sideways. */
  readonly bend: number;
  /** Half of the vein's breadth at the root. */
  readonly vein: number;
  /** Below 1 it is broadest towards the root, above 1 towards the tip. */
  readonly fullest: number;
}

function leaf(root: Leaf["root"], degrees: number, span: number, breadth: number, rest: Partial<Leaf> = {}): Leaf {
  return { root, degrees, length: span, breadth, bend: 0, vein: 0.014, fullest: 0.8, ...rest };
}

const PETALS: readonly Leaf[] = [
  leaf([0, 0], 0, 0.74, 0.115, { vein: 0.02, fullest: 1.9 }),
  leaf([0, 0], 29, 0.74, 0.112, { vein: 0.02, fullest: 1.9 }),
  leaf([0, 0], 57, 0.7, 0.105, { vein: 0.02, fullest: 1.9 }),
];
const FOLIAGE: readonly Leaf[] = [
  leaf([0.02, -0.26], 76, 0.78, 0.09, { bend: -0.14 }),
  leaf([0.02, -0.6], 52, 0.62, 0.1, { bend: -0.16 }),
  leaf([0.01, -0.92], 34, 0.42, 0.07, { bend: -0.08 }),
  leaf([0, 0.84], 0, 0.3, 0.06),
  leaf([0.03, 0.8], 42, 0.24, 0.05, { bend: -0.05 }),
];

function covers(part: Leaf, x: number, y: number): boolean {
  const u = x - part.root[0];
  const v = y - part.root[1];
  const reach = part.length + part.breadth + Math.abs(part.bend);
  if (Math.abs(u) > reach || Math.abs(v) > reach) return false;
  const turn = (part.degrees * Math.PI) / 180;
  const along = (u * Math.sin(turn) + v * Math.cos(turn)) / part.length;
  if (!(along > 0 && along < 1)) return false;
  const across = Math.abs(u * Math.cos(turn) - v * Math.sin(turn) - part.bend * along ** 2);
  const half = part.breadth * Math.sin(Math.PI * along ** part.fullest) ** (part.fullest < 1 ? 0.9 : 0.6);
  const vein = across < part.vein * (1 - 0.6 * along) && along > 0.15 && along < 0.8;
  return across < half && !vein;
}

/** The right half of a fan of petals over a scaled fruit, on a stem with leaves. */
function palmette(x: number, y: number): boolean {
  const fromHeart = length(x, y);
  if (Math.abs(fromHeart - 0.315) < 0.016 && y > -0.1) return true;
  if (fromHeart > 0.36 && PETALS.some((petal) => covers(petal, x, y))) return true;
  if (FOLIAGE.some((part) => covers(part, x, y))) return true;
  if (x < 0.022 && y < -0.24 && y > -1.12) return true;
  return length(x - 0.52, y + 0.5) < 0.06 || fruit(x, y);
}

/** A drop with a rim, filled with scales. */
function fruit(x: number, y: number): boolean {
  const v = (y + 0.02) / 0.26;
  const half = 0.2 * Math.sqrt(clamp(1 - v ** 2, 0, 1)) * (1 - 0.18 * v);
  const depth = half - x;
  if (depth > 0 && depth < 0.035) return true;
  const scales = Math.abs(fold(x + 0.8 * y, 0.105)) + Math.abs(fold(x - 0.8 * y, 0.105)) < 0.058;
  return depth > 0.055 && scales;
}

/** What the bake of one fabric takes: all of it follows from the draft's size and the number of groups. */
import { clamp } from "loomlight-fabric";

import {
  EVEN_FROM,
  EVEN_STEP,
  FEWER_NODES,
  GROUPS_PER_PACK,
  LOBES_TABLES,
  MAX_BLUR,
  MAX_BLUR_STEPS,
  MAX_PYRAMID_BYTES,
  MIN_RAYS,
  MAX_TEXELS_PER_NODE,
  NODES_PER_SIDE,
  RAYS_PER_GROUP,
  TENT_VARIANCE,
  TEXELS_PER_NODE,
  TEXELS_PER_THREAD,
} from "../generated.ts";
import { sizeOf, type ClothLayout } from "./look.ts";

/** A sum of products of whole numbers and names of sizes, as `bake.json` has it. */
export type Size = readonly (readonly (number | string)[])[];

export interface BakePlan {
  /** Fields of the record `Bake` that depend on neither buffers nor other fabrics. */
  readonly values: Readonly<Record<string, number>>;
  /** Values of names in sizes. */
  readonly sizes: Readonly<Record<string, number>>;
  /** First node, columns and rows of each level of the coverage pyramid. */
  readonly levels: readonly (readonly [number, number, number])[];
  /** Side of the squares of its first level, millimetres. */
  readonly baseSize: number;
  /** Weights of the taps across and along that make tents of cells, the middle one first. */
  readonly blur: readonly [readonly number[], readonly number[]];
  /** Words of the tables that kernels write, in order, by the field of `Lobes` that says where each begins. */
  readonly tableWords: Readonly<Record<string, number>>;
}

/** Packs of the groups of both families; each family begins with a pack of its own. */
export function packCount(perFamily: number): number {
  return 2 * Math.ceil(perFamily / 4);
}

/** A size as a number; `more` are names that depend on the level. */
export function valueOf(plan: BakePlan, size: Size, more: Readonly<Record<string, number>> = {}): number {
  return sumOfProducts(size, { ...plan.sizes, ...more });
}

function sumOfProducts(size: Size, sizes: Readonly<Record<string, number>>): number {
  const named = (part: number | string): number => (typeof part === "number" ? part : (sizes[part] ?? 0));
  return size.reduce((sum, parts) => sum + parts.reduce<number>((product, part) => product * named(part), 1), 0);
}

/** Words of a table of `lobes`. */
export function wordsOfTable(name: (typeof LOBES_TABLES)[number][0], sizes: Readonly<Record<string, number>>): number {
  const [, numbers, perWord] = LOBES_TABLES.find(([table]) => table === name)!;
  return Math.ceil(sumOfProducts(numbers, sizes) / perWord);
}

/** The plan of a fabric's bake with so many groups of each family, 1 to 64, on average. */
export function planBake(layout: ClothLayout, perFamily: number): BakePlan {
  const [width, height] = sizeOf(layout);
  const { ends, picks } = layout;
  const packs = packCount(perFamily);
  const { baseSize, nodes } = spacingOf(layout, width, height, packs);
  const columns = nodesAlong(width, baseSize, nodes);
  const rows = nodesAlong(height, baseSize, nodes);
  const across = texelsAlong(ends, columns);
  const along = texelsAlong(picks, rows);
  const levels = levelsOf(columns, rows);
  const faceNodes = levels.at(-1)![0] + 1;
  const recorded = {
    per_family: perFamily,
    packs,
    max_clusters: Math.max(perFamily, 2 * perFamily - GROUPS_PER_PACK),
    rays: Math.max(MIN_RAYS, RAYS_PER_GROUP * perFamily),
    columns,
    rows,
    face_nodes: faceNodes,
    texels_across: across,
    texels_along: along,
  };
  const sizes = { ...recorded, groups: 2 * perFamily, width: packs + 1 };
  // Joint visibility is not baked by kernels.
  const names = LOBES_TABLES.map(([name]) => name).filter((name) => name !== "joint");
  return {
    values: {
      ...recorded,
      ends,
      picks,
      spacing_x: width / ends,
      spacing_y: height / picks,
      texel_x: width / (columns * across),
      texel_y: height / (rows * along),
      // Squares twice as wide have four times the variance; see `coverage.Spacing`.
      far_weight: ((nodes ** 2 - 2) / 4 - 1 / 4) / 2,
    },
    sizes,
    levels,
    baseSize,
    blur: [tapWeights((baseSize * columns) / width), tapWeights((baseSize * rows) / height)],
    tableWords: Object.fromEntries(names.map((name) => [name, wordsOfTable(name, sizes)])),
  };
}

/** Squares of one thread, or as small as the bound on memory allows, and nodes along a square's side. */
function spacingOf(
  layout: ClothLayout,
  width: number,
  height: number,
  packs: number,
): { baseSize: number; nodes: number } {
  const thread = Math.sqrt((((width / layout.ends) * height) / layout.picks));
  const row = 2 * 4 * (packs + 1);
  const smallest = (nodes: number): number =>
    nodes * Math.sqrt((width * height * row * 4) / 3 / MAX_PYRAMID_BYTES);
  for (const nodes of [NODES_PER_SIDE, FEWER_NODES])
    if (smallest(nodes) <= thread) return { baseSize: thread, nodes };
  return { baseSize: smallest(FEWER_NODES), nodes: FEWER_NODES };
}

function nodesAlong(side: number, baseSize: number, nodes: number): number {
  const count = Math.max(1, Math.ceil((nodes * side) / baseSize - 1e-6));
  return count <= EVEN_FROM ? count : Math.ceil(count / EVEN_STEP) * EVEN_STEP;
}

function texelsAlong(threads: number, nodes: number): number {
  return Math.max(TEXELS_PER_NODE, Math.min(Math.ceil((TEXELS_PER_THREAD * threads) / nodes), MAX_TEXELS_PER_NODE));
}

function levelsOf(columns: number, rows: number): [number, number, number][] {
  const levels: [number, number, number][] = [];
  let first = 0;
  for (;;) {
    levels.push([first, columns, rows]);
    if (columns * rows === 1) return levels;
    first += columns * rows;
    columns = Math.ceil(columns / 2);
    rows = Math.ceil(rows / 2);
  }
}

/** Weights of the cell itself and of those 1, 2, … cells away after all blur steps; see `models/lobes/coverage.py`. */
function tapWeights(cells: number): number[] {
  const missing = (TENT_VARIANCE * cells ** 2 - 3) / 12;
  const steps = clamp(Math.ceil(missing / (2 * MAX_BLUR)), 1, MAX_BLUR_STEPS);
  const share = Math.fround(Math.min(missing / (2 * steps), MAX_BLUR));
  let weights = [1];
  for (let step = 0; step < steps; step++) {
    const wider = new Array<number>(weights.length + 2).fill(0);
    weights.forEach((weight, i) => {
      wider[i]! += share * weight;
      wider[i + 1]! += (1 - 2 * share) * weight;
      wider[i + 2]! += share * weight;
    });
    weights = wider;
  }
  return weights.slice(steps);
}

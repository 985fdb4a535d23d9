/**
 * What the geometry needs to know of each thread beyond its runs; see `yarn/threads.py`.
 *
 * A thread's cell reaches from the middle of the gap before it to the middle of the gap after it. Positions are
 * millimetres from the start of the repeat.
 */
import { InputError } from "loomlight-fabric";

import {
  CELL_MAX_LEVELS,
  FINEST_CELL,
  FLATTEST_CROWN,
  MAX_ARC,
  MAX_NEIGHBOUR,
  MAX_OFFSET,
  SECTION_ANGLE,
  MIN_INCLINATION,
  STEEPEST_SHARE,
} from "../generated.ts";
import { halfWidth, type FamilyLayout } from "./look.ts";
import { STRAIGHT_BIT } from "./runs.ts";
import { largest, pairwiseSum, smallestStep } from "./sums.ts";

/** Arrays over the threads of one family, millimetres and radians; heights before the scale β. */
export interface FamilyTables {
  /** Where a thread's cell begins and ends. */
  readonly lower: Float64Array;
  readonly upper: Float64Array;
  readonly centre: Float64Array;
  readonly halfWidth: Float64Array;
  /** U after clamping for the thread's shortest run. */
  readonly inclination: Float64Array;
  /** Longest half-length of a bent end. */
  readonly arc: Float64Array;
  /** How far below the crown line at a float's boundary its lowest visible edge lies. */
  readonly edgeDrop: Float64Array;
  /** How high each thread rises in the cell of each crossing [n·crossings], levels 0 to 15. */
  readonly cellMaxima: Uint8Array;
  /** Size of the repeat across this family. */
  readonly period: number;
  /** Bounds of the height of any thread, before β and without dives. */
  readonly highest: number;
  readonly lowest: number;
}

interface Cells {
  readonly lower: Float64Array;
  readonly upper: Float64Array;
  readonly centre: Float64Array;
  readonly halfWidth: Float64Array;
  readonly period: number;
}

/** Whether all threads are alike, so that no table is needed. */
export function areAlike(tables: FamilyTables): boolean {
  const sizes = tables.upper.map((upper, thread) => upper - tables.lower[thread]!);
  return [sizes, tables.halfWidth, tables.inclination, tables.arc, tables.edgeDrop].every((row) =>
    row.every((value) => Math.abs(value - row[0]!) <= 1e-9 * Math.abs(row[0]!)),
  );
}

/** Size of the smallest cell, millimetres. */
export function finestOf(tables: FamilyTables): number {
  return smallestStep(tables.lower, tables.upper);
}

/**
 * Tables of a family whose threads cross those of `crossing`; `words` [n·crossings] are its runs.
 *
 * @throws InputError spacings too uneven: a cell under 1/64 of the mean.
 */
export function prepareFamily(family: FamilyLayout, crossing: FamilyLayout, words: Uint32Array): FamilyTables {
  const own = cellsOf(family);
  const other = cellsOf(crossing);
  const count = own.lower.length;
  const section = own.halfWidth.map(sectionDrop);
  const runs = new RunLengths(words, other);
  const inclination = new Float64Array(count);
  const arc = new Float64Array(count);
  const longestArc = MAX_ARC * smallestStep(other.lower, other.upper);
  for (let thread = 0; thread < count; thread++) {
    // A run of length L leaves room for its arc while w·tan(v_max/2)·sin U < L.
    const steepest = Math.asin(Math.min((STEEPEST_SHARE * runs.shortest(thread)) / (2 * section[thread]!), 1));
    inclination[thread] = Math.max(Math.min(family.inclination, steepest), MIN_INCLINATION);
    // A float rises by one width at most, and its ends stay within what the run words can tell.
    arc[thread] = Math.min((2 * own.halfWidth[thread]!) / Math.tan(inclination[thread]! / 2), longestArc);
  }
  const { highest, lowestEdge } = heightsOf(runs, { own, other, section, inclination, arc });
  const cellMaxima = new Uint8Array(words.length);
  for (let thread = 0; thread < count; thread++)
    for (let at = 0; at < runs.crossings; at++) {
      const top = cellMax(runs, thread, at, arc[thread]!, inclination[thread]!);
      cellMaxima[thread * runs.crossings + at] = Math.ceil(
        Math.min(top / Math.max(highest, 1e-30) + 1e-6, 1) * CELL_MAX_LEVELS,
      );
    }
  return {
    ...own,
    inclination,
    arc,
    // One share for the family, so that threads alike in all else stay alike.
    edgeDrop: section.map((drop) => lowestEdge * drop),
    cellMaxima,
    highest,
    // Only a thread that interlaces ends low; the drop at the middle of a run is less than at its ends.
    lowest: -(highest + 2 * largest(section)),
  };
}

/** How far the edge of a thread's circular cross-section lies below its crown, mm. */
function sectionDrop(half: number): number {
  const radius = half / Math.sin(SECTION_ANGLE);
  return half ** 2 / (radius + Math.sqrt(Math.max(radius ** 2 - half ** 2, 0)));
}

function cellsOf(family: FamilyLayout): Cells {
  const count = family.spacing.length;
  const period = pairwiseSum(family.spacing);
  const half = Float64Array.from(family.spacing, (_, thread) => halfWidth(family, thread));
  const centre = new Float64Array(count);
  let end = 0;
  for (let thread = 0; thread < count; thread++) {
    end += family.spacing[thread]!;
    centre[thread] = end - family.spacing[thread]! / 2;
  }
  const lower = centre.map((middle, thread) => {
    const before = thread === 0 ? count - 1 : thread - 1;
    const edge = centre[before]! + half[before]! - (thread === 0 ? period : 0);
    return (edge + middle - half[thread]!) / 2;
  });
  const upper = lower.map((_, thread) => (thread + 1 < count ? lower[thread + 1]! : lower[0]! + period));
  const finest = smallestStep(lower, upper);
  if (finest < (FINEST_CELL * period) / count)
    throw new InputError(
      `The finest thread takes up ${Number((1e3 * finest).toPrecision(3))} µm, less than 1/64 of the mean of ` +
        `${Number(((1e3 * period) / count).toPrecision(3))} µm; give threads more even spacings.`,
    );
  return { lower, upper, centre, halfWidth: half, period };
}

interface Bends {
  readonly own: Cells;
  readonly other: Cells;
  readonly section: Float64Array;
  readonly inclination: Float64Array;
  readonly arc: Float64Array;
}

/** The highest crown, and the lowest visible edge in units of the section's drop, at least 1. */
function heightsOf(runs: RunLengths, bends: Bends): { highest: number; lowestEdge: number } {
  const { own, other, section, inclination, arc } = bends;
  let highest = FLATTEST_CROWN;
  let lowestEdge = 1;
  for (let thread = 0; thread < own.lower.length; thread++) {
    const tilt = inclination[thread]!;
    const rise = Math.tan(tilt / 2);
    const shape = { section: section[thread]!, sine: Math.sin(tilt), halfTangent: rise };
    for (let at = 0; at < runs.crossings; at++) {
      const run = runs.at(thread, at);
      const reach = Math.min(run.length / 2, arc[thread]!);
      if (Number.isFinite(run.length)) highest = Math.max(highest, reach * rise);
      const edge = (neighbour: number, distance: number): void => {
        const height = edgeHeight(distance, reach, Math.min(neighbour / 2, arc[thread]!), shape);
        lowestEdge = Math.max(lowestEdge, -height / shape.section);
      };
      if (run.starts) edge(run.before, other.centre[at]! - other.halfWidth[at]! - other.lower[at]!);
      if (run.finishes) edge(run.after, other.upper[at]! - other.centre[at]! - other.halfWidth[at]!);
    }
  }
  return { highest, lowestEdge };
}

/** Lengths in millimetres of a run at a crossing and of its neighbours. */
interface Run {
  isStraight: boolean;
  length: number;
  before: number;
  after: number;
  starts: boolean;
  finishes: boolean;
  /** From the run's start to the upper end of the crossing's cell. */
  fromStart: number;
  /** From the lower end of the crossing's cell to the run's end. */
  toEnd: number;
}

/** Lengths of the runs that words tell of. */
class RunLengths {
  readonly crossings: number;
  private readonly words: Uint32Array;
  /** Where cells begin, of all crossings that a word can tell of. */
  private readonly starts: Float64Array;
  private readonly run: Run = {
    isStraight: false,
    length: 0,
    before: 0,
    after: 0,
    starts: false,
    finishes: false,
    fromStart: 0,
    toEnd: 0,
  };
  private static readonly FARTHEST = MAX_OFFSET + MAX_NEIGHBOUR + 2;

  constructor(words: Uint32Array, cells: Cells) {
    const count = cells.lower.length;
    this.words = words;
    this.crossings = count;
    this.starts = Float64Array.from({ length: count + 2 * RunLengths.FARTHEST }, (_, index) => {
      const crossing = index - RunLengths.FARTHEST;
      const turns = Math.floor(crossing / count);
      return cells.lower[crossing - turns * count]! + cells.period * turns;
    });
  }

  /** The run of a thread at a crossing; the object is the same at each call. */
  at(thread: number, here: number): Run {
    const word = this.words[thread * this.crossings + here]!;
    const run = this.run;
    const behind = (word >>> 1) & 127;
    const ahead = (word >>> 8) & 127;
    const start = this.position(here - behind);
    const finish = this.position(here + ahead + 1);
    run.isStraight = (word & STRAIGHT_BIT) !== 0;
    run.length = run.isStraight ? Infinity : finish - start;
    run.before = start - this.position(here - behind - ((word >>> 15) & 63));
    run.after = this.position(here + ahead + 1 + ((word >>> 21) & 63)) - finish;
    run.starts = behind === 0 && !run.isStraight;
    run.finishes = ahead === 0 && !run.isStraight;
    run.fromStart = this.position(here + 1) - start;
    run.toEnd = finish - this.position(here);
    return run;
  }

  /** Length of a thread's shortest run. */
  shortest(thread: number): number {
    let found = Infinity;
    for (let at = 0; at < this.crossings; at++) found = Math.min(found, this.at(thread, at).length);
    return found;
  }

  private position(crossing: number): number {
    return this.starts[crossing + RunLengths.FARTHEST]!;
  }
}

/** Highest point of a thread's crown in a cell; 0 for threads that never interlace. */
function cellMax(runs: RunLengths, thread: number, at: number, arc: number, inclination: number): number {
  const run = runs.at(thread, at);
  const length = run.isStraight ? 0 : run.length;
  const reach = Math.min(length / 2, arc);
  const along = Math.max(reach - Math.min(run.fromStart, run.toEnd, length / 2), 0);
  const radius = reach / Math.sin(inclination);
  const root = Math.sqrt(Math.max(radius ** 2 - along ** 2, 0));
  return reach * Math.tan(inclination / 2) - along ** 2 / Math.max(radius + root, 1e-30);
}

/** Height of a float's edge `distance` from its boundary: the tube of `yarn/geometry.py`, at x = w/2. */
function edgeHeight(
  distance: number,
  reach: number,
  otherReach: number,
  shape: { section: number; sine: number; halfTangent: number },
): number {
  const isOwn = distance >= shape.section * shape.sine;
  const along = isOwn ? Math.max(reach - distance, 0) : otherReach + distance;
  const sign = isOwn ? 1 : -1;
  const arc = isOwn ? reach : otherReach;
  const radius = arc / shape.sine - sign * shape.section;
  const root = Math.sqrt(Math.max(radius ** 2 - along ** 2, 0));
  return sign * (arc * shape.halfTangent - along ** 2 / (radius + root)) - shape.section;
}

/**
 * A draft: the drawdown (the thread on top at every crossing) and the threads.
 *
 * End 1 and pick 1 are index 0; end 1 is at the left, pick 1 at the bottom.
 */
import { InputError } from "./errors.ts";

/** Ends, and picks, of one repeat at most. */
export const MAXIMUM_THREADS = 16384;

/** One family of threads of a draft, in thread order; what a draft does not say is null. */
export interface Threads {
  /** Linear RGB rows [n·3] in [0, 1]. */
  readonly colors: Float64Array | null;
  /** Distance that each thread takes up [n], millimetres, > 0. */
  readonly spacingMm: Float64Array | null;
  /** Diameter [n], millimetres, > 0; may exceed the spacing (dense cloth). */
  readonly thicknessMm: Float64Array | null;
  /** Row of the draft's palette that each thread has [n]; colours that are swapped by role follow it. */
  readonly colorIndex: Int32Array | null;
}

/** Sets of 1-based numbers in ascending order, one a thread or a treadle. */
export type Sets = readonly (readonly number[])[];

/** How a loom weaves the drawdown. With treadling and liftplan, the treadling says what is woven. */
export interface LoomPlan {
  /** Shafts that carry each end. */
  readonly threading: Sets;
  readonly shafts: number;
  /** How many treadles; 0 for a liftplan. */
  readonly treadles: number;
  /** Shafts tied to each treadle; null for a liftplan. */
  readonly tieup: Sets | null;
  /** Treadles pressed for each pick; null for a liftplan. */
  readonly treadling: Sets | null;
  /** Shafts lifted for each pick; null for tie-up and treadling. */
  readonly liftplan: Sets | null;
  /** Whether a lifted shaft raises its ends (true) or lowers them. */
  readonly risingShed: boolean;
}

/** A section's lines in their order: key and value; null where the line had no "=". */
export type Entries = readonly (readonly [string, string | null])[];

/** What [WARP] or [WEFT] of a weaving information file says for all of its threads. */
export interface FamilyDefaults {
  readonly threads: number | null;
  readonly unit: string;
  readonly colorIndex: number | null;
  readonly spacingMm: number | null;
  readonly thicknessMm: number | null;
}

/** Content of a weaving information file beyond the draft, kept so that writing it again loses nothing. */
export interface WifSource {
  readonly warp: FamilyDefaults;
  readonly weft: FamilyDefaults;
  readonly colorRange: readonly [number, number];
  readonly entries: readonly (readonly [string, Entries])[];
  readonly sections: readonly (readonly [string, Entries])[];
}

/** A weave draft. */
export interface Draft {
  /** One line; may be empty. */
  readonly name: string;
  readonly ends: number;
  readonly picks: number;
  /** [picks·ends], row = pick, 1 = warp on top. */
  readonly drawdown: Uint8Array;
  readonly warp: Threads;
  readonly weft: Threads;
  readonly loom: LoomPlan | null;
  /** Linear RGB rows [k·3] that the threads' `colorIndex` points into. */
  readonly palette: Float64Array | null;
  readonly notes: readonly string[];
  readonly source: WifSource | null;
}

/** Threads of which nothing is said. */
export const PLAIN_THREADS: Threads = { colors: null, spacingMm: null, thicknessMm: null, colorIndex: null };

/** A matrix of crossings [picks·ends], 1 = warp on top. */
export interface Structure {
  readonly ends: number;
  readonly picks: number;
  readonly drawdown: Uint8Array;
}

/**
 * A draft of a structure, with whatever else is known.
 *
 * @throws InputError no ends or picks, or more than 16384.
 */
export function makeDraft(structure: Structure, rest: Partial<Omit<Draft, keyof Structure>> = {}): Draft {
  const { ends, picks, drawdown } = structure;
  if (ends === 0 || picks === 0)
    throw new InputError(`The draft has ${ends} ends and ${picks} picks; it needs at least one of each.`);
  if (Math.max(ends, picks) > MAXIMUM_THREADS)
    throw new InputError(
      `The draft has ${ends} ends and ${picks} picks; at most ${MAXIMUM_THREADS} of each can be used.`,
    );
  return {
    name: "",
    warp: PLAIN_THREADS,
    weft: PLAIN_THREADS,
    loom: null,
    palette: null,
    notes: [],
    source: null,
    ...rest,
    ends,
    picks,
    drawdown,
  };
}

/** The structure whose crossing (pick, end) is `up(pick, end)`. */
export function structureOf(picks: number, ends: number, up: (pick: number, end: number) => boolean): Structure {
  const drawdown = new Uint8Array(picks * ends);
  for (let pick = 0; pick < picks; pick++)
    for (let end = 0; end < ends; end++) drawdown[pick * ends + end] = up(pick, end) ? 1 : 0;
  return { ends, picks, drawdown };
}

/** Whether the warp is on top at a crossing, 0-based. */
export function isUp(structure: Structure, pick: number, end: number): boolean {
  return structure.drawdown[pick * structure.ends + end] === 1;
}

/** The structure repeated so many times in ends (`across`) and in picks (`along`). */
export function tileStructure(structure: Structure, across: number, along: number): Structure {
  const { ends, picks } = structure;
  return structureOf(picks * along, ends * across, (pick, end) => isUp(structure, pick % picks, end % ends));
}

/** Raises InputError if no thread interlaces: one family is on top at every crossing. */
export function requireInterlacing(structure: Structure): void {
  const up = structure.drawdown.includes(1);
  const down = structure.drawdown.includes(0);
  if (up && down) return;
  throw new InputError(
    `none of its ${structure.ends} ends and ${structure.picks} picks interlaces: the ${up ? "warp" : "weft"} is on ` +
      "top at every crossing, so nothing holds the cloth together; see which shafts each pick lifts.",
  );
}

/** Thread colours: by role in a palette (dark and light), or in thread order. */
import type { Rgb } from "./colour.ts";
import { MAXIMUM_THREADS, tileStructure, type Draft, type Threads } from "./draft.ts";
import { InputError } from "./errors.ts";
import { lcm } from "./numbers.ts";

/** Of threads that nobody has coloured, sRGB: a dark warp and a light weft show how they interlace. */
export const WARP_COLOUR = "#30497a";
export const WEFT_COLOUR = "#efe7d6";

/** Colour rows [n·3] of the rows `index` of a palette. */
export function pickRows(palette: Float64Array, index: ArrayLike<number>): Float64Array {
  const rows = new Float64Array(index.length * 3);
  for (let at = 0; at < index.length; at++)
    rows.set(palette.subarray(index[at]! * 3, index[at]! * 3 + 3), at * 3);
  return rows;
}

/** Flat rows of a list of colours. */
export function flatRows(colours: readonly Rgb[]): Float64Array {
  return Float64Array.from(colours.flat());
}

/** Threads whose colour is row `order` (repeated over so many threads) of `palette`. */
export function fromPalette(count: number, order: readonly number[], palette: Float64Array): Threads {
  const colorIndex = Int32Array.from({ length: count }, (_, thread) => order[thread % order.length]!);
  return { colors: pickRows(palette, colorIndex), colorIndex, spacingMm: null, thicknessMm: null };
}

/** A colour order from (index, count) pairs: runs([0, 4], [1, 4]) is four dark, four light. */
export function runs(...lengths: readonly (readonly [number, number])[]): number[] {
  return lengths.flatMap(([index, count]) => Array<number>(count).fill(index));
}

/**
 * The draft in other colours; null leaves a family's own.
 *
 * Where the draft orders its colours by a `colorIndex`, a list is that palette and is put in that order. Otherwise a
 * list is in thread order and repeats; the repeat of the draft grows until it holds whole lists.
 *
 * @throws InputError a list too short for the roles, or a repeat that would exceed 16384 threads.
 */
export function withPalette(draft: Draft, warp: readonly Rgb[] | null, weft: readonly Rgb[] | null): Draft {
  const grown = repeatDraft(
    draft,
    timesFor("warp.color", draft.warp, draft.ends, warp),
    timesFor("weft.color", draft.weft, draft.picks, weft),
  );
  return {
    ...grown,
    warp: warp === null ? grown.warp : coloured("warp.color", grown.warp, warp, grown.ends),
    weft: weft === null ? grown.weft : coloured("weft.color", grown.weft, weft, grown.picks),
    palette: null,
  };
}

function timesFor(name: string, threads: Threads, count: number, colours: readonly Rgb[] | null): number {
  if (colours === null || threads.colorIndex !== null) return 1;
  const whole = lcm(count, colours.length);
  if (whole > MAXIMUM_THREADS)
    throw new InputError(
      `${name} has ${colours.length} colours for ${count} threads: together they repeat only after ${whole} threads, ` +
        `and at most ${MAXIMUM_THREADS} can be used; give as many as divide ${count}.`,
    );
  return whole / count;
}

/**
 * The same cloth with a repeat that holds the old one `across` times in ends, `along` in picks.
 *
 * @throws InputError more than 16384 ends or picks.
 */
export function repeatDraft(draft: Draft, across: number, along: number): Draft {
  if (across === 1 && along === 1) return draft;
  const [ends, picks] = [draft.ends * across, draft.picks * along];
  if (Math.max(ends, picks) > MAXIMUM_THREADS)
    throw new InputError(
      `The repeat would have ${ends} ends and ${picks} picks; at most ${MAXIMUM_THREADS} of each can be used.`,
    );
  return {
    ...draft,
    ...tileStructure(draft, across, along),
    warp: repeatedThreads(draft.warp, across),
    weft: repeatedThreads(draft.weft, along),
    loom: null,
  };
}

function repeatedThreads(threads: Threads, times: number): Threads {
  return {
    colors: repeated(threads.colors, times, Float64Array),
    spacingMm: repeated(threads.spacingMm, times, Float64Array),
    thicknessMm: repeated(threads.thicknessMm, times, Float64Array),
    colorIndex: repeated(threads.colorIndex, times, Int32Array),
  };
}

function repeated<T extends Float64Array | Int32Array>(
  values: T | null,
  times: number,
  make: { from(values: ArrayLike<number>, map: (value: number, at: number) => number): T },
): T | null {
  if (values === null || times === 1) return values;
  return make.from({ length: values.length * times }, (_, at) => values[at % values.length]!);
}

function coloured(name: string, threads: Threads, colours: readonly Rgb[], count: number): Threads {
  const rows = flatRows(colours);
  const { colorIndex } = threads;
  if (colorIndex === null) {
    const index = Int32Array.from({ length: count }, (_, thread) => thread % colours.length);
    return { ...threads, colors: pickRows(rows, index) };
  }
  if (colours.length === 1)
    return { ...threads, colors: pickRows(rows, new Int32Array(count)), colorIndex: null };
  const roles = colorIndex.reduce((most, index) => Math.max(most, index), 0) + 1;
  if (colours.length < roles)
    throw new InputError(
      `${name} has ${colours.length} colours, but the colour order of this weave uses ${roles}; give ${roles}, or one.`,
    );
  return { ...threads, colors: pickRows(rows, colorIndex) };
}

/** Floats: how far a thread runs over or under others before it is bound; the cloth repeats. */
import type { Structure } from "./draft.ts";

/** Longest floats in threads crossed; a thread that never binds counts one repeat. See `weave/textile.py`. */
export interface FloatLengths {
  readonly warpFace: number;
  readonly warpBack: number;
  readonly weftFace: number;
  readonly weftBack: number;
}

/** Bits of a crossing that lies in a float that is too long, on the face or on the back. */
export const FACE = 1;
export const BACK = 2;

/** One float: `length` threads crossed from the 0-based `first` on, around the repeat's edge where it reaches there. */
export interface Float {
  readonly family: "warp" | "weft";
  readonly isFace: boolean;
  /** The end, or pick, that floats, from 0. */
  readonly thread: number;
  readonly first: number;
  readonly length: number;
}

export interface LongFloats {
  readonly longest: FloatLengths;
  /** The longest of them, longest first, at most `MAX_REPORTED`. */
  readonly reported: readonly Float[];
  /** Floats longer than asked, of both families. */
  readonly onFace: number;
  readonly onBack: number;
  /** [picks·ends], `FACE` and `BACK` of each crossing. */
  readonly marks: Uint8Array;
}

/** Floats that are told one by one. */
export const MAX_REPORTED = 50;

/** The floats of a drawdown that cross more than `limit` threads. */
export function longFloats({ ends, picks, drawdown }: Structure, limit: number): LongFloats {
  const marks = new Uint8Array(drawdown.length);
  const longest = { warpFace: 0, warpBack: 0, weftFace: 0, weftBack: 0 };
  const counts = { onFace: 0, onBack: 0 };
  const reported: Float[] = [];
  const report = (float: Float): void => {
    if (reported.length === MAX_REPORTED && float.length <= reported.at(-1)!.length) return;
    const before = reported.findIndex((each) => each.length < float.length);
    reported.splice(before < 0 ? reported.length : before, 0, float);
    reported.length = Math.min(reported.length, MAX_REPORTED);
  };
  const take = (float: Float, cells: (step: number) => number): void => {
    const { family, isFace, length } = float;
    const name = `${family}${isFace ? "Face" : "Back"}` as const;
    longest[name] = Math.max(longest[name], length);
    if (length <= limit) return;
    report(float);
    counts[isFace ? "onFace" : "onBack"]++;
    for (let step = 0; step < length; step++) marks[cells(step)]! |= isFace ? FACE : BACK;
  };
  for (let end = 0; end < ends; end++)
    eachRun(picks, (pick) => drawdown[pick * ends + end]!, (first, length, up) =>
      take({ family: "warp", isFace: up === 1, thread: end, first, length }, (step) => ((first + step) % picks) * ends + end),
    );
  for (let pick = 0; pick < picks; pick++)
    eachRun(ends, (end) => drawdown[pick * ends + end]!, (first, length, up) =>
      take({ family: "weft", isFace: up === 0, thread: pick, first, length }, (step) => pick * ends + ((first + step) % ends)),
    );
  return { longest, reported, ...counts, marks };
}

/** Runs of equal values around a circle: first index, length and value; the whole circle where all are equal. */
function eachRun(count: number, at: (index: number) => number, tell: (first: number, length: number, value: number) => void): void {
  let start = 0;
  while (start < count && at(start) === at((start + count - 1) % count)) start++;
  if (start === count) return tell(0, count, at(0));
  for (let first = start; first < start + count; ) {
    const value = at(first % count);
    let length = 1;
    while (at((first + length) % count) === value) length++;
    tell(first % count, length, value);
    first += length;
  }
}

/**
 * Runs: where each thread stays on top or underneath, packed into one 32-bit word a crossing and family.
 *
 * The word of a crossing, as `yarn/threads.py` describes it: bit 0 on top, 1–7 crossings since the run began, 8–14 until
 * it ends, 15–20 length of the run before, 21–26 of the run after, 27 never interlaces, 28–31 the cell's maximum.
 */
import { MAX_NEIGHBOUR, MAX_OFFSET } from "../generated.ts";

export const STRAIGHT_BIT = 1 << 27;
const STRAIGHT =
  (MAX_OFFSET << 1) | (MAX_OFFSET << 8) | (MAX_NEIGHBOUR << 15) | (MAX_NEIGHBOUR << 21) | STRAIGHT_BIT;

/** Words [threads·crossings] of a family, from whether each thread is on top at each crossing; both axes repeat. */
export function packRuns(onTop: Uint8Array, threads: number, crossings: number): Uint32Array {
  const words = new Uint32Array(threads * crossings);
  const start = new Int32Array(crossings);
  const length = new Int32Array(crossings);
  for (let thread = 0; thread < threads; thread++) {
    const row = onTop.subarray(thread * crossings, (thread + 1) * crossings);
    const firstStart = findStart(row);
    if (firstStart < 0) {
      words.fill((STRAIGHT | row[0]!) >>> 0, thread * crossings, (thread + 1) * crossings);
      continue;
    }
    // From the first start on, once around: every run is whole.
    for (let from = 0; from < crossings; ) {
      let size = 1;
      while (from + size < crossings && at(row, firstStart + from + size) === at(row, firstStart + from)) size++;
      for (let k = 0; k < size; k++) {
        const crossing = (firstStart + from + k) % crossings;
        start[crossing] = (firstStart + from) % crossings;
        length[crossing] = size;
      }
      from += size;
    }
    for (let crossing = 0; crossing < crossings; crossing++) {
      const begin = start[crossing]!;
      const size = length[crossing]!;
      const behind = (crossing - begin + crossings) % crossings;
      const before = length[(begin - 1 + crossings) % crossings]!;
      const after = length[(begin + size) % crossings]!;
      words[thread * crossings + crossing] =
        row[crossing]! |
        (Math.min(behind, MAX_OFFSET) << 1) |
        (Math.min(size - 1 - behind, MAX_OFFSET) << 8) |
        (Math.min(before, MAX_NEIGHBOUR) << 15) |
        (Math.min(after, MAX_NEIGHBOUR) << 21);
    }
  }
  return words;
}

/** The first crossing where a run begins; −1 for a thread that never interlaces. */
function findStart(row: Uint8Array): number {
  for (let crossing = 0; crossing < row.length; crossing++)
    if (row[crossing] !== at(row, crossing + row.length - 1)) return crossing;
  return -1;
}

function at(row: Uint8Array, crossing: number): number {
  return row[crossing % row.length]!;
}

/** Figured cloth: a motif in one structure on a ground in another, as a jacquard loom weaves damask. */
import { parseColour } from "./colour.ts";
import { isUp, makeDraft, structureOf, type Draft, type Structure } from "./draft.ts";
import { InputError } from "./errors.ts";
import { argyle, lozenges, OGEE_ASPECT, ogeeDamask, type Mask } from "./motifs.ts";
import { rint } from "./numbers.ts";
import { flatRows, fromPalette } from "./palette.ts";
import { MAXIMUM_NAMED_THREADS, sateen, satin, twill } from "./structures.ts";

/** The ogee damask on so many ends (a multiple of 16 from 160): satin 8/3 on sateen 8/3. */
export function damask(ends: number): Draft {
  const picks = rint(ends * OGEE_ASPECT);
  check("damask", ends, picks, 16, 160);
  const structure = figured(ogeeDamask(ends, picks), satin(8, 3), sateen(8, 3), 10);
  return twoColoured(structure, `damask ${ends}`, "#e9dfc6", "#8c6a2f");
}

/** Argyle diamonds on so many ends (a multiple of 8 from 32): 3/1 twill on 1/3 twill. */
export function argyleCloth(ends: number): Draft {
  const picks = Math.floor((ends * 3) / 2);
  check("argyle", ends, picks, 8, 32);
  const structure = figured(argyle(ends, picks), twill([3, 1]), twill([1, 3]), 5);
  return twoColoured(structure, `argyle ${ends}`, "#39465c", "#e8e0cf");
}

/** Diamonds within diamonds on so many ends (a multiple of 16 from 48): satin 8/3 on sateen 8/3. */
export function diamondFigure(ends: number): Draft {
  check("diamond figure", ends, ends, 16, 48);
  const structure = figured(lozenges(ends, ends), satin(8, 3), sateen(8, 3), 10);
  return twoColoured(structure, `diamond figure ${ends}`, "#5d1f2e", "#d9a9a0");
}

/** `figure` inside the mask and `ground` elsewhere, with floats above `floatLimit` threads bound. */
function figured(mask: Mask, figure: Structure, ground: Structure, floatLimit: number): Structure {
  const structure = structureOf(mask.height, mask.width, (pick, end) => {
    const chosen = mask.inside[pick * mask.width + end] === 1 ? figure : ground;
    return isUp(chosen, pick % chosen.picks, end % chosen.ends);
  });
  bindFloats(structure, floatLimit);
  return structure;
}

/** One thread of a cloth: its crossings are `first + k·step` in the drawdown, k < count. */
interface Line {
  readonly first: number;
  readonly step: number;
  readonly count: number;
}

const endLine = (cloth: Structure, end: number): Line => ({ first: end, step: cloth.ends, count: cloth.picks });
const pickLine = (cloth: Structure, pick: number): Line => ({ first: pick * cloth.ends, step: 1, count: cloth.ends });

const ROUNDS = 8;

/**
 * Adds binding points, in place, to floats longer than `limit` on either face.
 *
 * Each is put as near the middle of its float as it can be without making a float of the other family too long.
 */
function bindFloats(cloth: Structure, limit: number): void {
  for (let round = 0; round < ROUNDS; round++) {
    const longEnds = longLines(cloth, cloth.ends, (end) => endLine(cloth, end), limit);
    for (const end of longEnds) bindThread(cloth, endLine(cloth, end), limit, end, (pick) => pickLine(cloth, pick));
    const longPicks = longLines(cloth, cloth.picks, (pick) => pickLine(cloth, pick), limit);
    for (const pick of longPicks) bindThread(cloth, pickLine(cloth, pick), limit, pick, (end) => endLine(cloth, end));
    if (longEnds.length === 0 && longPicks.length === 0) return;
  }
  throw new InputError(`No binding keeps every float of the figure to ${limit} threads; allow longer ones.`);
}

function longLines(cloth: Structure, count: number, line: (index: number) => Line, limit: number): number[] {
  return Array.from({ length: count }, (_, index) => index).filter((index) =>
    floats(cloth, line(index)).some(([, length]) => length > limit),
  );
}

/** Start and length of each run of equal crossings of a thread, which repeats. */
function floats(cloth: Structure, line: Line): [number, number][] {
  const at = (index: number): number => cloth.drawdown[line.first + (index % line.count) * line.step]!;
  const starts: number[] = [];
  for (let index = 0; index < line.count; index++) if (at(index) !== at(index + line.count - 1)) starts.push(index);
  if (starts.length === 0) return [[0, line.count]];
  return starts.map((start, index) => [start, (starts[index + 1] ?? starts[0]! + line.count) - start]);
}

function bindThread(
  cloth: Structure,
  line: Line,
  limit: number,
  thread: number,
  across: (crossing: number) => Line,
): void {
  for (const [start, length] of floats(cloth, line)) {
    if (length <= limit) continue;
    const middle = start + Math.floor(length / 2);
    const candidates = Array.from({ length: Math.max(length - 2, 0) }, (_, index) => start + 1 + index);
    candidates.sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle));
    for (const candidate of candidates) {
      const crossing = candidate % line.count;
      const at = line.first + crossing * line.step;
      cloth.drawdown[at] = 1 - cloth.drawdown[at]!;
      if (floatThrough(cloth, across(crossing), thread) <= limit) break;
      cloth.drawdown[at] = 1 - cloth.drawdown[at]!;
    }
  }
}

/** The length of the float of a thread that holds its crossing `at`. */
function floatThrough(cloth: Structure, line: Line, at: number): number {
  const value = (index: number): number =>
    cloth.drawdown[line.first + ((at + index + line.count) % line.count) * line.step]!;
  let after = 1;
  while (after < line.count && value(after) === value(0)) after++;
  if (after === line.count) return line.count;
  let before = 0;
  while (value(-before - 1) === value(0)) before++;
  return after + before;
}

function check(name: string, ends: number, picks: number, multiple: number, lowest: number): void {
  if (ends % multiple === 0 && ends >= lowest && Math.max(ends, picks) <= MAXIMUM_NAMED_THREADS) return;
  const largest = Math.floor((MAXIMUM_NAMED_THREADS * ends) / Math.max(ends, picks, 1));
  let nearest = Math.max(lowest, Math.min(rint(ends / multiple) * multiple, largest));
  nearest -= nearest % multiple;
  throw new InputError(
    `"${name} ${ends}" cannot be woven: its ends must be a multiple of ${multiple}, at least ${lowest}, with at most ` +
      `${MAXIMUM_NAMED_THREADS} ends and picks; ${nearest} would do.`,
  );
}

function twoColoured(structure: Structure, name: string, warp: string, weft: string): Draft {
  const palette = flatRows([parseColour(warp, "palette"), parseColour(weft, "palette")]);
  return makeDraft(structure, {
    name,
    warp: fromPalette(structure.ends, [0], palette),
    weft: fromPalette(structure.picks, [1], palette),
    palette,
  });
}

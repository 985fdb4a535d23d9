/** Blocks of a drawdown: rectangles that are copied, put elsewhere, mirrored, turned, shifted and filled. */
import { makeDraft, structureOf, type Draft, type Structure } from "./draft.ts";
import { derivedPlan } from "./edit.ts";
import { InputError } from "./errors.ts";
import { modulo } from "./numbers.ts";

/** Ends and picks side by side, from the first ones on, which count from 0. */
export interface Region {
  readonly firstEnd: number;
  readonly firstPick: number;
  readonly ends: number;
  readonly picks: number;
}

/** What can be done to a block where it lies. "face" brings the other thread on top. */
export const BLOCK_CHANGES = ["mirror-ends", "mirror-picks", "turn", "shift-right", "shift-left", "shift-up", "shift-down", "face", "clear"] as const;
export type BlockChange = (typeof BLOCK_CHANGES)[number];

/** The crossings of a region. */
export function blockOf({ drawdown, ends }: Structure, region: Region): Structure {
  const block = new Uint8Array(region.ends * region.picks);
  for (let pick = 0; pick < region.picks; pick++) {
    const first = (region.firstPick + pick) * ends + region.firstEnd;
    block.set(drawdown.subarray(first, first + region.ends), pick * region.ends);
  }
  return { ends: region.ends, picks: region.picks, drawdown: block };
}

/** The part of a region that a draft has; null where it has none. */
export function within(region: Region, { ends, picks }: { readonly ends: number; readonly picks: number }): Region | null {
  const [firstEnd, firstPick] = [Math.max(region.firstEnd, 0), Math.max(region.firstPick, 0)];
  const across = Math.min(region.firstEnd + region.ends, ends) - firstEnd;
  const along = Math.min(region.firstPick + region.picks, picks) - firstPick;
  return across > 0 && along > 0 ? { firstEnd, firstPick, ends: across, picks: along } : null;
}

/** Where a block lies after a change: a quarter turn exchanges its sides, about the corner of its first end and pick. */
export function regionAfter(region: Region, change: BlockChange): Region {
  return change === "turn" ? { ...region, ends: region.picks, picks: region.ends } : region;
}

/** A block after a change. A turn is a quarter, clockwise; what is shifted out comes in at the other side. */
export function changedBlock(block: Structure, change: BlockChange): Structure {
  const { ends, picks, drawdown } = block;
  switch (change) {
    case "mirror-ends":
      return taken(block, same, (end) => ends - 1 - end);
    case "mirror-picks":
      return taken(block, (pick) => picks - 1 - pick, same);
    case "turn":
      return structureOf(ends, picks, (pick, end) => drawdown[end * ends + ends - 1 - pick] === 1);
    case "shift-right":
      return taken(block, same, (end) => modulo(end - 1, ends));
    case "shift-left":
      return taken(block, same, (end) => modulo(end + 1, ends));
    case "shift-up":
      return taken(block, (pick) => modulo(pick - 1, picks), same);
    case "shift-down":
      return taken(block, (pick) => modulo(pick + 1, picks), same);
    case "face":
      return { ends, picks, drawdown: drawdown.map((up) => 1 - up) };
    case "clear":
      return { ends, picks, drawdown: new Uint8Array(drawdown.length) };
  }
}

const same = (thread: number): number => thread;

/** The block of which each pick is another one's, and each end. */
function taken({ ends, picks, drawdown }: Structure, pickFrom: (pick: number) => number, endFrom: (end: number) => number): Structure {
  const from = Int32Array.from({ length: ends }, (_, end) => endFrom(end));
  const found = new Uint8Array(drawdown.length);
  for (let pick = 0; pick < picks; pick++) {
    const [row, source] = [pick * ends, pickFrom(pick) * ends];
    for (let end = 0; end < ends; end++) found[row + end] = drawdown[source + from[end]!]!;
  }
  return { ends, picks, drawdown: found };
}

/**
 * The draft with a block of it changed; its plan is derived anew.
 *
 * @throws InputError a quarter turn for which the draft has too few threads.
 */
export function withBlockChange(draft: Draft, region: Region, change: BlockChange): Draft {
  const after = regionAfter(region, change);
  const fits = after.firstEnd + after.ends <= draft.ends && after.firstPick + after.picks <= draft.picks;
  if (!fits)
    throw new InputError(
      `A quarter turn of ${region.ends} ends and ${region.picks} picks from end ${region.firstEnd + 1} and pick ${region.firstPick + 1} on ` +
        `needs ${after.firstEnd + after.ends} ends and ${after.firstPick + after.picks} picks; the draft has ${draft.ends} and ${draft.picks}.`,
    );
  return withFill(draft, after, changedBlock(blockOf(draft, region), change), "region");
}

/**
 * The draft with a region filled by repeats of a structure; its plan is derived anew.
 *
 * @param from where a repeat begins: at the region's first end and pick, or at the draft's, so that regions of one
 *   weave that touch are one cloth.
 */
export function withFill(draft: Draft, region: Region, fill: Structure, from: "region" | "draft"): Draft {
  const drawdown = draft.drawdown.slice();
  const [end0, pick0] = from === "region" ? [0, 0] : [region.firstEnd, region.firstPick];
  const endFrom = Int32Array.from({ length: region.ends }, (_, end) => (end0 + end) % fill.ends);
  for (let pick = 0; pick < region.picks; pick++) {
    const source = ((pick0 + pick) % fill.picks) * fill.ends;
    const first = (region.firstPick + pick) * draft.ends + region.firstEnd;
    for (let end = 0; end < region.ends; end++) drawdown[first + end] = fill.drawdown[source + endFrom[end]!]!;
  }
  const edited = makeDraft({ ends: draft.ends, picks: draft.picks, drawdown }, draft);
  return { ...edited, loom: derivedPlan(edited) };
}

/** The draft as repeats of one of its regions, which stays where it is. */
export function withRepeat(draft: Draft, region: Region): Draft {
  const block = blockOf(draft, region);
  const shifted = taken(
    block,
    (pick) => modulo(pick - region.firstPick, block.picks),
    (end) => modulo(end - region.firstEnd, block.ends),
  );
  return withFill(draft, { firstEnd: 0, firstPick: 0, ends: draft.ends, picks: draft.picks }, shifted, "draft");
}

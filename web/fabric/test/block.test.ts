import { describe, expect, it } from "vitest";

import {
  BLOCK_CHANGES,
  blockOf,
  changedBlock,
  loadDraft,
  makeDraft,
  namedWeave,
  planDrawdown,
  regionAfter,
  structureOf,
  withBlockChange,
  withFill,
  within,
  withRepeat,
  type BlockChange,
  type Draft,
  type Structure,
} from "../src/index.ts";

/** A drawdown as it is seen: the last pick first, x where the warp is on top. */
function seen({ ends, picks, drawdown }: Structure): string[] {
  return Array.from({ length: picks }, (_, row) => {
    const pick = picks - 1 - row;
    return [...drawdown.subarray(pick * ends, (pick + 1) * ends)].map((up) => (up === 1 ? "x" : ".")).join("");
  });
}

function drawn(...rows: string[]): Structure {
  return structureOf(rows.length, rows[0]!.length, (pick, end) => rows[rows.length - 1 - pick]![end] === "x");
}

// An L: no mirror, turn or shift leaves it as it is.
const L = drawn("x..", "x..", "x..", "xx.");

describe("a block", () => {
  it.each<[BlockChange, string[]]>([
    ["mirror-ends", ["..x", "..x", "..x", ".xx"]],
    ["mirror-picks", ["xx.", "x..", "x..", "x.."]],
    // Clockwise as it is seen: the foot of the L, at the right below, goes to the left below.
    ["turn", ["xxxx", "x...", "...."]],
    ["shift-right", [".x.", ".x.", ".x.", ".xx"]],
    ["shift-left", ["..x", "..x", "..x", "x.x"]],
    ["shift-up", ["x..", "x..", "xx.", "x.."]],
    ["shift-down", ["xx.", "x..", "x..", "x.."]],
    ["face", [".xx", ".xx", ".xx", "..x"]],
    ["clear", ["...", "...", "...", "..."]],
  ])("after %s", (change, rows) => {
    expect(seen(changedBlock(L, change))).toEqual(rows);
  });

  it("comes back by four turns, two mirrors, or a shift there and back", () => {
    const after = (...changes: BlockChange[]): Structure => changes.reduce(changedBlock, L);
    const same: BlockChange[][] = [
      ["turn", "turn", "turn", "turn"],
      ["mirror-ends", "mirror-ends"],
      ["mirror-picks", "mirror-picks"],
      ["shift-left", "shift-right"],
      ["shift-up", "shift-down"],
      ["turn", "turn", "mirror-ends", "mirror-picks"],
      ["face", "face"],
    ];
    for (const changes of same) expect(after(...changes)).toEqual(L);
  });
});

/** The draft with no crossing outside a region other than before. */
function expectOnlyInside(before: Draft, after: Draft, inside: (pick: number, end: number) => boolean): void {
  for (let pick = 0; pick < before.picks; pick++)
    for (let end = 0; end < before.ends; end++)
      if (!inside(pick, end)) expect(after.drawdown[pick * before.ends + end]).toBe(before.drawdown[pick * before.ends + end]);
}

describe("a draft", () => {
  const twill = loadDraft({ weave: "herringbone 2/2 8" });
  const region = { firstEnd: 3, firstPick: 1, ends: 2, picks: 3 };

  it.each(BLOCK_CHANGES)("is changed by %s in that block alone, and its plan weaves it", (change) => {
    const after = withBlockChange(twill, region, change);
    const to = regionAfter(region, change);
    if (change !== "turn") expect(blockOf(after, to)).toEqual(changedBlock(blockOf(twill, region), change));
    expect(planDrawdown(after.loom!).drawdown).toEqual(after.drawdown);
    expectOnlyInside(twill, after, (pick, end) => isIn(region, pick, end) || isIn(to, pick, end));
  });

  it("refuses a quarter turn beyond its edge in a sentence", () => {
    expect(() => withBlockChange(twill, { firstEnd: 0, firstPick: 0, ends: 16, picks: 2 }, "turn")).toThrow(/needs 2 ends and 16 picks; the draft has 16 and 4/);
  });

  it("is filled by a weave so that touching regions are one cloth, by a copy from the region's corner", () => {
    const ground = makeDraft(namedWeave("plain"));
    const large = makeDraft(structureOf(12, 13, () => true), ground);
    const weave = namedWeave("satin 5/2");
    const left = withFill(large, { firstEnd: 0, firstPick: 0, ends: 6, picks: 12 }, weave, "draft");
    const both = withFill(left, { firstEnd: 6, firstPick: 0, ends: 7, picks: 12 }, weave, "draft");
    expect(seen(both)).toEqual(seen(structureOf(12, 13, (pick, end) => weave.drawdown[(pick % 5) * 5 + (end % 5)] === 1)));
    const pasted = withFill(large, { firstEnd: 7, firstPick: 5, ends: 3, picks: 4 }, L, "region");
    expect(blockOf(pasted, { firstEnd: 7, firstPick: 5, ends: 3, picks: 4 })).toEqual(L);
  });

  it("becomes repeats of a block that stays where it is", () => {
    const large = withFill(makeDraft(structureOf(9, 11, () => false)), { firstEnd: 4, firstPick: 2, ends: 3, picks: 4 }, L, "region");
    const repeated = withRepeat(large, { firstEnd: 4, firstPick: 2, ends: 3, picks: 4 });
    for (const [firstEnd, firstPick] of [[4, 2], [1, 2], [7, 2]] as const) expect(blockOf(repeated, { firstEnd, firstPick, ends: 3, picks: 4 })).toEqual(L);
    // Below and beside the whole repeats the pattern goes on.
    expect(seen(blockOf(repeated, { firstEnd: 1, firstPick: 0, ends: 3, picks: 2 }))).toEqual(["x..", "x.."]);
  });
});

function isIn({ firstEnd, firstPick, ends, picks }: { firstEnd: number; firstPick: number; ends: number; picks: number }, pick: number, end: number): boolean {
  return end >= firstEnd && end < firstEnd + ends && pick >= firstPick && pick < firstPick + picks;
}

describe("a region", () => {
  it("is cut at the edges of a draft", () => {
    const size = { ends: 10, picks: 8 };
    expect(within({ firstEnd: -2, firstPick: 6, ends: 5, picks: 5 }, size)).toEqual({ firstEnd: 0, firstPick: 6, ends: 3, picks: 2 });
    expect(within({ firstEnd: 10, firstPick: 0, ends: 1, picks: 1 }, size)).toBeNull();
  });
});

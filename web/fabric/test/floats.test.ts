import { describe, expect, it } from "vitest";

import { BACK, FACE, longFloats, MAX_REPORTED, namedWeave, ordered, ORDERS, structureOf } from "../src/index.ts";

describe("floats", () => {
  it("of a satin are as long as its shafts but one, on the face and on the back", () => {
    const { longest, onFace, onBack, marks } = longFloats(namedWeave("satin 8/3"), 6);
    // Warp over seven picks and under one; weft the other way.
    expect(longest).toEqual({ warpFace: 7, warpBack: 1, weftFace: 1, weftBack: 7 });
    expect([onFace, onBack]).toEqual([8, 8]);
    // Seven of eight crossings have the warp on top, in a long float of warp above and of weft below.
    expect(marks.filter((mark) => mark === (FACE | BACK)).length).toBe(56);
    expect(longFloats(namedWeave("satin 8/3"), 7).marks.some((mark) => mark > 0)).toBe(false);
  });

  it("are told with the longest first, where each lies", () => {
    // End 2 floats over three picks, from the fourth around the edge to the first; pick 3 over two ends.
    const structure = structureOf(5, 4, (pick, end) => (end === 1 ? pick !== 1 && pick !== 2 : (pick + end) % 2 === 0));
    const { reported, onFace, onBack } = longFloats(structure, 2);
    expect(reported.length).toBe(onFace + onBack);
    expect(reported.map(({ length }) => length)).toEqual(reported.map(({ length }) => length).sort((a, b) => b - a));
    expect(reported).toContainEqual({ family: "warp", isFace: true, thread: 1, first: 3, length: 3 });
    const many = longFloats(namedWeave("damask 160"), 3);
    expect(many.reported.length).toBe(MAX_REPORTED);
    expect(many.reported[0]!.length).toBe(Math.max(...Object.values(many.longest)));
  });

  it("run on into the next repeat, and an unbound thread counts one", () => {
    const wrapped = structureOf(5, 2, (pick, end) => (end === 0 ? pick !== 2 : true));
    expect(longFloats(wrapped, 3).longest).toEqual({ warpFace: 5, warpBack: 1, weftFace: 1, weftBack: 2 });
    expect(longFloats(wrapped, 3).onFace).toBe(2);
  });

  it("are found by walking twice around, whatever the drawdown is", () => {
    for (let seed = 0; seed < 200; seed++) {
      const [picks, ends] = [1 + (seed % 7), 1 + ((seed >> 3) % 6)];
      const bit = (at: number): number => (Math.imul(seed * 31 + at + 1, 0x9e3779b1) >>> 28) & 1;
      const structure = structureOf(picks, ends, (pick, end) => bit(pick * ends + end) === 1);
      let longest = 0;
      for (let end = 0; end < ends; end++)
        for (let run = 0, pick = 0; pick < 2 * picks; pick++) {
          run = structure.drawdown[(pick % picks) * ends + end] === 1 ? run + 1 : 0;
          longest = Math.max(longest, Math.min(run, picks));
        }
      expect(longFloats(structure, 2).longest.warpFace).toBe(longest);
    }
  });
});

describe("orders", () => {
  it("are those of the books", () => {
    expect(ordered("straight", 6, 4)).toEqual([1, 2, 3, 4, 1, 2]);
    expect(ordered("reversed", 5, 4)).toEqual([4, 3, 2, 1, 4]);
    expect(ordered("point", 8, 4)).toEqual([1, 2, 3, 4, 3, 2, 1, 2]);
    expect(ordered("broken", 5, 4)).toEqual([1, 2, 4, 3, 1]);
  });

  it("stay within their shafts, however few", () => {
    for (const order of ORDERS)
      for (const most of [1, 2, 3, 5]) {
        const numbers = ordered(order, 20, most);
        expect(numbers.length).toBe(20);
        expect(numbers.every((number) => Number.isInteger(number) && number >= 1 && number <= most)).toBe(true);
      }
  });
});

import { describe, expect, it } from "vitest";

import { clothFacts, colouredDraft, FIRST_PLAN, loadDraft, needsCsv, yarnNeeds, type FabricFields, type YarnNeeds } from "../src/index.ts";

function needsOf(fields: FabricFields, plan: Partial<typeof FIRST_PLAN>): YarnNeeds {
  return yarnNeeds(fields, colouredDraft(loadDraft(fields), fields), { ...FIRST_PLAN, ...plan });
}

const totals = ({ yarns }: YarnNeeds, family: string): { threads: number; metres: number; grams: number } =>
  yarns
    .filter((yarn) => yarn.family === family)
    .reduce((sum, { threads, metres, grams }) => ({ threads: sum.threads + threads, metres: sum.metres + metres, grams: sum.grams + grams }), { threads: 0, metres: 0, grams: 0 });

describe("yarn for a piece", () => {
  it("is what a mill reckons in pounds: 60 × 56 of 20s, 44 in wide, 100 yd", () => {
    const inch = 2.54;
    const yard = 0.9144;
    const pound = 453.59237;
    const found = needsOf(
      { weave: "plain", epi: 60, ppi: 56, warp: { count: "20s" }, weft: { count: "20s" } },
      { lengthM: 100 * yard, widthCm: 44 * inch, warpTakeUp: 4, weftTakeUp: 6, loomWasteM: 0, weftWaste: 0 },
    );
    // Ends × yards × (1 + crimp) / (840 yd a hank × count), the mills' rule; so for the weft.
    const warp = (60 * 44 * 100 * 1.04) / (840 * 20);
    const weft = (56 * 44 * 100 * 1.06) / (840 * 20);
    expect(warp).toBeCloseTo(16.343, 3);
    expect(weft).toBeCloseTo(15.547, 3);
    // Both rules are exact and the threads whole: equal to what five digits of a pound show.
    expect(totals(found, "warp").threads).toBe(2640);
    expect(totals(found, "warp").grams / pound).toBeCloseTo(warp, 5);
    expect(totals(found, "weft").threads).toBe(56 * 36 * 100);
    expect(totals(found, "weft").grams / pound).toBeCloseTo(weft, 5);
  });

  it("of a hand-woven scarf has the loom waste in every end and whole stripes in both colours", () => {
    // 24 cm at 8 ends a cm are 192 ends; 1.8 m, 10 % take-up and .7 m waste make ends of 2.68 m. 8/2 cotton is 148 tex.
    const found = needsOf(
      { weave: "plain", ends_per_cm: 8, picks_per_cm: 8, warp: { count: "148 tex", color: "8 #102030, 4 #f0f0f0" }, weft: { count: "148 tex", color: "#102030" } },
      { lengthM: 1.8, widthCm: 24, warpTakeUp: 10, weftTakeUp: 10, loomWasteM: 0.7, weftWaste: 5 },
    );
    expect(found.endM).toBeCloseTo(2.68, 12);
    expect(found.yarns.map(({ family, hex, threads }) => [family, hex, threads])).toEqual([
      ["warp", "#102030", 128],
      ["warp", "#f0f0f0", 64],
      ["weft", "#102030", 1440],
    ]);
    expect(found.yarns[0]!.metres).toBeCloseTo(343.04, 8);
    expect(found.yarns[0]!.grams).toBeCloseTo(343.04 * 0.148, 8);
    // 1,440 picks of 24 cm with 10 % and 5 % more.
    expect(found.yarns[2]!.metres).toBeCloseTo(1440 * 0.24 * 1.1 * 1.05, 8);
    expect(needsCsv(found).split("\n")).toHaveLength(5);
    expect(needsCsv(found)).toContain("warp,#f0f0f0,64,171.5,25.38");
  });

  it("without waste weighs what the cloth weighs, with the weave's own crimp, counted or not", () => {
    for (const fields of [
      { weave: "twill 3/1", ends_per_cm: 25, picks_per_cm: 20, warp: { count: "80 tex" }, weft: { count: "60 tex" } },
      { weave: "satin 5/2", ends_per_cm: 50, picks_per_cm: 25 },
    ] satisfies FabricFields[]) {
      const found = needsOf(fields, { lengthM: 1, widthCm: 100, loomWasteM: 0, weftWaste: 0 });
      const facts = clothFacts(fields, colouredDraft(loadDraft(fields), fields));
      expect(totals(found, "warp").grams + totals(found, "weft").grams).toBeCloseTo(facts.weight, 8);
      expect(found.isCounted).toBe("warp" in fields);
      expect(found.takeUp.warp).toBeGreaterThan(0);
    }
  });

  it("counts threads of a repeat that is cut at the edge", () => {
    // 10 cm at 10 a cm are 100 ends: 14 repeats of seven and two more of the first colour.
    const found = needsOf({ weave: "plain", ends_per_cm: 10, warp: { color: "3 #111111, 4 #222222" } }, { widthCm: 10 });
    expect(found.yarns.slice(0, 2).map(({ threads }) => threads)).toEqual([14 * 3 + 2, 14 * 4]);
  });

  it("refuses numbers that cannot be in a sentence", () => {
    expect(() => needsOf({ weave: "plain" }, { lengthM: 0 })).toThrow("lengthM = 0 cannot be: write a number from 0.01 to 100000.");
    expect(() => needsOf({ weave: "plain" }, { weftWaste: NaN })).toThrow(/weftWaste = NaN/);
  });
});

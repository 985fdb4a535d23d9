import { describe, expect, it } from "vitest";

import {
  asLiftplan,
  asTreadling,
  clothFacts,
  colouredDraft,
  deriveLoomPlan,
  draftFromJson,
  draftToJson,
  loadDraft,
  loomOf,
  namedWeave,
  planDrawdown,
  readToml,
  readWif,
  settsOfWeight,
  threadHexes,
  turnedOver,
  weaveNames,
  withColoursInDraft,
  withCrossing,
  withLoom,
  withOnly,
  withSize,
  withThreadHexes,
  writeToml,
  type FabricFields,
  writeWif,
  type Draft,
} from "../src/index.ts";

const TWILL = namedWeave("twill 2/2");
/** All but the largest, which takes seconds. */
const WEAVES = weaveNames().filter((name) => !name.startsWith("damask"));

describe("loom plans", () => {
  it("weave every named weave again, by treadles and by lifts", () => {
    for (const name of WEAVES) {
      const draft = namedWeave(name);
      const plan = deriveLoomPlan(draft);
      for (const each of [plan, asLiftplan(plan), asTreadling(asLiftplan(plan))])
        expect(planDrawdown(each).drawdown, name).toEqual(draft.drawdown);
    }
  });

  it("follow an edited crossing", () => {
    const edited = withCrossing(TWILL, 0, 2, true);
    expect(edited.drawdown[2]).toBe(1);
    expect(planDrawdown(loomOf(edited)).drawdown).toEqual(edited.drawdown);
    expect(TWILL.drawdown[2]).toBe(0);
  });

  it("change the drawdown with the threading", () => {
    const loom = loomOf(TWILL);
    const edited = withLoom(TWILL, { ...loom, threading: withOnly(loom.threading, 3, 1) });
    const column = (draft: Draft, end: number): number[] => [0, 1, 2, 3].map((pick) => draft.drawdown[pick * 4 + end]!);
    expect(column(edited, 3)).toEqual(column(TWILL, 0));
  });
});

describe("sizes", () => {
  it("go on as the repeat does", () => {
    const grown = withSize(TWILL, 8, 6);
    for (let pick = 0; pick < 6; pick++)
      for (let end = 0; end < 8; end++)
        expect(grown.drawdown[pick * 8 + end]).toBe(TWILL.drawdown[(pick % 4) * 4 + (end % 4)]);
    expect(planDrawdown(loomOf(grown)).drawdown).toEqual(grown.drawdown);
  });

  it("refuse what is no cloth", () => {
    expect(() => withSize(TWILL, 1, 4)).toThrow(/2 to 16384/);
  });

  it("are kept by turning over, and turning twice gives the cloth again", () => {
    expect(turnedOver(turnedOver(TWILL)).drawdown).toEqual(TWILL.drawdown);
  });
});

describe("colours of threads", () => {
  const painted = (name: string, thread: number): string[] => {
    const draft = namedWeave(name);
    const fields = { weave: name };
    const hexes = threadHexes(colouredDraft(draft, fields), "warp");
    hexes[thread] = "#c0ffee";
    const edited = withThreadHexes(fields, draft, "warp", hexes);
    expect(threadHexes(colouredDraft(draft, edited), "warp")).toEqual(hexes);
    // The text of the fabric file says the same.
    const read = readToml(writeToml(edited));
    expect(threadHexes(colouredDraft(loadDraft(read), read), "warp")).toEqual(hexes);
    return hexes;
  };

  it("are what was painted, in weaves with and without an order of colours", () => {
    for (const name of ["plain", "twill 3/1", "houndstooth 4", "hairline", "log cabin 4", "denim", "gingham 2"])
      for (const thread of [0, 1]) expect(painted(name, thread)).toContain("#c0ffee");
  });

  it("keep the roles of an effect where a whole role changes", () => {
    const draft = namedWeave("houndstooth 4");
    const hexes = threadHexes(colouredDraft(draft, { weave: "houndstooth 4" }), "warp").map((hex, thread) => (thread < 4 ? "#101010" : hex));
    const fields = withThreadHexes({ weave: "houndstooth 4" }, draft, "warp", hexes);
    expect(fields.warp?.color).toHaveLength(2);
  });

  it("move from the fields into the draft", () => {
    const fields = { weave: "plain", warp: { color: ["#111111", "#222222", "#333333"] } };
    const own = withColoursInDraft(fields, namedWeave("plain"));
    expect(own.draft.ends).toBe(6);
    expect(own.fields.warp?.color).toBeUndefined();
    expect(threadHexes(colouredDraft(own.draft, own.fields), "warp").slice(0, 3)).toEqual(fields.warp.color);
  });
});

describe("drafts in files", () => {
  it("are the same again from JSON and WIF", () => {
    for (const name of WEAVES) {
      const draft = namedWeave(name);
      const json = draftFromJson(draftToJson(draft));
      expect(json.drawdown).toEqual(draft.drawdown);
      expect(json.warp).toEqual(draft.warp);
      const wif = readWif(new TextEncoder().encode(writeWif(draft)), "a.wif");
      expect(wif.drawdown).toEqual(draft.drawdown);
      expect(threadHexes(wif, "weft")).toEqual(threadHexes(draft, "weft"));
    }
  });
});

describe("the weight of cloth", () => {
  const counted = (sett: number): FabricFields => ({
    weave: "twill 2/2",
    ends_per_cm: sett,
    picks_per_cm: sett,
    warp: { count: "30 tex" },
    weft: { count: "Nm 28" },
  });

  it("finds the sett that it came from", () => {
    const draft = loadDraft(counted(18));
    const { weight } = clothFacts(counted(18), draft);
    const setts = settsOfWeight(counted(30), draft, weight);
    expect(setts.warp).toBeCloseTo(18, 2);
    expect(setts.weft).toBeCloseTo(18, 2);
  });

  it("is refused where no sett or no count gives it", () => {
    const draft = loadDraft(counted(18));
    expect(() => settsOfWeight(counted(18), draft, -1)).toThrow(/weight = -1 g\/m² is none of cloth of these yarns/);
    expect(() => settsOfWeight({ weave: "plain" }, draft, 200)).toThrow(/counts of both families/);
  });
});

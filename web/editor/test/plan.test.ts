import { FIRST_PLAN, loadDraft, yarnNeeds, type FabricFields } from "loomlight-fabric";
import { describe, expect, it } from "vitest";

import { planOf } from "../src/keeping/plan.ts";
import { firstState, woven } from "../src/state/document.ts";
import { ODD } from "./odd.ts";

describe("the kept piece", () => {
  it("comes back, an empty take-up too", () => {
    const plan = { ...FIRST_PLAN, lengthM: 2.5, warpTakeUp: 8, weftTakeUp: null };
    expect(planOf(JSON.stringify(plan))).toEqual(plan);
  });

  it("is one that can be reckoned with, whatever became of it", () => {
    const fields: FabricFields = { weave: "plain" };
    const draft = woven(firstState({ fields, draft: loadDraft(fields) }).fabric);
    for (const name of Object.keys(FIRST_PLAN))
      for (const value of ODD) {
        const text = typeof value === "bigint" ? "{" : JSON.stringify({ ...FIRST_PLAN, [name]: value });
        expect(yarnNeeds(fields, draft, planOf(text)).yarns.length).toBe(2);
      }
    for (const text of ["", "null", "[]", "3", null]) expect(planOf(text)).toEqual(FIRST_PLAN);
  });
});

import { loadDraft, type FabricFields } from "loomlight-fabric";
import type { Openness } from "loomlight-web";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";

import { geometryKey, OpennessSource } from "../src/openness.ts";
import type { Fabric } from "../src/state/document.ts";

const fabric = (fields: FabricFields): Fabric => ({ fields, draft: loadDraft(fields) });
const twill = fabric({ weave: "twill 3/1" });
const withFields = (fields: Partial<FabricFields>): Fabric => ({ ...twill, fields: { ...twill.fields, ...fields } });
// What the source never looks into.
const answer = (name: string) => ({ name }) as unknown as Openness;

describe("the geometry that openness follows from", () => {
  it("is the same in other colours, lustre and yarns that differ close up", () => {
    const keys = [
      twill,
      withFields({ warp: { color: "#102030", specular: 0.8, translucency: 0.3, plies: 3, hairiness: 0.5 } }),
      withFields({ warp: {}, weft: undefined, name: "mine", sheen: { strength: 0.5 }, variation: { seed: 4 } }),
    ].map(geometryKey);
    expect(new Set(keys).size).toBe(1);
  });

  it("is another with other gaps, twist, roughness, depth, drafts and longer lists of colours", () => {
    const keys = [
      twill,
      withFields({ gap: 0.3 }),
      withFields({ warp: { twist_deg: 20 } }),
      withFields({ weft: { roughness: 0.2 } }),
      withFields({ optical_depth: 1 }),
      withFields({ warp: { color: ["#111", "#222", "#333"] } }),
      { ...twill, draft: loadDraft({ weave: "twill 3/1" }) },
    ].map(geometryKey);
    expect(new Set(keys).size).toBe(keys.length);
  });
});

describe("the source of openness", () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  const made = (ask: (fabric: Fabric) => Promise<Openness>) => {
    const told: string[] = [];
    let answers = 0;
    const source = new OpennessSource(ask, () => answers++, (sentence) => told.push(sentence));
    return { source, told, count: () => answers };
  };

  it("asks once for a geometry, after the last of many edits, and serves the last answer meanwhile", async () => {
    const asked: Fabric[] = [];
    const { source, count } = made(async (of) => answer(`answer ${asked.push(of)}`));
    expect(source.of(twill)).toBeNull();
    for (const gap of [0.1, 0.2, 0.3]) source.show([withFields({ gap })]);
    await vi.runAllTimersAsync();
    expect(asked.map(({ fields }) => fields.gap)).toEqual([0.3]);
    source.show([twill]);
    expect(source.of(twill)).toEqual(answer("answer 1"));
    await vi.runAllTimersAsync();
    expect([source.of(twill), count()]).toEqual([answer("answer 2"), 2]);
    source.show([withFields({ warp: { color: "#800000" } })]);
    await vi.runAllTimersAsync();
    expect(asked.length).toBe(2);
    expect(source.of(withFields({ warp: { color: "#800000" } }))).toEqual(answer("answer 2"));
  });

  it("asks for fabrics lit directly alone too, for their joint visibility", async () => {
    const { source, count } = made(async () => answer("joint"));
    const plain = fabric({ weave: "plain", interreflection: false });
    source.show([plain]);
    await vi.runAllTimersAsync();
    expect([source.of(plain), count()]).toEqual([answer("joint"), 1]);
  });

  it("tells a fault once, and asks again with the next edit", async () => {
    let isGone = true;
    const { source, told } = made(async () => {
      if (isGone) throw new Error("The server does not answer.");
      return answer("again");
    });
    for (let edit = 0; edit < 2; edit++) {
      source.show([twill]);
      await vi.runAllTimersAsync();
    }
    expect(told).toEqual(["The server does not answer."]);
    isGone = false;
    source.show([twill]);
    await vi.runAllTimersAsync();
    expect(source.of(twill)).toEqual(answer("again"));
  });
});

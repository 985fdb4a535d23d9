import { loadDraft, type FabricFields } from "loomlight-fabric";
import { beforeAll, describe, expect, it, vi } from "vitest";

import { keepFabric, ownFabrics, ownFabricsOf, removeFabric } from "../src/keeping/own_fabrics.ts";
import { isFound, saidOf } from "../src/panels/found.ts";
import { reduce } from "../src/reducers/index.ts";
import { firstState, type Fabric } from "../src/state/document.ts";
import { fabricText } from "../src/state/fabric_json.ts";
import { ODD, randomOf, showAll } from "./odd.ts";

const made = (fields: FabricFields): Fabric => firstState({ fields, draft: loadDraft(fields) }).fabric;
const kept = new Map<string, string>();
/** Characters that the browser keeps. */
let room = Infinity;

beforeAll(() => {
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, text: string) => {
      if (text.length > room) throw new Error("QuotaExceededError");
      kept.set(key, text);
    },
  });
});

describe("fabrics of one's own", () => {
  const shirt = made({ name: "Shirt", weave: "plain", ends_per_cm: 40, warp: { color: "#203050" } });

  it("are kept under names of their own, come back as they were, and are removed", () => {
    expect(keepFabric(shirt)).toBeNull();
    expect(keepFabric(made({ ...shirt.fields }))).toBe("It is kept already, as Shirt.");
    // Another of the same name, with a draft of its own.
    const edited = reduce(firstState(shirt), { type: "draft/size", ends: 5, picks: 7 }).fabric;
    expect(keepFabric(edited)).toBeNull();
    expect(ownFabrics().map(({ name }) => name)).toEqual(["Shirt 2", "Shirt"]);
    const read = ownFabricsOf(kept.get("loomlight.own.1")!);
    expect(read.map(({ name, fabric }) => [name, fabricText(fabric)])).toEqual([["Shirt 2", fabricText(edited)], ["Shirt", fabricText(shirt)]]);
    removeFabric("Shirt 2");
    expect(ownFabricsOf(kept.get("loomlight.own.1")!).map(({ name }) => name)).toEqual(["Shirt"]);
  });

  it("for which there is no room are told of, and nothing else is lost", () => {
    room = 10;
    expect(keepFabric(made({ weave: "twill 2/2" }))).toMatch(/keeps no more: save the fabric as a file/);
    room = Infinity;
    expect(ownFabrics().map(({ name }) => name)).toEqual(["Shirt"]);
    const noise = randomOf(1);
    const large = firstState(made({ weave: "plain" }));
    // A million crossings without an order are a draft of its own of that size as text.
    const wide = reduce(large, { type: "draft/size", ends: 1200, picks: 1200 });
    const block = { ends: 1200, picks: 1200, drawdown: Uint8Array.from({ length: 1200 * 1200 }, () => (noise() < 0.5 ? 1 : 0)) };
    const rough = reduce(wide, { type: "draft/paste", region: { firstEnd: 0, firstPick: 0, ends: 1200, picks: 1200 }, block });
    expect(keepFabric(rough.fabric)).toMatch(/no more room for so large a draft/);
  });

  it("that were kept are shown, whatever became of them", () => {
    const whole = JSON.parse(JSON.stringify([{ name: "Shirt", fabric: JSON.parse(fabricText(shirt)) as unknown }])) as [{ name: unknown; fabric: { fields: Record<string, unknown> } }];
    for (const value of ODD.filter((each) => typeof each !== "bigint"))
      for (const damaged of [value, [value, whole[0]], [{ ...whole[0], name: value }], [{ ...whole[0], fabric: value }], [{ name: "Shirt", fabric: { fields: value } }], [{ name: "Shirt", fabric: { fields: { ...whole[0].fabric.fields, ends_per_cm: value } } }]])
        for (const { name, fabric } of ownFabricsOf(JSON.stringify(damaged) ?? null)) {
          expect(typeof name).toBe("string");
          showAll(firstState(fabric));
        }
    expect(ownFabricsOf("{")).toEqual([]);
    expect(ownFabricsOf(JSON.stringify([{ name: 3 }, whole[0], whole[0]])).length).toBe(1);
  });
});

describe("a search", () => {
  const tweed = saidOf(made({ name: "Tweed à carreaux", description: "Twill of woollen yarns.", weave: "twill 2/2", yarn: "wool", warp: { count: "Nm 6" }, weft: { count: "Nm 7" } }));

  it.each(["", "tweed", "WOOL twill", "nm 6", "a carreaux", "2/2, woollen"])("for %j finds it", (sought) => {
    expect(isFound(sought, tweed)).toBe(true);
  });

  it.each(["silk", "wool silk", "nm 8"])("for %j does not", (sought) => {
    expect(isFound(sought, tweed)).toBe(false);
  });
});

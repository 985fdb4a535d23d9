/** Nothing that is typed, clicked, linked or kept ends the page. */
import { BLOCK_CHANGES, isInputError, loadDraft, ORDERS, type FabricFields } from "loomlight-fabric";
import { describe, expect, it } from "vitest";

import { documentOf, documentText } from "../src/keeping/document_text.ts";
import { fabricOfLink, linkOf } from "../src/link.ts";
import { reduce } from "../src/reducers/index.ts";
import type { Action } from "../src/state/actions.ts";
import { firstState, SHAPES, TABS, type State } from "../src/state/document.ts";
import { fabricFromJson, fabricText } from "../src/state/fabric_json.ts";
import { Store } from "../src/state/store.ts";
import { fieldNames, ODD, randomOf, showAll } from "./odd.ts";

const first = (fields: FabricFields): State => firstState({ fields, draft: loadDraft(fields) });
const HOUNDSTOOTH: FabricFields = { weave: "houndstooth 4", ends_per_cm: 11, picks_per_cm: 11, warp: { count: "30 tex" }, weft: { count: "Nm 28" } };

/** The state after an action that may be refused; any other fault is one of the page's own. */
function after(state: State, action: Action): State {
  let next = state;
  try {
    next = reduce(state, action);
  } catch (error) {
    if (!isInputError(error)) throw new Error(`${action.type} throws ${String(error)}`, { cause: error });
    expect(error.message).toMatch(/\w{3}/);
  }
  const store = new Store(state);
  store.dispatch(action);
  expect(store.state.fabric === state.fabric || next !== state).toBe(true);
  return next;
}

/** The same state from what the browser keeps of it, its steps only where asked, as each is read. */
function keptAndRead(state: State, withHistory = true): void {
  const { fabric, history, scene, comparison } = documentOf(documentText(state, { withHistory }));
  expect(fabricText(fabric)).toBe(fabricText(state.fabric));
  expect(comparison.before === null).toBe(state.comparison.before === null);
  expect(history.past.length).toBe(withHistory ? Math.min(state.history.past.length, 60) : 0);
  if (scene.shape === state.scene.shape && scene.surroundings === state.scene.surroundings) expect(scene).toEqual(state.scene);
}

describe("each field with each odd value", () => {
  const start = first(HOUNDSTOOTH);
  it.each(fieldNames())("%s", (field) => {
    for (const value of ODD) {
      const next = after(start, { type: "field/set", field, value });
      showAll(next);
      keptAndRead(next);
    }
  });

  it("that no fabric has is refused", () => {
    for (const field of ["", ".", "warp.", "warp.color.0", "__proto__", "constructor.prototype", "warp.__proto__", "toString"])
      for (const value of ODD) expect(after(start, { type: "field/set", field, value }).fabric.draft).toBe(start.fabric.draft);
  });

  it("of the scene and of the comparison", () => {
    for (const value of ODD) {
      for (const key of [...Object.keys(start.scene), "other"])
        showAll(after(start, { type: "scene/set", scene: { [key]: value } } as Action));
      for (const key of [...Object.keys(start.comparison), "other"]) {
        const { comparison } = after(start, { type: "comparison/set", comparison: { [key]: value } } as Action);
        expect(comparison.before).toBeNull();
        expect(comparison.position >= 0 && comparison.position <= 1).toBe(true);
      }
    }
  });
});

describe("edits at random", () => {
  const WEAVES = ["plain", "twill 2/2", "satin 8/3", "houndstooth 4", "denim", "waffle 8", "log cabin 4", "herringbone 2/2 8"];
  const HEXES = ["#102030", "#fff", "#c0ffee", "lab(50 10 -20)"];

  function randomAction(random: () => number): Action {
    const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]!;
    // One value in four is odd.
    const or = (usual: unknown): unknown => (random() < 0.25 ? pick(ODD) : usual);
    const small = (): unknown => or(Math.floor(random() * 12));
    const family = or(pick(["warp", "weft"]));
    const region = (): object => ({ firstEnd: small(), firstPick: small(), ends: small(), picks: small() });
    const number = (): unknown => or(pick([0, 0.1, 0.3, 1, 2, 12, 30, 60]));
    const actions: (() => object)[] = [
      () => ({ type: "field/set", field: pick(fieldNames()), value: number(), stroke: or("a") }),
      () => ({ type: "fields/set", values: { [pick(fieldNames())]: number(), [pick(fieldNames())]: number() } }),
      () => ({ type: "field/set", field: pick(["warp.count", "weft.count"]), value: or(pick(["20s", "Ne 40/2", "2/60 Nm", "75/36 dtex"])) }),
      () => ({ type: "weave/choose", weave: or(pick(WEAVES)) }),
      () => ({ type: "draft/crossing", pick: small(), end: small(), isUp: or(random() < 0.5), stroke: or("b") }),
      () => ({ type: "draft/thread", end: small(), shaft: small() }),
      () => ({ type: "draft/tie", treadle: small(), shaft: small(), isIn: or(random() < 0.5) }),
      () => ({ type: "draft/press", pick: small(), treadle: small() }),
      () => ({ type: "draft/lift", pick: small(), shaft: small(), isIn: or(random() < 0.5) }),
      () => ({ type: "draft/order", part: or(pick(["threading", "treadling"])), order: or(pick(ORDERS)) }),
      () => ({ type: "draft/plan", kind: or(pick(["liftplan", "treadling"])) }),
      () => ({ type: "draft/size", ends: or(2 + Math.floor(random() * 30)), picks: or(2 + Math.floor(random() * 30)) }),
      () => ({ type: "draft/shafts", shafts: small(), treadles: small() }),
      () => ({ type: "draft/over" }),
      () => ({ type: "draft/block", region: or(region()), change: or(pick(BLOCK_CHANGES)) }),
      () => ({ type: "draft/paste", region: or(region()), block: or({ ends: or(2), picks: 2, drawdown: or(Uint8Array.of(1, 0, 0, 1)) }) }),
      () => ({ type: "draft/fill", region: or(region()), weave: or(pick(WEAVES)) }),
      () => ({ type: "draft/repeat", region: or(region()) }),
      () => ({ type: "colour/paint", family, thread: small(), hex: or(pick(HEXES)) }),
      () => ({ type: "colour/swap", family, from: or(pick(HEXES)), to: or(pick(HEXES)) }),
      () => ({ type: "colour/order", family, hexes: or([pick(HEXES), or(pick(HEXES)), pick(HEXES)]) }),
      () => ({ type: "history/undo" }),
      () => ({ type: "history/redo" }),
      () => ({ type: "scene/set", scene: { [pick(["shape", "exposure", "lampStrength"])]: or(pick([...SHAPES, 0, 1])) } }),
      () => ({ type: "comparison/set", comparison: { [pick(["mode", "position", "left"])]: or(pick(["off", "models", 0.2, "lobes"])) } }),
      () => ({ type: "comparison/keep" }),
      () => ({ type: "comparison/exchange" }),
      () => ({ type: "tab/show", tab: or(pick(TABS)) }),
      () => ({ type: "notice/add", kind: or("fault"), text: or("text") }),
      () => ({ type: "notice/dismiss", id: small() }),
    ];
    return pick(actions)() as Action;
  }

  it.each([1, 2, 3, 4, 5])("250 of them, seed %d, end in cloth that is shown, saved and read again", async (seed) => {
    const random = randomOf(seed);
    let state = first(HOUNDSTOOTH);
    let edits = 0;
    for (let step = 0; step < 250; step++) {
      const action = randomAction(random);
      const next = after(state, action);
      if (next.fabric !== state.fabric) {
        edits++;
        showAll(next);
        keptAndRead(next, edits % 20 === 0);
      }
      state = next;
    }
    // Random edits that were all refused would test nothing.
    expect(edits).toBeGreaterThan(40);
    const link = await linkOf(state.fabric);
    expect(fabricText((await fabricOfLink(`#${link}`))!)).toBe(fabricText(state.fabric));
  });
});

describe("what was kept", () => {
  const draftOfOwn = reduce(first(HOUNDSTOOTH), { type: "draft/crossing", pick: 0, end: 0, isUp: false });
  const full = reduce(draftOfOwn, { type: "comparison/keep" });

  /** The JSON with another value at one place, chosen at random. */
  function damaged(json: unknown, random: () => number): unknown {
    if (typeof json !== "object" || json === null || random() < 0.12) return ODD[Math.floor(random() * ODD.length)];
    const keys = Object.keys(json);
    const key = keys[Math.floor(random() * keys.length)];
    if (key === undefined) return ODD[Math.floor(random() * ODD.length)];
    const copy = (Array.isArray(json) ? [...(json as unknown[])] : { ...json }) as Record<string, unknown>;
    if (random() < 0.05) delete copy[key];
    else copy[key] = damaged(copy[key], random);
    return copy;
  }

  it("is read as a document, or refused, whatever became of its JSON", () => {
    const random = randomOf(7);
    const json: unknown = JSON.parse(documentText(full));
    let read = 0;
    for (let step = 0; step < 1000; step++) {
      const text = JSON.stringify(damaged(json, random), (_, value: unknown) => (typeof value === "bigint" ? String(value) : value)) ?? "null";
      try {
        const kept = documentOf(text);
        read++;
        showAll({ ...full, ...kept });
      } catch (error) {
        if (!isInputError(error) && !(error instanceof SyntaxError)) throw new Error(text.slice(0, 300), { cause: error });
      }
    }
    expect(read).toBeGreaterThan(100);
    expect(read).toBeLessThan(900);
  });

  it("is refused where its text was cut", () => {
    const text = documentText(full);
    for (let end = 0; end < text.length; end += 97) expect(() => documentOf(text.slice(0, end))).toThrow(SyntaxError);
  });

  it("holds the count that once ended the page, which is refused", () => {
    const json = { fabric: { fields: { weave: "plain", warp: { count: "thin" } } }, before: null, scene: {} };
    expect(() => documentOf(JSON.stringify(json))).toThrow(/warp\.count: The yarn count "thin" is not known/);
    expect(() => fabricFromJson({ fields: { weave: "plain", weft: { count: "60/2 Nm" } } })).toThrow(/60 plies/);
  });

  it("goes on where the page was left: light, comparison, undo and redo", () => {
    let state = first({ weave: "plain" });
    for (const value of [10, 11, 12, 13]) state = reduce(state, { type: "field/set", field: "ends_per_cm", value });
    state = reduce(state, { type: "history/undo" });
    state = reduce(state, { type: "scene/set", scene: { exposure: 1.5 } });
    const read = { ...firstState(state.fabric), ...documentOf(documentText(state)) };
    expect(read.scene).toEqual(state.scene);
    expect(read.fabric.fields.ends_per_cm).toBe(12);
    expect(reduce(read, { type: "history/undo" }).fabric.fields.ends_per_cm).toBe(11);
    expect(reduce(read, { type: "history/redo" }).fabric.fields.ends_per_cm).toBe(13);
  });

  it("keeps the latest steps of large drafts, as many as there is room for", () => {
    let state = first({ weave: "plain" });
    state = reduce(state, { type: "draft/size", ends: 800, picks: 800 });
    for (let end = 0; end < 16; end++) state = reduce(state, { type: "draft/crossing", pick: 0, end, isUp: end % 2 === 1 });
    const text = documentText(state);
    expect(text.length).toBeLessThan(2_000_000);
    const { past } = documentOf(text).history;
    expect(past.length).toBeGreaterThan(0);
    expect(past.length).toBeLessThan(state.history.past.length);
    expect(fabricText(past.at(-1)!)).toBe(fabricText(state.history.past.at(-1)!));
  });
});

describe("an edit that is refused", () => {
  it("is told where it was made, and nowhere else", () => {
    const store = new Store(first({ weave: "plain" }));
    const { state } = store;
    let told = "";
    store.dispatch({ type: "field/set", field: "warp.count", value: "60/2 Nm" }, (sentence) => (told = sentence));
    expect(told).toMatch(/^warp\.count: .*write "Nm 60\/2"/);
    expect(store.state).toBe(state);
  });

  it("of two fields changes neither", () => {
    const start = first({ weave: "plain" });
    expect(() => reduce(start, { type: "fields/set", values: { "warp.count": "20s", "weft.count": "x" } })).toThrow(/weft\.count/);
  });

  it("by a fault of the page's own is told too", () => {
    const store = new Store(first({ weave: "plain" }));
    const { fabric } = store.state;
    store.dispatch({ type: "colour/order", family: "warp", get hexes(): string[] { throw new TypeError("gone"); } });
    expect(store.state.fabric).toBe(fabric);
    expect(store.state.notices.at(-1)?.text).toBe("This could not be done, and nothing was changed: gone.");
  });
});

import { loadDraft, loomOf, planDrawdown, type FabricFields } from "loomlight-fabric";
import { describe, expect, it } from "vitest";

import { fabricOfLink, linkOf } from "../src/link.ts";
import { orderText, parseOrder } from "../src/panels/colour_order.ts";
import { cellAt, fittingCell, layoutOf, panelWindow, placeOf, planSize } from "../src/panels/draft_grid.ts";
import { reduce } from "../src/reducers/index.ts";
import type { Action } from "../src/state/actions.ts";
import { firstState, woven, type State } from "../src/state/document.ts";
import { Store } from "../src/state/store.ts";
import { clothPicture } from "../src/view/cloth_picture.ts";

const first = (fields: FabricFields): State => firstState({ fields, draft: loadDraft(fields) });
const after = (state: State, ...actions: Action[]): State => actions.reduce(reduce, state);

describe("the document", () => {
  it("undoes a drag as one step, and redoes it", () => {
    const start = first({ weave: "plain" });
    const dragged = after(
      start,
      { type: "field/set", field: "warp.roughness", value: 0.5, stroke: "a" },
      { type: "field/set", field: "warp.roughness", value: 0.6, stroke: "a" },
      { type: "field/set", field: "warp.roughness", value: 0.7, stroke: "b" },
    );
    expect(dragged.fabric.fields.warp?.roughness).toBe(0.7);
    const once = after(dragged, { type: "history/undo" });
    expect(once.fabric.fields.warp?.roughness).toBe(0.6);
    const twice = after(once, { type: "history/undo" });
    expect(twice.fabric).toBe(start.fabric);
    expect(after(twice, { type: "history/redo" }).fabric).toBe(once.fabric);
  });

  it("tells a fault as a notice and keeps the fabric", () => {
    const store = new Store(first({ weave: "plain" }));
    const { fabric } = store.state;
    store.dispatch({ type: "field/set", field: "warp.roughness", value: 7 });
    expect(store.state.fabric).toBe(fabric);
    expect(store.state.notices[0]?.text).toMatch(/warp.roughness = 7 .* from 0.01 to 1/);
  });

  it("refuses an edit after which nothing interlaces", () => {
    const state = first({ weave: "plain" });
    const one = after(state, { type: "draft/crossing", pick: 0, end: 0, isUp: false });
    expect(() => reduce(one, { type: "draft/crossing", pick: 1, end: 1, isUp: false })).toThrow(/interlaces/);
  });

  it("makes a named weave a draft of its own by the first edit, colours included", () => {
    const state = after(first({ weave: "houndstooth 4" }), { type: "draft/crossing", pick: 0, end: 0, isUp: false });
    expect(state.fabric.fields.weave).toBeUndefined();
    expect(state.fabric.fields.draft).toBe("houndstooth-4.wif");
    expect(woven(state.fabric).drawdown[0]).toBe(0);
    const plan = state.fabric.draft.loom;
    expect(plan === null ? null : planDrawdown(plan).drawdown).toEqual(state.fabric.draft.drawdown);
  });

  it("replaces a gap by a width and keeps one unit of a sett", () => {
    const state = after(
      first({ weave: "plain", epi: 50, warp: { gap: 0.2 } }),
      { type: "field/set", field: "warp.width_mm", value: 0.3 },
      { type: "field/set", field: "ends_per_cm", value: 22 },
    );
    expect(state.fabric.fields.warp).toEqual({ width_mm: 0.3 });
    expect(state.fabric.fields).not.toHaveProperty("epi");
  });
});

describe("the link", () => {
  it("carries a named weave and a draft of one's own", async () => {
    for (const actions of [[], [{ type: "draft/crossing", pick: 0, end: 1, isUp: true } as const]]) {
      const { fabric } = after(first({ weave: "twill 2/2", warp: { color: "#123456" } }), ...actions);
      const read = await fabricOfLink(`#${await linkOf(fabric)}`);
      expect(read?.fields).toEqual(fabric.fields);
      expect(read?.draft.drawdown).toEqual(fabric.draft.drawdown);
    }
  });

  it("is null where the address carries nothing, and fails where it was cut", async () => {
    expect(await fabricOfLink("")).toBeNull();
    const link = await linkOf(first({ weave: "plain" }).fabric);
    await expect(fabricOfLink(`#${link!.slice(0, -6)}`)).rejects.toThrow();
  });
});

describe("panels", () => {
  it("write and read an order of colours", () => {
    const hexes = ["#000000", "#000000", "#ffffff", "#000000"];
    expect(orderText(hexes)).toBe("2a 1b 1a");
    expect(parseOrder("2a 1b 1a", hexes, "#ff0000")).toEqual(hexes);
    expect(parseOrder("2b z", hexes, "#ff0000")).toEqual(["#ffffff", "#ffffff", "#ff0000"]);
    expect(() => parseOrder("4q", hexes, "#ff0000")).toThrow(/4q/);
  });

  it("find each cell of a draft where it is drawn", () => {
    const draft = loadDraft({ weave: "twill 3/1" });
    const { loom } = after(first({ weave: "twill 3/1" }), { type: "draft/plan", kind: "treadling" }).fabric.draft;
    const layout = layoutOf(loom!, panelWindow(draft, 0, 0));
    for (const part of ["drawdown", "threading", "tieup", "treadling", "warp", "weft"] as const) {
      const place = placeOf(layout, { part, column: 0, row: 0 })!;
      expect(cellAt(layout, place.x + 0.5, place.y + 0.5)).toEqual({ part, column: 0, row: 0 });
    }
    expect(cellAt(layout, 0.5, 1.5)).toBeNull();
  });

  it("fit a draft into their width", () => {
    for (const weave of ["denim", "twill 2/2", "log cabin 8"]) {
      const draft = woven(first({ weave }).fabric);
      const loom = loomOf(draft);
      const layout = layoutOf(loom, panelWindow(draft, 0, 0));
      const plan = planSize(loom);
      expect([layout.columns, layout.rows]).toEqual([draft.ends + plan.columns, draft.picks + plan.rows]);
      const cell = fittingCell(layout, { width: 364, height: 1000 }, 7, 26);
      expect(layout.columns * cell + 1).toBeLessThanOrEqual(364);
      expect(cell === 26 || layout.columns * (cell + 1) + 1 > 364).toBe(true);
    }
  });

  it("draw the thread on top in its colour", () => {
    const fields = { weave: "plain", warp: { color: "#ff0000" }, weft: { color: "#0000ff" } };
    const { width, height, rgba } = clothPicture(woven(first(fields).fabric), { pixels: 8, gap: { warp: 0.1, weft: 0.1 } });
    // End 1 and pick 1, at the bottom left, have the warp on top.
    const at = ((height - 4) * width + 4) * 4;
    expect(rgba[at]!).toBeGreaterThan(rgba[at + 2]! + 50);
    const beside = ((height - 4) * width + 12) * 4;
    expect(rgba[beside + 2]!).toBeGreaterThan(rgba[beside]! + 50);
    // From afar each crossing is a pixel; the lower row is the last.
    const far = clothPicture(woven(first(fields).fabric), { pixels: 1, gap: { warp: 0.1, weft: 0.1 } });
    const isRed = [0, 1, 2, 3].map((pixel) => far.rgba[4 * pixel]! > far.rgba[4 * pixel + 2]! + 50);
    expect([far.width, far.height, ...isRed]).toEqual([2, 2, false, true, true, false]);
  });
});

/** What the page says and asks. */
import { looksPhotographed } from "loomlight-fabric";
import { describe, expect, it } from "vitest";

import { inWords } from "../src/controls/symbols.ts";
import { orderText, parseOrder } from "../src/panels/colour_order.ts";
import { fittingCell, layoutOf } from "../src/panels/draft_grid.ts";
import { withNotice, withoutTopic } from "../src/reducers/notices.ts";
import type { Notice } from "../src/state/document.ts";
import { framing } from "../src/view/framing.ts";
import { hasUv, readOwnMesh, serverMeshOf, type Geometry } from "../src/view/own_mesh.ts";

describe("an order of colours", () => {
  const [a, b, z] = ["#112233", "#445566", "#778899"];

  it("is written by its shortest repeat", () => {
    const typed = parseOrder("4a 2z", [a, b], z);
    const woven = Array.from({ length: 336 }, (_, thread) => typed[thread % typed.length]!);
    expect(orderText(woven)).toBe("4a 2b");
    expect(parseOrder(orderText(woven), woven, z)).toEqual(typed);
  });

  it("of one colour, or without a repeat, is written whole", () => {
    expect(orderText([a, a, a])).toBe("3a");
    expect(orderText([a, b, b])).toBe("1a 2b");
  });
});

describe("a sentence about a field", () => {
  it("calls it as the page does", () => {
    expect(inWords("picks_per_cm = 9999 is out of range: it lies between 0.1 and 1000.")).toMatch(/^Picks per cm = 9999/);
    expect(inWords("weft.twist_deg = 99 is out of range")).toMatch(/^[A-Z][a-z ]+ of the weft = 99/);
  });

  it("stays where it names none", () => {
    const text = "The repeat would have 4 ends: at most 3 can be used.";
    expect(inWords(text)).toBe(text);
  });
});

describe("notices", () => {
  const told = (texts: readonly string[], topic?: "file"): readonly Notice[] =>
    texts.reduce<readonly Notice[]>((notices, text) => withNotice(notices, { kind: "fault", text, ...(topic === undefined ? {} : { topic }) }), []);

  it("do not pile up", () => expect(told(["one", "two", "three"]).map(({ text }) => text)).toEqual(["two", "three"]));

  it("of earlier files go", () => {
    const both = withNotice(told(["a.wif is no draft."], "file"), { kind: "warning", text: "Another." });
    expect(withoutTopic(both, "file").map(({ text }) => text)).toEqual(["Another."]);
  });
});

describe("a picture", () => {
  const of = (colours: number): Uint8ClampedArray =>
    Uint8ClampedArray.from({ length: 4 * 400 }, (_, at) => (at % 4 === 3 ? 255 : at % 4 === 0 ? (at >> 2) % colours : 0));

  it("of more than a dozen colours may be a photograph", () => {
    expect(looksPhotographed(of(12))).toBe(false);
    expect(looksPhotographed(of(13))).toBe(true);
  });
});

describe("a draft in the panel", () => {
  const PANEL = 350;

  it("of 64 ends is shown whole, with its tie-up and treadling", () => {
    const loom = { shafts: 8, treadles: 10, threading: [], tieup: [], treadling: [], liftplan: null, risingShed: true } as unknown as Parameters<typeof layoutOf>[0];
    const layout = layoutOf(loom, { firstEnd: 0, firstPick: 0, ends: 64, picks: 64 });
    expect(layout.boxes.map(({ part }) => part)).toContain("treadling");
    const cell = fittingCell({ columns: layout.columns, rows: 1 }, { width: PANEL, height: Infinity }, 4, 26);
    expect(cell * layout.columns).toBeLessThanOrEqual(PANEL);
  });
});

describe("a part of a mesh", () => {
  const part = (uv: readonly number[] | null): Geometry => ({
    attributes: {
      position: { array: [0, 0, 0, 1, 0, 0, 0, 1, 0], count: 3 },
      ...(uv === null ? {} : { uv: { array: uv, count: 3 } }),
    },
    index: null,
    computeVertexNormals: () => undefined,
  });

  it("is cloth where its uv span an area", () => {
    expect(hasUv(part([0, 0, 1, 0, 0, 1]))).toBe(true);
    expect(hasUv(part(null))).toBe(false);
    expect(hasUv(part([0, 0, 1, 1, 2, 2]))).toBe(false);
  });
});

describe("the camera that frames a piece", () => {
  /** Least and most x and y of points in the picture, −1 to 1. */
  const extent = (points: readonly number[], width: number, height: number, from: readonly [number, number, number]): number[] => {
    const { origin, target } = framing(points, from, width, height);
    const minus = (a: readonly number[], b: readonly number[]): number[] => a.map((value, axis) => value - b[axis]!);
    const dot = (a: readonly number[], b: readonly number[]): number => a.reduce((sum, value, axis) => sum + value * b[axis]!, 0);
    const length = Math.hypot(...minus(origin, target));
    const back = minus(origin, target).map((value) => value / length);
    const across = Math.hypot(back[0]!, back[2]!);
    const right = [back[2]! / across, 0, -back[0]! / across];
    const up = [back[1]! * right[2]!, back[2]! * right[0]! - back[0]! * right[2]!, -back[1]! * right[0]!];
    const half = Math.tan((13 * Math.PI) / 180) / Math.min(width, height);
    const xs: number[] = [];
    const ys: number[] = [];
    for (let at = 0; at < points.length; at += 3) {
      const offset = minus(points.slice(at, at + 3), origin);
      const away = -dot(offset, back);
      xs.push(dot(offset, right) / away / (half * width));
      ys.push(dot(offset, up) / away / (half * height));
    }
    return [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  };

  it("centres it and fills the picture, whatever its proportions", () => {
    const points = [-0.3, 0, -0.3, 0.3, 0, -0.3, -0.3, 0, 0.3, 0.3, 0, 0.3, 0, 0.35, 0];
    for (const [width, height] of [[1000, 790], [300, 900], [900, 300]] as const) {
      const [left, right, low, high] = extent(points, width, height, [0.35, 0.55, 1]) as [number, number, number, number];
      const fills = Math.max(right - left, high - low) / 2;
      expect(fills).toBeGreaterThan(0.85);
      expect(fills).toBeLessThan(1);
      // Exactly so along the side that it fills; along the other, of which depth takes a part, nearly.
      expect(Math.abs(left + right)).toBeLessThan(0.15);
      expect(Math.abs(low + high)).toBeLessThan(0.15);
    }
  });
});

describe("a mesh that the server read", () => {
  it("is positions, normals, uv and triangles, and what is bare", () => {
    const head = new TextEncoder().encode('{"vertices":3,"triangles":1,"bareVertices":1,"bareTriangles":1,"warnings":["cut"]} ');
    const numbers = [[1, 2, 3, 4, 5, 6, 7, 8, 9], [0, 0, 1, 0, 0, 1, 0, 0, 1], [0, 0, 1, 0, 0, 1], [5, 5, 5], [0, 1, 0]].flat();
    const size = head.length + (-head.length & 3);
    const content = new ArrayBuffer(4 + size + 4 * (numbers.length + 6));
    new DataView(content).setUint32(0, size, true);
    new Uint8Array(content, 4).fill(32, 0, size).set(head);
    new Float32Array(content, 4 + size, numbers.length).set(numbers);
    new Uint32Array(content, 4 + size + 4 * numbers.length).set([2, 1, 0, 0, 0, 0]);
    const { mesh, bare, warnings } = serverMeshOf(content);
    expect([...(mesh.positions as Float32Array)]).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9]);
    expect([...(mesh.uv as Float32Array)]).toEqual([0, 0, 1, 0, 0, 1]);
    expect([...(mesh.triangles as Uint32Array)]).toEqual([2, 1, 0]);
    expect([...(bare!.positions as Float32Array)]).toEqual([5, 5, 5]);
    expect(warnings).toEqual(["cut"]);
  });

  it("needs a server, which a static page says", async () => {
    await expect(readOwnMesh(new File(["#usda 1.0"], "shirt.usda"), null)).rejects.toThrow("shirt.usda is read by `loomlight view`, which this page runs without");
  });
});

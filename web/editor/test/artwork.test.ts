/** Artwork of the document: what is kept of it, and that odd values end nothing. */
import { artworkFromJson, artworkToJson, isInputError, weaveArtwork, type Artwork, type FabricFields } from "loomlight-fabric";
import { expect, test } from "vitest";

import { fabricFiles } from "../src/files.ts";
import { documentOf, documentText } from "../src/keeping/document_text.ts";
import { reduce } from "../src/reducers/index.ts";
import type { Action } from "../src/state/actions.ts";
import { firstState, type Fabric, type State } from "../src/state/document.ts";
import { fabricFromJson, fabricText } from "../src/state/fabric_json.ts";
import { fieldNames, ODD, randomOf, showAll } from "./odd.ts";

const STEEP = { ends: 4, picks: 2, drawdown: Uint8Array.of(1, 1, 0, 0, 0, 0, 1, 1) };
/** 400 pixels, so that a run is longer than one group of bits holds. */
const ARTWORK: Artwork = {
  ends: 20,
  rows: 20,
  colours: ["#c00000", "#ffffff"],
  index: Uint8Array.from({ length: 400 }, (_, at) => (at > 300 && at % 3 === 0 ? 1 : 0)),
  drafts: { "twills/steep.wif": STEEP },
};
const FIELDS: FabricFields = { image: "art.png", weaves: { "#c00000": "twill 2/2", "#FFF": "twills/steep.wif" } };

const fabricOf = (fields: FabricFields): Fabric => ({ fields, draft: weaveArtwork(ARTWORK, fields, "art.png").draft, artwork: ARTWORK });
const start = (): State => firstState(fabricOf(FIELDS));

test("what is kept is the same cloth", () => {
  const { fabric } = start();
  expect(artworkFromJson(artworkToJson(ARTWORK))).toEqual(ARTWORK);
  const back = documentOf(documentText(start())).fabric;
  expect(back.draft.drawdown).toEqual(fabric.draft.drawdown);
  expect(fabricText(back)).toBe(fabricText(fabric));
  // The draft follows from the artwork.
  expect(JSON.parse(fabricText(fabric)).draft).toBeUndefined();
});

test("a fabric file is saved with its artwork and its drafts", () => {
  const files = fabricFiles(start().fabric);
  expect(files.map(({ name }) => name)).toEqual(["art.toml", "art.png", "steep.wif"]);
  expect(files[0]!.content).toContain('"#FFF" = "steep.wif"');
  const picture = files[1]!.content;
  if (typeof picture === "string") throw new Error("no picture");
  // The highest row is the first of a picture: pixel 380 has no number that 3 divides, 381 has.
  expect([...picture.data.subarray(0, 8)]).toEqual([192, 0, 0, 255, 255, 255, 255, 255]);
  expect([picture.width, picture.height]).toEqual([20, 20]);
});

test.each([
  { ends: 0 },
  { rows: 1e9 },
  { colours: [] },
  { colours: ["red"] },
  { runs: "" },
  { runs: "AA==" },
  { runs: "!" },
  { runs: btoa("\x02\x90\x03") },
  { runs: btoa("\x00\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01") },
  { drafts: [{ name: "a", ends: 2, picks: 2, drawdown: "" }] },
  { drafts: null },
])("JSON that is no artwork is refused: %j", (wrong) => {
  expect(() => artworkFromJson({ ...artworkToJson(ARTWORK), ...wrong })).toThrow(/artwork|draft/);
});

test("weaves of an artwork that is not at hand are refused", () => {
  const { artwork: _artwork, ...bare } = start().fabric;
  const state = firstState(bare);
  expect(() => reduce(state, { type: "field/set", field: "weaves.#c00000", value: "plain" })).toThrow(/open the artwork/);
  expect(() => reduce(state, { type: "artwork/wefts", wefts: 2 })).toThrow(/several wefts/);
  expect(reduce(state, { type: "field/set", field: "warp.roughness", value: 0.4 }).fabric.draft).toBe(bare.draft);
});

test("an edited draft leaves its artwork", () => {
  const { fabric } = reduce(start(), { type: "draft/crossing", pick: 0, end: 0, isUp: false });
  expect(fabric.artwork).toBeUndefined();
  expect(fabric.fields.weaves).toBeUndefined();
});

test("setts weave anew where the regulator stands still", () => {
  const wefts = reduce(start(), { type: "artwork/wefts", wefts: 2 });
  const fine = [
    { type: "field/set", field: "artwork.regulator", value: 2 },
    { type: "field/set", field: "ends_per_cm", value: 40 },
  ].reduce((state, action) => reduce(state, action as Action), wefts);
  // Rows are as close as ends where the file does not say.
  expect(fine.fabric.draft.weft.spacingMm![0]).toBeCloseTo(0.25, 12);
});

test("edits at random end nothing", () => {
  const random = randomOf(65);
  const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]!;
  const or = (usual: unknown): unknown => (random() < 0.3 ? pick(ODD) : usual);
  const weave = (): unknown => or(pick(["plain", "satin 8/3", "back", "twill 2/2 s", ["plain", "back"], ["sateen 5", "satin 8"], "gone.wif"]));
  let state = start();
  for (let step = 0; step < 400; step++) {
    const action = pick([
      () => ({ type: "field/set", field: `weaves.${pick(["#c00000", "#FFF", "#ffffff", "x", ""])}`, value: weave() }),
      () => ({ type: "fields/set", values: { weaves: or({ "#c00000": weave(), "#fff": weave() }) } }),
      () => ({ type: "field/set", field: pick(["artwork.order", "artwork.regulator", "artwork.longest_float", "artwork.nearest"]), value: or(pick([2, 5, "1 2", true, undefined])) }),
      () => ({ type: "artwork/wefts", wefts: or(pick([1, 2, 3])) }),
      () => ({ type: "artwork/read", as: or(pick(["weaves", "drawdown"])) }),
      () => ({ type: "field/set", field: pick(fieldNames()), value: or(pick([0.1, 12, 30])) }),
      () => ({ type: "history/undo" }),
    ])() as Action;
    try {
      state = reduce(state, action);
    } catch (error) {
      if (!isInputError(error)) throw new Error(`${JSON.stringify(action)} throws ${String(error)}`, { cause: error });
    }
    if (step % 8 === 0) showAll(state);
    if (step % 40 === 0) expect(fabricText(fabricFromJson(JSON.parse(fabricText(state.fabric))))).toBe(fabricText(state.fabric));
  }
});

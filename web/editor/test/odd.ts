/** Odd values, a seeded source of random numbers, and all that panels and cloth compute of a state. */
import {
  bendsOf,
  clothFacts,
  coloursInUse,
  FABRIC,
  FAMILIES,
  familySpacing,
  familyWidth,
  loomOf,
  parseColour,
  threadHexes,
  yarnTex,
  type FieldTable,
} from "loomlight-fabric";
import { lookOf } from "loomlight-web/look";

import { fabricFiles, wifFile } from "../src/files.ts";
import { geometryKey } from "../src/openness.ts";
import { orderText } from "../src/panels/colour_order.ts";
import { layoutOf, panelWindow } from "../src/panels/draft_grid.ts";
import { nameOf, woven, type Fabric, type State } from "../src/state/document.ts";

/** Values that no field expects all of; JSON has most of them. */
export const ODD: readonly unknown[] = [
  undefined,
  null,
  NaN,
  Infinity,
  -1,
  0,
  0.5,
  3,
  1e308,
  5e-324,
  "",
  " ",
  "20s",
  "60/2 Nm",
  "nonsense",
  "#12",
  "\u0000💥\n[warp]",
  "9".repeat(5000),
  [],
  {},
  [1, 2, 3],
  ["#102030", "#405060", "#708090"],
  [["a"]],
  true,
  { color: "#fff" },
  10n,
  Symbol("odd"),
  Object.create(null),
];

/** Random numbers in [0, 1) that are the same each time (mulberry32). */
export function randomOf(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Dotted names of all fields of a fabric. */
export function fieldNames(table: FieldTable = FABRIC, parent = ""): string[] {
  return Object.entries(table).flatMap(([key, kind]) =>
    kind.kind === "table" ? [parent + key, ...fieldNames(kind.fields, `${parent}${key}.`)] : [parent + key],
  );
}

/** Computes everything that is shown or saved of a state; throws what a panel would throw. */
export function showAll(state: State): void {
  showFabric(state.fabric);
  if (state.comparison.before !== null) showFabric(state.comparison.before);
  const { shape, surroundings, ...numbers } = state.scene;
  for (const [name, value] of Object.entries(numbers))
    if (!Number.isFinite(value)) throw new Error(`scene.${name} = ${String(value)}`);
  if (typeof shape !== "string" || typeof surroundings !== "string") throw new Error("no scene");
  for (const { text } of state.notices) if (typeof text !== "string") throw new Error("a notice without a text");
}

function showFabric(fabric: Fabric): void {
  const draft = woven(fabric);
  const { fields } = fabric;
  if (typeof nameOf(fabric) !== "string") throw new Error("no name");
  for (const family of FAMILIES) {
    const hexes = threadHexes(draft, family);
    coloursInUse(hexes);
    orderText(hexes);
    if (!hexes.every((hex) => /^#[0-9a-f]{6}$/.test(hex))) throw new Error(`a colour is ${hexes.join()}`);
    const spacing = familySpacing(fields, family, draft);
    const width = familyWidth(fields, family, draft, spacing);
    for (const lengths of [spacing, width]) if (!lengths.every((length) => length > 0 && Number.isFinite(length))) throw new Error("a length");
    const { count, specular_tint: tint } = fields[family] ?? {};
    if (count !== undefined) yarnTex(count);
    if (tint !== undefined) parseColour(tint, "tint");
  }
  if (!Number.isFinite(clothFacts(fields, draft).weight)) throw new Error("a weight");
  bendsOf(draft);
  layoutOf(loomOf(draft), panelWindow(draft, 0, 0));
  lookOf(fields, fabric.draft);
  geometryKey(fabric);
  fabricFiles(fabric);
  wifFile(fabric);
}

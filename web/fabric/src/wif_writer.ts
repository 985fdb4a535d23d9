/** Writes drafts as weaving information files (WIF 1.1), without losing content of the original file. */
import { linearToSrgb, srgbToLinear } from "./colour.ts";
import type { Draft, Entries, FamilyDefaults, LoomPlan, Sets, Threads, WifSource } from "./draft.ts";
import { deriveLoomPlan, weaves } from "./loom.ts";
import { rint } from "./numbers.ts";
import { pickRows } from "./palette.ts";
import { UNIT_MM, unitName } from "./wif_values.ts";

type Lines = (readonly [string, string | null])[];
type Sections = Map<string, Lines>;

const NO_DEFAULTS: FamilyDefaults = {
  threads: null,
  unit: "",
  colorIndex: null,
  spacingMm: null,
  thicknessMm: null,
};

/**
 * The text of a file with the draft, its colours, spacings, notes and private sections. Reading it gives the same draft.
 *
 * A draft that has no loom plan, or one that no longer weaves its drawdown, gets a derived one, with as many shafts
 * as it needs. Colours are written in the range of the file they came from, otherwise in 0 to 255 or, where that
 * would round them, 0 to 65535.
 *
 * Source: Weaving Information File specification 1.1, 20 April 1997.
 */
export function writeWif(draft: Draft): string {
  const { source } = draft;
  const loom = planOf(draft);
  const palette = paletteOf(draft);
  const sections: Sections = new Map<string, Lines>([
    [
      "WEAVING",
      [
        ["Shafts", String(loom.shafts)],
        ["Treadles", String(loom.treadles)],
        ["Rising Shed", loom.risingShed ? "true" : "false"],
      ],
    ],
    ["WARP", [["Threads", String(Math.max(draft.ends, source?.warp.threads ?? 0))]]],
    ["WEFT", [["Threads", String(Math.max(draft.picks, source?.weft.threads ?? 0))]]],
    ["TEXT", draft.name.trim() === "" ? [] : [["Title", oneLine(draft.name)]]],
    ["NOTES", draft.notes.map((note, index) => [String(index + 1), oneLine(note)] as const)],
    ...colorSections(palette.colors, source),
    ["THREADING", setLines(loom.threading)],
    ["TIEUP", setLines(loom.tieup ?? [])],
    ["TREADLING", setLines(loom.treadling ?? [])],
    ["LIFTPLAN", setLines(loom.liftplan ?? [])],
  ]);
  for (const [family, threads, index, defaults] of [
    ["WARP", draft.warp, palette.warp, source?.warp],
    ["WEFT", draft.weft, palette.weft, source?.weft],
  ] as const) {
    addColors(sections, family, index, palette.isOriginal ? defaults : undefined);
    addLengths(sections, family, threads, defaults);
  }
  for (const [name, entries] of source?.entries ?? [])
    sections.set(name, [...(sections.get(name) ?? []), ...entries]);
  return joined(sections, source?.sections ?? []);
}

function joined(sections: Sections, others: WifSource["sections"]): string {
  const header = sections.get("WIF") ?? OWN_HEADER;
  sections.delete("WIF");
  const written = [...sections].filter(([, lines]) => lines.length > 0);
  const contents = [...written, ...others].map(([name]) => [name, "true"] as const);
  const blocks: (readonly [string, Entries])[] = [
    ["WIF", header],
    ["CONTENTS", contents],
    ...written,
    ...others,
  ];
  return blocks
    .map(([name, lines]) =>
      [`[${name}]`, ...lines.map(([key, value]) => (value === null ? key : `${key}=${value}`)), ""].join("\r\n"),
    )
    .join("\r\n");
}

/** The specification requires this date and this address, those of its own version. */
const OWN_HEADER: Lines = [
  ["Version", "1.1"],
  ["Date", "April 20, 1997"],
  ["Developers", "wif@mhsoft.com"],
  ["Source Program", "loomlight"],
];

function oneLine(text: string): string {
  return text.replace(/[\r\n]+/g, " ").trim();
}

function planOf(draft: Draft): LoomPlan {
  return draft.loom !== null && weaves(draft.loom, draft) ? draft.loom : deriveLoomPlan(draft);
}

function setLines(sets: Sets): Lines {
  return sets.map((members, index) => [String(index + 1), members.join(",") || "0"] as const);
}

/** Colours of a draft as a table and a row per thread. */
interface Palette {
  /** Linear RGB rows [k·3]; k may be 0. */
  readonly colors: Float64Array;
  readonly warp: ArrayLike<number> | null;
  readonly weft: ArrayLike<number> | null;
  /** Whether it is the table that the draft came with. */
  readonly isOriginal: boolean;
}

function paletteOf(draft: Draft): Palette {
  const { palette } = draft;
  if (palette !== null && follows(draft.warp, palette) && follows(draft.weft, palette))
    return { colors: palette, warp: draft.warp.colorIndex, weft: draft.weft.colorIndex, isOriginal: true };
  const rows = new Map<string, number>();
  const colours: number[] = [];
  const indexOf = ({ colors }: Threads): number[] | null => {
    if (colors === null) return null;
    return Array.from({ length: colors.length / 3 }, (_, thread) => {
      const colour = colors.subarray(thread * 3, thread * 3 + 3);
      const key = colour.join();
      const row = rows.get(key) ?? rows.size;
      if (row === rows.size) {
        rows.set(key, row);
        colours.push(...colour);
      }
      return row;
    });
  };
  const warp = indexOf(draft.warp);
  const weft = indexOf(draft.weft);
  return { colors: Float64Array.from(colours), warp, weft, isOriginal: false };
}

function follows(threads: Threads, palette: Float64Array): boolean {
  const { colors, colorIndex } = threads;
  if (colorIndex === null || colors === null) return colors === null;
  return pickRows(palette, colorIndex).every((value, at) => value === colors[at]);
}

function colorSections(colors: Float64Array, source: WifSource | null): [string, Lines][] {
  if (colors.length === 0) return [];
  const [low, high] = exactRange(colors, source?.colorRange ?? [0, 255]);
  const table = components(colors, low, high);
  const lines: Lines = [];
  for (let row = 0; row < table.length / 3; row++)
    lines.push([String(row + 1), table.slice(row * 3, row * 3 + 3).join(",")]);
  return [
    [
      "COLOR PALETTE",
      [
        ["Entries", String(lines.length)],
        ["Range", `${low},${high}`],
      ],
    ],
    ["COLOR TABLE", lines],
  ];
}

function components(colors: Float64Array, low: number, high: number): number[] {
  return Array.from(colors, (value) => rint(linearToSrgb(value) * (high - low) + low));
}

/** The first range whose integers reproduce the colours; the finest one if none does. */
function exactRange(colors: Float64Array, first: readonly [number, number]): readonly [number, number] {
  for (const [low, high] of [first, [0, 255] as const]) {
    const isExact = components(colors, low, high).every(
      (component, at) => Math.abs(srgbToLinear((component - low) / (high - low)) - colors[at]!) <= 1e-9,
    );
    if (isExact) return [low, high];
  }
  return [0, 65535];
}

function mostCommon(values: ArrayLike<number>): number {
  const counts = new Map<number, number>();
  for (const value of Array.from(values)) counts.set(value, (counts.get(value) ?? 0) + 1);
  return [...counts].reduce((best, entry) => (entry[1] > best[1] ? entry : best))[0];
}

function addColors(
  sections: Sections,
  family: "WARP" | "WEFT",
  index: ArrayLike<number> | null,
  known: FamilyDefaults | undefined,
): void {
  if (index === null) return;
  const standard = known === undefined ? mostCommon(index) : known.colorIndex;
  if (standard !== null) sections.get(family)!.push(["Color", String(standard + 1)]);
  sections.set(
    `${family} COLORS`,
    Array.from(index).flatMap((row, thread) =>
      row === standard ? [] : [[String(thread + 1), String(row + 1)] as const],
    ),
  );
}

function addLengths(
  sections: Sections,
  family: "WARP" | "WEFT",
  threads: Threads,
  known: FamilyDefaults = NO_DEFAULTS,
): void {
  const isKnown = known !== NO_DEFAULTS;
  const spelled = known.unit === "" ? "Centimeters" : known.unit;
  const unit = UNIT_MM[unitName(spelled)]!;
  if (threads.spacingMm !== null || threads.thicknessMm !== null || known.unit !== "")
    sections.get(family)!.push(["Units", spelled]);
  for (const [what, lengths, stated] of [
    ["Spacing", threads.spacingMm, known.spacingMm],
    ["Thickness", threads.thicknessMm, known.thicknessMm],
  ] as const) {
    if (lengths === null) continue;
    const standard = isKnown ? stated : mostCommon(lengths);
    if (standard !== null) sections.get(family)!.push([what, decimalText(standard, unit)]);
    sections.set(
      `${family} ${what.toUpperCase()}`,
      Array.from(lengths).flatMap((length, thread) =>
        length === standard ? [] : [[String(thread + 1), decimalText(length, unit)] as const],
      ),
    );
  }
}

/** The shortest decimal that is `lengthMm` again when multiplied by `unit`. */
export function decimalText(lengthMm: number, unit: number): string {
  const quotient = lengthMm / unit;
  for (let digits = 1; digits < 18; digits++) {
    const rounded = Number(quotient.toPrecision(digits));
    if (rounded * unit === lengthMm) return String(rounded);
  }
  const step = Math.abs(quotient) * Number.EPSILON;
  const neighbour = [quotient - step, quotient - step / 2, quotient + step / 2, quotient + step].find(
    (value) => value * unit === lengthMm,
  );
  return String(neighbour ?? quotient);
}

/** Colours, spacings and thicknesses of the threads in a weaving information file. */
import { srgbToLinear } from "./colour.ts";
import type { FamilyDefaults, Threads } from "./draft.ts";
import { InputError } from "./errors.ts";
import { general } from "./numbers.ts";
import { pickRows } from "./palette.ts";
import type { WifText } from "./wif_text.ts";
import {
  integers,
  isInteger,
  lengthMm,
  threadNumber,
  UNIT_MM,
  unitMm,
  unitName,
  withoutComment,
} from "./wif_values.ts";

type Family = "WARP" | "WEFT";

const A_TRIPLE = "a colour: write three whole numbers, as in 255,128,0";
const A_RANGE = "a range of colour components: write two whole numbers, as in 0,255";

/** Linear RGB rows of the colour table, null without one, and its range of components. */
export function readPalette(text: WifText): { palette: Float64Array | null; range: [number, number] } {
  const used = usedColors(text);
  const rows = new Map<number, { key: string; value: string; rgb: number[] }>();
  const passedOver: [string, string, string][] = [];
  for (const [key, value] of text.items("COLOR TABLE")) {
    const number = threadNumber(text, "COLOR TABLE", key, value, "the number of a colour");
    try {
      rows.set(number, { key, value, rgb: integers(text, "COLOR TABLE", key, value, [3], A_TRIPLE) });
    } catch (error) {
      if (used.has(number)) throw error;
      passedOver.push([key, value, `is not ${A_TRIPLE}`]);
    }
  }
  if (rows.size === 0) return { palette: null, range: unusedRange(text) };
  const size = [...rows.keys()].reduce((most, number) => Math.max(most, number), 0);
  const gaps = [...used].filter((number) => number >= 1 && number < size && !rows.has(number));
  if (gaps.length > 0)
    throw new InputError(
      `${text.file}: [COLOR TABLE] lacks the colour ${Math.min(...gaps)}; its ${rows.size} colours are numbered from 1 ` +
        `to ${rows.size} without gaps.`,
    );
  const [low, high] = colorRange(text, Math.max(...[...rows.values()].map(({ rgb }) => Math.max(...rgb))));
  const table = new Float64Array(size * 3).fill(low);
  for (const [number, { key, value, rgb }] of rows) {
    if (Math.min(...rgb) < low || Math.max(...rgb) > high) {
      const fault = `leaves the range ${low} to ${high} that [COLOR PALETTE] Range gives`;
      if (used.has(number)) throw text.fault("COLOR TABLE", key, value, fault);
      passedOver.push([key, value, fault]);
    } else table.set(rgb, (number - 1) * 3);
  }
  for (const [key, value, fault] of passedOver.slice(0, 1))
    text.warn("COLOR TABLE", key, value, `${fault}; it is passed over, as no thread has that colour`);
  return { palette: table.map((component) => srgbToLinear((component - low) / (high - low))), range: [low, high] };
}

/** Numbers of the colours that a thread, or a default, names. */
function usedColors(text: WifText): ReadonlySet<number> {
  const defaults = defaultColors(text);
  const values = ["WARP", "WEFT"].flatMap((family) => text.items(`${family} COLORS`).map(([, value]) => value));
  const first = values.map((value) => withoutComment(value).split(",")[0]!.trim());
  const counted = defaults.includes(0) ? defaults.map((number) => number + 1) : [];
  return new Set([...first.filter(isInteger).map(Number), ...defaults, ...counted]);
}

/** The numbers of colours that [WARP] and [WEFT] give all threads; less of what is no number. */
function defaultColors(text: WifText): number[] {
  const values = ["WARP", "WEFT"].map((family) => text.value(family, "Color"));
  const first = values.map((value) => withoutComment(value).split(",")[0]!.trim());
  return first.filter(isInteger).map(Number);
}

/**
 * Whether the default colours count from 0, as a generator writes them beside a table from 1. That is so where one of
 * them is 0, all counted so are in the table, and no thread has a colour of its own, whose number would count from 1.
 */
export function defaultsCountFromZero(text: WifText, palette: Float64Array | null): boolean {
  const stated = defaultColors(text);
  if (palette === null || stated.length === 0) return false;
  if (Math.min(...stated) !== 0 || Math.max(...stated) >= palette.length / 3) return false;
  const own = ["WARP", "WEFT"].flatMap((family) => text.items(`${family} COLORS`));
  if (own.some(([, value]) => withoutComment(value) !== "")) return false;
  const family = withoutComment(text.value("WARP", "Color")).split(",")[0]!.trim() === "0" ? "WARP" : "WEFT";
  const fault = "counts the colours of [COLOR TABLE] from 0, and the table from 1: defaults are read so";
  text.warn(family, "Color", text.value(family, "Color"), fault);
  return true;
}

/** The range of components where there is no table. */
function unusedRange(text: WifText): [number, number] {
  try {
    return colorRange(text, 0);
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    const value = text.value("COLOR PALETTE", "Range");
    text.warn("COLOR PALETTE", "Range", value, "is passed over, since the file has no [COLOR TABLE]");
    return [0, 255];
  }
}

function colorRange(text: WifText, highest: number): [number, number] {
  const value = text.value("COLOR PALETTE", "Range");
  const form = text.value("COLOR PALETTE", "Form");
  if (form !== "" && withoutComment(form).toUpperCase() !== "RGB")
    text.warn("COLOR PALETTE", "Form", form, "is not known; the colours are read as RGB");
  if (withoutComment(value) !== "") {
    const [low, high] = integers(text, "COLOR PALETTE", "Range", value, [2], A_RANGE) as [number, number];
    if (low >= high)
      throw text.fault("COLOR PALETTE", "Range", value, "is no range: the first number must be the lower");
    return [low, high];
  }
  if (highest > 255)
    throw text.fault(
      "COLOR PALETTE",
      "Range",
      value,
      `is missing, and [COLOR TABLE] goes up to ${highest}: give the lowest and highest component, as in 0,255`,
    );
  if (text.has("COLOR TABLE"))
    text.warn("COLOR PALETTE", "Range", value, "is missing; the colours are read as 0 to 255");
  return [0, 255];
}

/**
 * The threads of one family, and what the file says for all of them.
 *
 * @param firstDefault the number, 0 or 1, by which a default names the first colour of the table.
 */
export function readFamily(
  text: WifText,
  family: Family,
  count: number,
  palette: Float64Array | null,
  firstDefault: 0 | 1,
): { threads: Threads; defaults: FamilyDefaults } {
  const colours = readColors(text, family, count, palette, firstDefault);
  const spacing = readLengths(text, family, "Spacing", count);
  const thickness = readLengths(text, family, "Thickness", count);
  const colors = colours.index !== null && palette !== null ? pickRows(palette, colours.index) : colours.rgb;
  let unit = withoutComment(text.value(family, "Units"));
  if (unit !== "" && !Object.hasOwn(UNIT_MM, unitName(unit))) {
    const said = text.value(family, "Units");
    text.warn(family, "Units", said, "is no known unit; it is passed over, as no length is given in it");
    unit = "";
  }
  return {
    threads: { colors, spacingMm: spacing.lengths, thicknessMm: thickness.lengths, colorIndex: colours.index },
    defaults: {
      threads: null,
      unit,
      colorIndex: colours.standard,
      spacingMm: spacing.standard,
      thicknessMm: thickness.standard,
    },
  };
}

/**
 * Warns of ends and picks thicker than their spacings, which programs write that know neither. One family may be:
 * wefts of a weft-faced cloth are beaten over one another.
 */
export function warnOfThickThreads(text: WifText, warp: Threads, weft: Threads): void {
  const told: string[] = [];
  for (const [name, threads] of [
    ["ends", warp],
    ["picks", weft],
  ] as const) {
    if (threads.thicknessMm === null || threads.spacingMm === null) return;
    const thickness = median(threads.thicknessMm);
    const spacing = median(threads.spacingMm);
    if (thickness <= spacing) return;
    const apart = `${general(spacing, 3)} mm apart and ${general(thickness, 3)} mm thick`;
    told.push(`${general(10 / spacing, 3)} ${name}/cm, ${apart}`);
  }
  text.report(
    `${text.file}: its Thickness is above its Spacing, as programs write that know neither; read are ` +
      `${told.join(" and ")}: if the cloth has others, give ends_per_cm and picks_per_cm in a fabric file.`,
  );
}

function median(values: Float64Array): number {
  const sorted = values.slice().sort();
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
}

interface Colours {
  /** Palette row per thread, 0-based. */
  readonly index: Int32Array | null;
  /** Palette row by default. */
  readonly standard: number | null;
  /** Without a palette, linear RGB rows. */
  readonly rgb: Float64Array | null;
}

function readColors(
  text: WifText,
  family: Family,
  count: number,
  palette: Float64Array | null,
  firstDefault: 0 | 1,
): Colours {
  const section = `${family} COLORS`;
  const own = text.items(section).filter(([, value]) => withoutComment(value) !== "");
  const value = text.value(family, "Color");
  const parts = withoutComment(value)
    .split(",")
    .map((part) => part.trim());
  // What is no colour is treated as one outside the table: it matters where a thread needs it.
  const isColor = [1, 4].includes(parts.length) && parts.every(isInteger);
  const stated = withoutComment(value) === "" ? [] : isColor ? parts.map(Number) : [0];
  if (palette === null) {
    if (own.length > 0)
      throw text.fault(section, ...own[0]!, "names a colour of [COLOR TABLE], and the file has none; add it");
    return { index: null, standard: null, rgb: statedRgb(text, family, stated, count) };
  }
  const size = palette.length / 3;
  const index = new Int32Array(count).fill(-1);
  for (const [key, colour] of own) {
    const thread = threadNumber(text, section, key, colour, "the number of a thread");
    if (thread > count) continue;
    // Some programs write "index,red,green,blue", as the specification has it for Color alone.
    const row = integers(text, section, key, colour, [1, 4], "the number of a colour")[0]!;
    if (!(1 <= row && row <= size))
      throw text.fault(
        section,
        key,
        colour,
        `is not in [COLOR TABLE], which holds the colours 1 to ${size}`,
      );
    index[thread - 1] = row - 1;
  }
  const counted = stated.map((number, at) => (at === 0 ? number + 1 - firstDefault : number));
  return withDefaultColor(text, family, index, counted, size);
}

function withDefaultColor(
  text: WifText,
  family: Family,
  index: Int32Array,
  stated: readonly number[],
  size: number,
): Colours {
  const value = text.value(family, "Color");
  const first = stated[0];
  if (first !== undefined && 1 <= first && first <= size)
    return { index: index.map((row) => (row < 0 ? first - 1 : row)), standard: first - 1, rgb: null };
  const without = index.indexOf(-1);
  if (first === undefined && index.every((row) => row < 0)) return { index: null, standard: null, rgb: null };
  if (without >= 0)
    throw text.fault(
      family,
      "Color",
      value,
      `${first !== undefined ? "is not in [COLOR TABLE]" : "is missing"}, and thread ${without + 1} has no colour of ` +
        `its own in [${family} COLORS]; give a colour from 1 to ${size}`,
    );
  if (first !== undefined)
    text.warn(
      family,
      "Color",
      value,
      `is not in [COLOR TABLE], which holds 1 to ${size}; it is passed over, since every thread has a colour of its own`,
    );
  return { index, standard: null, rgb: null };
}

/** The colour of "Color=index,red,green,blue" for every thread, where there is no table. */
function statedRgb(text: WifText, family: Family, stated: readonly number[], count: number): Float64Array | null {
  const value = text.value(family, "Color");
  if (stated.length !== 4) {
    if (stated.length > 0) text.warn(family, "Color", value, "is passed over, since the file has no [COLOR TABLE]");
    return null;
  }
  const components = stated.slice(1);
  const [low, high] = colorRange(text, Math.max(...components));
  if (Math.min(...components) < low || Math.max(...components) > high)
    throw text.fault(family, "Color", value, `leaves the range ${low} to ${high}`);
  const rgb = components.map((component) => srgbToLinear((component - low) / (high - low)));
  return Float64Array.from({ length: 3 * count }, (_, at) => rgb[at % 3]!);
}

/** Millimetres per thread, null if the file does not say for all, and the default. */
function readLengths(
  text: WifText,
  family: Family,
  what: "Spacing" | "Thickness",
  count: number,
): { lengths: Float64Array | null; standard: number | null } {
  const section = `${family} ${what.toUpperCase()}`;
  const own = text.items(section).filter(([, value]) => withoutComment(value) !== "");
  const value = text.value(family, what);
  if (own.length === 0 && withoutComment(value) === "") return { lengths: null, standard: null };
  const stated = unitMm(text, family);
  if (stated === null && (withoutComment(text.value(family, "Spacing")) === "" || what === "Spacing"))
    text.warn(family, "Units", "", "is missing; the lengths are read as centimetres");
  const unit = stated ?? 10;
  const standard = lengthMm(text, family, what, value, unit);
  const lengths = new Float64Array(count).fill(NaN);
  for (const [key, length] of own) {
    const thread = threadNumber(text, section, key, length, "the number of a thread");
    const millimetres = thread <= count ? lengthMm(text, section, key, length, unit) : null;
    if (millimetres !== null) lengths[thread - 1] = millimetres;
  }
  if (standard !== null)
    return { lengths: lengths.map((length) => (Number.isNaN(length) ? standard : length)), standard };
  const without = lengths.findIndex(Number.isNaN);
  if (without < 0) return { lengths, standard };
  if (!lengths.every(Number.isNaN))
    text.warn(
      section,
      ...own[0]!,
      `and the rest of this section is passed over: thread ${without + 1} is not in it, and [${family}] ${what} gives ` +
        "no default",
    );
  return { lengths: null, standard: null };
}

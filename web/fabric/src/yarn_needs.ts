/** How much yarn a piece of cloth takes, by family and colour, in metres and in grams. */
import type { Draft } from "./draft.ts";
import { InputError } from "./errors.ts";
import { clothFacts } from "./facts.ts";
import { FAMILIES, type FamilyName } from "./fields.ts";
import type { FabricFields } from "./generated.ts";
import { general, rint } from "./numbers.ts";
import { familySpacing, familyWidth } from "./spacing.ts";
import { texOfDiameter } from "./textile.ts";
import { threadHexes } from "./thread_colours.ts";
import { yarnTex } from "./yarn_count.ts";
import { kindOf } from "./yarns.ts";

/** The piece that is woven. Setts are those of the finished cloth. */
export interface WeavingPlan {
  /** Of the finished cloth. */
  readonly lengthM: number;
  readonly widthCm: number;
  /** How much longer yarn is than finished cloth, per cent: crimp, and what finishing shrinks; null: the weave's crimp alone. */
  readonly warpTakeUp: number | null;
  readonly weftTakeUp: number | null;
  /** Warp that stays on the loom and is cut off with thrums, metres, once a piece. */
  readonly loomWasteM: number;
  /** Weft that is lost at selvedges and on bobbins, per cent. */
  readonly weftWaste: number;
}

export const FIRST_PLAN: WeavingPlan = { lengthM: 10, widthCm: 150, warpTakeUp: null, weftTakeUp: null, loomWasteM: 1, weftWaste: 3 };

/** Least and most of each number of a plan. */
export const PLAN_RANGES: Readonly<Record<keyof WeavingPlan, readonly [number, number]>> = {
  lengthM: [0.01, 100_000],
  widthCm: [0.1, 1000],
  warpTakeUp: [0, 200],
  weftTakeUp: [0, 200],
  loomWasteM: [0, 1000],
  weftWaste: [0, 100],
};

/** One yarn: its colour in a family. */
export interface YarnNeed {
  readonly family: FamilyName;
  /** sRGB. */
  readonly hex: string;
  /** Ends, or picks, of this colour in the piece. */
  readonly threads: number;
  readonly metres: number;
  readonly grams: number;
}

export interface YarnNeeds {
  readonly yarns: readonly YarnNeed[];
  /** The take-up of each family that was reckoned with, per cent. */
  readonly takeUp: Readonly<Record<FamilyName, number>>;
  /** Metres of one end, from the beam to the cut. */
  readonly endM: number;
  /** Whether both families have a count; else grams are those of round yarns as wide as the threads. */
  readonly isCounted: boolean;
}

/**
 * The yarn of a piece: ends = width × ends/cm, each as long as the cloth and its take-up, and the loom waste;
 * picks = length × picks/cm, each as long as the width and its take-up, and the weft's waste. Grams are metres × tex / 1000.
 *
 * @throws InputError a number of the plan that is out of range.
 */
export function yarnNeeds(fields: FabricFields, draft: Draft, plan: WeavingPlan): YarnNeeds {
  for (const [name, [low, high]] of Object.entries(PLAN_RANGES) as [keyof WeavingPlan, readonly [number, number]][]) {
    const value = plan[name];
    const isLeftOut = value === null && (name === "warpTakeUp" || name === "weftTakeUp");
    if (!isLeftOut && !(typeof value === "number" && value >= low && value <= high))
      throw new InputError(`${name} = ${String(value)} cannot be: write a number from ${low} to ${general(high, 6)}.`);
  }
  const facts = clothFacts(fields, draft);
  const takeUp = { warp: plan.warpTakeUp ?? 100 * facts.crimp.warp, weft: plan.weftTakeUp ?? 100 * facts.crimp.weft };
  const metresOf = {
    warp: plan.lengthM * (1 + takeUp.warp / 100) + plan.loomWasteM,
    weft: (plan.widthCm / 100) * (1 + takeUp.weft / 100) * (1 + plan.weftWaste / 100),
  };
  const across = { warp: plan.widthCm * 10, weft: plan.lengthM * 1000 };
  const yarns = FAMILIES.flatMap((family) => {
    const spacing = familySpacing(fields, family, draft);
    const threads = Math.max(1, rint((across[family] * spacing.length) / spacing.reduce((sum, each) => sum + each, 0)));
    const found = colourCounts(threadHexes(draft, family), texOf(fields, family, draft, spacing), threads);
    return found.map(({ hex, count, tex }) => ({
      family,
      hex,
      threads: count,
      metres: count * metresOf[family],
      grams: (tex * metresOf[family]) / 1000,
    }));
  });
  return { yarns, takeUp, endM: metresOf.warp, isCounted: facts.isCounted };
}

/** Tex of each thread of a repeat: of the family's count, else of a round yarn as wide as the thread. */
function texOf(fields: FabricFields, family: FamilyName, draft: Draft, spacing: Float64Array): Float64Array {
  const count = fields[family]?.count;
  if (count !== undefined) return new Float64Array(spacing.length).fill(yarnTex(count));
  const density = kindOf(fields, family);
  return familyWidth(fields, family, draft, spacing).map((width) => texOfDiameter(width, density));
}

/** Threads of each colour among `threads` that repeat, in the order in which they come, and the sum of their tex. */
function colourCounts(hexes: readonly string[], tex: Float64Array, threads: number): { hex: string; count: number; tex: number }[] {
  const found = new Map<string, { count: number; tex: number }>();
  const repeats = Math.floor(threads / hexes.length);
  hexes.forEach((hex, thread) => {
    const times = repeats + (thread < threads % hexes.length ? 1 : 0);
    const before = found.get(hex) ?? { count: 0, tex: 0 };
    found.set(hex, { count: before.count + times, tex: before.tex + times * tex[thread]! });
  });
  return [...found].map(([hex, sums]) => ({ hex, ...sums })).filter(({ count }) => count > 0);
}

/** The needs as a table that spreadsheets read. */
export function needsCsv({ yarns }: YarnNeeds): string {
  const rows = yarns.map(({ family, hex, threads, metres, grams }) => [family, hex, threads, metres.toFixed(1), grams.toFixed(2)].join());
  return ["family,colour,threads,metres,grams", ...rows, ""].join("\n");
}

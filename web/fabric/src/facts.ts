/** What a square metre of cloth weighs, by Peirce's geometry of round yarns; see `src/loomlight/fabric/facts.py`. */
import type { Draft } from "./draft.ts";
import { InputError } from "./errors.ts";
import { type FamilyName } from "./fields.ts";
import { FABRIC, type FabricFields } from "./generated.ts";
import { general } from "./numbers.ts";
import { familySpacing, familyWidth } from "./spacing.ts";
import { texOfDiameter, yarnDiameterMm } from "./textile.ts";
import { yarnTex } from "./yarn_count.ts";
import { kindOf } from "./yarns.ts";

/** Yarn cannot be longer than that over the cloth: jammed plain weaves have crimps up to .3. */
const MAX_CRIMP = 0.5;
/** At least that share of a thread's spacing stays open, as `src/loomlight/yarn/layout.py` draws it. */
const MIN_GAP = 0.005;
/** Steps of the search for a sett: twice as many as the digits that are shown need. */
const STEPS = 40;

export interface ClothFacts {
  /** g/m². */
  readonly weight: number;
  /** Whether both families have a count; else yarns are taken as round, and the weight is an upper bound. */
  readonly isCounted: boolean;
  /** How much longer the yarn of each family is than the cloth, as a share. */
  readonly crimp: Readonly<Record<FamilyName, number>>;
}

/**
 * The weight of cloth: threads a metre times the grams of each, which is longer than the cloth by its crimp. At every
 * change of face a thread rises or falls by its crimp height h over the spacing p of the threads it crosses, and is
 * p·(1 + 9/16·(h/p)²) long.
 *
 * Source: Peirce, "The geometry of cloth structure", Journal of the Textile Institute 28 (1937), T45.
 */
export function clothFacts(fields: FabricFields, draft: Draft): ClothFacts {
  const [warp, weft] = [yarnOf(fields, "warp", draft), yarnOf(fields, "weft", draft)];
  const height = (warp.heightMm + weft.heightMm) / 2;
  const changes = changesOf(draft);
  const warpCrimp = crimp(weft.spacing, changes.warp, draft.ends, height);
  const weftCrimp = crimp(warp.spacing, changes.weft, draft.picks, height);
  const grams = ({ spacing, tex }: Yarn, longer: number): number => (spacing.length / sum(spacing)) * tex * (1 + longer);
  return {
    weight: grams(warp, warpCrimp) + grams(weft, weftCrimp),
    isCounted: fields.warp?.count !== undefined && fields.weft?.count !== undefined,
    crimp: { warp: warpCrimp, weft: weftCrimp },
  };
}

/**
 * Threads/cm of both families, in the proportion they have, at which cloth of these yarn counts weighs `weight` g/m².
 *
 * @throws InputError no such weight, or a family without a count.
 */
export function settsOfWeight(fields: FabricFields, draft: Draft, weight: number): Record<FamilyName, number> {
  if (!clothFacts(fields, draft).isCounted)
    throw new InputError("weight needs the yarn counts of both families: it says then how close the threads lie.");
  const setts = { warp: settOf(fields, "warp", draft), weft: settOf(fields, "weft", draft) };
  const scaled = (by: number): FabricFields => {
    const { epi: _epi, ppi: _ppi, ...rest } = fields;
    return { ...rest, ends_per_cm: setts.warp * by, picks_per_cm: setts.weft * by };
  };
  const weightAt = (by: number): number => clothFacts(scaled(by), draft).weight;
  const range = FABRIC["ends_per_cm"] as { readonly low: number; readonly high: number };
  let low = range.low / Math.min(setts.warp, setts.weft);
  let high = range.high / Math.max(setts.warp, setts.weft);
  const [least, most] = [weightAt(low), weightAt(high)];
  if (!(weight >= least && weight <= most))
    throw new InputError(
      `weight = ${general(weight, 4)} g/m² is none of cloth of these yarns: it weighs ${general(least, 3)} to ${general(most, 3)}.`,
    );
  for (let step = 0; step < STEPS; step++) {
    const middle = (low + high) / 2;
    if (weightAt(middle) < weight) low = middle;
    else high = middle;
  }
  return { warp: Number((setts.warp * high).toPrecision(5)), weft: Number((setts.weft * high).toPrecision(5)) };
}

interface Yarn {
  readonly spacing: Float64Array;
  /** Mean height of the yarn, millimetres, and its linear density. */
  readonly heightMm: number;
  readonly tex: number;
}

function yarnOf(fields: FabricFields, family: FamilyName, draft: Draft): Yarn {
  const spacing = familySpacing(fields, family, draft);
  const width = familyWidth(fields, family, draft, spacing);
  const density = kindOf(fields, family);
  const count = fields[family]?.count;
  if (count === undefined) {
    const tex = sum(width.map((diameter) => texOfDiameter(diameter, density))) / width.length;
    return { spacing, heightMm: sum(width) / width.length, tex };
  }
  const diameter = yarnDiameterMm(count, density);
  const visible = sum(width.map((each, thread) => Math.min(each, (1 - MIN_GAP) * spacing[thread]!))) / width.length;
  // A yarn that is wider than round is pressed flat: the height of the ellipse of the same area.
  return { spacing, heightMm: Math.min(diameter, diameter ** 2 / visible), tex: yarnTex(count) };
}

function settOf(fields: FabricFields, family: FamilyName, draft: Draft): number {
  const spacing = familySpacing(fields, family, draft);
  return (10 * spacing.length) / sum(spacing);
}

/** Mean crimp of `threads` threads that change face so often at each of those that they cross. */
function crimp(crossed: Float64Array, changes: Float64Array, threads: number, height: number): number {
  const extra = crossed.map((spacing, at) => ((9 / 16) * height ** 2 * changes[at]!) / spacing);
  return Math.min(sum(extra) / threads / sum(crossed), MAX_CRIMP);
}

interface Changes {
  /** Ends that change face before each pick. */
  readonly warp: Float64Array;
  /** Picks that change face before each end. */
  readonly weft: Float64Array;
}

/** Of drawdowns, which stay while colours and numbers change. */
const changesOfDrawdown = new WeakMap<Uint8Array, Changes>();

function changesOf(draft: Draft): Changes {
  const { ends, picks, drawdown } = draft;
  let found = changesOfDrawdown.get(drawdown);
  if (found === undefined) {
    found = { warp: new Float64Array(picks), weft: new Float64Array(ends) };
    for (let pick = 0; pick < picks; pick++)
      for (let end = 0; end < ends; end++) {
        const face = drawdown[pick * ends + end];
        if (drawdown[((pick + picks - 1) % picks) * ends + end] !== face) found.warp[pick]!++;
        if (drawdown[pick * ends + ((end + ends - 1) % ends)] !== face) found.weft[end]!++;
      }
    changesOfDrawdown.set(drawdown, found);
  }
  return found;
}

function sum(values: Float64Array): number {
  return values.reduce((total, value) => total + value, 0);
}

/** What a renderer needs of a fabric: where the threads of one repeat lie, and what scatters. */
import {
  bendsOf,
  colouredDraft,
  DIFFUSE_BLEND,
  familySpacing,
  familyWidth,
  HEIGHT_SCALE,
  InputError,
  isIrregular,
  OPTICAL_DEPTH,
  ROUGHNESS,
  SHEEN_ROUGHNESS,
  SHEEN_STRENGTH,
  withYarns,
  type Bend,
  type Draft,
  type FabricFields,
  type FamilyName,
} from "loomlight-fabric";

import { GRAZING_RISE_LOSS, MAXIMUM_CROSSINGS, MIN_GAP } from "../generated.ts";
import { familyAppearance, type FamilyAppearance } from "./albedos.ts";
import { requireOpenness, type Openness } from "./between_yarns.ts";
import { pairwiseSum } from "./sums.ts";

/** The threads of one family, in thread order. */
export interface FamilyLayout {
  /** Distance that each thread takes up, millimetres, > 0. */
  readonly spacing: Float64Array;
  /** Visible width of each thread, millimetres; at most 0.995 of its spacing is used. */
  readonly width: Float64Array;
  /** U, the angle of a float's ends to the cloth, radians. */
  readonly inclination: number;
  /** ψ, the angle of the fibres to the yarn, radians. */
  readonly twist: number;
  /** β. */
  readonly heightScale: number;
}

/** One repeat of cloth; `warpOnTop` is [picks·ends]. */
export interface ClothLayout {
  readonly ends: number;
  readonly picks: number;
  readonly warpOnTop: Uint8Array;
  readonly warp: FamilyLayout;
  readonly weft: FamilyLayout;
}

/** Everything that scatters in one fabric. */
export interface Appearance {
  readonly warp: FamilyAppearance;
  readonly weft: FamilyAppearance;
  readonly sheenStrength: number;
  readonly sheenRoughness: number;
  readonly fibreNoise: number;
  /** Relative spread of the albedo from thread to thread. */
  readonly colourNoise: number;
  readonly seed: number;
  /** w, the share of the yarn normal in the blended diffuse term. */
  readonly diffuseBlend: number;
  /** Tρ of the fibre layer. */
  readonly opticalDepth: number;
  /** What albedos of highlights gain towards grazing, the mean of both families, 0 to 4. */
  readonly grazingGain: number;
  /** What diffuse light loses there, 0 to 1. */
  readonly grazingLoss: number;
  /** What light between yarns follows from; null for direct light alone. */
  readonly openness: Openness | null;
}

export interface Look {
  readonly layout: ClothLayout;
  readonly appearance: Appearance;
  /** Words of the factors of joint visibility; null where they are not known. */
  readonly joint: readonly number[] | null;
}

export { MAXIMUM_CROSSINGS };

const RADIANS = Math.PI / 180;

/**
 * The look of a fabric's fields and of the draft that they name.
 *
 * @param known the openness of its yarns, where it is known: light between yarns counts unless the fields say
 * `interreflection = false`.
 * @throws InputError fields that contradict the draft, albedos that exceed the light, or too many crossings.
 */
export function lookOf(given: FabricFields, draft: Draft, known: Openness | null = null): Look {
  const fields = withYarns(given);
  const coloured = colouredDraft(draft, fields);
  const crossings = coloured.ends * coloured.picks;
  if (crossings > MAXIMUM_CROSSINGS)
    throw new InputError(
      `the repeat of ${coloured.ends} ends and ${coloured.picks} picks has ${(crossings / 1e6).toFixed(0)} million ` +
        `crossings, and at most ${(MAXIMUM_CROSSINGS / 1e6).toFixed(0)} million can be rendered: render a part of it.`,
    );
  const opticalDepth = fields.optical_depth ?? OPTICAL_DEPTH;
  const openness = fields.interreflection === false ? null : known;
  if (known !== null) requireOpenness(known);
  const bends = bendsOf(coloured);
  return {
    layout: {
      ends: coloured.ends,
      picks: coloured.picks,
      warpOnTop: coloured.drawdown,
      warp: familyLayout(fields, "warp", coloured, bends.warp),
      weft: familyLayout(fields, "weft", coloured, bends.weft),
    },
    appearance: {
      warp: familyAppearance(fields, "warp", coloured, opticalDepth, openness),
      weft: familyAppearance(fields, "weft", coloured, opticalDepth, openness),
      sheenStrength: fields.sheen?.strength ?? SHEEN_STRENGTH,
      sheenRoughness: fields.sheen?.roughness ?? SHEEN_ROUGHNESS,
      fibreNoise: fields.variation?.fibre_noise ?? 0,
      colourNoise: fields.variation?.colour_noise ?? 0,
      seed: fields.variation?.seed ?? 0,
      diffuseBlend: fields.diffuse_blend ?? DIFFUSE_BLEND,
      opticalDepth,
      ...grazingOf(fields),
      openness,
    },
    joint: known?.joint ?? null,
  };
}

/** How highlights rise towards grazing (`scattering/grazing.py`). */
function grazingOf({ warp, weft }: FabricFields): Pick<Appearance, "grazingGain" | "grazingLoss"> {
  const grazingGain = ((warp?.specular_grazing ?? 0) + (weft?.specular_grazing ?? 0)) / 2;
  const roughness = ((warp?.roughness ?? ROUGHNESS) + (weft?.roughness ?? ROUGHNESS)) / 2;
  const share = GRAZING_RISE_LOSS[0] * (1 - roughness) ** 3 + GRAZING_RISE_LOSS[1];
  return { grazingGain, grazingLoss: Math.min(share * grazingGain, 1) };
}

/** Whether yarns vary along themselves, and from thread to thread by the same process. */
export function hasIrregularYarns({ warp, weft }: Appearance): boolean {
  return isIrregular(warp.irregularity) || isIrregular(weft.irregularity);
}

/** Width and height of the repeat, millimetres. */
export function sizeOf(layout: ClothLayout): [number, number] {
  return [pairwiseSum(layout.warp.spacing), pairwiseSum(layout.weft.spacing)];
}

function familyLayout(fields: FabricFields, family: FamilyName, draft: Draft, bend: Bend): FamilyLayout {
  const table = fields[family] ?? {};
  const spacing = familySpacing(fields, family, draft);
  const width = familyWidth(fields, family, draft, spacing);
  requireWithin(`${family}: spacing (mm)`, spacing, 1e-4, 1e4);
  requireWithin(`${family}: width (mm)`, width, 1e-5, 1e5);
  return {
    spacing,
    width,
    inclination: (table.inclination_deg ?? bend.inclinationDeg) * RADIANS,
    twist: (table.twist_deg ?? bend.twistDeg) * RADIANS,
    heightScale: table.height_scale ?? HEIGHT_SCALE,
  };
}

/** Half the visible width of a thread, millimetres. */
export function halfWidth(family: FamilyLayout, thread: number): number {
  return Math.min(family.width[thread]!, (1 - MIN_GAP) * family.spacing[thread]!) / 2;
}

function requireWithin(name: string, values: Float64Array, low: number, high: number): void {
  const bad = values.find((value) => !(value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)));
  if (bad !== undefined)
    throw new InputError(`${name} = ${Number(bad.toPrecision(6))} is outside ${low} to ${high}.`);
}

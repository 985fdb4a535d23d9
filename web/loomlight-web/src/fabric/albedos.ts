/** Albedos of one family, twelve numbers a thread: from colour, specular and translucency, or explicit. */
import {
  InputError,
  parseColour,
  ROUGHNESS,
  SPECULAR,
  TRANSLUCENCY,
  type Draft,
  type FabricFields,
  type FamilyName,
} from "loomlight-fabric";

import { ALBEDO_TOLERANCE, WHITE_SHARE } from "../generated.ts";
import { coloursFor, type ChannelAlbedos, type Openness } from "./between_yarns.ts";
import { detailOf, type YarnDetail } from "./detail.ts";

/** The order of a thread's albedos, red, green and blue of each. */
export const ALBEDOS = ["diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit"] as const;
export const ALBEDO_NUMBERS = 3 * ALBEDOS.length;

/** One family of threads. */
export interface FamilyAppearance {
  /** [n·12], linear RGB in the order of `ALBEDOS`. */
  readonly albedos: Float64Array;
  /** α of the fibre distribution. */
  readonly roughness: number;
  /** What the yarns show close up. */
  readonly detail: YarnDetail;
}

/** Shares of the light that a fibre layer may return: of the larger and of the smaller of its two albedos. */
type LayerBound = readonly [larger: number, smaller: number];

/** κ = (1 + e^{−Tρ})/2: no direction gets more than this share back from a fibre layer of albedo 1. */
function layerAlbedoBound(opticalDepth: number): number {
  return 0.5 * (1 + Math.exp(-opticalDepth));
}

/**
 * The bound as a factor of the larger of a thread's two highlights; with light between yarns the largest over threads,
 * see `scattering/cloth_layer_bound.py`.
 */
export function boundInUse(
  families: readonly FamilyAppearance[],
  opticalDepth: number,
  openness: Openness | null,
): number {
  if (openness === null) return layerAlbedoBound(opticalDepth);
  let most = 0;
  families.forEach(({ albedos }, family) => {
    const bound = boundOf(openness, family);
    most = Math.max(most, bound[0]);
    for (let first = 0; first < albedos.length; first += ALBEDO_NUMBERS)
      for (let channel = first; channel < first + 3; channel++) {
        const [reflect, transmit] = [albedos[channel + 6]!, albedos[channel + 9]!];
        most = Math.max(most, taken(bound, reflect, transmit) / Math.max(reflect, transmit, 1e-9));
      }
  });
  return most;
}

function boundOf(openness: Openness, family: number): LayerBound {
  return [openness.bounds[2 * family]!, openness.bounds[2 * family + 1]!];
}

/** What a layer of these albedos, in any order, takes of what diffuse terms may return. */
function taken([larger, smaller]: LayerBound, first: number, second: number): number {
  return larger * Math.max(first, second) + smaller * Math.min(first, second);
}

/**
 * The appearance of a family whose threads have the colours of a coloured draft; see `fabric/albedos.py`.
 *
 * @param openness of cloth with light between its yarns: colours are then those that cloth shows.
 * @throws InputError explicit albedos that together send back more light than arrives.
 */
export function familyAppearance(
  fields: FabricFields,
  family: FamilyName,
  draft: Draft,
  opticalDepth: number,
  openness: Openness | null = null,
): FamilyAppearance {
  const table = fields[family] ?? {};
  const bound = layerAlbedoBound(opticalDepth);
  let albedos = albedosOfFamily(fields, family, draft, opticalDepth, null);
  // Explicit albedos keep the bound of a yarn alone, which is larger than that of cloth.
  checkAlbedos(albedos, family, bound);
  if (openness !== null) albedos = albedosOfFamily(fields, family, draft, opticalDepth, openness);
  return { albedos, roughness: table.roughness ?? ROUGHNESS, detail: detailOf(table) };
}

function albedosOfFamily(
  fields: FabricFields,
  family: FamilyName,
  draft: Draft,
  opticalDepth: number,
  openness: Openness | null,
): Float64Array {
  const table = fields[family] ?? {};
  const number = family === "warp" ? 0 : 1;
  const strength = (table.specular ?? SPECULAR) * strongestHighlight(opticalDepth);
  const bound = openness === null ? ([layerAlbedoBound(opticalDepth), 0] as const) : boundOf(openness, number);
  const albedosOf = (colour: number) => channelAlbedos(colour, strength, table.translucency ?? TRANSLUCENCY, bound);
  let colours = draft[family].colors ?? new Float64Array(0);
  if (openness !== null && table.albedo === undefined) colours = coloursFor(colours, openness, number, albedosOf);
  const albedos = albedosFromColours(colours, albedosOf);
  if (table.specular_tint !== undefined) {
    const tint = parseColour(table.specular_tint, `${family}.specular_tint`);
    for (let i = 0; i < albedos.length; i++) if (i % ALBEDO_NUMBERS >= 6) albedos[i]! *= tint[i % 3]!;
  }
  ALBEDOS.forEach((name, place) => {
    const given = table[name];
    if (given === undefined) return;
    const colour = parseColour(given, `${family}.${name}`);
    for (let i = 3 * place; i < albedos.length; i += ALBEDO_NUMBERS) albedos.set(colour, i);
  });
  return albedos;
}

/** Albedo of the highlight of white threads at specular 1; see `scattering/albedo.py`. */
function strongestHighlight(opticalDepth: number): number {
  return Math.min(1, 1 / ((2 - WHITE_SHARE) * layerAlbedoBound(opticalDepth)));
}

/** Albedos of one channel of a colour, by the highlight's strength and the share of light that passes. */
function channelAlbedos(colour: number, strength: number, translucency: number, bound: LayerBound): ChannelAlbedos {
  const highlight = strength * (WHITE_SHARE + (1 - WHITE_SHARE) * colour);
  const diffuse = colour * (1 - taken(bound, highlight, translucency * highlight));
  return [(1 - translucency) * diffuse, translucency * diffuse, highlight, translucency * highlight];
}

/** Albedos of threads from linear RGB [n·3]. */
function albedosFromColours(colours: Float64Array, albedosOf: (colour: number) => ChannelAlbedos): Float64Array {
  const albedos = new Float64Array((colours.length / 3) * ALBEDO_NUMBERS);
  for (let i = 0; i < colours.length; i++) {
    const at = Math.floor(i / 3) * ALBEDO_NUMBERS + (i % 3);
    albedosOf(colours[i]!).forEach((albedo, number) => {
      albedos[at + 3 * number] = albedo;
    });
  }
  return albedos;
}

function checkAlbedos(albedos: Float64Array, family: FamilyName, bound: number): void {
  for (let first = 0; first < albedos.length; first += ALBEDO_NUMBERS)
    for (let channel = 0; channel < 3; channel++) {
      const [reflect, transmit, shine, through] = [0, 3, 6, 9].map((at) => albedos[first + at + channel]!) as [
        number,
        number,
        number,
        number,
      ];
      const diffuse = reflect + transmit;
      const highlight = Math.max(shine, through);
      if (diffuse + bound * highlight <= 1 + ALBEDO_TOLERANCE) continue;
      throw new InputError(
        `${family}: diffuse_reflect + diffuse_transmit + ${bound.toFixed(3)} × the larger of specular_reflect and ` +
          `specular_transmit of thread ${first / ALBEDO_NUMBERS + 1} is ${short(diffuse)} + ${bound.toFixed(3)} × ` +
          `${short(highlight)} = ${short(diffuse + bound * highlight)} in ${"RGB"[channel]}, and more than 1 would ` +
          "create light.",
      );
    }
}

function short(value: number): string {
  return String(Number(value.toPrecision(6)));
}

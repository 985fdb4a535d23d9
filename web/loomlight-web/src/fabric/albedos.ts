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
import { colourFor, type YarnOfCloth } from "./authored_colour.ts";
import { detailOf, type YarnDetail } from "./detail.ts";
import type { Openness } from "./openness.ts";

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

/** κ: no direction gets more than this share back from a fibre layer of albedo 1; see `scattering/albedo.py`. */
export function layerAlbedoBound(opticalDepth: number, betweenYarns = false): number {
  if (betweenYarns) return 0.34 + 0.66 * Math.exp(-3 * opticalDepth);
  return 0.5 * (1 + Math.exp(-opticalDepth));
}

/**
 * The appearance of a family whose threads have the colours of a coloured draft; see `fabric/albedos.py`.
 *
 * @param openness of the cloth, by which colours are those that cloth shows; null makes albedos of them.
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
  const [specular, translucency] = [table.specular ?? SPECULAR, table.translucency ?? TRANSLUCENCY];
  const roughness = table.roughness ?? ROUGHNESS;
  const betweenYarns = openness !== null;
  let colours = draft[family].colors ?? new Float64Array(0);
  if (betweenYarns && table.albedo === undefined)
    colours = shownBy(colours, { specular, translucency, openness, family: family === "warp" ? 0 : 1, roughness, opticalDepth });
  const albedos = albedosFromColour(colours, specular, translucency, opticalDepth, betweenYarns);
  if (table.specular_tint !== undefined) {
    const tint = parseColour(table.specular_tint, `${family}.specular_tint`);
    for (let i = 0; i < albedos.length; i++) if (i % ALBEDO_NUMBERS >= 6) albedos[i]! *= tint[i % 3]!;
  }
  ALBEDOS.forEach((name, number) => {
    const given = table[name];
    if (given === undefined) return;
    const colour = parseColour(given, `${family}.${name}`);
    for (let i = 3 * number; i < albedos.length; i += ALBEDO_NUMBERS) albedos.set(colour, i);
  });
  checkAlbedos(albedos, family, opticalDepth, betweenYarns);
  return { albedos, roughness, detail: detailOf(table) };
}

/** Albedo of the highlight of white threads at specular 1; see `scattering/albedo.py`. */
function strongestHighlight(opticalDepth: number): number {
  return Math.min(1, 1 / ((2 - WHITE_SHARE) * layerAlbedoBound(opticalDepth)));
}

/** Colours that albedos are made of so that cloth shows these, linear RGB [n·3]. */
function shownBy(colours: Float64Array, yarn: YarnOfCloth): Float64Array {
  const found = new Map<number, number>();
  return colours.map((colour) => {
    if (!found.has(colour)) found.set(colour, colourFor(colour, yarn));
    return found.get(colour)!;
  });
}

/** Albedos of threads from linear RGB [n·3]; see `scattering/albedo.py`. */
function albedosFromColour(
  colours: Float64Array,
  specular: number,
  translucency: number,
  opticalDepth: number,
  betweenYarns: boolean,
): Float64Array {
  const albedos = new Float64Array((colours.length / 3) * ALBEDO_NUMBERS);
  for (let i = 0; i < colours.length; i++) {
    const at = Math.floor(i / 3) * ALBEDO_NUMBERS + (i % 3);
    channelAlbedos(colours[i]!, specular, translucency, opticalDepth, betweenYarns).forEach((albedo, number) => {
      albedos[at + 3 * number] = albedo;
    });
  }
  return albedos;
}

/** The four albedos of one channel, in the order of `ALBEDOS`. */
export function channelAlbedos(
  colour: number,
  specular: number,
  translucency: number,
  opticalDepth: number,
  betweenYarns: boolean,
): [number, number, number, number] {
  const strength = specular * strongestHighlight(opticalDepth);
  const highlight = strength * (WHITE_SHARE + (1 - WHITE_SHARE) * colour);
  const diffuse = colour * (1 - layerAlbedoBound(opticalDepth, betweenYarns) * highlight);
  return [(1 - translucency) * diffuse, translucency * diffuse, highlight, translucency * highlight];
}

function checkAlbedos(albedos: Float64Array, family: FamilyName, opticalDepth: number, betweenYarns: boolean): void {
  const bound = layerAlbedoBound(opticalDepth, betweenYarns);
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

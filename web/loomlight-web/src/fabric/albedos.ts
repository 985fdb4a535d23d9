/** Albedos of one family, twelve numbers a thread: from colour, specular and translucency, or explicit. */
import {
  InputError,
  irregularityOf,
  NEP_COLOUR,
  parseColour,
  ROUGHNESS,
  SPECULAR,
  TRANSLUCENCY,
  type Draft,
  type FabricFields,
  type FamilyName,
  type Irregularity,
} from "loomlight-fabric";

import { ALBEDO_TOLERANCE, DARKEST, FADING, TRACE, WHITE_SHARE } from "../generated.ts";
import { coloursFor, type ChannelAlbedos, type Openness } from "./between_yarns.ts";
import { detailOf, type YarnDetail } from "./detail.ts";
import { boundInUse, clothBound, taken, yarnBound, type LayerBound } from "./layer_bound.ts";

/** The order of a thread's albedos, red, green and blue of each. */
export const ALBEDOS = ["diffuse_reflect", "diffuse_transmit", "specular_reflect", "specular_transmit"] as const;
export const ALBEDO_NUMBERS = 3 * ALBEDOS.length;

/** One family of threads. */
export interface FamilyAppearance {
  /** [n·12], linear RGB in the order of `ALBEDOS`. */
  readonly albedos: Float64Array;
  /** α of the fibre distribution. */
  readonly roughness: number;
  /** κ of the energy bound that the albedos keep, of the larger highlight. */
  readonly layerBound: number;
  /** What the yarns show close up. */
  readonly detail: YarnDetail;
  /** How they vary over millimetres to metres, and the diffuse albedo of neps; 0 without any. */
  readonly irregularity: Irregularity;
  readonly nepAlbedo: readonly [number, number, number];
}

/**
 * The appearance of a family whose threads have the colours of a coloured draft; see `fabric/colour.py`.
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
  const strength = (table.specular ?? SPECULAR) * strongestHighlight(opticalDepth);
  const roughness = table.roughness ?? ROUGHNESS;
  const number = family === "warp" ? 0 : 1;
  const bound =
    openness === null
      ? yarnBound(opticalDepth)
      : clothBound(roughness, opticalDepth, openness.layers.slice(2 * number, 2 * number + 2));
  const albedosOf = (colour: number) => channelAlbedos(colour, strength, table.translucency ?? TRANSLUCENCY, bound);
  const irregularity = irregularityOf(fields, family);
  let colours = faded(draft[family].colors ?? new Float64Array(0), wornShare(fields, family, draft));
  if (openness !== null && table.albedo === undefined)
    colours = coloursFor(colours, openness, number, albedosOf);
  const albedos = albedosFromColours(colours, albedosOf);
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
  checkAlbedos(albedos, family, bound);
  const layerBound = boundInUse(bound, highlightsOf(albedos));
  const nepAlbedo: [number, number, number] = [0, 0, 0];
  if (irregularity.neps > 0) {
    // Knots so thick that no light goes through.
    const knotOf = (colour: number) => channelAlbedos(colour, strength, 0, bound);
    const shown = Float64Array.from(parseColour(table.nep_color ?? NEP_COLOUR, `${family}.nep_color`));
    const knots = openness === null ? shown : coloursFor(shown, openness, number, knotOf);
    knots.forEach((colour, channel) => (nepAlbedo[channel] = knotOf(colour)[0]));
  }
  return { albedos, roughness, layerBound, detail: detailOf(table), irregularity, nepAlbedo };
}

/** How much a family's threads are rubbed; see `fabric/resolve.py`. */
function wornShare(fields: FabricFields, family: FamilyName, { drawdown }: Draft): number {
  const wear = fields.wear ?? 0;
  if (wear === 0) return 0;
  const onFace = drawdown.reduce((sum, warpIsOnTop) => sum + warpIsOnTop, 0) / drawdown.length;
  return (wear * (family === "warp" ? onFace : 1 - onFace)) / Math.max(onFace, 1 - onFace);
}

/** Colours of threads that are rubbed; see `fabric/colour.py`. */
function faded(colours: Float64Array, worn: number): Float64Array {
  if (worn === 0) return colours;
  const left = (1 - worn) / (1 + FADING * worn) + TRACE * worn;
  const undyed = parseColour(NEP_COLOUR, "undyed fibres").map(absorption);
  return colours.map((colour, index) => {
    const own = undyed[index % 3]!;
    const ratio = own + left * (absorption(Math.max(colour, DARKEST)) - own);
    return 1 + ratio - Math.sqrt(ratio * (ratio + 2));
  });
}

/** K/S of a reflectance above 0. */
function absorption(colour: number): number {
  return (1 - colour) ** 2 / (2 * colour);
}

/** Albedo of the highlight of white threads at specular 1; see `scattering/albedo.py`. */
function strongestHighlight(opticalDepth: number): number {
  return Math.min(1, 1 / ((2 - WHITE_SHARE) * yarnBound(opticalDepth).larger));
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

/** Reflected and transmitted highlight of each thread and channel. */
function* highlightsOf(albedos: Float64Array): Generator<[number, number]> {
  for (let first = 0; first < albedos.length; first += ALBEDO_NUMBERS)
    for (let channel = 0; channel < 3; channel++)
      yield [albedos[first + 6 + channel]!, albedos[first + 9 + channel]!];
}

function checkAlbedos(albedos: Float64Array, family: FamilyName, bound: LayerBound): void {
  for (let first = 0; first < albedos.length; first += ALBEDO_NUMBERS)
    for (let channel = 0; channel < 3; channel++) {
      const [reflect, transmit, shine, through] = [0, 3, 6, 9].map((at) => albedos[first + at + channel]!) as [
        number,
        number,
        number,
        number,
      ];
      const diffuse = reflect + transmit;
      const total = diffuse + taken(bound, shine, through);
      if (total <= 1 + ALBEDO_TOLERANCE) continue;
      const larger = bound.larger.toFixed(3);
      const ofSmaller = (what: string) => (bound.smaller > 0 ? ` + ${bound.smaller.toFixed(3)} × ${what}` : "");
      const names = ofSmaller("the smaller");
      const numbers = ofSmaller(short(Math.min(shine, through)));
      throw new InputError(
        `${family}: diffuse_reflect + diffuse_transmit + ${larger} × the larger of specular_reflect and ` +
          `specular_transmit${names} of thread ${first / ALBEDO_NUMBERS + 1} is ${short(diffuse)} + ${larger} × ` +
          `${short(Math.max(shine, through))}${numbers} = ${short(total)} in ${"RGB"[channel]}, and more than 1 would ` +
          "create light.",
      );
    }
}

function short(value: number): string {
  return String(Number(value.toPrecision(6)));
}

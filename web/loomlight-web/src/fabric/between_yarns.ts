/**
 * Light between yarns, of numbers that Python finds by rays: colours of cloth as albedos, and the numbers as shaders
 * read them; see `fabric/colour.py` and `scattering/interreflection.py`.
 */
import { InputError } from "loomlight-fabric";

import { HALVINGS, OPENNESS_OTHERS, OPENNESS_PARTS, type OpennessTables } from "../generated.ts";
import type { WordTable } from "../records.ts";
import { wordsOfTable } from "./bake_plan.ts";

/**
 * What a cloth's yarns see of the sky: flat lists, as `loomlight view` answers them at `/api/openness`. They follow
 * from where yarns lie, from roughness, optical depth and the diffuse blend alone. See
 * `scattering/openness.py`.
 */
export interface Openness extends OpennessTables {
  /** Words of the factors of joint visibility, which `lobes` reads; without them its ratios are 1. */
  readonly joint?: readonly number[];
  /** How many layers the cloth has, one number: tables of Python draw them. */
  readonly planes?: readonly number[];
}

/** Albedos of one colour channel, in the order of `ALBEDOS`. */
export type ChannelAlbedos = readonly [
  diffuseReflect: number,
  diffuseTransmit: number,
  specularReflect: number,
  specularTransmit: number,
];

const SIZES: readonly (readonly [keyof Openness, number])[] = [...OPENNESS_PARTS, ...OPENNESS_OTHERS];
/** Words of the factors of joint visibility. */
export const JOINT_WORDS = wordsOfTable("joint", {});

/** @throws InputError lists that are missing, or of another length, or not of finite numbers. */
export function requireOpenness(openness: Openness): void {
  const sizes = openness.joint === undefined ? SIZES : [...SIZES, ["joint", JOINT_WORDS] as const];
  for (const [name, size] of sizes) {
    const given: unknown = openness[name];
    if (Array.isArray(given) && given.length === size && given.every(Number.isFinite)) continue;
    throw new InputError(`openness: ${name} is no list of ${size} finite numbers, as this version's /api/openness answers.`);
  }
}

/** Appends the numbers of a fabric; the first word. */
export function packOpenness(table: WordTable, openness: Openness): number {
  return table.addNumbers(OPENNESS_PARTS.flatMap(([name]) => openness[name]));
}

/**
 * The colours [n] that albedos are made of so that flat cloth woven of one yarn alone shows `shown` [n] under a white
 * sky, 8° from the normal. Brighter or darker ones than such cloth can show become the nearest, 1 or 0.
 *
 * @param family 0 for warp, 1 for weft.
 * @param albedosOf albedos of a colour; they grow with it.
 */
export function coloursFor(
  shown: Float64Array,
  openness: Openness,
  family: number,
  albedosOf: (colour: number) => ChannelAlbedos,
): Float64Array {
  // Threads share few colours.
  const found = new Map<number, number>();
  return shown.map((value) => {
    let colour = found.get(value);
    if (colour === undefined) {
      colour = colourFor(value, openness, family, albedosOf);
      found.set(value, colour);
    }
    return colour;
  });
}

function colourFor(
  shown: number,
  openness: Openness,
  family: number,
  albedosOf: (colour: number) => ChannelAlbedos,
): number {
  let [low, high] = [0, 1];
  for (let step = 0; step < HALVINGS; step++) {
    const middle = 0.5 * (low + high);
    if (shownBy(albedosOf(middle), openness, family) < shown) low = middle;
    else high = middle;
  }
  return 0.5 * (low + high);
}

/** Reflectance of cloth woven of one yarn alone. */
function shownBy(
  [diffuseReflect, diffuseTransmit, specularReflect, specularTransmit]: ChannelAlbedos,
  openness: Openness,
  family: number,
): number {
  const [turned, through] = openness.layers.slice(2 * family, 2 * family + 2) as [number, number];
  const back = diffuseReflect + turned * specularReflect;
  const forth = diffuseTransmit + through * specularTransmit;
  const [near, leaked] = interiorOf(back, forth, openness);
  const [seen, far] = openness.facing as [number, number];
  return (
    seen * diffuseReflect +
    openness.facing_layer[2 * family]! * specularReflect +
    (1 - seen) * back * near +
    (1 - far) * forth * leaked
  );
}

/** Mean radiance between yarns of one kind on the front, and what of it has crossed to the back. */
function interiorOf(back: number, forth: number, { interior, meets, blocks }: Openness): [near: number, leaked: number] {
  const [front, behind] = [0, 1].map((face) => {
    const open = interior.slice(2 * face, 2 * face + 2);
    const weights = blocks.slice(2 * face, 2 * face + 2);
    const met = meets.slice(4 * face, 4 * face + 4);
    const kept = open.map((share) => (1 - share) * back);
    const ofSky = open.map((share) => share * back);
    return {
      sky: mean(sent(ofSky, kept, met), weights),
      crossing: mean(sent([forth, forth], kept, met), weights),
      open: mean(open, weights),
    };
  }) as [FaceShares, FaceShares];
  const returns = front.crossing * behind.crossing * (1 - front.open) * (1 - behind.open);
  const leaked = (behind.crossing * (front.open + (1 - front.open) * front.sky)) / (1 - returns);
  return [front.sky + (1 - behind.open) * leaked * front.crossing, leaked];
}

/** Means over the yarn of a face: radiance of its sky's light, and of light from the other face; openness. */
interface FaceShares {
  readonly sky: number;
  readonly crossing: number;
  readonly open: number;
}

/** Radiances of warp and weft that send out `first` at the start: the inverse of a 2 × 2 matrix. */
function sent(first: readonly number[], kept: readonly number[], meets: readonly number[]): [number, number] {
  const warp = 1 - kept[0]! * meets[0]!;
  const weft = 1 - kept[1]! * meets[3]!;
  const scale = 1 / (warp * weft - kept[0]! * kept[1]! * (meets[1]! * meets[2]!));
  return [
    (first[0]! * weft + kept[0]! * meets[1]! * first[1]!) * scale,
    (first[1]! * warp + kept[1]! * meets[2]! * first[0]!) * scale,
  ];
}

function mean(parts: readonly number[], weights: readonly number[]): number {
  return weights[0]! * parts[0]! + weights[1]! * parts[1]!;
}

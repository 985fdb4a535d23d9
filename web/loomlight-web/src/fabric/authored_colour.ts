/** Colours as cloth shows them, and the inverse of that: the twin of `fabric/authored_colour.py`, by channels. */
import { COLOUR_HALVINGS, MEAN_THROUGH, MEAN_TURNED } from "../generated.ts";
import { channelAlbedos } from "./albedos.ts";
import type { Openness, Pair } from "./openness.ts";

/** What colours of a family depend on beside the colour itself. */
export interface YarnOfCloth {
  /** 0 to 1, of the yarn. */
  readonly specular: number;
  readonly translucency: number;
  readonly openness: Openness;
  /** 0 for warp, 1 for weft. */
  readonly family: 0 | 1;
  /** α of the yarn. */
  readonly roughness: number;
  /** Tρ of its fibre layer. */
  readonly opticalDepth: number;
}

/** R and T of a yarn in one channel. */
interface Scattered {
  readonly back: number;
  readonly through: number;
}

/** Shares of diffuse light that a fibre layer of albedo 1 scatters back and through; see `scattering/fibre.py`. */
export function meanLayerShares(roughness: number, opticalDepth: number): Pair {
  const turned = MEAN_TURNED[0] + MEAN_TURNED[1] * roughness;
  const through = MEAN_THROUGH[0] + MEAN_THROUGH[1] * roughness;
  const depth = opticalDepth ** MEAN_THROUGH[3];
  return [
    turned * (1 - Math.exp(MEAN_TURNED[2] * opticalDepth)),
    through * opticalDepth * Math.exp(MEAN_THROUGH[2] * depth),
  ];
}

/** Linear reflectance in one channel of cloth woven of a yarn alone whose albedos are made of `colour`. */
export function shownColour(colour: number, yarn: YarnOfCloth): number {
  const { openness, family, specular, translucency, opticalDepth } = yarn;
  const [diffuseReflect, diffuseTransmit, specularReflect, specularTransmit] = channelAlbedos(
    colour,
    specular,
    translucency,
    opticalDepth,
    true,
  );
  const [turned, through] = meanLayerShares(yarn.roughness, opticalDepth);
  const of = {
    back: diffuseReflect + turned * specularReflect,
    through: diffuseTransmit + through * specularTransmit,
  };
  const [front, behind] = solvedInterior(of, openness);
  const [seen, far] = openness.facing;
  return (
    seen * diffuseReflect +
    openness.facingLayer[family][0] * specularReflect +
    (1 - seen) * of.back * front.mean +
    (1 - far) * of.through * behind.leaked
  );
}

/** The colour that albedos are made of so that cloth shows `shown`, in one channel; the nearest where it cannot. */
export function colourFor(shown: number, yarn: YarnOfCloth): number {
  let [low, high] = [0, 1];
  for (let step = 0; step < COLOUR_HALVINGS; step++) {
    const middle = 0.5 * (low + high);
    if (shownColour(middle, yarn) < shown) low = middle;
    else high = middle;
  }
  return 0.5 * (low + high);
}

interface FaceRadiance {
  readonly mean: number;
  readonly leaked: number;
}

/** Mean radiances between the yarns of the front and of the back, of cloth of one yarn; `scattering/interreflection.py`, eq. 1. */
function solvedInterior(of: Scattered, { interior, meets, blocks }: Openness): [FaceRadiance, FaceRadiance] {
  const faces = ([0, 1] as const).map((face) => {
    const open = interior[face];
    const kept = open.map((share) => (1 - share) * of.back) as unknown as Pair;
    const sky = sent(open.map((share) => share * of.back) as unknown as Pair, kept, meets[face]);
    const crossing = sent([of.through, of.through], kept, meets[face]);
    return {
      open: mean(open, blocks[face]),
      sky: mean(sky, blocks[face]),
      crossing: mean(crossing, blocks[face]),
    };
  });
  const passed = ([0, 1] as const).map((face) => {
    const [here, there] = [faces[face]!, faces[1 - face]!];
    const enters = here.open + (1 - here.open) * here.sky;
    return (there.crossing * enters) / (1 - here.crossing * there.crossing * (1 - here.open) * (1 - there.open));
  });
  const radiance = (face: 0 | 1): FaceRadiance => ({
    mean: faces[face]!.sky + (1 - faces[1 - face]!.open) * passed[face]! * faces[face]!.crossing,
    leaked: passed[1 - face]!,
  });
  return [radiance(0), radiance(1)];
}

/** Radiances of warp and weft that send out `first` at the start: the inverse of a 2 × 2 matrix. */
function sent(first: Pair, kept: Pair, meets: readonly [Pair, Pair]): Pair {
  const warp = 1 - kept[0] * meets[0][0];
  const weft = 1 - kept[1] * meets[1][1];
  const scale = 1 / (warp * weft - kept[0] * kept[1] * (meets[0][1] * meets[1][0]));
  return [
    (first[0] * weft + kept[0] * meets[0][1] * first[1]) * scale,
    (first[1] * warp + kept[1] * meets[1][0] * first[0]) * scale,
  ];
}

function mean(parts: Pair, weights: Pair): number {
  return weights[0] * parts[0] + weights[1] * parts[1];
}

/** Shares of the light that a fibre layer may return: the energy bound of albedos; see `scattering/albedo.py`. */
import { DEEP_MARGIN, MARGIN_FADE, THIN_MARGIN } from "../generated.ts";

/** Of the larger and of the smaller of the layer's two albedos. */
export interface LayerBound {
  readonly larger: number;
  readonly smaller: number;
}

/** κ of a yarn alone: no direction gets more than this share back from a layer of albedo 1. */
export function yarnBound(opticalDepth: number): LayerBound {
  return { larger: 0.5 * (1 + Math.exp(-opticalDepth)), smaller: 0 };
}

/**
 * The bound in cloth with light between its yarns; see `scattering/albedo.py`.
 *
 * @param shares what the layer sends back and lets through of diffuse light at albedo 1.
 */
export function clothBound(roughness: number, opticalDepth: number, shares: readonly number[]): LayerBound {
  const thin = Math.exp(-MARGIN_FADE * opticalDepth);
  const margin = DEEP_MARGIN[0] + DEEP_MARGIN[1] * roughness + (THIN_MARGIN[0] + THIN_MARGIN[1] * roughness) * thin;
  return { larger: margin * Math.max(...shares), smaller: margin * Math.min(...shares) };
}

/** What a layer of these albedos, reflected and transmitted in any order, takes of what diffuse terms may return. */
export function taken({ larger, smaller }: LayerBound, first: number, second: number): number {
  return larger * Math.max(first, second) + smaller * Math.min(first, second);
}

/** The bound as a factor of the larger of two highlights, the largest of all given. */
export function boundInUse(bound: LayerBound, highlights: Iterable<readonly [number, number]>): number {
  let most = bound.larger;
  // Where there is no highlight any factor serves.
  for (const [first, second] of highlights)
    most = Math.max(most, taken(bound, first, second) / Math.max(first, second, 1e-9));
  return most;
}

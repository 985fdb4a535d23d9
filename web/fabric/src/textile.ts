/** Textile quantities: setts, and the width of a yarn of a count. */
import { yarnTex } from "./yarn_count.ts";

export const CM_PER_INCH = 2.54;
export const DEFAULT_SETT_PER_CM = 20;
/** Cotton; g/cm³. */
export const COTTON_DENSITY = 1.52;
/** The fraction of a ring-spun yarn's cross-section that is fibre (Morton and Hearle 2008 give 0.5 to 0.65). */
export const DEFAULT_PACKING = 0.6;

/**
 * Diameter in millimetres of a round yarn of that count, of cotton by default: d = √(4 tex / (π · 1000 · ρ · φ)).
 *
 * @throws InputError a count that is not known.
 *
 * Source: Peirce, "The geometry of cloth structure", Journal of the Textile Institute 28 (1937), T45.
 */
export function yarnDiameterMm(
  count: string,
  { density, packing } = { density: COTTON_DENSITY, packing: DEFAULT_PACKING },
): number {
  return Math.sqrt((4 * yarnTex(count)) / (Math.PI * 1000 * density * packing));
}

/** Linear density in tex of a round yarn of that diameter in millimetres: see `yarnDiameterMm`. */
export function texOfDiameter(
  diameterMm: number,
  { density, packing } = { density: COTTON_DENSITY, packing: DEFAULT_PACKING },
): number {
  return diameterMm ** 2 * ((Math.PI / 4) * 1000 * density * packing);
}

/** Textile quantities: yarn counts and the width of a yarn. */
import { InputError } from "./errors.ts";
import { general } from "./numbers.ts";

export const CM_PER_INCH = 2.54;
export const DEFAULT_SETT_PER_CM = 20;
/** Cotton; g/cm³. */
export const COTTON_DENSITY = 1.52;
/** The fraction of a ring-spun yarn's cross-section that is fibre (Morton and Hearle 2008 give 0.5 to 0.65). */
export const DEFAULT_PACKING = 0.6;

const DIRECT = /^(\d+(?:\.\d+)?)\s*(?:x\s*(\d+)\s*)?(dtex|tex|denier|den|ktex)$/;
const INDIRECT = /^(ne|nec|nm)\s*(\d+(?:\.\d+)?)(?:\s*\/\s*(\d+))?$/;
const TEX_PER: Readonly<Record<string, number>> = { tex: 1, dtex: 0.1, ktex: 1000, denier: 1 / 9, den: 1 / 9 };
/** Ne counts hanks of 840 yd a pound, Nm kilometres a kilogram. */
const NE = (1000 * 453.59237) / (840 * 0.9144);
const TEX_OF_COUNT: Readonly<Record<string, number>> = { ne: NE, nec: NE, nm: 1000 };

/**
 * Linear density in tex (g/km) of a yarn count: "30 tex", "2x20 tex", "300 dtex", "150 denier", "Ne 40/2", "Nm 28/2".
 *
 * @throws InputError none of these, or a count outside 0.1 to 100 000 tex.
 *
 * Source: ISO 1144 (tex system); ISO 2947 (conversion between systems).
 */
export function yarnTex(count: string): number {
  const text = count.toLowerCase().trim().split(/\s+/).join(" ");
  const tex = directTex(text) ?? indirectTex(text);
  const said = count.trim().slice(0, 40);
  if (tex === null)
    throw new InputError(
      `The yarn count "${said}" is not known; write it like "30 tex", "150 denier", "Ne 40/2" or "Nm 28".`,
    );
  if (!(0.1 <= tex && tex <= 100_000))
    throw new InputError(`The yarn count "${said}" is ${general(tex, 3)} tex; yarns have 0.1 to 100000 tex.`);
  return tex;
}

function directTex(text: string): number | null {
  const match = DIRECT.exec(text);
  if (match === null) return null;
  return Number(match[1]) * Number(match[2] ?? 1) * TEX_PER[match[3]!]!;
}

function indirectTex(text: string): number | null {
  const match = INDIRECT.exec(text);
  if (match === null || Number(match[2]) === 0) return null;
  return (TEX_OF_COUNT[match[1]!]! / Number(match[2])) * Number(match[3] ?? 1);
}

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

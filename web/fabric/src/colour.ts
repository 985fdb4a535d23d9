/** Colour: sRGB where people write it, linear RGB (ITU-R BT.709 primaries) where light is computed. */
import { InputError } from "./errors.ts";
import { clamp, rint } from "./numbers.ts";

/** A colour as a fabric file has it: "#rrggbb" (sRGB), "lab(52 -10 30)" (D65), or a linear RGB triple in [0, 1]. */
export type Colour = string | readonly [number, number, number];
/** Linear RGB, each in [0, 1]. */
export type Rgb = [number, number, number];

const LAB = /^lab\(\s*([^\s,]+)[\s,]+([^\s,]+)[\s,]+([^\s,)]+)\s*\)$/i;
const HEX = /^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$/;
/** A colour in a measurement file, which only Python reads. */
const MEASURED = /\.(csv|cxf|xml)(#.*)?$/i;

/** Linear value of an sRGB-encoded one, both in [0, 1] (IEC 61966-2-1). */
export function srgbToLinear(encoded: number): number {
  return encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4;
}

/** sRGB encoding of a linear value; values outside [0, 1] are clipped (IEC 61966-2-1). */
export function linearToSrgb(linear: number): number {
  const value = clamp(linear, 0, 1);
  return value <= 0.0031308 ? value * 12.92 : 1.055 * value ** (1 / 2.4) - 0.055;
}

/**
 * Linear RGB of a colour of a fabric file; messages name `field`.
 *
 * @throws InputError no colour, or a component outside [0, 1].
 */
export function parseColour(value: unknown, field: string): Rgb {
  if (typeof value === "string") {
    const lab = LAB.exec(value.trim());
    if (lab !== null) return linearOfLab(lab.slice(1).map((part) => Number(part.replace(/%$/, ""))), value, field);
    const digits = HEX.exec(value.trim())?.[1];
    if (digits === undefined && MEASURED.test(value.trim()))
      throw new InputError(
        `${field} = "${value}" is a measured colour in a file beside the fabric, which a page cannot read: ` +
          "open the fabric by `loomlight view`, or write lab(L a b).",
      );
    if (digits === undefined)
      throw new InputError(`${field} = "${value}" is no colour: write sRGB hex such as "#20305c".`);
    const pairs = digits.length === 3 ? [...digits].map((digit) => digit + digit) : (digits.match(/../g) ?? []);
    return pairs.map((pair) => srgbToLinear(parseInt(pair, 16) / 255)) as Rgb;
  }
  if (Array.isArray(value) && value.length === 3) {
    if (!value.every((part) => typeof part === "number"))
      throw new InputError(`${field} = [${value.join(", ")}] is no colour: a linear RGB triple holds three numbers.`);
    if (!value.every((part) => part >= 0 && part <= 1))
      throw new InputError(`${field} = [${value.join(", ")}] is out of gamut: linear RGB lies between 0 and 1.`);
    return [...value] as Rgb;
  }
  const shown = typeof value === "object" || typeof value === "symbol" ? `a ${typeof value}` : String(value);
  throw new InputError(`${field} = ${shown} is no colour: write "#rrggbb" or a linear RGB triple.`);
}

/** Linear RGB of L*, a*, b* relative to D65; outside the gamut the nearest in each channel. */
function linearOfLab(lab: readonly number[], text: string, field: string): Rgb {
  const [lightness = NaN, a = NaN, b = NaN] = lab;
  if (!(lightness >= 0 && lightness <= 100 && Math.abs(a) <= 150 && Math.abs(b) <= 150))
    throw new InputError(
      `${field} = "${text.trim()}" is no colour: write lab(L a b) with L from 0 to 100, a and b from -150 to 150.`,
    );
  return labToLinear([lightness, a, b], "D65").map((channel) => clamp(channel, 0, 1)) as Rgb;
}

/** The white to which L*, a*, b* are relative: D65 in textiles and on screens, D50 in print. */
export type White = keyof typeof WHITES;
/** X and Z of a white of Y = 1, and rows that make linear sRGB of X, Y, Z; from D50 by Bradford's adaptation. */
const WHITES = {
  D65: {
    x: 0.95045593,
    z: 1.08905775,
    rows: [
      [3.24096994, -1.53738318, -0.49861076],
      [-0.96924364, 1.8759675, 0.04155506],
      [0.05563008, -0.20397696, 1.05697151],
    ],
  },
  D50: {
    x: 0.96422,
    z: 0.82521,
    rows: [
      [3.1338561, -1.6168667, -0.4906146],
      [-0.9787684, 1.9161415, 0.033454],
      [0.0719453, -0.2289914, 1.4052427],
    ],
  },
} as const;

/**
 * Linear RGB of L*, a*, b*; outside [0, 1] where the colour is outside sRGB.
 *
 * Source: CIE 15:2018; Lindbloom, "RGB/XYZ matrices" (Bradford-adapted D50), as ICC profiles have it.
 */
export function labToLinear([lightness, a, b]: readonly [number, number, number], white: White): Rgb {
  const { x: whiteX, z: whiteZ } = WHITES[white];
  const middle = (lightness + 16) / 116;
  const edge = 6 / 29;
  const ratio = (root: number): number => (root > edge ? root ** 3 : 3 * edge ** 2 * (root - 4 / 29));
  const x = ratio(middle + a / 500) * whiteX;
  const y = ratio(middle);
  const z = ratio(middle - b / 200) * whiteZ;
  return xyzToLinear([x, y, z], white);
}

/** Linear RGB of X, Y, Z. */
export function xyzToLinear([x, y, z]: readonly [number, number, number], white: White): Rgb {
  return WHITES[white].rows.map(([ofX, ofY, ofZ]) => ofX * x + ofY * y + ofZ * z) as unknown as Rgb;
}

/** sRGB hex of linear RGB, rounded to 8 bits. */
export function toHex(linear: ArrayLike<number>): string {
  const pair = (value: number): string =>
    rint(linearToSrgb(value) * 255)
      .toString(16)
      .padStart(2, "0");
  return `#${pair(linear[0] ?? 0)}${pair(linear[1] ?? 0)}${pair(linear[2] ?? 0)}`;
}

/** Threads of a repeat, at most. */
const MOST_THREADS = 16384;
/** Commas outside of brackets: lab(52, -10, 30) is one colour. */
const COMMA = /,(?![^(]*\))/;
const RUN = /^(?:([0-9]{1,9}) *[x×]? *)?(#[0-9a-f]+|lab\([^)]*\))$/i;

/** Whether a value is written as one colour, not as a list of colours or as runs of threads. */
export function isOneColour(value: unknown): value is Colour {
  if (typeof value === "string") return runsOf(value) === null;
  if (!Array.isArray(value)) return true;
  return value.length > 0 && value.every((part) => typeof part === "number" || typeof part === "bigint");
}

/**
 * The colours of threads, one after the other: of a colour, a list, or runs such as "20 #223355, 20 #eeeeee".
 *
 * @throws InputError a run of no threads, or more threads than a repeat may have.
 */
export function coloursInOrder(value: unknown, field: string): unknown[] {
  const parts = Array.isArray(value) && !isOneColour(value) ? (value as unknown[]) : [value];
  const found: unknown[] = [];
  for (const part of parts) {
    const runs = typeof part === "string" ? runsOf(part) : null;
    for (const { count, colour } of runs ?? [{ count: 1, colour: part }]) {
      if (count < 1) throw new InputError(`${field} = "${String(part)}" holds a run of 0 threads: write 1 or more.`);
      if (found.length + count > MOST_THREADS)
        throw new InputError(`${field} has more than ${MOST_THREADS} threads, which no repeat may have.`);
      for (let i = 0; i < count; i++) found.push(colour);
    }
  }
  return found;
}

/** Threads and colour of every run; null of a text that is one colour, or no colour at all. */
function runsOf(text: string): { count: number; colour: string }[] | null {
  const matches = text.split(COMMA).map((part) => RUN.exec(part.trim()));
  if (matches.some((match) => match === null)) return null;
  const runs = matches.map((match) => ({ count: Number(match![1] ?? 1), colour: match![2]! }));
  return runs.length > 1 || matches[0]![1] !== undefined ? runs : null;
}

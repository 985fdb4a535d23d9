/** What actions may say: each fault is one sentence. */
import { InputError, parseColour, toHex } from "loomlight-fabric";

/**
 * A whole number within a range.
 *
 * @throws InputError any other value.
 */
export function requireWhole(name: string, value: unknown, low: number, high: number): number {
  if (typeof value === "number" && Number.isInteger(value) && low <= value && value <= high) return value;
  throw new InputError(`${name} = ${shown(value)} cannot be: write a whole number from ${low} to ${high}.`);
}

/**
 * A number within a range.
 *
 * @throws InputError any other value.
 */
export function requireNumber(name: string, value: unknown, low: number, high: number): number {
  if (typeof value === "number" && low <= value && value <= high) return value;
  throw new InputError(`${name} = ${shown(value)} cannot be: write a number from ${low} to ${high}.`);
}

/**
 * One of some values.
 *
 * @throws InputError any other value.
 */
export function requireOneOf<T>(name: string, value: unknown, among: readonly T[]): T {
  const found = among.find((each) => each === value);
  if (found === undefined) throw new InputError(`${name} = ${shown(value)} is none of ${among.join(", ")}.`);
  return found;
}

/**
 * A colour as "#rrggbb".
 *
 * @throws InputError no colour.
 */
export function requireHex(name: string, value: unknown): string {
  if (typeof value !== "string") throw new InputError(`${name} = ${shown(value)} is no colour: write "#rrggbb".`);
  return toHex(parseColour(value, name));
}

/** A value in a sentence; objects have no text that helps. */
export function shown(value: unknown): string {
  if (typeof value === "string") return `"${value.slice(0, 40)}"`;
  return typeof value === "number" || typeof value === "boolean" ? String(value) : value === undefined ? "nothing" : `a ${typeof value}`;
}

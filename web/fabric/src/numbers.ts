/** Arithmetic that several modules need. */

/** The value, or the nearest in [low, high]. */
export function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), high);
}

/** The nearest whole number, halves to the even one, as IEEE 754 rounds. */
export function rint(value: number): number {
  const floor = Math.floor(value);
  const rest = value - floor;
  if (rest !== 0.5) return Math.round(value);
  return floor % 2 === 0 ? floor : floor + 1;
}

/** Greatest common divisor of two whole numbers ≥ 0. */
export function gcd(a: number, b: number): number {
  while (b > 0) [a, b] = [b, a % b];
  return a;
}

/** Least common multiple of two whole numbers ≥ 1. */
export function lcm(a: number, b: number): number {
  return (a / gcd(a, b)) * b;
}

/** The remainder in [0, period), also of negative numbers. */
export function modulo(value: number, period: number): number {
  return ((value % period) + period) % period;
}

/** A number with at most `digits` significant digits, without trailing zeros. */
export function general(value: number, digits = 6): string {
  return String(Number(value.toPrecision(digits)));
}

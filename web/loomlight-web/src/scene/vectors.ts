/** Vectors of three numbers. */
import { InputError } from "loomlight-fabric";

import type { Vector3 } from "../types.ts";

export function subtract(a: Vector3, b: Vector3): Vector3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function add(a: Vector3, b: Vector3): Vector3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

export function scale(a: Vector3, factor: number): Vector3 {
  return [a[0] * factor, a[1] * factor, a[2] * factor];
}

export function dot(a: Vector3, b: Vector3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector3, b: Vector3): Vector3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** @throws InputError a vector of no direction; the message names `what`. */
export function unit(a: Vector3, what: string): Vector3 {
  const length = Math.hypot(...a);
  if (!Number.isFinite(length) || length === 0) throw new InputError(`${what} = [${a.join(", ")}] has no direction.`);
  return scale(a, 1 / length);
}

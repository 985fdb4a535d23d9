/** A camera that orbits about a target: what a pointer moves; see `realtime/viewer.py`. */
import { clamp, InputError } from "loomlight-fabric";

import { NOTCH, STEEPEST_DEGREES, TURN_DEGREES } from "../generated.ts";
import type { Camera, Vector3 } from "../types.ts";
import { FIELD_OF_VIEW } from "./camera.ts";
import { add, cross, scale, subtract, unit } from "./vectors.ts";

const RADIANS = Math.PI / 180;
const UP: Vector3 = [0, 1, 0];

/** Where a camera stands, as seen from its target; +y is up, angles are degrees, lengths metres. */
export interface Orbit {
  readonly target: Vector3;
  /** About the vertical, 0 from +z, 90 from +x. */
  readonly azimuth: number;
  /** Above the horizon, −89 to 89. */
  readonly elevation: number;
  readonly distance: number;
  readonly nearest: number;
  readonly farthest: number;
  readonly fieldOfView: number;
}

/**
 * The orbit of a camera at `origin` that looks at `target`.
 *
 * @throws InputError both are the same point.
 */
export function orbitBetween(origin: Vector3, target: Vector3, nearest = 2e-3): Orbit {
  const offset = subtract(origin, target);
  const distance = Math.hypot(...offset);
  if (!(distance > 0))
    throw new InputError(`The camera at [${target.join(", ")}] looks at the point where it stands.`);
  return {
    target,
    azimuth: Math.atan2(offset[0], offset[2]) / RADIANS,
    elevation: steepest(Math.asin(offset[1] / distance) / RADIANS),
    distance,
    nearest: Math.min(nearest, distance),
    farthest: 10 * distance,
    fieldOfView: FIELD_OF_VIEW,
  };
}

/** The camera that stands there. */
export function orbitCamera(orbit: Orbit): Camera {
  return {
    origin: add(orbit.target, scale(backward(orbit), orbit.distance)),
    target: orbit.target,
    up: UP,
    fieldOfView: orbit.fieldOfView,
    near: orbit.distance * 1e-3,
  };
}

/** After a drag, in shares of the picture's shorter side: the object follows the pointer. */
export function turned(orbit: Orbit, right: number, down: number): Orbit {
  const azimuth = (((orbit.azimuth - TURN_DEGREES * right) % 360) + 360) % 360;
  return { ...orbit, azimuth, elevation: steepest(orbit.elevation + TURN_DEGREES * down) };
}

/** After a drag that moves the object with the pointer, in shares of the picture's shorter side. */
export function moved(orbit: Orbit, right: number, down: number): Orbit {
  const side = 2 * orbit.distance * Math.tan((orbit.fieldOfView * RADIANS) / 2);
  const back = backward(orbit);
  const toRight = unit(cross(UP, back), "right");
  const up = cross(back, toRight);
  return { ...orbit, target: add(orbit.target, add(scale(up, side * down), scale(toRight, -side * right))) };
}

/** After so many notches of a wheel towards the cloth, within the bounds of the distance. */
export function closer(orbit: Orbit, notches: number): Orbit {
  return closerBy(orbit, NOTCH ** notches);
}

/** So many times closer, within the bounds of the distance. */
export function closerBy(orbit: Orbit, ratio: number): Orbit {
  return { ...orbit, distance: clamp(orbit.distance / ratio, orbit.nearest, orbit.farthest) };
}

/** Unit vector from the target to the camera. */
function backward({ azimuth, elevation }: Orbit): Vector3 {
  const across = Math.cos(elevation * RADIANS);
  const around = azimuth * RADIANS;
  return [across * Math.sin(around), Math.sin(elevation * RADIANS), across * Math.cos(around)];
}

function steepest(elevation: number): number {
  return clamp(elevation, -STEEPEST_DEGREES, STEEPEST_DEGREES);
}

/** What tests of Python ask of the page's cameras; see `tests/web/test_camera_parity.py`. */
import { moved, orbitBetween, orbitCamera, turned, closerBy, type Vector3 } from "loomlight-web";

import { cameraValues } from "../../loomlight-web/src/scene/camera.ts";
import { cameraOptions } from "../src/view/camera_options.ts";
import { framing } from "../src/view/framing.ts";

/** A piece that the page frames, and what is done to its camera then. */
export interface Question {
  readonly positions: readonly number[];
  readonly from: Vector3;
  readonly size: readonly [number, number];
  readonly turn: readonly [number, number];
  readonly move: readonly [number, number];
  readonly closer: number;
}

/** The options of the camera, and where its picture shows the points: shares of width and height from the upper left. */
export function report({ positions, from, size, turn, move, closer }: Question): { options: string; places: number[][] } {
  const [width, height] = size;
  const { origin, target } = framing(positions, from, width, height);
  const orbit = closerBy(moved(turned(orbitBetween(origin, target), ...turn), ...move), closer);
  const camera = cameraValues(orbitCamera(orbit), width, height) as Readonly<Record<string, number>>;
  const vector = (name: string): Vector3 => [camera[`${name}_x`]!, camera[`${name}_y`]!, camera[`${name}_z`]!];
  const dot = (a: readonly number[], b: readonly number[]): number => a.reduce((sum, value, axis) => sum + value * b[axis]!, 0);
  const [eye, right, up, forward] = ["origin", "right", "up", "forward"].map(vector) as [Vector3, Vector3, Vector3, Vector3];
  const places: number[][] = [];
  for (let at = 0; at < positions.length; at += 3) {
    const offset = eye.map((value, axis) => positions[at + axis]! - value);
    const depth = dot(offset, forward);
    places.push([0.5 + dot(offset, right) / dot(right, right) / depth / 2, 0.5 - dot(offset, up) / dot(up, up) / depth / 2]);
  }
  return { options: cameraOptions(orbit), places };
}

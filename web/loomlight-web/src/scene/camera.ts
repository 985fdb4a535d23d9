/** Cameras and lights as records of shaders have them. */
import { InputError } from "loomlight-fabric";

import type { Area } from "../areas.ts";
import { RecordArray, type Values } from "../records.ts";
import type { Camera, Light, Vector3 } from "../types.ts";
import { add, cross, scale, subtract, unit } from "./vectors.ts";

export const FIELD_OF_VIEW = 26;
const NEAR = 1e-4;
const UP: Vector3 = [0, 1, 0];
const RADIANS = Math.PI / 180;

/**
 * Fields of the record of a frame of so many pixels, or of an area of it: its axis then goes through the area's middle, and
 * is not upright on `right` and `up`, which only the raster pass asks.
 *
 * @throws InputError a field of view outside 0 to 180, or no direction to look in.
 */
export function cameraValues(camera: Camera, width: number, height: number, area?: Area): Values {
  const angle = camera.fieldOfView ?? FIELD_OF_VIEW;
  if (!(angle > 0 && angle < 180))
    throw new InputError(`fieldOfView = ${angle} is out of range: it lies between 0 and 180 degrees.`);
  const forward = unit(subtract(camera.target, camera.origin), "target − origin");
  const right = unit(cross(forward, camera.up ?? UP), "the camera's up");
  const up = cross(right, forward);
  const half = Math.tan((angle * RADIANS) / 2) / Math.min(width, height);
  const { x, y, width: across, height: down } = area ?? { x: 0, y: 0, width, height };
  const middle = add(scale(right, half * (2 * x + across - width)), scale(up, half * (height - 2 * y - down)));
  return {
    ...named("origin", camera.origin),
    ...named("right", scale(right, half * across)),
    ...named("up", scale(up, half * down)),
    ...named("forward", add(forward, middle)),
    near: camera.near ?? NEAR,
  };
}

/** Records of lights; one that is dark if there is none, as no buffer is empty. */
export function lightRecords(lights: readonly Light[]): RecordArray {
  const records = new RecordArray("Light", Math.max(1, lights.length));
  lights.forEach((light, number) => {
    const isPoint = light.kind === "point";
    const place = isPoint ? light.position : unit(light.towards, "towards");
    const colour = isPoint ? light.intensity : (light.irradiance ?? [Math.PI, Math.PI, Math.PI]);
    records.set(number, {
      is_point: isPoint ? 1 : 0,
      x: place[0],
      y: place[1],
      z: place[2],
      red: colour[0],
      green: colour[1],
      blue: colour[2],
    });
  });
  return records;
}

function named(name: string, vector: Vector3): Values {
  return { [`${name}_x`]: vector[0], [`${name}_y`]: vector[1], [`${name}_z`]: vector[2] };
}

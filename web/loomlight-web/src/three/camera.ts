/** Cameras of three.js as the renderer takes them. */
import { InputError } from "loomlight-fabric";
import { Vector3 } from "three";
import type { Camera as ThreeCamera, PerspectiveCamera } from "three";

import type { Camera, Vector3 as Triple } from "../types.ts";

/**
 * The camera of a picture of so many pixels.
 *
 * @throws InputError an orthographic camera.
 */
export function cameraOf(camera: ThreeCamera, width: number, height: number, metresPerUnit: number): Camera {
  if ((camera as PerspectiveCamera).isPerspectiveCamera !== true)
    throw new InputError("Cloth is seen by a PerspectiveCamera: an orthographic one has no footprints of pixels.");
  const origin = new Vector3().setFromMatrixPosition(camera.matrixWorld).multiplyScalar(metresPerUnit);
  const [right, up, back] = [new Vector3(), new Vector3(), new Vector3()];
  camera.matrixWorld.extractBasis(right, up, back);
  const target = origin.clone().addScaledVector(back.normalize(), -1);
  // Cotangents of half the angles of width and height.
  const { elements } = camera.projectionMatrix;
  const cotangent = width < height ? elements[0]! : elements[5]!;
  return {
    origin: triple(origin),
    target: triple(target),
    up: triple(up),
    fieldOfView: (2 * Math.atan(1 / cotangent) * 180) / Math.PI,
    near: (camera as PerspectiveCamera).near * metresPerUnit,
  };
}

export function triple({ x, y, z }: Vector3): Triple {
  return [x, y, z];
}

/** Lights of a scene of three.js as the renderer takes them. */
import { Vector3 } from "three";
import type { AmbientLight, Color, DirectionalLight, HemisphereLight, Light as ThreeLight, Object3D, PointLight } from "three";

import type { Environment, Light, Vector3 as Triple } from "../types.ts";
import { triple } from "./camera.ts";

// Rows of the picture of ambient and hemisphere lights; each half of the sphere has one colour.
const ROWS = 16;
const COLUMNS = 4;

/**
 * Visible directional and point lights, and a picture of what ambient and hemisphere lights add; null without.
 *
 * Other kinds (spot, area, light probes) light no cloth.
 */
export function lightsOf(
  scene: Object3D,
  metresPerUnit: number,
): { readonly lights: Light[]; readonly environment: Environment | null } {
  const lights: Light[] = [];
  const sky: [number, number, number] = [0, 0, 0];
  const ground: [number, number, number] = [0, 0, 0];
  scene.traverseVisible((object) => {
    const light = object as ThreeLight;
    if (light.isLight !== true || !(light.intensity > 0)) return;
    if ((light as DirectionalLight).isDirectionalLight === true) {
      const { target } = light as DirectionalLight;
      target.updateWorldMatrix(true, false);
      const towards = placeOf(light).sub(placeOf(target));
      if (towards.lengthSq() === 0) return;
      lights.push({ kind: "directional", towards: triple(towards), irradiance: scaled(light.color, light.intensity) });
    } else if ((light as PointLight).isPointLight === true) {
      // Candela: the square of a unit's length in metres keeps what arrives.
      const intensity = scaled(light.color, light.intensity * metresPerUnit ** 2);
      lights.push({ kind: "point", position: triple(placeOf(light).multiplyScalar(metresPerUnit)), intensity });
    } else if ((light as AmbientLight).isAmbientLight === true) {
      add(sky, light.color, light.intensity);
      add(ground, light.color, light.intensity);
    } else if ((light as HemisphereLight).isHemisphereLight === true) {
      add(sky, light.color, light.intensity);
      add(ground, (light as HemisphereLight).groundColor, light.intensity);
    }
  });
  const isDark = [...sky, ...ground].every((value) => value === 0);
  return { lights, environment: isDark ? null : halves(sky, ground) };
}

function placeOf(object: Object3D): Vector3 {
  return new Vector3().setFromMatrixPosition(object.matrixWorld);
}

function scaled({ r, g, b }: Color, factor: number): Triple {
  return [r * factor, g * factor, b * factor];
}

/** Adds the radiance of a light whose irradiance from all around is colour times intensity. */
function add(sum: [number, number, number], colour: Color, intensity: number): void {
  scaled(colour, intensity / Math.PI).forEach((value, channel) => (sum[channel]! += value));
}

function halves(sky: Triple, ground: Triple): Environment {
  const pixels = Float32Array.from(
    { length: 3 * ROWS * COLUMNS },
    (_, i) => (i < (3 * ROWS * COLUMNS) / 2 ? sky : ground)[i % 3]!,
  );
  return { picture: { width: COLUMNS, height: ROWS, pixels } };
}

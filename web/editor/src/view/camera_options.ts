/** The page's camera as a command of `loomlight render`, which shows the same view. */
import { InputError } from "loomlight-fabric";
import type { Orbit } from "loomlight-web";

import { FIRST_SCENE, type Scene, type Shape } from "../state/document.ts";
import type { ClothShape } from "./meshes.ts";

/** Millimetres of a sensor of 36 × 24 that the picture's shorter side is. */
const SENSOR_MM = 24;

/** What a command is of. */
export interface Shot {
  /** The name of the fabric's files, without suffix. */
  readonly stem: string;
  readonly scene: Scene;
  readonly piece: ClothShape;
  readonly orbit: Orbit;
  /** Of the picture, pixels. */
  readonly size: readonly [number, number];
}

/**
 * The command.
 *
 * @throws InputError a shape that the page alone has.
 */
export function renderCommand({ stem, scene, piece, orbit, size }: Shot): string {
  return [
    ...["loomlight render", quoted(`${stem}.toml`), "-o", quoted(`${stem}.png`)],
    ...[clothOptions(scene.shape, piece), `--size ${size.join("x")}`, cameraOptions(orbit), ...lightOptions(scene)],
  ].join(" ");
}

/** A camera as options; as `core/camera_settings.py:options_of_camera`. */
export function cameraOptions({ azimuth, elevation, target, distance, fieldOfView }: Orbit): string {
  const digits = Math.min(Math.max(4 - Math.floor(Math.log10(distance)), 0), 9);
  const around = ((((azimuth + 180) % 360) + 360) % 360) - 180;
  const focal = SENSOR_MM / 2 / Math.tan((fieldOfView * Math.PI) / 360);
  return [
    `--view ${decimal(around, 2)},${decimal(elevation, 2)}`,
    `--target ${target.map((place) => decimal(place, digits)).join(",")}`,
    `--distance ${decimal(distance, digits)}`,
    `--focal-length ${decimal(focal, 3)}`,
  ].join(" ");
}

function clothOptions(shape: Shape, { file }: ClothShape): string {
  if (shape === "curtain") throw new InputError("The curtain is the page's own, and loomlight render has none: copy the camera of another shape.");
  if (shape !== "mesh" || file === undefined) return `--scene ${shape}`;
  const unit = file.metresPerUnit === 1 ? "" : ` --metres-per-unit ${Number(file.metresPerUnit.toPrecision(6))}`;
  return `--mesh ${quoted(file.name)}${unit}`;
}

/** The studio's key light and the film; other surroundings are the page's own. */
function lightOptions({ surroundings, lampAzimuth, lampElevation, exposure, whiteBalance }: Scene): string[] {
  return [
    ...(surroundings === "studio" && lampElevation >= 0 ? [`--light-from ${decimal(lampAzimuth, 1)},${decimal(lampElevation, 1)}`] : []),
    ...(exposure === FIRST_SCENE.exposure ? [] : [`--exposure ${decimal(exposure, 2)}`]),
    ...(whiteBalance === FIRST_SCENE.whiteBalance ? [] : [`--white-balance ${decimal(whiteBalance, 0)}`]),
  ];
}

/** Without zeros at its end. */
function decimal(number: number, digits: number): string {
  const text = number.toFixed(digits);
  const short = text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  return short === "-0" ? "0" : short;
}

/** A file's name as a word of a shell. */
function quoted(name: string): string {
  return /^[\w.][\w.+-]*$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`;
}

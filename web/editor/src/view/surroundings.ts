/** Surroundings as pictures: all grey but the sky, so that a grey card looks grey; the studio is that of `core/studio.py`. */
import { clamp, whiteBalance } from "loomlight-fabric";
import type { DirectionalLight, Environment, Ground, Vector3 } from "loomlight-web";

import type { Scene } from "../state/document.ts";
import type { SurroundingsPicture } from "./cloth_view.ts";
import type { ClothShape } from "./meshes.ts";
import { BACK_EDGE, BACK_RADIUS, BACK_SHARE, FILL_SHARE, PAPER, PAPER_SHARE, STUDIO_AZIMUTH, STUDIO_ELEVATION } from "./studio.ts";

const ROWS = 64;
const COLUMNS = 2 * ROWS;
/** Of a card that faces upwards, or the window, where the room is no studio. */
const ROOM_IRRADIANCE = 0.22 * Math.PI;
const KEY = directionOf(STUDIO_AZIMUTH, STUDIO_ELEVATION);
const UP: Vector3 = [0, 1, 0];
/** Cards of which the brightest tells how bright a room is. */
const CARDS: readonly Vector3[] = [UP, [-0.94, 0.34, 0], [0, 0, 1]];
/** The window: directions within these degrees of its middle, which is to the left and a little above. */
const WINDOW = { azimuth: -70, elevation: 20, width: 26, height: 30, edge: 3 } as const;
/** Radiance of the room's walls, as a share of the window's. */
const WALLS = 0.03;
const SKY = { zenith: [0.25, 0.5, 1.0], horizon: [0.85, 0.95, 1.05], ground: [0.16, 0.14, 0.11] } as const;

type Radiance = (x: number, y: number, z: number) => readonly [number, number, number];

/** What lights the cloth beside the lamp; null for nothing. */
export function surroundingsOf(scene: Scene, own: SurroundingsPicture | null): Environment | null {
  const picture = scene.surroundings === "picture" ? own : pictureOf(scene.surroundings);
  if (picture === null || scene.surroundingsStrength === 0) return null;
  const gains = whiteBalance(scene.whiteBalance).map((gain) => gain * scene.surroundingsStrength);
  const pixels = Float32Array.from(picture.pixels, (value, i) => value * gains[i % 3]!);
  return { picture: { ...picture, pixels }, turn: scene.surroundingsTurn };
}

/** The lamp, whose light on a card that faces it is what the surroundings leave of π; null if it is off. */
export function lampOf(scene: Scene): DirectionalLight | null {
  if (scene.lampStrength === 0) return null;
  const towards = directionOf(scene.lampAzimuth, scene.lampElevation);
  const irradiance = whiteBalance(scene.whiteBalance).map((gain) => gain * lampIrradiance() * scene.lampStrength);
  return { kind: "directional", towards, irradiance: irradiance as unknown as Vector3 };
}

/** Of a card that faces the lamp: what the studio leaves of π, where the lamp stands as designed. */
function lampIrradiance(): number {
  return Math.PI - irradianceOf(pictureOf("studio")!.pixels, KEY);
}

/** Azimuth 0 in front, 90 to the right; degrees. */
function directionOf(azimuth: number, elevation: number): Vector3 {
  const [around, above] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180) as [number, number];
  return [Math.sin(around) * Math.cos(above), Math.sin(above), Math.cos(around) * Math.cos(above)];
}

/** What a piece stands on, with the lamp's share in the light there. */
export function groundOf(scene: Scene, { ground }: ClothShape): Ground {
  const { towards } = lampOf(scene) ?? { towards: [0, 0, 0] };
  const cosine = ground.normal.reduce((sum, value, axis) => sum + value * towards[axis]!, 0);
  const lamp = lampIrradiance() * scene.lampStrength * Math.max(cosine, 0);
  const room = skyIrradiance(scene.surroundings) * scene.surroundingsStrength;
  return { ...ground, lampShare: lamp > 0 ? lamp / (lamp + room) : 0 };
}

const pictures = new Map<Scene["surroundings"], SurroundingsPicture>();

function pictureOf(kind: Scene["surroundings"]): SurroundingsPicture | null {
  let picture = pictures.get(kind);
  if (picture === undefined) {
    const pixels = pixelsOf(kind);
    if (pixels === null) return null;
    picture = { width: COLUMNS, height: ROWS, pixels };
    pictures.set(kind, picture);
  }
  return picture;
}

function pixelsOf(kind: Scene["surroundings"]): Float32Array | null {
  switch (kind) {
    case "studio":
      return studio();
    case "window":
      return painted(room, CARDS, ROOM_IRRADIANCE);
    case "sky":
      return painted(sky, CARDS, ROOM_IRRADIANCE);
    default:
      return null;
  }
}

/** What lies flat gets of the surroundings; of a picture of the user's own, about. */
function skyIrradiance(kind: Scene["surroundings"]): number {
  if (kind === "none") return 0;
  const picture = pictureOf(kind);
  return picture === null ? ROOM_IRRADIANCE : irradianceOf(picture.pixels, UP);
}

/** The studio but for its key light, which is the lamp: a dome, the back light, and paper, which throws light back. */
function studio(): Float32Array {
  const back: Vector3 = [-KEY[0], KEY[1], -KEY[2]];
  const dome = painted((_x, y) => grey(y > 0 ? 0.5 + 0.5 * y : 0), [KEY], FILL_SHARE * Math.PI);
  const disc = painted((x, y, z) => {
    const off = (Math.acos(clamp(x * back[0] + y * back[1] + z * back[2], -1, 1)) * 180) / Math.PI;
    return grey(clamp((BACK_RADIUS - off) / BACK_EDGE + 0.5, 0, 1));
  }, [back], BACK_SHARE * Math.PI);
  const lights = dome.map((value, i) => value + disc[i]!);
  const paper = (PAPER_SHARE * PAPER * ((1 - FILL_SHARE) * Math.PI * KEY[1] + irradianceOf(lights, UP))) / Math.PI;
  const pixels = lights.map((value, i) => (i < lights.length / 2 ? value : paper));
  // A white card that faces the key shows a radiance of 1.
  const scale = Math.PI / ((1 - FILL_SHARE) * Math.PI + irradianceOf(pixels, KEY));
  return pixels.map((value) => value * scale);
}

/** A tall window with soft edges in a dim room. */
function room(x: number, y: number, z: number): readonly [number, number, number] {
  const azimuth = (Math.atan2(x, z) * 180) / Math.PI;
  const elevation = (Math.asin(clamp(y, -1, 1)) * 180) / Math.PI;
  const inside = (distance: number, half: number): number =>
    clamp((half - Math.abs(distance)) / WINDOW.edge + 0.5, 0, 1);
  const pane = inside(azimuth - WINDOW.azimuth, WINDOW.width) * inside(elevation - WINDOW.elevation, WINDOW.height);
  return grey(WALLS + (1 - WALLS) * pane);
}

/** A clear sky without its sun, which the lamp stands for, over dry ground. */
function sky(_x: number, y: number): readonly [number, number, number] {
  if (y < 0) return SKY.ground;
  const up = Math.sqrt(y);
  return SKY.zenith.map((high, channel) => SKY.horizon[channel]! + (high - SKY.horizon[channel]!) * up) as unknown as readonly [
    number,
    number,
    number,
  ];
}

function grey(value: number): readonly [number, number, number] {
  return [value, value, value];
}

/** Radiance over the sphere, scaled so that the best-lit of some cards gets so much irradiance. */
function painted(radiance: Radiance, cards: readonly Vector3[], irradiance: number): Float32Array {
  const pixels = new Float32Array(ROWS * COLUMNS * 3);
  eachDirection((direction, index) => pixels.set(radiance(...direction), 3 * index));
  const scale = irradiance / Math.max(...cards.map((card) => irradianceOf(pixels, card)));
  return pixels.map((value) => value * scale);
}

/** Irradiance of a card by a picture of surroundings, the mean of its channels. */
function irradianceOf(pixels: Float32Array, card: Vector3): number {
  let sum = 0;
  eachDirection(([x, y, z], index, solidAngle) => {
    const mean = (pixels[3 * index]! + pixels[3 * index + 1]! + pixels[3 * index + 2]!) / 3;
    sum += Math.max(card[0] * x + card[1] * y + card[2] * z, 0) * mean * solidAngle;
  });
  return sum;
}

function eachDirection(visit: (direction: Vector3, index: number, solidAngle: number) => void): void {
  for (let row = 0; row < ROWS; row++) {
    const polar = ((row + 0.5) / ROWS) * Math.PI;
    const solidAngle = (Math.sin(polar) * (Math.PI / ROWS) * 2 * Math.PI) / COLUMNS;
    for (let column = 0; column < COLUMNS; column++) {
      const around = ((column + 0.5) / COLUMNS) * 2 * Math.PI;
      const direction: Vector3 = [Math.sin(polar) * Math.sin(around), Math.cos(polar), -Math.sin(polar) * Math.cos(around)];
      visit(direction, row * COLUMNS + column, solidAngle);
    }
  }
}

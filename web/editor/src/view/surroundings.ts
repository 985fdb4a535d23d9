/** Surroundings as pictures: all grey but the sky, so that a grey card looks grey; see `mitsuba/lights.py`. */
import { clamp, whiteBalance } from "loomlight-fabric";
import type { DirectionalLight, Environment, Ground, Vector3 } from "loomlight-web";

import type { Scene } from "../state/document.ts";
import type { SurroundingsPicture } from "./cloth_view.ts";
import type { ClothShape } from "./meshes.ts";

const ROWS = 64;
const COLUMNS = 2 * ROWS;
/** Irradiance that a card which faces upwards, or the window, gets of the surroundings: the lamp gives the rest of π. */
const FILL = 0.22 * Math.PI;
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
  const [around, above] = [scene.lampAzimuth, scene.lampElevation].map((degrees) => (degrees * Math.PI) / 180) as [number, number];
  const towards: Vector3 = [Math.sin(around) * Math.cos(above), Math.sin(above), Math.cos(around) * Math.cos(above)];
  const irradiance = whiteBalance(scene.whiteBalance).map((gain) => gain * LAMP_IRRADIANCE * scene.lampStrength);
  return { kind: "directional", towards, irradiance: irradiance as unknown as Vector3 };
}

const LAMP_IRRADIANCE = Math.PI - FILL;

/** What a piece stands on, with the lamp's share in the light there. */
export function groundOf(scene: Scene, { ground }: ClothShape): Ground {
  const { towards } = lampOf(scene) ?? { towards: [0, 0, 0] };
  const cosine = ground.normal.reduce((sum, value, axis) => sum + value * towards[axis]!, 0);
  const lamp = LAMP_IRRADIANCE * scene.lampStrength * Math.max(cosine, 0);
  const room = scene.surroundings === "none" ? 0 : FILL * scene.surroundingsStrength;
  return { ...ground, lampShare: lamp > 0 ? lamp / (lamp + room) : 0 };
}

const pictures = new Map<string, SurroundingsPicture>();

function pictureOf(kind: Scene["surroundings"]): SurroundingsPicture | null {
  const radiance: Radiance | null = kind === "studio" ? studio : kind === "window" ? room : kind === "sky" ? sky : null;
  if (radiance === null) return null;
  let picture = pictures.get(kind);
  if (picture === undefined) {
    picture = { width: COLUMNS, height: ROWS, pixels: painted(radiance) };
    pictures.set(kind, picture);
  }
  return picture;
}

/** A dome that is brightest above; nothing from below. */
function studio(_x: number, y: number): readonly [number, number, number] {
  const grey = y > 0 ? 0.5 + 0.5 * y : 0;
  return [grey, grey, grey];
}

/** A tall window with soft edges in a dim room. */
function room(x: number, y: number, z: number): readonly [number, number, number] {
  const azimuth = (Math.atan2(x, z) * 180) / Math.PI;
  const elevation = (Math.asin(clamp(y, -1, 1)) * 180) / Math.PI;
  const inside = (distance: number, half: number): number =>
    clamp((half - Math.abs(distance)) / WINDOW.edge + 0.5, 0, 1);
  const pane = inside(azimuth - WINDOW.azimuth, WINDOW.width) * inside(elevation - WINDOW.elevation, WINDOW.height);
  const grey = WALLS + (1 - WALLS) * pane;
  return [grey, grey, grey];
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

/** Radiance over the sphere, scaled so that the best-lit of a few cards gets an irradiance of FILL. */
function painted(radiance: Radiance): Float32Array {
  const pixels = new Float32Array(ROWS * COLUMNS * 3);
  const cards = [
    [0, 1, 0],
    [-0.94, 0.34, 0],
    [0, 0, 1],
  ] as const;
  const irradiances = cards.map(() => 0);
  for (let row = 0; row < ROWS; row++) {
    const polar = ((row + 0.5) / ROWS) * Math.PI;
    const solidAngle = (Math.sin(polar) * (Math.PI / ROWS) * 2 * Math.PI) / COLUMNS;
    for (let column = 0; column < COLUMNS; column++) {
      const around = ((column + 0.5) / COLUMNS) * 2 * Math.PI;
      const direction = [Math.sin(polar) * Math.sin(around), Math.cos(polar), -Math.sin(polar) * Math.cos(around)] as const;
      const colour = radiance(...direction);
      pixels.set(colour, (row * COLUMNS + column) * 3);
      const mean = (colour[0] + colour[1] + colour[2]) / 3;
      cards.forEach((card, index) => {
        const cosine = card[0] * direction[0] + card[1] * direction[1] + card[2] * direction[2];
        irradiances[index]! += Math.max(cosine, 0) * mean * solidAngle;
      });
    }
  }
  const scale = FILL / Math.max(...irradiances);
  return pixels.map((value) => value * scale);
}

/** What a renderer shows its cloth by: camera, lights, environment, exposure. */
import type { Area } from "./areas.ts";
import { GOLDEN } from "./generated.ts";
import { RecordArray, type Values } from "./records.ts";
import { cameraValues } from "./scene/camera.ts";
import type { EnvironmentTables } from "./scene/environment.ts";
import type { Camera, Ground, Light, Vector3 } from "./types.ts";

export interface View {
  readonly camera: Camera;
  readonly lights: readonly Light[];
  readonly environment: EnvironmentTables | null;
  /** Of the environment, degrees. */
  readonly turn: number;
  readonly environmentSamples: number;
  /** Linear radiance beside the cloth and behind its holes; null for the environment, else 0. */
  readonly background: Vector3 | null;
  /** Where the background takes the cloth's shadow. */
  readonly ground: Ground | null;
  readonly shadows: boolean;
  /** Stops. */
  readonly exposure: number;
}

const NO_GROUND: Ground = { normal: [0, 0, 0], offset: 0, lampShare: 0 };

/** What a pass takes beside the view. */
export interface Pass {
  readonly width: number;
  readonly height: number;
  /** Passes before this one. */
  readonly passes: number;
  readonly samples: number;
  readonly castsShadows: boolean;
  /** Passes that the buffers hold the sum of when this one is done; 1 for means. */
  readonly summed: number;
  /** The part of the picture that is drawn; all of it by default. */
  readonly area?: Area;
}

/** The record of the frame of one pass; `scene` are the fields that the scene's buffers say. */
export function frameRecord(view: View, scene: Values, pass: Pass): RecordArray {
  const frame = new RecordArray("Frame", 1);
  // Passes 0 and following of the R2 sequence, about the middle of the pixel.
  const jitter = GOLDEN.map((step) => ((0.5 + pass.passes * step) % 1) - 0.5) as [number, number];
  const background = view.background ?? [0, 0, 0];
  const { normal, offset, lampShare } = view.ground ?? NO_GROUND;
  frame.set(0, {
    width: (pass.area ?? pass).width,
    height: (pass.area ?? pass).height,
    lights: view.lights.length,
    samples: pass.samples,
    pass_number: pass.passes,
    jitter_x: jitter[0],
    jitter_y: jitter[1],
    gain: 2 ** view.exposure / pass.summed,
    casts_shadows: pass.castsShadows ? 1 : 0,
    ...scene,
    ...cameraValues(view.camera, pass.width, pass.height, pass.area),
    background_red: background[0],
    background_green: background[1],
    background_blue: background[2],
    ground_x: normal[0],
    ground_y: normal[1],
    ground_z: normal[2],
    ground_offset: offset,
    ground_lamp: view.lights.length > 0 ? lampShare : 0,
    shows_environment: view.environment !== null && view.background === null ? 1 : 0,
  });
  return frame;
}

/** Whether something is seen beside the cloth; a black background is nothing. */
export function hasBackgroundOf(view: View): boolean {
  return view.background === null ? view.environment !== null : view.background.some((radiance) => radiance > 0);
}

/** What sums over passes depend on, as a text; the exposure is none of it. */
export function keyOfView(view: View, more: readonly unknown[]): string {
  const { environment, exposure: _, ...rest } = view;
  return JSON.stringify([rest, environment === null ? null : identity(environment), more]);
}

const identities = new WeakMap<object, number>();
let identified = 0;

/** A number that no other object has. */
function identity(object: object): number {
  if (!identities.has(object)) identities.set(object, ++identified);
  return identities.get(object)!;
}

/** What a renderer shows its cloth by: camera, lights, environment, exposure. */
import type { EnvironmentTables } from "./scene/environment.ts";
import type { Camera, Light, Vector3 } from "./types.ts";

export interface View {
  readonly camera: Camera;
  readonly lights: readonly Light[];
  readonly environment: EnvironmentTables | null;
  /** Of the environment, degrees. */
  readonly turn: number;
  readonly environmentSamples: number;
  /** Linear radiance beside the cloth and behind its holes; null for the environment, else 0. */
  readonly background: Vector3 | null;
  readonly shadows: boolean;
  /** Stops. */
  readonly exposure: number;
}

/** Meshes, environment and lights in one buffer of an adapter. */
import type { Values } from "../records.ts";
import type { EnvironmentTables } from "../scene/environment.ts";
import { joinMeshes } from "../scene/mesh.ts";
import { joinWords, sceneWords, type SceneWords } from "../scene/scene_words.ts";
import type { Caster, LinearPicture, Mesh } from "../types.ts";
import type { Device } from "./device.ts";

export class SceneBuffers {
  /** Faces of cloth; what only casts shadows comes behind them. */
  readonly shownFaces: number;
  private buffer: GPUBuffer | null = null;
  private readonly device: Device;
  private readonly scene: SceneWords;
  private environment: EnvironmentTables | null = null;
  private firstLight = 0;

  constructor(device: Device, meshes: readonly Mesh[], albedos: readonly (LinearPicture | null)[], casters: readonly Caster[]) {
    const joined = joinMeshes(meshes, casters);
    this.device = device;
    this.shownFaces = joined.shown.faces;
    this.scene = sceneWords(joined, albedos);
  }

  /** No face can hide another from a light. */
  get isFlat(): boolean {
    return this.scene.isFlat;
  }

  /** Where the albedo map of each piece begins, as its fabric's record says it. */
  get maps(): SceneWords["maps"] {
    return this.scene.maps;
  }

  /** By the names that shaders have for them. */
  get buffers(): Record<string, GPUBuffer> {
    return this.buffer === null ? {} : { scene_words: this.buffer };
  }

  /** Light of the next frames: from all directions, or null for none, and records of lights. */
  setLight(environment: EnvironmentTables | null, lights: Uint32Array<ArrayBuffer>): void {
    const isHeld = this.buffer !== null && environment === this.environment;
    if (isHeld && this.buffer!.size >= 4 * (this.firstLight + lights.length)) {
      this.device.write(this.buffer!, lights, this.firstLight);
      return;
    }
    const { words } = this.scene;
    const before = environment === null ? [words] : [words, environment.words];
    const all = joinWords([...before, lights]);
    this.buffer?.destroy();
    this.buffer = this.device.buffer(all.byteLength);
    this.device.write(this.buffer, all);
    [this.environment, this.firstLight] = [environment, all.length - lights.length];
  }

  /** Fields of the record of a frame: the hierarchy, and the environment, turned and taken in so many directions. */
  frameValues(turn: number, samples: number): Values {
    const tables = this.environment;
    const frame = { ...this.scene.frame, light_records: this.firstLight };
    if (tables === null) return frame;
    const angle = (turn * Math.PI) / 180;
    return {
      ...frame,
      environment_rows: tables.rows,
      environment_columns: tables.columns,
      environment_total: tables.total,
      environment_sine: Math.sin(angle),
      environment_cosine: Math.cos(angle),
      environment_samples: tables.total > 0 ? samples : 0,
    };
  }

  destroy(): void {
    this.buffer?.destroy();
  }
}

/** Meshes, environment and lights in an adapter's buffers. */
import type { Values } from "../records.ts";
import type { EnvironmentTables } from "../scene/environment.ts";
import { joinMeshes } from "../scene/mesh.ts";
import { sceneWords, withEnvironment, type SceneWords } from "../scene/scene_words.ts";
import type { LinearPicture, Mesh } from "../types.ts";
import type { Device } from "./device.ts";

export class SceneBuffers {
  readonly buffers: Record<string, GPUBuffer> = {};
  readonly faces: number;
  private readonly device: Device;
  private readonly scene: SceneWords;
  private environment: EnvironmentTables | null = null;

  constructor(device: Device, meshes: readonly Mesh[], albedos: readonly (LinearPicture | null)[]) {
    const joined = joinMeshes(meshes);
    this.device = device;
    this.faces = joined.faces;
    this.scene = sceneWords(joined, albedos);
    this.store("vertices", joined.vertices.words);
    this.store("corners", joined.corners);
    this.store("scene_words", withEnvironment(this.scene, null));
  }

  /** No face can hide another from a light. */
  get isFlat(): boolean {
    return this.scene.isFlat;
  }

  /** Where the albedo map of each piece begins, as its fabric's record says it. */
  get maps(): SceneWords["maps"] {
    return this.scene.maps;
  }

  /** Light from all directions; null for none. */
  setEnvironment(tables: EnvironmentTables | null): void {
    if (tables === this.environment) return;
    this.environment = tables;
    this.store("scene_words", withEnvironment(this.scene, tables));
  }

  /** Fields of the record of a frame: the hierarchy, and the environment, turned and taken in so many directions. */
  frameValues(turn: number, samples: number): Values {
    const tables = this.environment;
    if (tables === null) return this.scene.frame;
    const angle = (turn * Math.PI) / 180;
    return {
      ...this.scene.frame,
      environment_rows: tables.rows,
      environment_columns: tables.columns,
      environment_total: tables.total,
      environment_sine: Math.sin(angle),
      environment_cosine: Math.cos(angle),
      environment_samples: tables.total > 0 ? samples : 0,
    };
  }

  destroy(): void {
    Object.values(this.buffers).forEach((buffer) => buffer.destroy());
  }

  private store(name: string, words: Uint32Array<ArrayBuffer>): void {
    const before = this.buffers[name];
    // Shaders read the number of faces from the size of `corners`, so a buffer has the size of its content.
    before?.destroy();
    const buffer = this.device.buffer(words.byteLength);
    this.device.write(buffer, words);
    this.buffers[name] = buffer;
  }
}

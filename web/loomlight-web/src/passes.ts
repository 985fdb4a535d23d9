/** Passes of one picture, which add up in the buffers of the adapter. */
import type { ClothBuffers } from "./gpu/cloth_buffers.ts";
import type { Device, Resources } from "./gpu/device.ts";
import type { Source } from "./gpu/present.ts";
import { Raster } from "./gpu/raster.ts";
import { Targets } from "./gpu/targets.ts";
import { ENTRIES, type Plan } from "./plan.ts";
import type { RecordArray } from "./records.ts";
import { lightRecords } from "./scene/camera.ts";
import { frameRecord, hasBackgroundOf, type View } from "./view.ts";

export class Passes {
  /** Resolves when the raster pass is compiled. */
  readonly compiled: Promise<void>;
  /** Passes that have added up. */
  count = 0;
  /** Rises with each picture. */
  revision = 0;
  private readonly device: Device;
  private readonly raster: Raster;
  private targets: Targets;
  private record: GPUBuffer | null = null;
  /** Of the picture that the sums are of, pixels. */
  private size: readonly [number, number] = [1, 1];
  /** What the sums show; empty where they are to begin anew. */
  private shown = "";
  /** Of the last picture. */
  private exposure = 0;
  private hasBackground = false;

  /** For pictures of at most so many pixels. */
  constructor(device: Device, width: number, height: number) {
    this.device = device;
    this.raster = new Raster(device);
    this.compiled = this.raster.compiled;
    this.targets = new Targets(device, width, height);
  }

  get isReady(): boolean {
    return this.raster.isReady;
  }

  /** Whether the sums are of what has this key. */
  shows(key: string): boolean {
    return this.shown === key;
  }

  /** The next pass begins new sums. */
  forget(): void {
    this.shown = "";
  }

  resize(width: number, height: number): void {
    this.targets.destroy();
    this.targets = new Targets(this.device, width, height);
    this.forget();
  }

  /** Begins new sums if the picture is to be another. */
  begin(key: string, view: View, cloth: ClothBuffers, width: number, height: number): void {
    if (this.shows(key) && this.size[0] === width && this.size[1] === height) return;
    this.shown = key;
    this.count = 0;
    this.size = [width, height];
    cloth.scene.setLight(view.environment, lightRecords(view.lights).words);
  }

  /** Adds a pass of so many samples a pixel, or of all directions that `view` takes to its environment. */
  add(view: View, cloth: ClothBuffers, plan: Plan, samples: number): void {
    const [width, height] = this.size;
    const { castsShadows } = plan;
    const scene = cloth.scene.frameValues(view.turn, view.environmentSamples);
    const frame = frameRecord(view, scene, { width, height, passes: this.count, samples, castsShadows });
    this.targets.makeRoom(castsShadows ? view.lights.length + frame.get(0, "environment_samples") : 1);
    const resources = this.resources(frame, cloth);
    this.raster.draw(this.targets, resources, cloth.scene.shownFaces, width, height);
    const tiles = [Math.ceil(width / 8), Math.ceil(height / 8)] as const;
    // A dispatch a submission: software adapters take seconds for all of them.
    for (let layer = 0; layer < plan.layers; layer++) {
      this.device.dispatch(layer === 0 ? "first_layer" : "next_layer", tiles, resources);
      if (castsShadows) this.device.dispatch("cast_shadows", tiles, resources);
      this.device.dispatch(ENTRIES[plan.model], tiles, resources);
    }
    this.device.dispatch("add_background", tiles, resources);
    this.toneMap(view, resources);
    this.count++;
    this.hasBackground = hasBackgroundOf(view);
  }

  /** Shows the sums by another exposure, if it is another. */
  expose(view: View, cloth: ClothBuffers): void {
    if (view.exposure === this.exposure) return;
    const [width, height] = this.size;
    const pass = { width, height, passes: this.count - 1, samples: 1, castsShadows: false };
    this.toneMap(view, this.resources(frameRecord(view, {}, pass), cloth));
  }

  private toneMap(view: View, resources: Resources): void {
    const [width, height] = this.size;
    this.device.dispatch("tone_map", [Math.ceil((width * height) / 64), 1], resources);
    this.exposure = view.exposure;
    this.revision++;
  }

  /** What kernels bind, with this record of the frame. */
  private resources(frame: RecordArray, cloth: ClothBuffers): Resources {
    this.record ??= this.device.buffer(frame.words.byteLength, GPUBufferUsage.UNIFORM);
    this.device.write(this.record, frame.words);
    return {
      ...cloth.buffers,
      ...this.targets.buffers,
      frame_record: this.record,
      visible_faces: this.targets.faces,
    };
  }

  /** The picture as it lies in buffers. */
  source(): Source {
    const [width, height] = this.size;
    const { pixels, radiance } = this.targets.buffers;
    return { width, height, passes: this.count, revision: this.revision, pixels: pixels!, sums: radiance!, hasBackground: this.hasBackground };
  }

  destroy(): void {
    this.targets.destroy();
    this.record?.destroy();
  }
}

/** Passes of one picture, which add up in the buffers of the adapter: each in one go, or area by area. */
import type { Area } from "./areas.ts";
import { Averages } from "./gpu/averages.ts";
import type { ClothBuffers } from "./gpu/cloth_buffers.ts";
import type { Device, Resources } from "./gpu/device.ts";
import type { Source } from "./gpu/present.ts";
import { Raster } from "./gpu/raster.ts";
import type { ShaderName } from "./gpu/shaders.ts";
import { Targets } from "./gpu/targets.ts";
import { ENTRIES, type Plan } from "./plan.ts";
import type { RecordArray } from "./records.ts";
import { lightRecords } from "./scene/camera.ts";
import { frameRecord, hasBackgroundOf, type Pass, type View } from "./view.ts";

// Directions to the environment that a pass of areas takes at most: slow adapters have a picture sooner, and passes add up.
const AREA_ENVIRONMENT_SAMPLES = 2;

export class Passes {
  /** Resolves when what every pass needs is compiled. */
  readonly compiled: Promise<void>;
  /** Passes that have added up. */
  count = 0;
  /** Rises with each picture. */
  revision = 0;
  /** Whether the buffers hold means over passes, in place of sums: those of pictures that are made of areas. */
  isAveraged = false;
  private readonly device: Device;
  private readonly raster: Raster;
  private readonly averages: Averages;
  private targets: Targets;
  /** Where areas are drawn. */
  private tile: Targets | null = null;
  private record: GPUBuffer | null = null;
  /** Of the picture that the sums are of, pixels. */
  private size: readonly [number, number] = [1, 1];
  /** What the sums show; empty where they are to begin anew. */
  private shown = "";
  /** Whether there is a picture before the first pass is done: a coarser one. */
  private hasStart = false;
  /** Whether the raster pass of this pass is drawn. */
  private isRastered = false;
  /** Of the last picture. */
  private exposure = 0;
  private hasBackground = false;

  /** For pictures of at most so many pixels. */
  constructor(device: Device, width: number, height: number) {
    this.device = device;
    this.raster = new Raster(device);
    this.averages = new Averages(device);
    this.compiled = Promise.all([this.raster.compiled, this.averages.compiled]).then(() => undefined);
    this.targets = new Targets(device, width, height);
  }

  get isReady(): boolean {
    return this.raster.isReady && this.averages.isReady;
  }

  /** Whether there is something to show. */
  get hasPicture(): boolean {
    return this.count > 0 || this.hasStart;
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
    [this.count, this.hasStart] = [0, false];
    this.forget();
  }

  /** Begins new sums, or means, if the picture is to be another. */
  begin(key: string, view: View, cloth: ClothBuffers, width: number, height: number, isAveraged: boolean): void {
    if (this.shows(key) && this.size[0] === width && this.size[1] === height) return;
    this.shown = key;
    this.count = 0;
    this.size = [width, height];
    [this.isAveraged, this.hasStart, this.isRastered] = [isAveraged, false, false];
    cloth.scene.setLight(view.environment, lightRecords(view.lights).words);
  }

  /** Goes on with means of so many pixels, which begin as what is shown now. */
  refine(width: number, height: number): void {
    const [fromWidth, fromHeight] = this.size;
    const isSame = fromWidth === width && fromHeight === height;
    this.averages.enlarge(this.targets, this.size, this.isAveraged ? 1 : this.count, [width, height]);
    this.size = [width, height];
    this.count = isSame ? this.count : 0;
    [this.isAveraged, this.hasStart, this.isRastered] = [true, true, false];
    this.revision++;
  }

  /** Adds a pass of so many samples a pixel, or of all directions that `view` takes to its environment. */
  add(view: View, cloth: ClothBuffers, plan: Plan, samples: number): void {
    this.device.isLayered = cloth.isLayered;
    const [width, height] = this.size;
    const pass = { width, height, passes: this.count, samples, castsShadows: plan.castsShadows, summed: this.count + 1 };
    const resources = this.prepare(this.targets, view, cloth, pass);
    this.raster.draw(this.targets, resources, cloth.scene.shownFaces, width, height);
    // A dispatch a submission: software adapters take seconds for all of them.
    this.shade(plan, width, height, (name, groups) => this.device.dispatch(name, groups, resources));
    this.toneMap(view, resources, width, height);
    this.count++;
    this.hasBackground = hasBackgroundOf(view);
  }

  /** Draws an area of the next pass of a picture of means; `endPass` counts the pass. */
  addArea(area: Area, whole: View, cloth: ClothBuffers, plan: Plan, samples: number): void {
    this.device.isLayered = cloth.isLayered;
    const view = { ...whole, environmentSamples: Math.min(whole.environmentSamples, AREA_ENVIRONMENT_SAMPLES) };
    const [width, height] = this.size;
    const pass = { width, height, passes: this.count, samples, castsShadows: plan.castsShadows, summed: 1 };
    if (!this.isRastered) {
      const resources = this.prepare(this.targets, view, cloth, { ...pass, castsShadows: false });
      this.raster.draw(this.targets, resources, cloth.scene.shownFaces, width, height);
      this.isRastered = true;
    }
    const tile = this.tileFor(area);
    const encoder = this.device.gpu.createCommandEncoder();
    const origin = { x: area.x, y: area.y };
    encoder.copyTextureToTexture({ texture: this.targets.faceTexture, origin }, { texture: tile.faceTexture }, [area.width, area.height]);
    encoder.clearBuffer(tile.buffers["radiance"]!);
    const resources = this.prepare(tile, view, cloth, { ...pass, area });
    // One submission: each costs a busy machine a turn of its processor.
    const run = (name: ShaderName, groups: readonly [number, number]): void => this.device.encode(encoder, name, groups, resources);
    this.shade(plan, area.width, area.height, run);
    this.averages.blend(encoder, area, tile, this.targets, width, this.count);
    run("tone_map", [Math.ceil((area.width * area.height) / 64), 1]);
    this.place(encoder, area, tile);
    this.device.gpu.queue.submit([encoder.finish()]);
    this.exposure = view.exposure;
    this.revision++;
    this.hasBackground = hasBackgroundOf(view);
  }

  /** All areas of a pass are drawn. */
  endPass(): void {
    this.count++;
    this.isRastered = false;
  }

  /** Shows what there is by another exposure, if it is another. */
  expose(view: View, cloth: ClothBuffers): void {
    if (view.exposure === this.exposure || !this.hasPicture) return;
    this.device.isLayered = cloth.isLayered;
    const [width, height] = this.size;
    const pass = { width, height, passes: 0, samples: 1, castsShadows: false, summed: this.summed };
    this.toneMap(view, this.prepare(this.targets, view, cloth, pass), width, height);
  }

  /** The picture as it lies in buffers. */
  source(): Source {
    const [width, height] = this.size;
    const { pixels, radiance } = this.targets.buffers;
    const { summed, revision, hasBackground } = this;
    return { width, height, passes: summed, revision, pixels: pixels!, sums: radiance!, hasBackground };
  }

  destroy(): void {
    this.targets.destroy();
    this.tile?.destroy();
    this.averages.destroy();
    this.record?.destroy();
  }

  /** Passes that the buffers hold the sum of. */
  private get summed(): number {
    return this.isAveraged ? 1 : this.count;
  }

  private shade(plan: Plan, width: number, height: number, run: (name: ShaderName, groups: readonly [number, number]) => void): void {
    const groups = [Math.ceil(width / 8), Math.ceil(height / 8)] as const;
    for (let layer = 0; layer < plan.layers; layer++) {
      run(layer === 0 ? "first_layer" : "next_layer", groups);
      if (plan.castsShadows) run("cast_shadows", groups);
      run(ENTRIES[plan.model], groups);
    }
    run("add_background", groups);
  }

  private toneMap(view: View, resources: Resources, width: number, height: number): void {
    this.device.dispatch("tone_map", [Math.ceil((width * height) / 64), 1], resources);
    this.exposure = view.exposure;
    this.revision++;
  }

  /** The buffers where an area is drawn. */
  private tileFor({ width, height }: Area): Targets {
    const { tile } = this;
    if (tile !== null && tile.width >= width && tile.height >= height) return tile;
    tile?.destroy();
    this.tile = new Targets(this.device, Math.max(width, tile?.width ?? 0), Math.max(height, tile?.height ?? 0));
    return this.tile;
  }

  /** Copies the colours of an area to its place in the picture. */
  private place(encoder: GPUCommandEncoder, { x, y, width, height }: Area, tile: Targets): void {
    const [from, to] = [tile.buffers["pixels"]!, this.targets.buffers["pixels"]!];
    for (let row = 0; row < height; row++)
      encoder.copyBufferToBuffer(from, 4 * row * width, to, 4 * ((y + row) * this.size[0] + x), 4 * width);
  }

  /** What kernels bind for a pass over targets, with room for the visibility of its lights. */
  private prepare(targets: Targets, view: View, cloth: ClothBuffers, pass: Pass): Resources {
    const frame = frameRecord(view, cloth.scene.frameValues(view.turn, view.environmentSamples), pass);
    targets.makeRoom(pass.castsShadows ? view.lights.length + frame.get(0, "environment_samples") : 1);
    return this.resources(frame, cloth, targets);
  }

  /** What kernels bind, with this record of the frame. */
  private resources(frame: RecordArray, cloth: ClothBuffers, targets: Targets): Resources {
    this.record ??= this.device.buffer(frame.words.byteLength, GPUBufferUsage.UNIFORM);
    this.device.write(this.record, frame.words);
    return {
      ...cloth.buffers,
      ...targets.buffers,
      frame_record: this.record,
      visible_faces: targets.faces,
    };
  }
}

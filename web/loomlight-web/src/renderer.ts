/** Renders meshes of cloth on WebGPU; see `realtime/renderer.py`, whose frames it makes. */
import { clamp, InputError, type Draft, type FabricFields } from "loomlight-fabric";

import { areasOf, pixelsOf, taken, type Area } from "./areas.ts";
import type { Openness } from "./fabric/between_yarns.ts";
import { DEFAULT_ENVIRONMENT_SAMPLES, DEFAULT_SAMPLES } from "./generated.ts";
import { ClothBuffers } from "./gpu/cloth_buffers.ts";
import { Device, type DeviceOptions } from "./gpu/device.ts";
import { Presenter } from "./gpu/present.ts";
import type { TableCache } from "./gpu/table_cache.ts";
import { requireSize } from "./gpu/targets.ts";
import { BUDGET, Pace, type Budget } from "./pace.ts";
import { Passes } from "./passes.ts";
import { ENTRIES, possible, ready, type Plan, type Previews, type ReadyPlan } from "./plan.ts";
import { cameraValues, lightRecords } from "./scene/camera.ts";
import { environmentTables } from "./scene/environment.ts";
import type { Camera, Caster, Environment, FrameReport, Ground, Light, Mesh, ModelName, Picture, PictureOptions, Piece, Statistics, Vector3 } from "./types.ts";
import { keyOfView, type View } from "./view.ts";

const OWN_MODELS: readonly ModelName[] = ["lobes", "point"];
// A picture that is the mean of so many passes changes no more to the eye.
const MAX_PASSES = 256;
// Of a preview, and of one on a software adapter, where more would keep the processor from compiling.
const PREVIEW_PASSES = 4;
const SOFTWARE_PREVIEW_PASSES = 1;
// Between two showings of a picture that is made of areas, as each is one of the whole canvas: milliseconds, and times of
// what the last one took.
const SHOWS_EVERY = 1000;
const SHOWS_REST = 5;
// Pixels of the areas of pictures for files.
const PICTURE_AREA = 64 * 64;

/** How a renderer is made. */
export interface RendererOptions extends DeviceOptions {
  /** Where frames are shown; without one they are only read back. */
  readonly canvas?: HTMLCanvasElement | OffscreenCanvas;
  /** Of frames without a canvas, pixels; 512 × 512 by default. */
  readonly size?: readonly [number, number];
  /** Whether the canvas lets through what lies behind it where there is neither cloth nor a background. */
  readonly transparent?: boolean;
  /** A renderer whose device this one uses, so that `wipe` can show both. */
  readonly shareWith?: ClothRenderer;
  /** Milliseconds that passes may take; null for pictures that are always as fine as the canvas, each pass in one go. */
  readonly budget?: Budget | null;
  /** Keeps baked tables between visits. */
  readonly tables?: TableCache;
}

/** Renders pieces of cloth by direct light; see `docs/web.md`. */
export class ClothRenderer {
  private readonly options: RendererOptions;
  private device: Device;
  private view: View = {
    camera: { origin: [0, 0, 0.3], target: [0, 0, 0] },
    lights: [],
    environment: null,
    turn: 0,
    environmentSamples: DEFAULT_ENVIRONMENT_SAMPLES,
    background: null,
    ground: null,
    shadows: true,
    exposure: 0,
  };
  private model: ModelName = "lobes";
  private samples = DEFAULT_SAMPLES;
  private mostPasses = MAX_PASSES;
  private width: number;
  private height: number;
  private cloth: ClothBuffers | null = null;
  private passes: Passes;
  private presenter: Presenter | null = null;
  private readonly pace: Pace | null;
  /** What the last frame was drawn with. */
  private plan: ReadyPlan | null = null;
  /** Whether all of a picture was ever ready: from then on it stays as it is while something compiles. */
  private wasWhole = false;
  /** What the device could not compile, a sentence each. */
  private missing: readonly string[] = [];
  /** Submissions that are waited for. */
  private pending = 0;
  /** Areas that the pass which has begun still lacks. */
  private areas: Area[] = [];
  private shownAt = 0;
  private showMs = 0;
  /** Whether the picture at rest is refined to the size of the canvas; see `holdRefining`. */
  private refines = true;
  private other: { readonly renderer: ClothRenderer; readonly split: number } | null = null;
  private done = { passes: 0, frameMs: 0, editMs: 0, bakeKernels: 0, bakes: 0, openings: 0, writes: 0, writtenBytes: 0 };

  private constructor(options: RendererOptions, device: Device) {
    this.options = options;
    this.device = device;
    const { canvas } = options;
    [this.width, this.height] = canvas ? [canvas.width, canvas.height] : (options.size ?? [512, 512]);
    requireSize(this.width, this.height);
    this.pace = options.budget === null ? null : new Pace(options.budget ?? BUDGET);
    this.passes = new Passes(device, this.width, this.height);
    if (canvas) this.presenter = new Presenter(device, canvas, options.transparent ?? false);
  }

  /**
   * A renderer on the browser's graphics adapter.
   *
   * @throws InputError no WebGPU, no adapter, or one whose limits are too small: one sentence.
   */
  static async create(options: RendererOptions = {}): Promise<ClothRenderer> {
    const device = options.shareWith?.device ?? (await Device.request(options));
    return new ClothRenderer(options, device);
  }

  /** Resolves with a sentence when the device is lost; `rebuild` then goes on. */
  get lost(): Promise<string> {
    return this.device.lost;
  }

  /** Name of the graphics adapter, as far as the browser tells, and whether a CPU computes. */
  get adapter(): { readonly name: string; readonly isSoftware: boolean } {
    return { name: this.device.name, isSoftware: this.device.isSoftware };
  }

  /** What was done so far, in kernels, bytes and milliseconds. */
  get statistics(): Statistics {
    const { done } = this;
    const fabrics = this.cloth?.fabrics;
    return {
      bakeKernels: done.bakeKernels + (fabrics?.bakeKernels ?? 0),
      bakes: done.bakes + (fabrics?.bakes ?? 0),
      openings: done.openings + (this.cloth?.openings ?? 0),
      writes: done.writes + (fabrics?.writes ?? 0),
      writtenBytes: done.writtenBytes + (fabrics?.writtenBytes ?? 0),
      passes: done.passes,
      frameMs: done.frameMs,
      editMs: done.editMs,
    };
  }

  /**
   * The cloth to show: meshes and fabrics; a model whose tables came from Python gives way to `lobes`. `casters` are
   * opaque and cast shadows on it; they are not drawn.
   *
   * @throws InputError a mesh without uv, a fabric that cannot be, or tables beyond the adapter's limits.
   */
  setPieces(pieces: readonly Piece[], casters: readonly Caster[] = []): void {
    const cloth = new ClothBuffers(this.device, pieces, casters, this.options.tables ?? null);
    this.keepCounts();
    this.leaveTables();
    cloth.fabrics.useTables(this.model === "lobes");
    this.cloth?.destroy();
    this.cloth = cloth;
    this.passes.forget();
  }

  /**
   * Other meshes for the pieces, one each, and what casts shadows on them, by default as before; nothing is baked.
   *
   * @throws InputError a mesh without uv, or another number of meshes.
   */
  setMeshes(meshes: readonly Mesh[], casters?: readonly Caster[]): void {
    const cloth = this.require();
    cloth.setMeshes(meshes, casters ?? cloth.casters);
    this.passes.forget();
  }

  /**
   * Another fabric, or an edit of it, for piece `number`: only what changes is written, and only tables that change
   * are baked. Where tables from Python are shown, the picture changes with the next `setTables`.
   *
   * @param openness what light between yarns needs; see `Piece`.
   * @throws InputError a fabric that cannot be; the picture stays as it is.
   */
  setFabric(number: number, fields: FabricFields, draft: Draft, openness?: Openness | null): void {
    const cloth = this.require();
    const begin = performance.now();
    cloth.setFabric(number, fields, draft, openness);
    this.done.editMs = performance.now() - begin;
    this.passes.forget();
  }

  /**
   * The model of the next frames, `lobes` or `point`, whose tables the page makes; `samples` are points of a pixel's
   * footprint that one pass of `point` takes, and `passes` how many passes add up at rest, 256 by default.
   *
   * @throws InputError no such model, no sample, or no pass.
   */
  setModel(model: ModelName, options: { readonly samples?: number; readonly passes?: number } = {}): void {
    const samples = options.samples ?? DEFAULT_SAMPLES;
    const passes = options.passes ?? MAX_PASSES;
    if (!OWN_MODELS.includes(model))
      throw new InputError(
        Object.hasOwn(ENTRIES, model)
          ? `model = "${model}" has tables that Python makes: give them by setTables.`
          : `model = "${model}" is unknown here: use ${OWN_MODELS.join(" or ")}.`,
      );
    if (!(Number.isInteger(samples) && samples >= 1))
      throw new InputError(`samples = ${samples}: it is a whole number of at least 1.`);
    if (!(Number.isInteger(passes) && passes >= 1))
      throw new InputError(`passes = ${passes}: it is a whole number of at least 1.`);
    this.leaveTables();
    this.model = model;
    this.samples = samples;
    this.mostPasses = passes;
    this.cloth?.fabrics.useTables(model === "lobes");
  }

  /**
   * Shows the only piece by tables that Python packs: `content` is the answer of `/api/tables` of `loomlight view`. So it
   * is with `neural` and `clustered`, and with `lobes` and `point` of cloth in layers; for `options` see `setModel`.
   *
   * @throws InputError no such model, content that is no tables, or several pieces.
   */
  setTables(model: ModelName, content: Uint8Array, options: { readonly samples?: number; readonly passes?: number } = {}): void {
    if (!Object.hasOwn(ENTRIES, model))
      throw new InputError(`model = "${model}" is unknown here: use ${Object.keys(ENTRIES).join(", ")}.`);
    this.require().setTables(model, content);
    this.model = model;
    [this.samples, this.mostPasses] = [options.samples ?? DEFAULT_SAMPLES, options.passes ?? MAX_PASSES];
    this.passes.forget();
  }

  /** Directional and point lights, which are exact. */
  setLights(lights: readonly Light[]): void {
    lightRecords(lights); // refuses a light of no direction
    this.view = { ...this.view, lights: [...lights] };
  }

  /**
   * Light from all directions, which is seen beside the cloth too; `samples` directions are taken in one pass.
   *
   * @throws InputError radiance that is negative or not finite.
   */
  setEnvironment(environment: Environment | null, options: { readonly samples?: number } = {}): void {
    this.view = {
      ...this.view,
      environment: environment === null ? null : environmentTables(environment),
      turn: environment?.turn ?? 0,
      environmentSamples: options.samples ?? DEFAULT_ENVIRONMENT_SAMPLES,
    };
  }

  /** Turns the environment about the vertical, degrees. */
  turnEnvironment(turn: number): void {
    this.view = { ...this.view, turn };
  }

  /** Linear radiance beside the cloth and behind its holes; null for the environment, else black. */
  setBackground(background: Vector3 | null): void {
    this.view = { ...this.view, background };
  }

  /** A plane where the background takes the shadow of the cloth; null for none. */
  setGround(ground: Ground | null): void {
    this.view = { ...this.view, ground };
  }

  /** Whether cloth casts shadows on cloth. */
  setShadows(shadows: boolean): void {
    this.view = { ...this.view, shadows };
  }

  /** Stops: colours are multiplied by 2^exposure. */
  setExposure(exposure: number): void {
    this.view = { ...this.view, exposure };
  }

  /**
   * The camera of the next frames.
   *
   * @throws InputError a field of view outside 0 to 180, or no direction to look in.
   */
  setCamera(camera: Camera): void {
    cameraValues(camera, this.width, this.height);
    this.view = { ...this.view, camera };
  }

  /**
   * Another size of frames, pixels, and of the canvas.
   *
   * @throws InputError a size out of range.
   */
  resize(width: number, height: number): void {
    requireSize(width, height);
    const { canvas } = this.options;
    if (canvas) [canvas.width, canvas.height] = [width, height];
    [this.width, this.height] = [width, height];
    this.passes.resize(width, height);
  }

  /**
   * Whether a picture at rest that takes many submissions stays as coarse as it is for now: where something else makes
   * it meanwhile, on the same processor.
   */
  holdRefining(isHeld: boolean): void {
    this.refines = !isHeld;
  }

  /** Milliseconds that a pass of the size of the canvas takes, as far as measured; 0 before the first. */
  get passMs(): number {
    return this.pace?.expected(this.width * this.height) ?? 0;
  }

  /** Shows `other`, which shares this one's device, right of `split` (0 at the left edge, 1 at the right); null ends it. */
  wipe(other: ClothRenderer | null, split = 0.5): void {
    if (other !== null && other.device !== this.device)
      throw new InputError("The other renderer has a device of its own: make it with shareWith.");
    this.other = other === null ? null : { renderer: other, split: clamp(split, 0, 1) };
  }

  /**
   * One pass, shown on the canvas: call it at every animation frame.
   *
   * Coarse while something moves on a slow adapter, finer at rest, where passes add up: at last as fine as the canvas, from
   * the middle on, an area at a time. It never waits: while shaders compile or the adapter is busy, it returns what there
   * is.
   */
  frame(): FrameReport {
    const mine = this.advance(this.view);
    if (this.other === null) {
      this.show();
      return mine;
    }
    const others = this.other.renderer.advance(this.view);
    this.show();
    return {
      ...mine,
      passes: Math.min(mine.passes, others.passes),
      refined: Math.min(mine.refined, others.refined),
      isComplete: mine.isComplete && others.isComplete,
    };
  }

  /**
   * A picture of so many passes as fine as the canvas, for files and tests; resolves when the adapter has made it.
   *
   * @throws Error a shader that the browser cannot compile.
   */
  async render(passes: number): Promise<void> {
    const plan = await this.whole();
    this.passes.forget();
    this.areas = [];
    this.begin(plan, this.width, this.height, false);
    for (let pass = 0; pass < passes; pass++) {
      this.addPass(plan);
      await this.device.gpu.queue.onSubmittedWorkDone();
    }
    this.show();
  }

  /**
   * A picture of another size than the canvas, of what is shown, beside it: nothing is baked for it.
   *
   * @throws InputError a size out of range, or one that the adapter has no room for.
   * @throws Error a shader that the browser cannot compile.
   */
  async picture(options: PictureOptions): Promise<Picture> {
    const { width, height, onPass } = options;
    requireSize(width, height);
    const view = options.background === undefined ? this.view : { ...this.view, background: options.background };
    const plan = await this.whole();
    const passes = new Passes(this.device, width, height);
    try {
      await passes.compiled;
      const all = { x: 0, y: 0, width, height };
      // Areas of one size: a pixel's random numbers follow from its place in one, and are the same each time.
      const pixels = Math.max(this.pace?.pixels ?? Infinity, PICTURE_AREA);
      const inAreas = this.pace !== null && (this.device.isSoftware || pixelsOf(all) > pixels);
      passes.begin(keyOfView(view, []), view, this.require(), width, height, inAreas);
      const most = Math.min(options.passes, this.mostPasses);
      for (let pass = 0; pass < most; pass++) {
        const areas = inAreas ? areasOf(width, height, PICTURE_AREA) : [all];
        for (let left = pixelsOf(all); left > 0; ) {
          const next = taken(areas, inAreas ? Math.max(this.pace?.pixels ?? Infinity, PICTURE_AREA) : Infinity);
          const begin = performance.now();
          if (inAreas) for (const area of next) passes.addArea(area, view, this.require(), plan, this.samples);
          else passes.add(view, this.require(), plan, this.samples);
          await this.device.gpu.queue.onSubmittedWorkDone();
          const done = next.reduce((sum, area) => sum + pixelsOf(area), 0);
          this.pace?.measured(performance.now() - begin, done);
          left -= done;
          onPass?.((pass + 1 - left / pixelsOf(all)) / most);
        }
        if (inAreas) passes.endPass();
      }
      return { width, height, pixels: await this.pixelsOf(passes), linear: await this.linearOf(passes) };
    } finally {
      passes.destroy();
    }
  }

  /**
   * Resolves when everything that the next frame needs is compiled and baked, or cannot be.
   *
   * @throws Error a shader without which there is no picture, and which the browser cannot compile.
   */
  async ready(): Promise<void> {
    await this.whole();
  }

  /** The picture's pixels, sRGB with an opaque alpha [height·width·4], of the size of the last frame. */
  async readPixels(): Promise<{ width: number; height: number; data: Uint8ClampedArray<ArrayBuffer> }> {
    const { width, height } = this.passes.source();
    return { width, height, data: await this.pixelsOf(this.passes) };
  }

  /** Mean linear radiance, and the share of each pixel that cloth covers [height·width·4]. */
  async readLinear(): Promise<{ width: number; height: number; data: Float32Array }> {
    const { width, height } = this.passes.source();
    return { width, height, data: await this.linearOf(this.passes) };
  }

  /** A new device after a loss, with everything that the old one held. */
  async rebuild(): Promise<void> {
    const { canvas, shareWith, transparent } = this.options;
    this.device = shareWith?.device ?? (await Device.request(this.options));
    this.passes = new Passes(this.device, this.width, this.height);
    if (canvas) this.presenter = new Presenter(this.device, canvas, transparent ?? false);
    this.keepCounts();
    const { model, cloth, samples, mostPasses } = this;
    [this.cloth, this.pending] = [null, 0];
    if (cloth !== null) {
      this.setPieces(cloth.pieces, cloth.casters);
      if (cloth.servedContent !== null) this.setTables(model, cloth.servedContent, { samples, passes: mostPasses });
    }
    this.passes.forget();
  }

  /** Gives everything back to the adapter. */
  destroy(): void {
    if (this.options.shareWith === undefined) {
      this.device.destroy();
      return;
    }
    this.cloth?.destroy();
    this.passes.destroy();
  }

  /** The plan of the whole picture, once it is ready. */
  private async whole(): Promise<ReadyPlan> {
    for (;;) {
      const plan = this.prepare("none");
      if (plan !== null && this.require().isSettled) {
        this.wasWhole = true;
        return plan;
      }
      await Promise.all([this.passes.compiled, this.device.compiled(), this.require().found()]);
    }
  }

  /** What can be drawn of what was asked for, or in its place meanwhile; begins what is missing. */
  private prepare(previews: Previews): ReadyPlan | null {
    const cloth = this.require();
    this.device.isLayered = cloth.isLayered;
    const castsShadows = this.view.shadows && !cloth.scene.isFlat;
    const asked: Plan = { model: this.model, castsShadows, layers: cloth.layers };
    const { plan, missing } = possible(this.device, cloth, asked);
    this.missing = missing;
    const found = ready(this.device, cloth, plan, previews, () => this.passes.forget());
    return this.passes.isReady ? found : null;
  }

  private async pixelsOf(from: Passes): Promise<Uint8ClampedArray<ArrayBuffer>> {
    const { width, height, pixels } = from.source();
    return new Uint8ClampedArray(await this.device.read(pixels, 4 * width * height));
  }

  private async linearOf(from: Passes): Promise<Float32Array> {
    const { width, height, passes, sums } = from.source();
    return new Float32Array(await this.device.read(sums, 16 * width * height)).map((sum) => sum / Math.max(passes, 1));
  }

  private advance(view: View): FrameReport {
    this.view = view;
    const previews = this.wasWhole ? "none" : this.done.passes === 0 ? "first" : "more";
    const plan = this.pending > 0 ? null : this.prepare(previews);
    if (plan === null) return this.report(false);
    this.plan = plan;
    this.wasWhole ||= !plan.isPreview;
    if (!this.passes.shows(this.keyOf(plan))) {
      this.pace?.moved(this.width * this.height);
      this.beginPicture(plan);
    } else {
      this.passes.expose(this.view, this.require());
      if (this.areas.length === 0 && !this.beginPass(plan)) return this.report(!plan.isPreview && this.isFull);
    }
    this.draw(plan);
    return this.report(false);
  }

  /** Whether the picture has the size of the canvas. */
  private get isFull(): boolean {
    const { width, height } = this.passes.source();
    return width === this.width && height === this.height;
  }

  /** Begins a picture as fine as the pace has it. */
  private beginPicture(plan: ReadyPlan): void {
    const divisor = this.pace?.divisor ?? 1;
    const side = (length: number): number => Math.max(1, Math.round(length / divisor));
    const [width, height] = [side(this.width), side(this.height)];
    const isAveraged = this.pace !== null && width * height > this.pace.pixels;
    this.passes.forget();
    this.begin(plan, width, height, isAveraged);
    this.areas = isAveraged ? areasOf(width, height, this.pace!.pixels) : [];
  }

  /** Begins another pass over a picture that stands, or a finer picture; false where there is nothing more to do. */
  private beginPass(plan: ReadyPlan): boolean {
    const { pace, passes } = this;
    const full = this.width * this.height;
    if (!this.isFull && pace?.rested(full)) {
      this.beginPicture(plan);
      return true;
    }
    if (pace !== null && !plan.isPreview && !this.isFull) {
      if (!this.refines) return false;
      passes.refine(this.width, this.height);
    }
    const previews = this.device.isSoftware ? SOFTWARE_PREVIEW_PASSES : PREVIEW_PASSES;
    const most = plan.isPreview ? previews : (pace?.passes(full, this.mostPasses) ?? this.mostPasses);
    if (passes.count >= most) return false;
    const { width, height } = passes.source();
    // What has become too slow for one submission goes on in areas.
    if (pace !== null && !passes.isAveraged && width * height > pace.pixels) passes.refine(width, height);
    this.areas = passes.isAveraged ? areasOf(width, height, pace?.pixels ?? Infinity) : [];
    return true;
  }

  /** Draws a pass, or as many areas of one as a submission may take. */
  private draw(plan: ReadyPlan): void {
    const { width, height } = this.passes.source();
    if (!this.passes.isAveraged) {
      this.addPass(plan);
      this.time(width * height);
      return;
    }
    const areas = taken(this.areas, this.pace?.pixels ?? Infinity);
    for (const area of areas) this.passes.addArea(area, this.view, this.require(), plan, plan.isPreview ? 1 : this.samples);
    if (this.areas.length === 0) {
      this.passes.endPass();
      this.done.passes++;
    }
    this.time(areas.reduce((sum, area) => sum + pixelsOf(area), 0));
  }

  private time(pixels: number): void {
    this.wait((ms) => {
      this.done.frameMs = ms;
      this.pace?.measured(ms, pixels);
    });
  }

  /** Draws nothing more until the adapter has done what it was given; `onDone` is told the milliseconds. */
  private wait(onDone: (ms: number) => void): void {
    const [begin, { device }] = [performance.now(), this];
    this.pending++;
    void device.gpu.queue.onSubmittedWorkDone().then(() => {
      if (device !== this.device) return; // it was lost
      this.pending--;
      onDone(performance.now() - begin);
    });
  }

  private report(isComplete: boolean): FrameReport {
    const { width, height } = this.passes.source();
    const { missing, device, passes } = this;
    const isPreview = this.plan?.isPreview ?? true;
    const left = this.areas.reduce((sum, area) => sum + pixelsOf(area), 0);
    const refined = isPreview || !this.isFull ? 0 : passes.count > 0 ? 1 : 1 - left / (width * height);
    return { passes: passes.hasPicture ? Math.max(passes.count, 1) : 0, width, height, refined, isComplete, isPreview, compiled: device.share, missing };
  }

  private begin(plan: ReadyPlan, width: number, height: number, isAveraged: boolean): void {
    this.passes.begin(this.keyOf(plan), this.view, this.require(), width, height, isAveraged);
  }

  private addPass(plan: ReadyPlan): void {
    this.passes.add(this.view, this.require(), plan, plan.isPreview ? 1 : this.samples);
    this.done.passes++;
  }

  private keyOf(plan: ReadyPlan): string {
    return keyOfView(this.view, [plan, this.model, this.samples, this.mostPasses]);
  }

  private show(): void {
    if (this.presenter === null || !this.passes.hasPicture) return;
    const now = performance.now();
    const isPart = this.areas.length > 0;
    if (isPart && now - this.shownAt < Math.max(SHOWS_EVERY, SHOWS_REST * this.showMs)) return;
    this.shownAt = now;
    const left = this.passes.source();
    const other = this.other?.renderer.passes;
    const right = other === undefined ? left : other.hasPicture ? other.source() : null;
    if (right === null) return;
    const hasShown = this.presenter.show(left, right, other === undefined ? 1 : this.other!.split);
    // What the next area takes is not to be taken for it.
    if (hasShown && isPart) this.wait((ms) => (this.showMs = ms));
  }

  /** @throws InputError no cloth was given yet. */
  private require(): ClothBuffers {
    if (this.cloth === null) throw new InputError("A renderer needs at least one piece of cloth.");
    return this.cloth;
  }

  /** Goes back from tables that Python packed to `lobes`. */
  private leaveTables(): void {
    if (this.cloth === null || this.cloth.servedContent === null) return;
    this.cloth.leaveTables();
    this.model = "lobes";
    this.passes.forget();
  }

  /** Adds what buffers of fabrics counted, which are about to be replaced, to the counts. */
  private keepCounts(): void {
    const { bakeKernels, bakes, openings, writes, writtenBytes } = this.statistics;
    Object.assign(this.done, { bakeKernels, bakes, openings, writes, writtenBytes });
  }
}

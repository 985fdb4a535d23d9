/** The cloth on WebGPU: lit, draped, from the whole piece to a single yarn; two fabrics or models side by side. */
import { InputError } from "loomlight-fabric";
import { ClothRenderer, type FrameReport, type Openness, type Orbit, type Vector3 } from "loomlight-web";

import { tableStore } from "../keeping/table_store.ts";
import { woven, type Fabric, type Model, type Scene } from "../state/document.ts";
import type { ClothView, PictureRequest, Pixels, Print, Shown, ViewStatistics } from "./cloth_view.ts";
import type { ClothShape } from "./meshes.ts";
import { withOpacity } from "./opacity.ts";
import { OrbitControl } from "./orbit_control.ts";
import { paperRadiance, watchPaper } from "./paper.ts";
import { StagePictures, type PictureSource, type Stage } from "./stage_pictures.ts";
import { isServed, ServedModels, type ServedModel, type TableSource } from "./served_models.ts";
import { groundOf, lampOf, surroundingsOf } from "./surroundings.ts";

const NOTHING: Vector3 = [0, 0, 0];
const MAX_DEVICE_PIXELS = 2;
/** Passes of a picture for a file; fewer where a processor computes. */
const PICTURE_PASSES = 64;
const SOFTWARE_PASSES = 4;
/** A picture whose pass takes so many milliseconds is one that is waited for. */
const SLOW_MS = 2000;
/** One whose pass takes so many is left to the server, where there is one. */
const LEFT_MS = 10_000;

/** The renderer's model, points a pass, and passes that add up, for each of the page's models. */
const MODELS: Readonly<Record<Exclude<Model, ServedModel>, readonly ["lobes" | "point", number, number]>> = {
  lobes: ["lobes", 1, 256],
  "point-1": ["point", 1, 1],
  "point-3": ["point", 3, 1],
  "point-256": ["point", 8, 32],
};

/** What one renderer has been given, so that only what changed is given again. */
interface Given {
  shape: ClothShape | null;
  fabric: Fabric | null;
  openness: Openness | null | undefined;
  print: Print | null;
  model: Model | null;
  /** Of a model that Python bakes, which is shown. */
  tables: Uint8Array | null;
}

export class WebGpuView implements ClothView {
  readonly kind = "webgpu";
  readonly lost: Promise<string>;
  private readonly canvas: HTMLCanvasElement;
  private readonly renderer: ClothRenderer;
  private readonly control: OrbitControl;
  private readonly resizing: ResizeObserver;
  private readonly unwatchPaper: () => void;
  private readonly served: ServedModels;
  /** Pictures of the server for slow adapters; null where there is no server. */
  private readonly pictures: StagePictures | null;
  private readonly given = new Map<ClothRenderer, Given>();
  private other: ClothRenderer | null = null;
  private isMakingOther = false;
  /** A picture for a file is made: the screen waits. */
  private isDrawing = false;
  private shown: Shown | null = null;
  private lit: readonly [Scene, Shown["surroundings"], Shown["piece"]] | null = null;
  /** Rises with each change of what is shown. */
  private changes = 0;
  private frames = 0;
  private isComplete = false;
  private report: FrameReport | null = null;
  private readonly told = new Set<string>();
  /** The cloth without light, until there is a first picture by WebGPU. */
  private flat: ClothView | null;
  private readonly onFault: (sentence: string) => void;

  private constructor(
    host: HTMLElement,
    canvas: HTMLCanvasElement,
    renderer: ClothRenderer,
    flat: ClothView,
    tables: TableSource,
    pictures: PictureSource | null,
    onFault: (sentence: string) => void,
  ) {
    [this.canvas, this.renderer, this.flat, this.onFault] = [canvas, renderer, flat, onFault];
    this.lost = renderer.lost;
    this.served = new ServedModels(tables, () => this.shown && this.show(this.shown), onFault);
    this.pictures = pictures === null ? null : new StagePictures(host, pictures, onFault);
    this.control = new OrbitControl(canvas);
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(host);
    this.unwatchPaper = watchPaper(() => {
      this.lit = null;
      this.changes++;
      if (this.shown !== null) this.show(this.shown);
    });
    this.resize();
  }

  /**
   * A view that fills `host`; `flat` is seen there until there is light, and is then disposed of.
   *
   * @throws InputError no graphics adapter, or one whose limits are too small.
   */
  static async create(
    host: HTMLElement,
    flat: ClothView,
    tables: TableSource,
    pictures: PictureSource | null,
    onFault: (sentence: string) => void,
  ): Promise<WebGpuView> {
    const canvas = document.createElement("canvas");
    canvas.className = "cloth-canvas";
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "The cloth");
    canvas.dataset["testid"] = "cloth";
    const renderer = await ClothRenderer.create({ canvas, transparent: true, tables: tableStore });
    host.append(canvas);
    return new WebGpuView(host, canvas, renderer, flat, tables, pictures, onFault);
  }

  show(shown: Shown): void {
    const isNewShape = shown.piece !== null && shown.piece !== this.shown?.piece;
    if (this.shown === null || isOther(shown, this.shown)) this.changes++;
    this.shown = shown;
    this.isComplete = false;
    this.flat?.show(shown);
    const { ends, picks } = woven(shown.fabric);
    this.canvas.setAttribute("aria-label", `The cloth: ${ends} ends and ${picks} picks a repeat`);
    if (shown.piece === null) return;
    if (isNewShape) this.control.frame(shown.piece);
    const { comparison, fabric } = shown;
    if (comparison.mode === "off" || (comparison.mode === "fabrics" && comparison.before === null)) {
      this.dress(this.renderer, shown.piece, fabric, "lobes");
      this.renderer.wipe(null);
    } else {
      const isModels = comparison.mode === "models";
      this.dress(this.renderer, shown.piece, isModels ? fabric : comparison.before!, isModels ? comparison.left : "lobes");
      if (this.other === null) void this.makeOther();
      else {
        this.dress(this.other, shown.piece, fabric, isModels ? comparison.right : "lobes");
        this.renderer.wipe(this.other, comparison.position);
      }
    }
    this.light(shown);
  }

  resize(): void {
    const ratio = Math.min(devicePixelRatio, MAX_DEVICE_PIXELS);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (width === this.canvas.width && height === this.canvas.height) return;
    this.renderer.resize(width, height);
    this.other?.resize(width, height);
    this.control.resized();
  }

  frame(): void {
    this.flat?.frame();
    if (this.shown === null || this.shown.piece === null || this.isDrawing) return;
    this.renderer.setCamera(this.control.camera);
    this.followPictures();
    const report = this.renderer.frame();
    this.isComplete = report.isComplete || this.pictures?.state === "shown";
    this.report = report;
    this.frames++;
    for (const sentence of report.missing.filter((text) => !this.told.has(text))) {
      this.told.add(sentence);
      this.onFault(sentence);
    }
    if (report.passes === 0) return;
    this.flat?.dispose();
    this.flat = null;
  }

  /** Leaves the picture at rest to the server where this adapter takes long for it. */
  private followPictures(): void {
    const { pictures, renderer, shown, canvas } = this;
    if (pictures === null) return;
    const isSlow = renderer.adapter.isSoftware || renderer.passMs > LEFT_MS;
    const isAlone = shown!.comparison.mode === "off" && shown!.print === null;
    const camera = this.control.camera;
    const key = JSON.stringify([this.changes, camera, canvas.width, canvas.height, isSlow && isAlone]);
    pictures.follow(key, () => (isSlow && isAlone ? this.stage() : null));
    renderer.holdRefining(isSlow && isAlone && pictures.isLeft);
  }

  private stage(): Stage {
    const { fabric, scene, surroundings, piece } = this.shown!;
    return {
      fabric,
      piece: piece!,
      camera: this.control.camera,
      size: [this.canvas.width, this.canvas.height],
      lamp: lampOf(scene),
      environment: surroundingsOf(scene, surroundings),
      background: paperRadiance(),
      ground: groundOf(scene, piece!),
      exposure: scene.exposure,
    };
  }

  get zoom(): number {
    return this.control.zoom;
  }

  set zoom(zoom: number) {
    this.control.zoom = zoom;
  }

  get orbit(): Orbit {
    return this.control.place;
  }

  frameWhole(): void {
    if (this.shown?.piece) this.control.frame(this.shown.piece);
  }

  async readPixels(): Promise<Pixels> {
    const rendered = this.pictures?.pixels ?? null;
    if (rendered !== null) return rendered;
    const left = await this.renderer.readPixels();
    if (this.other === null || this.shown === null || this.shown.comparison.mode === "off") return left;
    const right = await this.other.readPixels();
    return right.width === left.width && right.height === left.height ? joined(left, right, this.shown.comparison.position) : left;
  }

  async picture({ width, height, isTransparent, onProgress }: PictureRequest): Promise<Pixels> {
    const { shown, other } = this;
    if (shown === null || shown.piece === null) throw new InputError("There is no picture yet: the cloth is being made.");
    const renderers = other === null || shown.comparison.mode === "off" ? [this.renderer] : [this.renderer, other];
    const passes = this.renderer.adapter.isSoftware ? SOFTWARE_PASSES : PICTURE_PASSES;
    this.isDrawing = true;
    try {
      const sides: Pixels[] = [];
      for (const [number, renderer] of renderers.entries()) {
        renderer.setCamera(this.control.camera);
        const picture = await renderer.picture({
          ...{ width, height, passes, background: isTransparent ? NOTHING : paperRadiance() },
          onPass: (share) => onProgress((number + share) / renderers.length),
        });
        sides.push(isTransparent ? withOpacity(picture, shown.scene.exposure) : { width, height, data: picture.pixels });
      }
      return sides[1] === undefined ? sides[0]! : joined(sides[0]!, sides[1], shown.comparison.position);
    } finally {
      this.isDrawing = false;
    }
  }

  statistics(): ViewStatistics {
    const { renderer, frames, isComplete } = this;
    const { isPreview, compiled } = this.report ?? { isPreview: true, compiled: 0 };
    const preparing = isPreview ? `Preparing the light: ${Math.floor(100 * compiled)} %` : null;
    const { width, height, refined } = this.report ?? { width: 0, height: 0, refined: 0 };
    const rendered = this.pictures?.state ?? null;
    const refining = rendered !== null || isPreview || refined === 1 || renderer.passMs < SLOW_MS ? null : refined;
    return { ...renderer.statistics, adapter: renderer.adapter.name, kind: "webgpu", frames, isComplete, preparing, refining, rendered, width, height };
  }

  dispose(): void {
    this.pictures?.dispose();
    this.unwatchPaper();
    this.resizing.disconnect();
    this.flat?.dispose();
    this.other?.destroy();
    this.renderer.destroy();
    this.canvas.remove();
  }

  private async makeOther(): Promise<void> {
    if (this.isMakingOther) return;
    this.isMakingOther = true;
    const { width, height } = this.canvas;
    this.other = await ClothRenderer.create({ shareWith: this.renderer, size: [width, height], tables: tableStore });
    this.isMakingOther = false;
    this.lit = null;
    if (this.shown !== null) this.show(this.shown);
  }

  /** Gives a renderer its piece, fabric and model, as far as they are new. */
  private dress(renderer: ClothRenderer, shape: ClothShape, fabric: Fabric, model: Model): void {
    const empty: Given = { shape: null, fabric: null, openness: null, print: null, model: null, tables: null };
    const given = this.given.get(renderer) ?? empty;
    const { fields, draft } = fabric;
    const openness = this.shown?.opennessOf(fabric);
    const print = this.shown?.print ?? null;
    if (given.shape !== shape || given.print !== print)
      renderer.setPieces(
        [{ mesh: shape.mesh, uvSizeMm: shape.uvSizeMm, fields, draft, ...(openness === undefined ? {} : { openness }), albedo: print?.picture ?? null }],
        shape.casters,
      );
    else if (given.fabric !== fabric || given.openness !== openness) renderer.setFabric(0, fields, draft, openness);
    const [own, samples, passes] = MODELS[isServed(model) ? "lobes" : model];
    const name = isServed(model) ? model : own;
    // The server says with the openness of yarns how many layers the cloth has.
    const isLayered = (openness?.planes?.[0] ?? 1) > 1;
    const tables = isServed(model) || isLayered ? this.served.tables(name, fabric) : null;
    const isShown = given.shape === shape && given.print === print && given.model === model && given.tables === tables;
    // Until its tables are here, a model of Python's gives way to the page's own, and layers to one plane.
    if (tables !== null) {
      if (!isShown) renderer.setTables(name, tables, isServed(model) ? {} : { samples, passes });
    } else {
      renderer.setModel(own, { samples, passes });
    }
    this.given.set(renderer, { shape, fabric, openness, print, model, tables });
  }

  private light({ scene, surroundings, piece }: Shown): void {
    if (this.lit !== null && this.lit[0] === scene && this.lit[1] === surroundings && this.lit[2] === piece) return;
    this.lit = [scene, surroundings, piece];
    const lamp = lampOf(scene);
    const environment = surroundingsOf(scene, surroundings);
    const ground = piece === null ? null : groundOf(scene, piece);
    for (const renderer of [this.renderer, this.other]) {
      if (renderer === null) continue;
      renderer.setLights(lamp === null ? [] : [lamp]);
      renderer.setEnvironment(environment);
      renderer.setBackground(paperRadiance());
      renderer.setGround(ground);
      renderer.setExposure(scene.exposure);
    }
  }
}

/** Whether two are of different pictures; what is found of yarns' openness meanwhile is Python's own. */
function isOther(one: Shown, other: Shown): boolean {
  const keys = ["fabric", "scene", "comparison", "piece", "surroundings", "print"] as const;
  return keys.some((key) => one[key] !== other[key]);
}

/** The left one's pixels up to a share of its width, then the right one's. */
function joined(left: Pixels, right: Pixels, position: number): Pixels {
  const split = Math.round(position * left.width);
  for (let row = 0; row < left.height; row++) {
    const [begin, end] = [(row * left.width + split) * 4, (row + 1) * left.width * 4];
    left.data.set(right.data.subarray(begin, end), begin);
  }
  return left;
}

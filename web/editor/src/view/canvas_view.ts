/** The flat view: yarns and colours of the draft on a 2D canvas, without light models. */
import { clamp, familySpacing, familyWidth } from "loomlight-fabric";

import { woven, type Fabric } from "../state/document.ts";
import { clothPicture } from "./cloth_picture.ts";
import type { ClothView, PictureRequest, Pixels, Shown, ViewStatistics } from "./cloth_view.ts";
import { paperHex } from "./paper.ts";

/** Pixels of the picture of one repeat along its longer side, about. */
const PICTURE_SIDE = 1200;
/** Of more crossings than that each is one pixel. */
const DETAILED = 2 ** 20;
/** CSS pixels of an arrow key. */
const KEY_STEP = 24;
/** Side of a print, as on the swatch of the lit view. */
const PRINT_MM = 100;
/** Screen pixels a thread: of the farthest and the closest view. */
const FARTHEST = 1.5;
const CLOSEST = 90;
/** At first a thread has so many pixels, in wide repeats fewer: those are seen as figures. */
const FIRST = 12;
const FIGURE_WIDTH = 960;

export class CanvasView implements ClothView {
  readonly kind = "canvas";
  readonly lost = new Promise<string>(() => undefined);
  private readonly canvas = document.createElement("canvas");
  private readonly pictures = new WeakMap<Fabric, HTMLCanvasElement[]>();
  private readonly resizing: ResizeObserver;
  private shown: Shown | null = null;
  private isStale = true;
  private readonly pointers = new Map<number, { x: number; y: number }>();
  private frames = 0;
  private frameMs = 0;
  /** Screen pixels a thread, in CSS pixels, and where the pattern begins. */
  private scale = FIRST;
  private offset = { x: 0, y: 0 };

  constructor(host: HTMLElement) {
    this.canvas.className = "cloth-canvas";
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The cloth");
    this.canvas.dataset["testid"] = "cloth";
    host.append(this.canvas);
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(host);
    this.listen();
    this.resize();
  }

  show(shown: Shown): void {
    const before = this.shown === null ? 0 : woven(this.shown.fabric).ends;
    this.shown = shown;
    if (firstScale(before) !== firstScale(woven(shown.fabric).ends)) this.frameWhole();
    this.canvas.setAttribute("aria-label", `The cloth, flat: ${woven(shown.fabric).ends} ends and ${woven(shown.fabric).picks} picks a repeat`);
    this.isStale = true;
  }

  resize(): void {
    const ratio = Math.min(devicePixelRatio, 2);
    const { clientWidth, clientHeight } = this.canvas;
    this.canvas.width = Math.max(1, Math.round(clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(clientHeight * ratio));
    this.isStale = true;
  }

  get zoom(): number {
    return Math.log(this.scale / this.farthest) / Math.log(CLOSEST / this.farthest);
  }

  set zoom(zoom: number) {
    this.zoomTo(this.farthest * (CLOSEST / this.farthest) ** zoom, this.canvas.clientWidth / 2, this.canvas.clientHeight / 2);
  }

  /** So far off that the repeat is seen whole. */
  private get farthest(): number {
    return this.shown === null ? FARTHEST : Math.min(FARTHEST, firstScale(woven(this.shown.fabric).ends));
  }

  readonly orbit = null;

  frameWhole(): void {
    this.scale = firstScale(this.shown === null ? 0 : woven(this.shown.fabric).ends);
    this.offset = { x: 0, y: 0 };
    this.isStale = true;
  }

  frame(): void {
    if (!this.isStale || this.shown === null) return;
    const began = performance.now();
    this.isStale = false;
    this.paint(this.canvas, this.canvas.width / Math.max(1, this.canvas.clientWidth), this.shown);
    this.frames++;
    this.frameMs = performance.now() - began;
  }

  readPixels(): Promise<Pixels> {
    this.frame();
    return Promise.resolve(pixelsOf(this.canvas, null));
  }

  picture({ width, height, isTransparent, onProgress }: PictureRequest): Promise<Pixels> {
    const canvas = canvasOf(width, height);
    const side = Math.min(this.canvas.clientWidth, this.canvas.clientHeight);
    if (this.shown !== null) this.paint(canvas, Math.min(width, height) / Math.max(1, side), this.shown);
    onProgress(1);
    return Promise.resolve(pixelsOf(canvas, isTransparent ? null : paperHex()));
  }

  statistics(): ViewStatistics {
    return { kind: "canvas", frameMs: this.frameMs, frames: this.frames, isComplete: !this.isStale, preparing: null, refining: null, rendered: null };
  }

  dispose(): void {
    this.resizing.disconnect();
    this.canvas.remove();
  }

  /** Draws the swatch; `ratio` are pixels of the canvas a pixel of the screen. */
  private paint(canvas: HTMLCanvasElement, ratio: number, shown: Shown): void {
    const context = canvas.getContext("2d")!;
    const { width, height } = canvas;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    const { fabric, comparison } = shown;
    const before = comparison.mode === "fabrics" ? comparison.before : null;
    const margin = Math.round(Math.min(width, height) * 0.07);
    const swatch = { x: margin, y: margin, width: width - 2 * margin, height: height - 2.4 * margin };
    context.save();
    context.shadowColor = "rgb(60 45 20 / 35%)";
    context.shadowBlur = margin * 0.5;
    context.shadowOffsetY = margin * 0.16;
    context.fillStyle = "#777";
    context.fillRect(swatch.x, swatch.y, swatch.width, swatch.height);
    context.restore();
    const split = before === null ? 0 : clamp(width * comparison.position, swatch.x, swatch.x + swatch.width);
    if (before !== null) this.fill(context, ratio, before, swatch.x, swatch.y, split - swatch.x, swatch.height);
    const left = Math.max(swatch.x, split);
    this.fill(context, ratio, fabric, left, swatch.y, swatch.x + swatch.width - left, swatch.height);
  }

  private fill(
    context: CanvasRenderingContext2D,
    ratio: number,
    fabric: Fabric,
    x: number,
    y: number,
    width: number,
    height: number,
  ): void {
    if (width <= 0) return;
    const draft = woven(fabric);
    const levels = this.picturesOf(fabric);
    const wanted = this.scale * ratio * draft.ends;
    const level = levels.findLast((picture) => picture.width >= wanted) ?? levels[0]!;
    const pattern = context.createPattern(level, "repeat")!;
    const across = wanted / level.width;
    const { warp, weft } = meanSpacings(fabric);
    const along = (across * (weft / warp) * draft.picks * level.width) / (draft.ends * level.height);
    // Pick 1 lies at the bottom of the swatch.
    const { width: columns, height: rows } = context.canvas;
    const bottom = rows - Math.round(Math.min(columns, rows) * 0.07) * 1.4;
    pattern.setTransform(new DOMMatrix([across, 0, 0, along, this.offset.x * ratio, bottom + this.offset.y * ratio]));
    context.imageSmoothingQuality = "high";
    context.fillStyle = pattern;
    context.fillRect(x, y, width, height);
    const print = this.shown?.print?.canvas;
    if (print === undefined) return;
    // Encoded values of a power law multiply as linear ones do.
    const printed = context.createPattern(print, "repeat")!;
    const side = (PRINT_MM * this.scale * ratio) / warp;
    const [u, v] = [side / print.width, side / print.height];
    printed.setTransform(new DOMMatrix([u, 0, 0, v, this.offset.x * ratio, bottom + this.offset.y * ratio]));
    context.globalCompositeOperation = "multiply";
    context.fillStyle = printed;
    context.fillRect(x, y, width, height);
    context.globalCompositeOperation = "source-over";
  }

  /** The picture of one repeat and its halves, finest first. */
  private picturesOf(fabric: Fabric): HTMLCanvasElement[] {
    let levels = this.pictures.get(fabric);
    if (levels === undefined) {
      const draft = woven(fabric);
      const isDetailed = draft.ends * draft.picks <= DETAILED;
      const pixels = isDetailed ? clamp(Math.floor(PICTURE_SIDE / Math.max(draft.ends, draft.picks)), 2, 40) : 1;
      const { width, height, rgba } = clothPicture(draft, { pixels, gap: gapsOf(fabric) });
      const finest = canvasOf(width, height);
      finest.getContext("2d")!.putImageData(new ImageData(rgba, width, height), 0, 0);
      levels = [finest];
      for (let last = finest; Math.min(last.width, last.height) >= 8; ) {
        const half = canvasOf(Math.ceil(last.width / 2), Math.ceil(last.height / 2));
        half.getContext("2d")!.drawImage(last, 0, 0, half.width, half.height);
        levels.push(half);
        last = half;
      }
      this.pictures.set(fabric, levels);
    }
    return levels;
  }

  private zoomTo(scale: number, x: number, y: number): void {
    const bounded = clamp(scale, this.farthest, CLOSEST);
    const ratio = bounded / this.scale;
    const bottom = this.canvas.clientHeight - Math.min(this.canvas.clientWidth, this.canvas.clientHeight) * 0.098;
    this.offset = { x: x - (x - this.offset.x) * ratio, y: y - bottom - (y - bottom - this.offset.y) * ratio };
    this.scale = bounded;
    this.isStale = true;
  }

  private listen(): void {
    this.canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoomTo(this.scale * 1.0015 ** -event.deltaY, event.offsetX, event.offsetY);
      },
      { passive: false },
    );
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    });
    for (const end of ["pointerup", "pointercancel"] as const)
      this.canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    this.canvas.addEventListener("pointermove", (event) => this.drag(event));
    this.canvas.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (step !== undefined) this.move(step[0]! * KEY_STEP, step[1]! * KEY_STEP);
      else if (event.key === "+" || event.key === "=") this.zoom = Math.min(this.zoom + 0.05, 1);
      else if (event.key === "-") this.zoom = Math.max(this.zoom - 0.05, 0);
      else if (event.key === "0") this.frameWhole();
      else return;
      event.preventDefault();
    });
  }

  /** One pointer moves the cloth; two also bring it closer. */
  private drag(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    if (before === undefined) return;
    const now = { x: event.offsetX, y: event.offsetY };
    this.pointers.set(event.pointerId, now);
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    if (other === undefined) return this.move(now.x - before.x, now.y - before.y);
    const apart = (point: { x: number; y: number }): number => Math.max(Math.hypot(point.x - other.x, point.y - other.y), 1);
    this.move((now.x - before.x) / 2, (now.y - before.y) / 2);
    this.zoomTo((this.scale * apart(now)) / apart(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
  }

  private move(right: number, down: number): void {
    this.offset = { x: this.offset.x + right, y: this.offset.y + down };
    this.isStale = true;
  }
}

function firstScale(ends: number): number {
  return Math.min(FIRST, FIGURE_WIDTH / Math.max(ends, 1));
}

function canvasOf(width: number, height: number): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  return canvas;
}

/** What a canvas holds, on a ground or none. */
function pixelsOf(canvas: HTMLCanvasElement, ground: string | null): Pixels {
  const { width, height } = canvas;
  const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
  if (ground !== null) {
    copy.fillStyle = ground;
    copy.fillRect(0, 0, width, height);
  }
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, width, height);
  return { width, height, data };
}

function meanSpacings(fabric: Fabric): { warp: number; weft: number } {
  const draft = woven(fabric);
  const mean = (values: Float64Array): number => values.reduce((sum, value) => sum + value, 0) / values.length;
  return {
    warp: mean(familySpacing(fabric.fields, "warp", draft)),
    weft: mean(familySpacing(fabric.fields, "weft", draft)),
  };
}

function gapsOf(fabric: Fabric): { warp: number; weft: number } {
  const draft = woven(fabric);
  const gap = (family: "warp" | "weft"): number => {
    const spacing = familySpacing(fabric.fields, family, draft);
    const width = familyWidth(fabric.fields, family, draft, spacing);
    return clamp(1 - width[0]! / spacing[0]!, 0.02, 0.95);
  };
  return { warp: gap("warp"), weft: gap("weft") };
}

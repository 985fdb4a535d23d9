/** What shows the cloth: by WebGPU, or where that is missing as a flat picture of its yarns. */
import type { LinearPicture, Openness, Orbit } from "loomlight-web";

import type { Comparison, Fabric, Scene } from "../state/document.ts";
import type { ClothShape } from "./meshes.ts";
import type { TableSource } from "./served_models.ts";
import type { PictureSource } from "./stage_pictures.ts";

/** What a view shows. */
export interface Shown {
  readonly fabric: Fabric;
  readonly scene: Scene;
  readonly comparison: Comparison;
  /** The piece of cloth; null while it loads. */
  readonly piece: ClothShape | null;
  /** The user's own surroundings, if the scene asks for them. */
  readonly surroundings: SurroundingsPicture | null;
  /** How open the yarns of a fabric are, for light between them, as far as it is known. */
  readonly opennessOf: (fabric: Fabric) => Openness | null | undefined;
  /** What is printed on the cloth. */
  readonly print: Print | null;
}

/** A picture on the cloth: albedos are multiplied by it, over the unit of uv, which repeats. */
export interface Print {
  readonly name: string;
  readonly canvas: HTMLCanvasElement;
  readonly picture: LinearPicture;
}

/** An equirectangular picture: linear RGB [height·width·3], the top row first. */
export interface SurroundingsPicture {
  readonly width: number;
  readonly height: number;
  readonly pixels: Float32Array;
}

/** Pixels of what is shown: sRGB, 0 to 255 [height·width·4], the top row first. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray<ArrayBuffer>;
}

/** A picture of what is shown, of another size. */
export interface PictureRequest {
  readonly width: number;
  readonly height: number;
  /** Whether what is beside the cloth, and behind its holes, is nothing in place of the paper. */
  readonly isTransparent: boolean;
  /** Is told the share that is done. */
  readonly onProgress: (share: number) => void;
}

export interface ViewStatistics {
  readonly kind: "webgpu" | "canvas";
  /** Milliseconds of the last frame. */
  readonly frameMs: number;
  /** Frames that were drawn. */
  readonly frames: number;
  /** Whether the picture is as fine as it gets. */
  readonly isComplete: boolean;
  /** What the cloth waits for, in words; null once it is shown as it was asked for. */
  readonly preparing: string | null;
  /** Share of the canvas that is as fine as it gets, 0 to 1, where that takes a while; else null. */
  readonly refining: number | null;
  /** Whether a picture by the server is on its way, or shown in place of the page's own. */
  readonly rendered: "asked" | "shown" | null;
  readonly [name: string]: unknown;
}

export interface ClothView {
  readonly kind: "webgpu" | "canvas";
  /** Takes over what changed; drawn by the next `frame`. */
  show(shown: Shown): void;
  /** The element's size changed. */
  resize(): void;
  /** Draws if there is anything new to draw. */
  frame(): void;
  /** 0 is across the room, 1 a single yarn. */
  zoom: number;
  /** The camera as it began. */
  frameWhole(): void;
  /** Where the camera stands; null where cloth is shown flat. */
  readonly orbit: Orbit | null;
  readPixels(): Promise<Pixels>;
  /**
   * A picture from the present camera, with as many passes as a still one.
   *
   * @throws InputError a size that the adapter has no room for.
   */
  picture(request: PictureRequest): Promise<Pixels>;
  statistics(): ViewStatistics;
  /** Resolves with a sentence once the view can draw no more. */
  readonly lost: Promise<string>;
  dispose(): void;
}

/** A view in an element, and why it is no WebGPU if it is none. */
export interface Made {
  readonly view: ClothView;
  readonly reason: string | null;
}

/** Makes the best view that the browser has; `onFault` is told why tables or pictures do not come. */
export async function makeView(
  host: HTMLElement,
  tables: TableSource,
  pictures: PictureSource | null,
  onFault: (sentence: string) => void,
): Promise<Made> {
  const { CanvasView } = await import("./canvas_view.ts");
  if (!("gpu" in navigator))
    return {
      view: new CanvasView(host),
      reason: "This browser has no WebGPU.",
    };
  const flat = new CanvasView(host);
  try {
    const { WebGpuView } = await import("./webgpu_view.ts");
    return { view: await WebGpuView.create(host, flat, tables, pictures, onFault), reason: null };
  } catch (error) {
    return {
      view: flat,
      reason: `WebGPU does not start here. ${reasonOf(error)}`,
    };
  }
}

function reasonOf(error: unknown): string {
  return error instanceof Error ? (error.message.split("\n")[0] ?? "") : "";
}

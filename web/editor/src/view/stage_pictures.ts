/**
 * Pictures of the stage by Python, where the page's own adapter takes minutes for one: asked for once the stage stands still,
 * laid over it when they come, and gone with the next change.
 */
import { messageOf } from "loomlight-fabric";
import type { Camera, DirectionalLight, Environment, Ground, Vector3 } from "loomlight-web";

import type { Fabric } from "../state/document.ts";
import { fabricForServer } from "../state/fabric_json.ts";
import type { Pixels } from "./cloth_view.ts";
import type { ClothShape } from "./meshes.ts";

/** Asks the server for the picture of what a request describes. */
export type PictureSource = (request: Uint8Array<ArrayBuffer>, signal: AbortSignal) => Promise<Blob>;

/** What a picture is of. */
export interface Stage {
  readonly fabric: Fabric;
  readonly piece: ClothShape;
  readonly camera: Camera;
  readonly size: readonly [number, number];
  readonly lamp: DirectionalLight | null;
  readonly environment: Environment | null;
  readonly background: Vector3;
  readonly ground: Ground | null;
  /** Stops. */
  readonly exposure: number;
}

/** After a change the stage is asked for once it stood so many milliseconds. */
const CALM_MS = 500;

export class StagePictures {
  private readonly source: PictureSource;
  private readonly canvas: HTMLCanvasElement;
  private readonly context: CanvasRenderingContext2D;
  private readonly onFault: (sentence: string) => void;
  private key = "";
  private since = 0;
  private asking: AbortController | null = null;
  /** Pictures cannot be had: the page makes its own. */
  private hasFailed = false;
  private isShown = false;

  /** Shows pictures in `host`, over what is there. */
  constructor(host: HTMLElement, source: PictureSource, onFault: (sentence: string) => void) {
    [this.source, this.onFault] = [source, onFault];
    this.canvas = document.createElement("canvas");
    this.canvas.className = "stage-picture";
    this.canvas.hidden = true;
    // Pixels are read for files: unless that is said, Chromium warns of the second reading.
    this.context = this.canvas.getContext("2d", { willReadFrequently: true })!;
    host.append(this.canvas);
  }

  /** "asked" while a picture is on its way, "shown" once it is there. */
  get state(): "asked" | "shown" | null {
    return this.isShown ? "shown" : this.asking === null ? null : "asked";
  }

  /** Whether the page leaves the picture to Python. */
  get isLeft(): boolean {
    return !this.hasFailed;
  }

  /** The pixels of the picture, where one is shown. */
  get pixels(): Pixels | null {
    if (!this.isShown) return null;
    const { width, height } = this.canvas;
    return { width, height, data: this.context.getImageData(0, 0, width, height).data as Uint8ClampedArray<ArrayBuffer> };
  }

  /** Called with each frame: `key` is another one where the stage has changed; `stage` is null where none is to be asked for. */
  follow(key: string, stage: () => Stage | null, now = performance.now()): void {
    if (key !== this.key) {
      this.drop();
      [this.key, this.since] = [key, now];
      return;
    }
    if (this.hasFailed || this.isShown || this.asking !== null || now - this.since < CALM_MS) return;
    const asked = stage();
    if (asked !== null) void this.ask(asked);
  }

  dispose(): void {
    this.drop();
    this.canvas.remove();
  }

  private drop(): void {
    this.asking?.abort();
    [this.asking, this.isShown, this.canvas.hidden] = [null, false, true];
  }

  private async ask(stage: Stage): Promise<void> {
    const asking = (this.asking = new AbortController());
    try {
      const picture = await createImageBitmap(await this.source(requestOf(stage), asking.signal));
      if (asking !== this.asking) return;
      [this.canvas.width, this.canvas.height] = [picture.width, picture.height];
      this.context.drawImage(picture, 0, 0);
      [this.isShown, this.canvas.hidden] = [true, false];
    } catch (error) {
      if (asking !== this.asking) return;
      this.hasFailed = true;
      this.onFault(`Python renders no picture of the stage, so the page does. ${messageOf(error)}`);
    }
    if (asking === this.asking) this.asking = null;
  }
}

/** A stage as `viewer/picture.py:stage_of` reads it: a safetensors file. */
export function requestOf(stage: Stage): Uint8Array<ArrayBuffer> {
  const { fabric, piece, camera, lamp, environment, ground } = stage;
  const said = {
    fabric: fabricForServer(fabric),
    uvSizeMm: piece.uvSizeMm,
    size: stage.size,
    camera: { origin: camera.origin, target: camera.target },
    lamp: lamp === null ? null : { towards: lamp.towards, irradiance: lamp.irradiance },
    turn: environment?.turn ?? 0,
    background: stage.background,
    ground: ground ?? { normal: [0, 1, 0], offset: -1e9, lampShare: 0 },
    exposure: stage.exposure,
  };
  const { positions, normals, uv, triangles } = piece.mesh;
  const tensors: Record<string, readonly ["F32" | "U32", readonly number[], Float32Array | Uint32Array]> = {
    positions: ["F32", [positions.length / 3, 3], Float32Array.from(positions)],
    normals: ["F32", [normals.length / 3, 3], Float32Array.from(normals)],
    uv: ["F32", [uv.length / 2, 2], Float32Array.from(uv)],
    triangles: ["U32", [triangles.length / 3, 3], Uint32Array.from(triangles)],
  };
  if (environment !== null) {
    const { width, height, pixels } = environment.picture;
    tensors["environment"] = ["F32", [height, width, 3], Float32Array.from(pixels)];
  }
  return safetensors(tensors, { stage: JSON.stringify(said) });
}

function safetensors(
  tensors: Readonly<Record<string, readonly [string, readonly number[], Float32Array | Uint32Array]>>,
  metadata: Readonly<Record<string, string>>,
): Uint8Array<ArrayBuffer> {
  let end = 0;
  const entries = Object.entries(tensors).map(([name, [dtype, shape, values]]) => {
    const begin = end;
    end += values.byteLength;
    return [name, { dtype, shape, data_offsets: [begin, end] }] as const;
  });
  const head = new TextEncoder().encode(JSON.stringify({ __metadata__: metadata, ...Object.fromEntries(entries) }));
  const padded = Math.ceil(head.length / 8) * 8;
  const file = new Uint8Array(8 + padded + end).fill(0x20, 8, 8 + padded);
  new DataView(file.buffer).setUint32(0, padded, true);
  file.set(head, 8);
  let at = 8 + padded;
  for (const [, , values] of Object.values(tensors)) {
    file.set(new Uint8Array(values.buffer, values.byteOffset, values.byteLength), at);
    at += values.byteLength;
  }
  return file;
}

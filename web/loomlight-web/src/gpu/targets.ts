/** What a frame is drawn into, for pictures of at most one size. */
import { InputError } from "loomlight-fabric";

import type { Device } from "./device.ts";

const MAX_TARGET_SIDE = 8192;

export class Targets {
  readonly width: number;
  readonly height: number;
  readonly buffers: Record<string, GPUBuffer>;
  readonly faces: GPUTextureView;
  readonly depth: GPUTextureView;
  /** Of `faces`. */
  readonly faceTexture: GPUTexture;
  private readonly device: Device;
  private readonly textures: readonly GPUTexture[];

  constructor(device: Device, width: number, height: number) {
    this.device = device;
    this.width = width;
    this.height = height;
    const pixels = width * height;
    this.buffers = {
      radiance: device.buffer(16 * pixels),
      pixels: device.buffer(4 * pixels),
      layers: device.buffer(8 * pixels),
      visibilities: device.buffer(4 * pixels),
    };
    const texture = (format: GPUTextureFormat, usage: GPUTextureUsageFlags): GPUTexture =>
      device.gpu.createTexture({ size: [width, height], format, usage: usage | GPUTextureUsage.RENDER_ATTACHMENT });
    const { TEXTURE_BINDING, COPY_SRC, COPY_DST } = GPUTextureUsage;
    this.faceTexture = texture("r32uint", TEXTURE_BINDING | COPY_SRC | COPY_DST);
    this.textures = [this.faceTexture, texture("depth32float", 0)];
    this.faces = this.faceTexture.createView();
    this.depth = this.textures[1]!.createView();
  }

  /** Room for the visibility of so many lights from every pixel. */
  makeRoom(lights: number): void {
    const size = 4 * this.width * this.height * Math.max(lights, 1);
    const before = this.buffers["visibilities"]!;
    if (before.size >= size) return;
    before.destroy();
    this.buffers["visibilities"] = this.device.buffer(size);
  }

  destroy(): void {
    Object.values(this.buffers).forEach((buffer) => buffer.destroy());
    this.textures.forEach((texture) => texture.destroy());
  }
}

/** @throws InputError a size out of range, pixels. */
export function requireSize(width: number, height: number): void {
  const isSide = (side: number): boolean => Number.isInteger(side) && side >= 1 && side <= MAX_TARGET_SIDE;
  if (!isSide(width) || !isSide(height))
    throw new InputError(`size = ${width} × ${height} is out of range: 1 to ${MAX_TARGET_SIDE} pixels each way.`);
}

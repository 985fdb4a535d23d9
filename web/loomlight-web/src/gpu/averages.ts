/** Kernels that make means of sums, and blend areas into them. */
import type { Area } from "../areas.ts";
import averageText from "./average.wgsl?raw";
import type { Device } from "./device.ts";
import type { Targets } from "./targets.ts";

const UNIFORM_WORDS = 8;

export class Averages {
  /** Resolves when the kernels are compiled. */
  readonly compiled: Promise<void>;
  private readonly device: Device;
  private pipelines: readonly [GPUComputePipeline, GPUComputePipeline] | null = null;
  private readonly uniform: GPUBuffer;

  constructor(device: Device) {
    this.device = device;
    this.uniform = device.buffer(4 * UNIFORM_WORDS, GPUBufferUsage.UNIFORM);
    const module = device.gpu.createShaderModule({ code: averageText, label: "average" });
    const pipeline = (entryPoint: string): Promise<GPUComputePipeline> =>
      device.gpu.createComputePipelineAsync({ layout: "auto", compute: { module, entryPoint } });
    this.compiled = Promise.all([pipeline("blend"), pipeline("enlarge")]).then((pipelines) => {
      this.pipelines = pipelines;
    });
  }

  get isReady(): boolean {
    return this.pipelines !== null;
  }

  /** Takes pass number `passes` of an area, in the upper left of `tile`, into the means of `picture`. */
  blend(encoder: GPUCommandEncoder, area: Area, tile: Targets, picture: Targets, stride: number, passes: number): void {
    const { x, y, width, height } = area;
    this.device.write(this.uniform, Uint32Array.of(x, y, width, height, stride, passes, 0, 0));
    const buffers = [this.uniform, tile.buffers["radiance"]!, picture.buffers["radiance"]!];
    this.encode(encoder, this.pipelines![0], buffers, [Math.ceil(width / 8), Math.ceil(height / 8)]);
  }

  /** Makes means of the sums of so many passes, and a picture of another size. */
  enlarge(picture: Targets, from: readonly [number, number], passes: number, to: readonly [number, number]): void {
    const { gpu } = this.device;
    const [pixels, sums] = [from[0] * from[1] * 4, from[0] * from[1] * 16];
    const [fromPixels, fromSums] = [this.device.buffer(pixels), this.device.buffer(sums)];
    const encoder = gpu.createCommandEncoder();
    encoder.copyBufferToBuffer(picture.buffers["pixels"]!, 0, fromPixels, 0, pixels);
    encoder.copyBufferToBuffer(picture.buffers["radiance"]!, 0, fromSums, 0, sums);
    const words = Uint32Array.of(...from, 0, ...to, 0, 0, 0);
    new Float32Array(words.buffer)[2] = passes;
    this.device.write(this.uniform, words);
    const buffers = [this.uniform, fromPixels, fromSums, picture.buffers["pixels"]!, picture.buffers["radiance"]!];
    this.encode(encoder, this.pipelines![1], buffers, [Math.ceil(to[0] / 8), Math.ceil(to[1] / 8)]);
    gpu.queue.submit([encoder.finish()]);
    fromPixels.destroy();
    fromSums.destroy();
  }

  destroy(): void {
    this.uniform.destroy();
  }

  private encode(encoder: GPUCommandEncoder, pipeline: GPUComputePipeline, buffers: readonly GPUBuffer[], groups: readonly [number, number]): void {
    const { gpu } = this.device;
    const layout = pipeline.getBindGroupLayout(0);
    const entries = buffers.map((buffer, binding) => ({ binding, resource: { buffer } }));
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, gpu.createBindGroup({ layout, entries }));
    pass.dispatchWorkgroups(groups[0], groups[1]);
    pass.end();
  }
}

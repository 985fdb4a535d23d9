/** Shows pictures on a canvas. */
import type { Device } from "./device.ts";
import presentText from "./present.wgsl?raw";

/** A picture in buffers. */
export interface Source {
  readonly width: number;
  readonly height: number;
  readonly passes: number;
  /** Another one each time that the pixels or sums change. */
  readonly revision: number;
  /** sRGB, 8 bits a channel. */
  readonly pixels: GPUBuffer;
  /** Whether something is seen beside the cloth: then nothing behind the canvas is. */
  readonly hasBackground: boolean;
  /** Sums of linear radiance and of the share of cloth. */
  readonly sums: GPUBuffer;
}

const UNIFORM_WORDS = 12;

export class Presenter {
  private readonly device: Device;
  private readonly context: GPUCanvasContext;
  private readonly pipeline: GPURenderPipeline;
  private readonly uniform: GPUBuffer;
  private readonly isTransparent: boolean;
  /** What the canvas shows: it stays there until there is another. */
  private shown: readonly unknown[] = [];

  constructor(device: Device, canvas: HTMLCanvasElement | OffscreenCanvas, isTransparent: boolean) {
    const context = canvas.getContext("webgpu") as GPUCanvasContext | null;
    if (context === null) throw new Error("The canvas has a context of another kind than webgpu already.");
    this.device = device;
    this.context = context;
    this.isTransparent = isTransparent;
    const format = navigator.gpu.getPreferredCanvasFormat();
    context.configure({ device: device.gpu, format, alphaMode: isTransparent ? "premultiplied" : "opaque" });
    const module = device.gpu.createShaderModule({ code: presentText, label: "present" });
    this.pipeline = device.gpu.createRenderPipeline({
      layout: "auto",
      vertex: { module, entryPoint: "cover" },
      fragment: { module, entryPoint: "present", targets: [{ format }] },
    });
    this.uniform = device.buffer(4 * UNIFORM_WORDS, GPUBufferUsage.UNIFORM);
  }

  /** Shows `left`, and from `split` (0 to 1) on `right` in its place; false, where the canvas shows that already. */
  show(left: Source, right: Source, split: number): boolean {
    const { canvas } = this.context;
    const picture = [left.pixels, left.revision, right.pixels, right.revision, split, canvas.width, canvas.height];
    if (picture.every((part, number) => part === this.shown[number])) return false;
    this.shown = picture;
    const words = new Uint32Array(UNIFORM_WORDS);
    const floats = new Float32Array(words.buffer);
    [left, right].forEach((source, number) => {
      words.set([source.width, source.height, 0, source.hasBackground ? 1 : 0], 4 * number);
      floats[4 * number + 2] = Math.max(source.passes, 1);
    });
    floats.set([canvas.width, canvas.height, split], 8);
    words[11] = this.isTransparent ? 1 : 0;
    this.device.write(this.uniform, words);
    const { gpu } = this.device;
    const buffers = [this.uniform, left.pixels, left.sums, right.pixels, right.sums];
    // Where both are the same picture one buffer is bound twice, which read-only bindings may.
    const group = gpu.createBindGroup({
      layout: this.pipeline.getBindGroupLayout(0),
      entries: buffers.map((buffer, binding) => ({ binding, resource: { buffer } })),
    });
    const encoder = gpu.createCommandEncoder();
    const pass = encoder.beginRenderPass({
      colorAttachments: [{ view: this.context.getCurrentTexture().createView(), loadOp: "clear", storeOp: "store" }],
    });
    pass.setPipeline(this.pipeline);
    pass.setBindGroup(0, group);
    pass.draw(3);
    pass.end();
    gpu.queue.submit([encoder.finish()]);
    return true;
  }
}

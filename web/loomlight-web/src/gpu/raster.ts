/** The raster pass: the number of the nearest face at each pixel. */
import { bindingsOf } from "./bindings.ts";
import { bindEntries, type Device, type Resources } from "./device.ts";
import { shaderText } from "./shaders.ts";
import type { Targets } from "./targets.ts";

export class Raster {
  private readonly device: Device;
  private readonly bindings: Readonly<Record<string, number>>;
  private pipeline: GPURenderPipeline | null = null;

  /** Resolves when it is compiled. */
  readonly compiled: Promise<void>;

  constructor(device: Device) {
    this.device = device;
    const [vertex, fragment] = [shaderText("raster_vertex"), shaderText("raster_fragment")];
    this.bindings = bindingsOf(vertex);
    const module = (code: string): GPUShaderModule => device.gpu.createShaderModule({ code, label: "raster" });
    this.compiled = device.gpu
      .createRenderPipelineAsync({
        layout: "auto",
        vertex: { module: module(vertex), entryPoint: "raster_vertex" },
        primitive: { topology: "triangle-list", cullMode: "none" },
        // Depth is near / distance: larger is nearer.
        depthStencil: { format: "depth32float", depthWriteEnabled: true, depthCompare: "greater" },
        fragment: { module: module(fragment), entryPoint: "raster_fragment", targets: [{ format: "r32uint" }] },
      })
      .then((pipeline) => {
        this.pipeline = pipeline;
      });
  }

  get isReady(): boolean {
    return this.pipeline !== null;
  }

  /** Draws so many faces into the upper left of the targets, `width` by `height` pixels. */
  draw(targets: Targets, resources: Resources, faces: number, width: number, height: number): void {
    if (this.pipeline === null) return;
    const { gpu } = this.device;
    const encoder = gpu.createCommandEncoder();
    const pass = encoder.beginRenderPass({
      colorAttachments: [
        { view: targets.faces, loadOp: "clear", storeOp: "store", clearValue: { r: 0, g: 0, b: 0, a: 0 } },
      ],
      depthStencilAttachment: {
        view: targets.depth,
        depthLoadOp: "clear",
        depthStoreOp: "discard",
        depthClearValue: 0,
      },
    });
    pass.setPipeline(this.pipeline);
    pass.setViewport(0, 0, width, height, 0, 1);
    const layout = this.pipeline.getBindGroupLayout(0);
    pass.setBindGroup(0, gpu.createBindGroup({ layout, entries: bindEntries(this.bindings, resources) }));
    pass.draw(3 * faces);
    pass.end();
    gpu.queue.submit([encoder.finish()]);
  }
}

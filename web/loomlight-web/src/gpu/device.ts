/** The graphics adapter: a WebGPU device, its buffers, and pipelines that compile in the background. */
import { InputError } from "loomlight-fabric";

import { bindingsOf } from "./bindings.ts";
import { shaderText, type ShaderName } from "./shaders.ts";

export const NO_WEBGPU =
  "This browser has no WebGPU, which draws the cloth: use a current Chrome, Edge, Safari 26 or Firefox, on a page " +
  "that came by https or from this machine.";
export const NO_ADAPTER =
  "This browser has WebGPU but finds no graphics adapter for it: see that hardware acceleration is switched on.";
// Kernels that a software adapter compiles at a time.
const AT_A_TIME = 2;
// Of the sizes of tables: every adapter binds the eight storage buffers of the largest shader.
const RAISED_LIMITS = ["maxStorageBufferBindingSize", "maxBufferSize"] as const;

// The number of the constant of `planes.slang`.
const LAYERED = /@id\((\d+)\) override HAS_LAYERS_\d+ /;

/** Buffers and views by the names that shaders have for them. */
export type Resources = Readonly<Record<string, GPUBuffer | GPUBufferBinding | GPUTextureView>>;

/** A compute pipeline, and the bindings of what it uses. */
export interface Kernel {
  readonly pipeline: GPUComputePipeline;
  readonly bindings: Readonly<Record<string, number>>;
}

/** Where a device comes from. */
export interface DeviceOptions {
  /** What adapter to ask for. */
  readonly adapter?: GPURequestAdapterOptions;
}

/** A device, with the counts of what was sent to it. */
export class Device {
  readonly gpu: GPUDevice;
  /** The adapter's name, as far as the browser tells. */
  readonly name: string;
  /** Whether a CPU computes, as far as the browser tells. */
  readonly isSoftware: boolean;
  /** Resolves with a sentence when the device is lost, but not after `destroy`. */
  readonly lost: Promise<string>;
  /** Whether the cloth that is drawn next has layers: kernels are compiled with them, or faster without. */
  isLayered = false;
  private readonly kernels = new Map<string, Kernel>();
  private readonly compiling = new Map<string, Promise<void>>();
  /** Why kernels could not be compiled. */
  private readonly faults = new Map<string, Error>();
  /** What waits for its turn to compile: software adapters compile two at a time, in the order of asking. */
  private readonly waiting: (() => void)[] = [];
  private running = 0;
  private isDestroyed = false;

  private constructor(gpu: GPUDevice, info: GPUAdapterInfo) {
    this.gpu = gpu;
    this.name = [info.vendor, info.architecture, info.description].filter((part) => part !== "").join(" ") || "unnamed";
    this.isSoftware = info.isFallbackAdapter || /swiftshader|llvmpipe|lavapipe/i.test(this.name);
    this.lost = new Promise((resolve) => {
      void gpu.lost.then(({ message }) => {
        if (this.isDestroyed) return;
        const reason = message === "" ? "" : ` (${message.trim().replace(/\.$/, "")})`;
        resolve(`The graphics adapter ${this.name} was lost${reason}: the picture is begun again.`);
      });
    });
  }

  /**
   * A device of the browser's adapter.
   *
   * @throws InputError no WebGPU, or no adapter.
   */
  static async request(options: DeviceOptions = {}): Promise<Device> {
    const gpu = (globalThis.navigator as Navigator | undefined)?.gpu;
    if (gpu === undefined) throw new InputError(NO_WEBGPU);
    const adapter = await gpu.requestAdapter(options.adapter ?? { powerPreference: "high-performance" });
    if (adapter === null) throw new InputError(NO_ADAPTER);
    const requiredLimits = Object.fromEntries(RAISED_LIMITS.map((limit) => [limit, adapter.limits[limit]]));
    return new Device(await adapter.requestDevice({ requiredLimits }), adapter.info);
  }

  /** A buffer of at least so many bytes, all zero. */
  buffer(size: number, usage: GPUBufferUsageFlags = GPUBufferUsage.STORAGE): GPUBuffer {
    const most = Math.min(this.gpu.limits.maxStorageBufferBindingSize, this.gpu.limits.maxBufferSize);
    if (size > most)
      throw new InputError(
        `${this.name} takes at most ${most} bytes in a table, but ${size} are needed: choose a smaller draft, mesh or ` +
          "picture, or another adapter.",
      );
    return this.gpu.createBuffer({
      size: Math.max(16, Math.ceil(size / 16) * 16),
      usage: usage | GPUBufferUsage.COPY_DST | GPUBufferUsage.COPY_SRC,
    });
  }

  /** Overwrites a part of a buffer with words, from the word `at` on. */
  write(buffer: GPUBuffer, words: Uint32Array<ArrayBuffer>, at = 0): void {
    this.gpu.queue.writeBuffer(buffer, 4 * at, words);
  }

  /** The first bytes of a buffer; waits for the device. */
  async read(buffer: GPUBuffer, size: number): Promise<ArrayBuffer> {
    const copy = this.gpu.createBuffer({ size, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const encoder = this.gpu.createCommandEncoder();
    encoder.copyBufferToBuffer(buffer, 0, copy, 0, size);
    this.gpu.queue.submit([encoder.finish()]);
    await copy.mapAsync(GPUMapMode.READ);
    const bytes = copy.getMappedRange().slice(0);
    copy.destroy();
    return bytes;
  }

  /** The kernel of an entry point of a shader if it is compiled; else undefined, and compiling begins. */
  kernel(shader: ShaderName, entry: string, bindings?: Readonly<Record<string, number>>): Kernel | undefined {
    const key = this.keyOf(shader, entry);
    if (!this.compiling.has(key)) {
      const compiling = this.compile(key, shader, entry, bindings).catch((error: unknown) => {
        this.faults.set(key, error instanceof Error ? error : new Error(String(error)));
      });
      this.compiling.set(key, compiling);
    }
    return this.kernels.get(key);
  }

  /** Why the browser could not compile a kernel that was asked for, if so. */
  fault(shader: ShaderName, entry: string = shader): Error | undefined {
    return this.faults.get(this.keyOf(shader, entry));
  }

  /** Share of the kernels that were asked for which are compiled, or cannot be: 0 to 1. */
  get share(): number {
    return this.compiling.size === 0 ? 0 : (this.kernels.size + this.faults.size) / this.compiling.size;
  }

  /** Resolves when all kernels that were asked for are compiled, or one cannot be. */
  async compiled(): Promise<void> {
    await Promise.all(this.compiling.values());
  }

  /** The bind group that gives a kernel the buffers and views of the names it has for them. */
  bind(kernel: Kernel, resources: Resources): GPUBindGroup {
    return this.gpu.createBindGroup({
      layout: kernel.pipeline.getBindGroupLayout(0),
      entries: bindEntries(kernel.bindings, resources),
    });
  }

  /** Runs a compiled kernel over so many groups of threads, in a submission of its own. */
  dispatch(name: ShaderName, groups: readonly [number, number], resources: Resources): void {
    const encoder = this.gpu.createCommandEncoder();
    this.encode(encoder, name, groups, resources);
    this.gpu.queue.submit([encoder.finish()]);
  }

  /** Adds a run of a compiled kernel to a submission. */
  encode(encoder: GPUCommandEncoder, name: ShaderName, groups: readonly [number, number], resources: Resources): void {
    const kernel = this.kernel(name, name);
    if (kernel === undefined) throw new Error(`${name} is not compiled yet`);
    const pass = encoder.beginComputePass();
    pass.setPipeline(kernel.pipeline);
    pass.setBindGroup(0, this.bind(kernel, resources));
    pass.dispatchWorkgroups(groups[0], groups[1]);
    pass.end();
  }

  /** Gives everything back; `lost` then stays pending. */
  destroy(): void {
    this.isDestroyed = true;
    this.gpu.destroy();
  }

  private async compile(
    key: string,
    shader: ShaderName,
    entry: string,
    bindings?: Readonly<Record<string, number>>,
  ): Promise<void> {
    const isLayered = this.isLayered;
    await this.turn();
    try {
      const code = shaderText(shader);
      // The constant of `planes.slang`: without layers nothing of them is computed.
      const declared = LAYERED.exec(code);
      const constants: Record<string, number> = declared === null ? {} : { [declared[1]!]: isLayered ? 1 : 0 };
      const pipeline = await this.gpu.createComputePipelineAsync({
        layout: "auto",
        compute: { module: this.gpu.createShaderModule({ code, label: shader }), entryPoint: entry, constants },
      });
      this.kernels.set(key, { pipeline, bindings: bindings ?? bindingsOf(code) });
    } finally {
      this.running--;
      this.waiting.shift()?.();
    }
  }

  private keyOf(shader: ShaderName, entry: string): string {
    return `${shader} ${entry} ${this.isLayered ? "layered" : ""}`;
  }

  /** Resolves when a kernel may be compiled. */
  private async turn(): Promise<void> {
    if (this.isSoftware && this.running >= AT_A_TIME) await new Promise<void>((resolve) => this.waiting.push(resolve));
    this.running++;
  }
}

/** Entries of a bind group by the names of globals. */
export function bindEntries(bindings: Readonly<Record<string, number>>, resources: Resources): GPUBindGroupEntry[] {
  return Object.entries(bindings).map(([name, binding]) => {
    const resource = resources[name];
    if (resource === undefined) throw new Error(`no resource ${name}`);
    return { binding, resource: resource instanceof GPUBuffer ? { buffer: resource } : resource };
  });
}

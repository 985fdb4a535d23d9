/** Bakes tables of `lobes` by the sequence of kernels in `bake.json`, into the buffers that shaders read. */
import type { BakePlan } from "../fabric/bake_plan.ts";
import { valueOf } from "../fabric/bake_plan.ts";
import type { RecordArray } from "../records.ts";
import { BAKE, bakeRecord, bakeSteps, scratchWords, type Dispatch } from "./bake_records.ts";
import type { Device, Kernel, Resources } from "./device.ts";
import type { ShaderName } from "./shaders.ts";

/** Consecutive kernels that run once, or again for each face. */
const SEQUENCES: readonly (readonly Dispatch[])[] = BAKE.dispatches.reduce<Dispatch[][]>((sequences, dispatch) => {
  const last = sequences.at(-1);
  if (last !== undefined && (last[0]!.each !== "") === (dispatch.each !== "")) last.push(dispatch);
  else sequences.push([dispatch]);
  return sequences;
}, []);

export class Baker {
  /** Kernels that were launched so far. */
  kernels = 0;
  private readonly device: Device;
  private readonly own = new Map<string, GPUBuffer>();

  constructor(device: Device) {
    this.device = device;
  }

  /** Whether all kernels are compiled; otherwise compiling goes on. */
  isReady(): boolean {
    return BAKE.dispatches.map((dispatch) => this.kernel(dispatch)).every((kernel) => kernel !== undefined);
  }

  /** Why a kernel cannot be compiled, if so. */
  get fault(): Error | undefined {
    const faults = BAKE.dispatches.map(({ module, entry }) => this.device.fault(module as ShaderName, entry));
    return faults.find((fault) => fault !== undefined);
  }

  /** Bakes the tables of a fabric whose geometry is in `buffers`; returns before the device is done. */
  bake(buffers: Readonly<Record<string, GPUBuffer>>, fabrics: RecordArray, number: number, plan: BakePlan): void {
    const resources: Record<string, GPUBuffer | GPUBufferBinding> = { ...buffers };
    for (const [name, size] of Object.entries(BAKE.buffer_bytes)) resources[name] = this.room(name, valueOf(plan, size));
    resources["scratch"] = this.room("scratch", 4 * scratchWords(plan));
    resources["bakes"] = this.stored("bakes", bakeRecord(plan, fabrics, number).words);
    for (const [alias, name] of Object.entries(BAKE.aliases)) resources[alias] = resources[name]!;
    const steps = this.stored("steps", bakeSteps(plan));
    let encoder = this.device.gpu.createCommandEncoder();
    for (const sequence of SEQUENCES)
      for (let face = 0; face < (sequence[0]!.each === "" ? 1 : 2); face++)
        for (const dispatch of sequence) {
          const isOfLevel = dispatch.each === "level";
          for (let level = isOfLevel ? 1 : 0; level < (isOfLevel ? plan.levels.length : 1); level++) {
            const offset = (face * plan.levels.length + level) * BAKE.step_bytes;
            resources["steps"] = { buffer: steps, offset, size: BAKE.step_bytes };
            const [, columns, rows] = plan.levels[level]!;
            const threads = valueOf(plan, dispatch.threads, { level_columns: columns, level_rows: rows });
            if (dispatch.clears !== "") encoder.clearBuffer(resources[dispatch.clears] as GPUBuffer);
            this.encode(encoder, dispatch, threads, resources);
            // A software adapter takes seconds for all of them: what else the page draws comes in between.
            if (!this.device.isSoftware) continue;
            this.device.gpu.queue.submit([encoder.finish()]);
            encoder = this.device.gpu.createCommandEncoder();
          }
        }
    this.device.gpu.queue.submit([encoder.finish()]);
  }

  destroy(): void {
    this.own.forEach((buffer) => buffer.destroy());
  }

  private encode(encoder: GPUCommandEncoder, dispatch: Dispatch, threads: number, resources: Resources): void {
    const kernel = this.kernel(dispatch);
    if (kernel === undefined) throw new Error(`${dispatch.entry} is not compiled yet`);
    const groups = Math.ceil(threads / dispatch.group);
    const pass = encoder.beginComputePass();
    pass.setPipeline(kernel.pipeline);
    pass.setBindGroup(0, this.device.bind(kernel, resources));
    pass.dispatchWorkgroups(Math.min(groups, BAKE.row_of_groups), Math.ceil(groups / BAKE.row_of_groups));
    pass.end();
    this.kernels++;
  }

  private kernel(dispatch: Dispatch): Kernel | undefined {
    return this.device.kernel(dispatch.module as ShaderName, dispatch.entry, dispatch.bindings);
  }

  /** A buffer for what lies between kernels, kept from bake to bake where it is large enough. */
  private room(name: string, size: number): GPUBuffer {
    const found = this.own.get(name);
    if (found !== undefined && found.size >= size) return found;
    found?.destroy();
    const made = this.device.buffer(size);
    this.own.set(name, made);
    return made;
  }

  private stored(name: string, words: Uint32Array<ArrayBuffer>): GPUBuffer {
    const buffer = this.room(name, words.byteLength);
    this.device.write(buffer, words);
    return buffer;
  }
}

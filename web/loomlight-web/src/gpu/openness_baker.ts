/** Casts the rays that find how open cloth is, by the kernel `bake_openness`, and reads back what they meet. */
import type { Openness } from "../fabric/between_yarns.ts";
import { sizeOf, type Look } from "../fabric/look.ts";
import { opennessOf, RAYS, viewRays } from "../fabric/openness.ts";
import { sameLayout } from "../fabric/pack.ts";
import { RAY_RESULTS } from "../generated.ts";
import { BAKE } from "./bake_records.ts";
import type { Device } from "./device.ts";

const KERNEL = "bake_openness";

/** Whether two looks have one openness: it depends on yarns, on how light scatters, and on no colour. */
export function isAsOpen(one: Look, other: Look): boolean {
  const numbers = ({ appearance }: Look): number[] => [
    appearance.diffuseBlend,
    appearance.opticalDepth,
    appearance.warp.roughness,
    appearance.weft.roughness,
  ];
  const others = numbers(other);
  return sameLayout(one.layout, other.layout) && numbers(one).every((value, i) => value === others[i]);
}

/**
 * The openness of fabric `number`, whose look and highest yarn (millimetres) these are and whose geometry is in
 * `buffers`; undefined while the kernel compiles.
 */
export function bakeOpenness(
  device: Device,
  buffers: Readonly<Record<string, GPUBuffer>>,
  number: number,
  look: Look,
  highest: number,
): Promise<Openness> | undefined {
  const { group, bindings } = BAKE.openness;
  const kernel = device.kernel(KERNEL, KERNEL, bindings);
  if (kernel === undefined) return undefined;
  const numbers = Float32Array.from(viewRays(sizeOf(look.layout)));
  const words = new Uint32Array(2 + numbers.length);
  words.set([number, RAYS]);
  words.set(new Uint32Array(numbers.buffer), 2);
  const steps = device.buffer(words.byteLength);
  device.write(steps, words);
  const size = 4 * 2 * RAYS * RAY_RESULTS;
  const scratch = device.buffer(size);
  const encoder = device.gpu.createCommandEncoder();
  const pass = encoder.beginComputePass();
  pass.setPipeline(kernel.pipeline);
  pass.setBindGroup(0, device.bind(kernel, { ...buffers, steps, scratch }));
  pass.dispatchWorkgroups(Math.ceil((2 * RAYS) / group));
  pass.end();
  device.gpu.queue.submit([encoder.finish()]);
  return device.read(scratch, size).then((bytes) => {
    steps.destroy();
    scratch.destroy();
    const { warp, weft, opticalDepth } = look.appearance;
    return opennessOf(new Uint32Array(bytes), highest, [warp.roughness, weft.roughness], opticalDepth);
  });
}

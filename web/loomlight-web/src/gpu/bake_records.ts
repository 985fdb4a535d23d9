/** What the kernels that bake are told: the record of a bake, and the uniforms of its steps; see `bake.py`. */
import bakeList from "@shaders/bake.json";

import type { BakePlan, Size } from "../fabric/bake_plan.ts";
import { valueOf } from "../fabric/bake_plan.ts";
import { FIRST_WEIGHT } from "../generated.ts";
import { RecordArray, wordOf } from "../records.ts";

/** A kernel of the sequence. */
export interface Dispatch {
  readonly entry: string;
  readonly module: string;
  /** That it needs. */
  readonly threads: Size;
  /** "" for once; "face" and "level" repeat for each face, and for each level of the pyramid but the first. */
  readonly each: string;
  /** Threads of a workgroup. */
  readonly group: number;
  /** A buffer that is set to 0 before, or "". */
  readonly clears: string;
  /** By the name of the buffer. */
  readonly bindings: Readonly<Record<string, number>>;
}

/** `bake.json`: the sequence of kernels and the sizes of buffers. */
export interface BakeList {
  readonly row_of_groups: number;
  readonly step_bytes: number;
  readonly dispatches: readonly Dispatch[];
  readonly scratch_words: Readonly<Record<string, Size>>;
  readonly buffer_bytes: Readonly<Record<string, Size>>;
  readonly aliases: Readonly<Record<string, string>>;
  /** The kernel of the openness of yarns: threads of a workgroup, and bindings by the name of the buffer. */
  readonly openness: { readonly group: number; readonly bindings: Readonly<Record<string, number>> };
}

export const BAKE = bakeList as unknown as BakeList;

/** The record `Bake` of fabric `number`. */
export function bakeRecord(plan: BakePlan, fabrics: RecordArray, number: number): RecordArray {
  const record = new RecordArray("Bake", 1);
  record.set(0, plan.values);
  let first = 0;
  for (const [name, size] of Object.entries(BAKE.scratch_words)) {
    record.set(0, { [name]: first });
    first += valueOf(plan, size);
  }
  const begin = (number * fabrics.words.length) / fabrics.count;
  record.set(0, {
    fabric: number,
    moments_table: fabrics.get(number, "lobes.moments"),
    record_warp_packs: begin + wordOf("Fabric", "lobes.front_warp_packs"),
    record_hole_weights: begin + wordOf("Fabric", "lobes.front_hole_weight"),
  });
  return record;
}

/** Words of `scratch`. */
export function scratchWords(plan: BakePlan): number {
  return Object.values(BAKE.scratch_words).reduce((sum, size) => sum + valueOf(plan, size), 0);
}

/** The uniform of each face and level, `BAKE.step_bytes` apart. */
export function bakeSteps(plan: BakePlan): Uint32Array<ArrayBuffer> {
  const stride = BAKE.step_bytes / 4;
  const count = plan.levels.length;
  const words = new Uint32Array(2 * count * stride);
  const floats = new Float32Array(words.buffer);
  for (let face = 0; face < 2; face++)
    for (let level = 0; level < count; level++) {
      const at = (face * count + level) * stride;
      words[at] = face;
      words.set(plan.levels[level]!, at + 1);
      if (level > 0) words.set(plan.levels[level - 1]!, at + 4);
      plan.blur.forEach((weights, axis) => {
        words[at + 7 + axis] = weights.length - 1;
        floats.set(weights, at + FIRST_WEIGHT * (axis + 1));
      });
    }
  return words;
}

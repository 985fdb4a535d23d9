/** Tables of `lobes` that are kept between visits, so that neither kernels of the bake nor their compiling are waited for. */
import bakeCoverage from "@shaders/wgsl/bake_coverage.wgsl?raw";
import bakeGroups from "@shaders/wgsl/bake_groups.wgsl?raw";
import bakePoints from "@shaders/wgsl/bake_points.wgsl?raw";
import bakeRays from "@shaders/wgsl/bake_rays.wgsl?raw";
import bakeTables from "@shaders/wgsl/bake_tables.wgsl?raw";

import type { FamilyLayout, Look } from "../fabric/look.ts";

/** Where tables are kept: words by a key. What fails keeps nothing. */
export interface TableCache {
  get(key: string): Promise<Uint32Array<ArrayBuffer> | null>;
  put(key: string, words: Uint32Array<ArrayBuffer>): void;
}

/** FNV-1a over bytes in two lanes of 32 bits, of which the second begins elsewhere. */
class Hash {
  private one = 0x811c9dc5;
  private two = 0x1b873593;

  bytes(values: ArrayLike<number>): this {
    for (let at = 0; at < values.length; at++) {
      this.one = Math.imul(this.one ^ values[at]!, 0x01000193);
      this.two = Math.imul(this.two ^ values[at]!, 0x85ebca6b) ^ (this.two >>> 13);
    }
    return this;
  }

  numbers(values: ArrayLike<number>): this {
    return this.bytes(new Uint8Array(Float64Array.from(values).buffer));
  }

  get text(): string {
    return [this.one, this.two].map((lane) => (lane >>> 0).toString(16).padStart(8, "0")).join("");
  }
}

let ofShaders: string | null = null;

/** The key of the tables of a look: what they are baked of, and by which kernels. */
export function keyOfTables({ layout, appearance }: Look): string {
  ofShaders ??= [bakeCoverage, bakeGroups, bakePoints, bakeRays, bakeTables]
    .reduce((hash, text) => hash.bytes(new TextEncoder().encode(text)), new Hash())
    .text;
  const { ends, picks, warpOnTop, warp, weft } = layout;
  const hash = new Hash().numbers([ends, picks, appearance.diffuseBlend]).bytes(warpOnTop);
  for (const family of [warp, weft] satisfies FamilyLayout[])
    hash.numbers([family.inclination, family.twist, family.heightScale]).numbers(family.spacing).numbers(family.width);
  return `${ofShaders}-${ends}x${picks}-${hash.text}`;
}

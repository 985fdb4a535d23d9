/** Fabrics in an adapter's buffers, with tables of `lobes` baked there; an edit rewrites what it changes. */
import { planBake } from "../fabric/bake_plan.ts";
import type { Look } from "../fabric/look.ts";
import { packFabrics, prepare, sameLayout, type Ingredients, type Packed } from "../fabric/pack.ts";
import { DEFAULT_GROUPS, RECORDS } from "../generated.ts";
import { wordOf, type RecordArray, type Values } from "../records.ts";
import { Baker } from "./baker.ts";
import type { Device } from "./device.ts";

// Changes of words that lie closer than this go in one write. Tables that kernels wrote are longer than that, and so
// never in between.
const NEAR = 64;
// What kernels write into the record of a fabric; the back's follows the front's.
const BAKED_FIELDS = ["lobes.front_warp_packs", "lobes.front_hole_weight"] as const;

/** A fabric of a scene: its look, its size on the mesh, and what the scene adds to its record. */
export interface Dressing {
  readonly look: Look;
  readonly uvSizeMm: readonly [number, number];
  readonly extra: Values;
}

/**
 * Buffers of fabrics, families and words.
 *
 * An edit of colours, roughness or sheen writes the numbers that change. An edit of the yarns' heights, twist or widths
 * writes the geometry and bakes that fabric again, and so does a new weave. Where tables change size, all are written
 * anew, and what is baked already is copied on the adapter. Nothing is read back.
 */
export class FabricBuffers {
  /** By name, as shaders name them; other objects after an edit that needs larger ones. */
  buffers: Record<string, GPUBuffer> = {};
  /** Writes of buffers, or of parts of them, so far, and their bytes. */
  writes = 0;
  writtenBytes = 0;
  /** Fabrics that were baked so far. */
  bakes = 0;
  private readonly device: Device;
  private readonly baker: Baker;
  private readonly dressings: Dressing[];
  private readonly ingredients: Ingredients[];
  private packed: Packed;
  private usesTables = true;
  private readonly unbaked = new Set<number>();

  constructor(device: Device, dressings: readonly Dressing[]) {
    this.device = device;
    this.baker = new Baker(device);
    this.dressings = [...dressings];
    this.ingredients = dressings.map((dressing) => ingredientsOf(dressing, null));
    this.packed = this.pack();
    dressings.forEach((_, number) => this.unbaked.add(number));
    this.upload();
  }

  /** Kernels that were launched so far. */
  get bakeKernels(): number {
    return this.baker.kernels;
  }

  /** Whether light passes through holes of any of the fabrics. */
  get isOpen(): boolean {
    return this.dressings.some((_, number) => this.packed.fabrics.get(number, "is_open") === 1);
  }

  /** The look of a fabric, and its highest yarn, millimetres. */
  lookAt(number: number): { readonly look: Look; readonly highest: number } {
    return { look: this.dressings[number]!.look, highest: this.packed.fabrics.get(number, "height_high") };
  }

  /** Why tables cannot be baked, if so. */
  get fault(): Error | undefined {
    return this.baker.fault;
  }

  /** Bakes what is not baked yet; false while kernels compile. */
  bake(): boolean {
    if (this.unbaked.size === 0) return true;
    if (!this.baker.isReady()) return false;
    for (const number of this.unbaked) {
      this.baker.bake(this.buffers, this.packed.fabrics, number, this.ingredients[number]!.plan!);
      this.bakes++;
    }
    this.unbaked.clear();
    return true;
  }

  /** Another fabric, or an edit of it, in place of fabric `number`; tables are baked by the next `bake`. */
  setFabric(number: number, look: Look): void {
    const before = this.ingredients[number]!;
    const old = this.packed;
    const dressing = { ...this.dressings[number]!, look };
    this.ingredients[number] = ingredientsOf(dressing, before);
    this.dressings[number] = dressing;
    this.packed = this.pack();
    const isSame =
      sameLayout(before.look.layout, look.layout) &&
      before.look.appearance.diffuseBlend === look.appearance.diffuseBlend;
    if (!isSame) this.unbaked.add(number);
    if (!haveSameTables(old, this.packed)) {
      const buffers = this.buffers;
      this.upload();
      this.copyTables(buffers, old);
      Object.values(buffers).forEach((buffer) => buffer.destroy());
      return;
    }
    this.rewrite("words", this.packed.words, old.words, NEAR);
    // Records: no word that a kernel wrote may be overwritten.
    this.rewrite("fabrics", this.packed.fabrics.words, old.fabrics.words, 1);
    this.rewrite("families", this.packed.families.words, old.families.words, 1);
  }

  /**
   * Whether shadows may read the tables of `lobes`. Those of `point` fall through single points of holes: they need no
   * tables, and none are baked for it.
   */
  useTables(usesTables: boolean): void {
    if (usesTables === this.usesTables) return;
    const old = this.packed.fabrics.words;
    this.usesTables = usesTables;
    this.packed = this.pack();
    this.rewrite("fabrics", this.packed.fabrics.words, old, 1);
  }

  /** What the scene adds to the record of each fabric. */
  describe(extras: readonly Values[]): void {
    const old = this.packed.fabrics.words.slice();
    extras.forEach((extra, number) => {
      this.dressings[number] = { ...this.dressings[number]!, extra };
      this.packed.fabrics.set(number, extra);
    });
    this.rewrite("fabrics", this.packed.fabrics.words, old, 1);
  }

  destroy(): void {
    Object.values(this.buffers).forEach((buffer) => buffer.destroy());
    this.baker.destroy();
  }

  private pack(): Packed {
    const result = packFabrics(this.ingredients);
    this.dressings.forEach(({ extra }, number) => {
      result.fabrics.set(number, { ...extra, "lobes.is_baked": this.usesTables ? 1 : 0 });
    });
    return result;
  }

  private upload(): void {
    this.buffers = {};
    const contents = {
      fabrics: this.packed.fabrics.words,
      families: this.packed.families.words,
      words: this.packed.words,
    };
    for (const [name, words] of Object.entries(contents)) {
      // One record of zeros more: what casts shadows and is no cloth.
      const more = name === "fabrics" ? 4 * RECORDS.Fabric.words : 0;
      this.buffers[name] = this.device.buffer(words.byteLength + more);
      this.write(name, words, 0);
    }
  }

  private rewrite(name: string, words: Uint32Array<ArrayBuffer>, old: Uint32Array, gap: number): void {
    for (const [start, stop] of changedRanges(words, old, gap)) this.write(name, words.slice(start, stop), start);
  }

  private write(name: string, words: Uint32Array<ArrayBuffer>, at: number): void {
    this.device.write(this.buffers[name]!, words, at);
    this.writes++;
    this.writtenBytes += words.byteLength;
  }

  /** Copies what kernels have baked out of the buffers before. */
  private copyTables(before: Readonly<Record<string, GPUBuffer>>, old: Packed): void {
    const encoder = this.device.gpu.createCommandEncoder();
    this.dressings.forEach((_, number) => {
      if (this.unbaked.has(number)) return;
      const [from, to] = [old, this.packed].map(({ fabrics }) => 4 * fabrics.get(number, "lobes.coverage")) as [
        number,
        number,
      ];
      const words = Object.values(this.ingredients[number]!.plan!.tableWords).reduce((sum, size) => sum + size, 0);
      encoder.copyBufferToBuffer(before["words"]!, from, this.buffers["words"]!, to, 4 * words);
      for (const field of BAKED_FIELDS) {
        const at = 4 * (number * RECORDS.Fabric.words + wordOf("Fabric", field));
        encoder.copyBufferToBuffer(before["fabrics"]!, at, this.buffers["fabrics"]!, at, 8);
      }
    });
    this.device.gpu.queue.submit([encoder.finish()]);
  }
}

function ingredientsOf(dressing: Dressing, before: Ingredients | null): Ingredients {
  const plan = planBake(dressing.look.layout, DEFAULT_GROUPS);
  return prepare(dressing.look, dressing.uvSizeMm, plan, before);
}

/** Whether all tables are at the same places: the fields that say so are whole numbers. */
function haveSameTables(one: Packed, other: Packed): boolean {
  const same = (a: RecordArray, b: RecordArray): boolean =>
    Array.from({ length: a.count }, (_, record) => record).every((record) => {
      const places = b.wholeNumbers(record, ["seed"]);
      return a.wholeNumbers(record, ["seed"]).every((place, i) => place === places[i]);
    });
  return (
    one.words.length === other.words.length && same(one.fabrics, other.fabrics) && same(one.families, other.families)
  );
}

/** Ranges that hold all words that differ; such words at most `gap` apart share a range. */
export function changedRanges(words: Uint32Array, old: Uint32Array, gap: number): [number, number][] {
  const ranges: [number, number][] = [];
  for (let i = 0; i < words.length; i++) {
    if (words[i] === old[i]) continue;
    const last = ranges.at(-1);
    if (last !== undefined && i - last[1] < gap) last[1] = i + 1;
    else ranges.push([i, i + 1]);
  }
  return ranges;
}

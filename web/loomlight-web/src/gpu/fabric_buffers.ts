/** Fabrics in an adapter's buffers, with tables of `lobes` baked there; an edit rewrites what it changes. */
import { planBake } from "../fabric/bake_plan.ts";
import type { Look } from "../fabric/look.ts";
import { packFabrics, prepare, sameLayout, type Ingredients, type Packed } from "../fabric/pack.ts";
import { DEFAULT_GROUPS, RECORDS } from "../generated.ts";
import { wordOf, type RecordArray, type Values } from "../records.ts";
import { Baker } from "./baker.ts";
import type { Device } from "./device.ts";
import { keyOfTables, type TableCache } from "./table_cache.ts";

// Changes of words that lie closer than this go in one write. Tables that kernels wrote are longer than that, and so
// never in between.
const NEAR = 64;
// What kernels write into the record of a fabric; the back's follows the front's.
const BAKED_FIELDS = ["lobes.front_warp_packs", "lobes.front_hole_weight"] as const;
const WORDS_OF_FIELD = 2;
// Tables are kept once a fabric has stood so many milliseconds: a slider that is drawn makes many.
const CALM_MS = 2000;

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
  private readonly cache: TableCache | null;
  /** Kept tables of fabrics that are not baked: null where there are none, undefined while they are looked for. */
  private readonly kept = new Map<number, Uint32Array<ArrayBuffer> | null | undefined>();
  private readonly looking = new Set<Promise<void>>();
  /** On a software adapter a bake takes seconds: nothing is drawn that would wait for it. */
  private baking: Promise<void> | null = null;
  private isDestroyed = false;

  constructor(device: Device, dressings: readonly Dressing[], cache: TableCache | null = null) {
    this.device = device;
    this.cache = cache;
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
    if (this.baking !== null) return false;
    for (const number of this.unbaked) {
      const kept = this.keptOf(number);
      if (kept === undefined) continue;
      if (kept !== null) this.restore(number, kept);
      else if (this.baker.isReady()) this.bakeOne(number);
      else continue;
      this.unbaked.delete(number);
    }
    return this.unbaked.size === 0 && this.baking === null;
  }

  /** Resolves when what is looked for is found or not, and what is baked is done. */
  async settled(): Promise<void> {
    await Promise.all([...this.looking, this.baking]);
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
    if (!isSame) {
      this.unbaked.add(number);
      this.kept.delete(number);
    }
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
    this.isDestroyed = true;
    Object.values(this.buffers).forEach((buffer) => buffer.destroy());
    this.baker.destroy();
  }

  /** Kept tables of a fabric, which are looked for once. */
  private keptOf(number: number): Uint32Array<ArrayBuffer> | null | undefined {
    if (this.cache === null) return null;
    if (!this.kept.has(number)) {
      this.kept.set(number, undefined);
      const { look } = this.dressings[number]!;
      const looking: Promise<void> = this.cache.get(keyOfTables(look)).then((words) => {
        this.looking.delete(looking);
        // Another fabric may have come meanwhile.
        if (this.kept.has(number) && this.dressings[number]!.look === look)
          this.kept.set(number, words?.length === this.tableWords(number) + WORDS_OF_FIELD * BAKED_FIELDS.length ? words : null);
        else this.kept.delete(number);
      });
      this.looking.add(looking);
    }
    return this.kept.get(number);
  }

  private bakeOne(number: number): void {
    this.baker.bake(this.buffers, this.packed.fabrics, number, this.ingredients[number]!.plan!);
    this.bakes++;
    const done = this.device.gpu.queue.onSubmittedWorkDone();
    const end = (): void => void (this.baking = null);
    if (this.device.isSoftware) this.baking = done.then(end, end);
    const { look } = this.dressings[number]!;
    if (this.cache !== null) setTimeout(() => void this.keep(number, look), CALM_MS);
  }

  private tableWords(number: number): number {
    return Object.values(this.ingredients[number]!.plan!.tableWords).reduce((sum, size) => sum + size, 0);
  }

  /** Bytes from the beginning of the records to what kernels wrote of a fabric. */
  private fieldAt(number: number, field: (typeof BAKED_FIELDS)[number]): number {
    return 4 * (number * RECORDS.Fabric.words + wordOf("Fabric", field));
  }

  private restore(number: number, words: Uint32Array<ArrayBuffer>): void {
    const size = this.tableWords(number);
    this.device.write(this.buffers["words"]!, words.slice(0, size), this.packed.fabrics.get(number, "lobes.coverage"));
    BAKED_FIELDS.forEach((field, index) => {
      const at = size + WORDS_OF_FIELD * index;
      this.device.write(this.buffers["fabrics"]!, words.slice(at, at + WORDS_OF_FIELD), this.fieldAt(number, field) / 4);
    });
  }

  /** Reads the tables of a fabric back and keeps them, if it is still the one that was baked. */
  private async keep(number: number, look: Look): Promise<void> {
    if (this.isDestroyed || this.unbaked.has(number) || keyOfTables(this.dressings[number]!.look) !== keyOfTables(look)) return;
    const { gpu } = this.device;
    const size = this.tableWords(number);
    const copy = gpu.createBuffer({
      size: 4 * (size + WORDS_OF_FIELD * BAKED_FIELDS.length),
      usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ,
    });
    const encoder = gpu.createCommandEncoder();
    encoder.copyBufferToBuffer(this.buffers["words"]!, 4 * this.packed.fabrics.get(number, "lobes.coverage"), copy, 0, 4 * size);
    BAKED_FIELDS.forEach((field, index) =>
      encoder.copyBufferToBuffer(this.buffers["fabrics"]!, this.fieldAt(number, field), copy, 4 * (size + WORDS_OF_FIELD * index), 4 * WORDS_OF_FIELD),
    );
    gpu.queue.submit([encoder.finish()]);
    try {
      await copy.mapAsync(GPUMapMode.READ);
    } catch {
      return; // the device is lost
    }
    this.cache?.put(keyOfTables(look), new Uint32Array(copy.getMappedRange().slice(0)));
    copy.destroy();
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
      encoder.copyBufferToBuffer(before["words"]!, from, this.buffers["words"]!, to, 4 * this.tableWords(number));
      for (const field of BAKED_FIELDS) {
        const at = this.fieldAt(number, field);
        encoder.copyBufferToBuffer(before["fabrics"]!, at, this.buffers["fabrics"]!, at, 4 * WORDS_OF_FIELD);
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

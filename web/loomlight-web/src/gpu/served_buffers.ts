/** Buffers of a fabric that Python packed for a model whose tables the page does not bake itself. */
import { InputError } from "loomlight-fabric";

import { RECORDS } from "../generated.ts";
import { RecordArray, type Values } from "../records.ts";
import type { Device } from "./device.ts";

/** The buffers of `realtime.tables.Packed` by name, as their words. */
export type ServedTables = Readonly<Record<(typeof NAMES)[number], Uint32Array<ArrayBuffer>>>;

const NAMES = ["fabrics", "families", "words", "packed_numbers"] as const;
const LENGTH_BYTES = 8;

/**
 * What the server's `/api/tables` sends: a safetensors file of the buffers' bytes.
 *
 * @throws InputError another file, or tables of another version of the package.
 */
export function readTables(content: Uint8Array): ServedTables {
  const fault = (what: string): InputError => new InputError(`The tables of the model ${what}: reload the page.`);
  if (content.byteLength < LENGTH_BYTES) throw fault("are incomplete");
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const first = LENGTH_BYTES + view.getUint32(0, true);
  if (first > content.byteLength) throw fault("are incomplete");
  let header: Record<string, { data_offsets?: [number, number] }>;
  try {
    header = JSON.parse(new TextDecoder().decode(content.subarray(LENGTH_BYTES, first)));
  } catch {
    throw fault("are no safetensors file");
  }
  const words = (name: string): Uint32Array<ArrayBuffer> => {
    const [start, stop] = header[name]?.data_offsets ?? [0, 0];
    if (stop <= start || first + stop > content.byteLength) throw fault("are incomplete");
    // A copy, as words begin at multiples of four bytes; `slice` of Node's Buffer makes none.
    return new Uint32Array(new Uint8Array(content.subarray(first + start, first + stop)).buffer);
  };
  const tables = Object.fromEntries(NAMES.map((name) => [name, words(name)])) as unknown as ServedTables;
  // Layers have records of families of their own behind the two.
  const families = tables.families.length / RECORDS.Family.words;
  if (tables.fabrics.length !== RECORDS.Fabric.words || families < 2 || families % 2 !== 0)
    throw fault("are of another version of loomlight");
  return tables;
}

export class ServedBuffers {
  readonly buffers: Record<string, GPUBuffer> = {};
  private readonly device: Device;
  private readonly record = new RecordArray("Fabric", 1);

  constructor(device: Device, tables: ServedTables, uvSizeMm: readonly [number, number], extra: Values) {
    this.device = device;
    this.record.words.set(tables.fabrics);
    this.record.set(0, { uv_width: uvSizeMm[0], uv_height: uvSizeMm[1], ...extra });
    for (const [name, words] of Object.entries({ ...tables, fabrics: this.record.words })) {
      // One record of zeros more: what casts shadows and is no cloth.
      this.buffers[name] = device.buffer(words.byteLength * (name === "fabrics" ? 2 : 1));
      device.write(this.buffers[name], words);
    }
  }

  /** Whether light passes through holes. */
  get isOpen(): boolean {
    return this.record.get(0, "is_open") === 1;
  }

  /** Whether the fabric has layers. */
  get isLayered(): boolean {
    return this.record.get(0, "planes") > 0;
  }

  /** What the scene adds to the record of the fabric. */
  describe(extra: Values): void {
    this.record.set(0, extra);
    this.device.write(this.buffers["fabrics"]!, this.record.words);
  }

  destroy(): void {
    Object.values(this.buffers).forEach((buffer) => buffer.destroy());
  }
}

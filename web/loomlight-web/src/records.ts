/** Records as shaders read them: arrays of 32-bit words whose places `generated.ts` names. */
import { RECORDS, type Field } from "./generated.ts";

export type RecordName = keyof typeof RECORDS;
/** Values of fields by name; those of inner records dotted. */
export type Values = Readonly<Record<string, number>>;

/** Any number of records of one kind, as they lie in a buffer. */
export class RecordArray {
  readonly words: Uint32Array<ArrayBuffer>;
  private readonly floats: Float32Array;
  private readonly fields: Readonly<Record<string, Field>>;
  private readonly stride: number;

  constructor(name: RecordName, count: number) {
    this.stride = RECORDS[name].words;
    this.fields = RECORDS[name].fields;
    this.words = new Uint32Array(this.stride * count);
    this.floats = new Float32Array(this.words.buffer);
  }

  get count(): number {
    return this.words.length / this.stride;
  }

  /** Writes fields of a record, whose names may have a common prefix. */
  set(record: number, values: Values, prefix = ""): void {
    for (const [name, value] of Object.entries(values)) {
      const [word, kind] = this.field(prefix + name);
      (kind === "uint" ? this.words : this.floats)[record * this.stride + word] = value;
    }
  }

  get(record: number, name: string): number {
    const [word, kind] = this.field(name);
    return (kind === "uint" ? this.words : this.floats)[record * this.stride + word]!;
  }

  /** Words of the fields that hold whole numbers: where tables begin, and counts. */
  wholeNumbers(record: number, except: readonly string[] = []): number[] {
    return Object.entries(this.fields)
      .filter(([name, [, kind]]) => kind === "uint" && !except.includes(name))
      .map(([, [word]]) => this.words[record * this.stride + word]!);
  }

  private field(name: string): Field {
    const field = this.fields[name];
    if (field === undefined) throw new Error(`no field ${name}`);
    return field;
  }
}

/** Words from the beginning of a record to a field. */
export function wordOf(record: RecordName, field: string): number {
  return (RECORDS[record].fields as Readonly<Record<string, Field>>)[field]![0];
}

/** Tables of 32-bit words, one behind the other. */
export class WordTable {
  private readonly parts: Uint32Array[] = [];
  size = 0;

  /** Appends numbers as float32; the index of the first word. */
  addNumbers(values: ArrayLike<number>): number {
    return this.append(new Uint32Array(Float32Array.from(values).buffer));
  }

  /** Appends whole numbers; the index of the first word. */
  addWords(values: ArrayLike<number>): number {
    return this.append(values instanceof Uint32Array ? values : Uint32Array.from(values));
  }

  /** Appends so many words of 0; the index of the first. */
  reserve(count: number): number {
    return this.append(new Uint32Array(count));
  }

  /** All of them; at least one, as no buffer is empty. */
  words(): Uint32Array<ArrayBuffer> {
    const all = new Uint32Array(Math.max(1, this.size));
    let first = 0;
    for (const part of this.parts) {
      all.set(part, first);
      first += part.length;
    }
    return all;
  }

  private append(words: Uint32Array): number {
    const first = this.size;
    this.parts.push(words);
    this.size += words.length;
    return first;
  }
}

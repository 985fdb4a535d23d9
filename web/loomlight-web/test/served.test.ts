import { expect, test } from "vitest";

import { RECORDS } from "../src/generated.ts";
import { readTables } from "../src/gpu/served_buffers.ts";

/** A safetensors file of bytes by name. */
function safetensors(parts: Record<string, Uint8Array>): Uint8Array {
  let end = 0;
  const header = Object.fromEntries(
    Object.entries(parts).map(([name, bytes]) => [
      name,
      { dtype: "U8", shape: [bytes.length], data_offsets: [end, (end += bytes.length)] },
    ]),
  );
  const text = new TextEncoder().encode(JSON.stringify(header));
  const content = new Uint8Array(8 + text.length + end);
  new DataView(content.buffer).setUint32(0, text.length, true);
  content.set(text, 8);
  let at = 8 + text.length;
  for (const bytes of Object.values(parts)) {
    content.set(bytes, at);
    at += bytes.length;
  }
  return content;
}

const whole = {
  fabrics: new Uint8Array(4 * RECORDS.Fabric.words),
  families: new Uint8Array(8 * RECORDS.Family.words),
  words: Uint8Array.of(1, 0, 0, 0, 2, 0, 0, 0),
  packed_numbers: new Uint8Array(16),
};

test("tables are the buffers of the file, wherever they lie in it", () => {
  expect(Array.from(readTables(safetensors(whole)).words)).toEqual([1, 2]);
  const { words, ...rest } = whole;
  expect(Array.from(readTables(safetensors({ words, ...rest })).words)).toEqual([1, 2]);
});

test("what is no tables is refused in a sentence", () => {
  const { packed_numbers: _, ...some } = whole;
  for (const [content, said] of [
    [new Uint8Array(3), "are incomplete"],
    [new Uint8Array(64), "are no safetensors file"],
    [safetensors(some), "are incomplete"],
    [safetensors(whole).subarray(0, -1), "are incomplete"],
    [safetensors({ ...whole, fabrics: new Uint8Array(8) }), "another version"],
  ] as const)
    expect(() => readTables(content)).toThrow(said);
});

import { expect, test } from "vitest";

import { bindingsOf, numbersAndWords, withFewerBuffers } from "../src/gpu/bindings.ts";
import { shaderText } from "../src/gpu/shaders.ts";

test("shaders bind no more storage buffers than browsers allow", () => {
  for (const name of ["shade_neural", "shade_clustered", "shade_lobes", "shade_points", "cast_shadows"] as const) {
    const text = shaderText(name);
    expect([...text.matchAll(/var<storage/g)].length, name).toBeLessThanOrEqual(10);
    expect(bindingsOf(text)).not.toHaveProperty("face_fabrics");
  }
});

test("shaders of networks read words behind the numbers", () => {
  const text = withFewerBuffers(`
@binding(0) @group(0) var<storage, read> packed_numbers_0 : array<vec4<u32>>;
@binding(1) @group(0) var<storage, read> words_0 : array<u32>;
@binding(2) @group(0) var<storage, read> scene_words_0 : array<u32>;
let a = words_0[words_0[i] + 1u] + scene_words_0[j];`);
  expect(text).toContain("let a = joined_word(u32(joined_word(u32(i)) + 1u)) + scene_words_0[j];");
  expect(Object.keys(bindingsOf(text))).toEqual(["packed_numbers", "scene_words"]);
  const joined = numbersAndWords(Uint32Array.of(1, 2, 3, 4), Uint32Array.of(7, 8, 9, 10, 11));
  // As the shader: the last element names the first of words.
  const element = joined[joined.length - 4]!;
  const read = [0, 1, 2, 3, 4].map((index) => joined[4 * (element + (index >> 2)) + (index & 3)]);
  expect(read).toEqual([7, 8, 9, 10, 11]);
});

import { expect, test } from "vitest";

import { bindingsOf } from "../src/gpu/bindings.ts";
import { shaderText } from "../src/gpu/shaders.ts";

test("buffers are found by their names", () => {
  const bindings = bindingsOf(shaderText("shade_lobes"));
  expect(Object.keys(bindings).sort()).toEqual(
    ["fabrics", "families", "frame_record", "layers", "radiance", "scene_words", "visibilities", "words"].sort(),
  );
  expect(bindingsOf(shaderText("first_layer"))).toHaveProperty("visible_faces");
});

/** Light and shape, and what is wiped against what. */
import { InputError } from "loomlight-fabric";

import { COMPARISON_MODES, MODELS, SCENE_RANGES, SHAPES, SURROUNDINGS, type Comparison, type Scene, type State } from "../state/document.ts";
import { requireNumber, requireOneOf, shown } from "./checks.ts";

/**
 * The scene with other values.
 *
 * @throws InputError a value that is out of range, or none of a scene.
 */
export function withScene(scene: Scene, values: Partial<Scene>): Scene {
  const valid: Record<string, unknown> = { ...scene };
  for (const [key, value] of Object.entries(values)) {
    if (key === "shape") valid[key] = requireOneOf("shape", value, SHAPES);
    else if (key === "surroundings") valid[key] = requireOneOf("surroundings", value, SURROUNDINGS);
    else valid[key] = requireNumber(key, value, ...rangeOf(key));
  }
  return valid as unknown as Scene;
}

function rangeOf(key: string): readonly [number, number] {
  if (Object.hasOwn(SCENE_RANGES, key)) return SCENE_RANGES[key as keyof typeof SCENE_RANGES];
  throw new InputError(`${shown(key)} is none of a scene's values.`);
}

/**
 * The comparison with other values; the fabric "before" is kept by `kept` alone.
 *
 * @throws InputError a value that is out of range, or none of a comparison.
 */
export function withComparison(comparison: Comparison, values: Partial<Omit<Comparison, "before">>): Comparison {
  const valid: Record<string, unknown> = { ...comparison };
  for (const [key, value] of Object.entries(values)) {
    if (key === "mode") valid[key] = requireOneOf("mode", value, COMPARISON_MODES);
    else if (key === "position") valid[key] = requireNumber("position", value, 0, 1);
    else if (key === "left" || key === "right") valid[key] = requireOneOf(key, value, MODELS);
    else throw new InputError(`${shown(key)} is none of a comparison's values.`);
  }
  return valid as unknown as Comparison;
}

/** The state that keeps the present fabric as "before". */
export function kept(state: State): State {
  return { ...state, comparison: { ...state.comparison, mode: "fabrics", before: state.fabric } };
}

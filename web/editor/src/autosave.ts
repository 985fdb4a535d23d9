/** Keeps the fabric and the scene in the browser, so that a closed page or a lost connection loses nothing. */
import { FIRST_SCENE, SHAPES, type Fabric, type Scene, type State } from "./state/document.ts";
import { fabricFromJson, fabricToJson, type StoredFabric } from "./state/fabric_json.ts";

const PLACE = "loomlight.document.1";

interface Kept {
  readonly fabric: StoredFabric;
  readonly before: StoredFabric | null;
  readonly scene: Partial<Scene>;
}

/** What the browser kept; null if nothing, or nothing that can be read. */
export interface Restored {
  readonly fabric: Fabric;
  readonly before: Fabric | null;
  readonly scene: Scene;
}

/** Keeps the state; a browser that keeps nothing, or no more, is no fault of the user's. */
export function keep(state: State): void {
  const { before } = state.comparison;
  const kept: Kept = {
    fabric: fabricToJson(state.fabric),
    before: before === null ? null : fabricToJson(before),
    scene: state.scene,
  };
  try {
    localStorage.setItem(PLACE, JSON.stringify(kept));
  } catch {
    // Private windows and full storage: the address still carries the fabric.
  }
}

/** What was kept last; null if nothing was, or it cannot be read. */
export function restore(): Restored | null {
  try {
    const text = localStorage.getItem(PLACE);
    if (text === null) return null;
    const kept = JSON.parse(text) as Kept;
    const scene = { ...FIRST_SCENE, ...kept.scene };
    // A mesh or a picture of the user's own is not kept.
    const shape = SHAPES.includes(scene.shape) && scene.shape !== "mesh" ? scene.shape : FIRST_SCENE.shape;
    const surroundings = scene.surroundings === "picture" ? FIRST_SCENE.surroundings : scene.surroundings;
    return {
      fabric: fabricFromJson(kept.fabric),
      before: kept.before === null ? null : fabricFromJson(kept.before),
      scene: { ...scene, shape, surroundings },
    };
  } catch {
    return null;
  }
}

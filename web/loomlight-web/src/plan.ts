/** What frames are drawn with: what was asked for, as far as the device has it, and a cheap preview until then. */
import type { ClothBuffers } from "./gpu/cloth_buffers.ts";
import type { Device } from "./gpu/device.ts";
import type { ShaderName } from "./gpu/shaders.ts";
import type { ModelName } from "./types.ts";

export const ENTRIES: Readonly<Record<ModelName, ShaderName>> = {
  lobes: "shade_lobes",
  point: "shade_points",
  neural: "shade_neural",
  clustered: "shade_clustered",
};
const ALWAYS: readonly ShaderName[] = ["first_layer", "add_background", "tone_map"];

export interface Plan {
  readonly model: ModelName;
  readonly castsShadows: boolean;
  /** Layers of cloth that a pixel can see. */
  readonly layers: number;
}

/** A plan whose kernels are compiled and whose tables are baked. */
export interface ReadyPlan extends Plan {
  readonly isPreview: boolean;
}

// Points need no tables, and of all models they compile fastest.
const PREVIEW: ReadyPlan = { model: "point", castsShadows: false, layers: 1, isPreview: true };

/** Whether there may be previews, and whether none was drawn yet. */
export type Previews = "none" | "first" | "more";

/** What of a plan the device can do, and a sentence for each part that it could not compile. */
export interface Possible {
  readonly plan: Plan;
  readonly missing: readonly string[];
}

/** @throws Error the device cannot compile what no picture can be without. */
export function possible(device: Device, cloth: ClothBuffers, asked: Plan): Possible {
  const missing: string[] = [];
  const lacks = (name: string, fault: Error | undefined, instead: string): boolean => {
    if (fault !== undefined) missing.push(`This device could not compile ${name} (${firstLine(fault)}): ${instead}.`);
    return fault !== undefined;
  };
  const entry = ENTRIES[asked.model];
  const lacksModel =
    asked.model !== "point" &&
    (lacks(entry, device.fault(entry), "the cloth is shown point by point") ||
      (asked.model === "lobes" &&
        lacks("the kernels that bake lobes", cloth.fabrics.fault, "the cloth is shown point by point")));
  const lacksShadows = asked.castsShadows && lacks("cast_shadows", device.fault("cast_shadows"), "cloth casts no shadows");
  const lacksLayers = asked.layers > 1 && lacks("next_layer", device.fault("next_layer"), "holes show the background alone");
  lacks("bake_openness", device.fault("bake_openness"), "there is no light between yarns");
  const plan: Plan = {
    model: lacksModel ? "point" : asked.model,
    castsShadows: asked.castsShadows && !lacksShadows,
    layers: lacksLayers ? 1 : asked.layers,
  };
  for (const name of [...ALWAYS, ENTRIES[plan.model]]) {
    const fault = device.fault(name);
    if (fault !== undefined) throw fault;
  }
  return { plan, missing };
}

/**
 * The plan that can be drawn now: the one given, or where that is still compiled or baked the preview, or null.
 *
 * Begins what is missing, what the preview needs first; before a first preview on a software adapter nothing else, as what
 * is drawn there waits until what compiles is compiled.
 */
export function ready(device: Device, cloth: ClothBuffers, plan: Plan, previews: Previews, onFound: () => void): ReadyPlan | null {
  const has = (names: readonly ShaderName[]): boolean =>
    names.map((name) => device.kernel(name, name)).every((kernel) => kernel !== undefined);
  const canPreview = previews !== "none" && has([...ALWAYS, ENTRIES.point]);
  if (previews === "first" && device.isSoftware) return canPreview ? PREVIEW : null;
  const bakes = plan.model === "lobes" && cloth.servedContent === null;
  cloth.fabrics.useTables(bakes);
  const names: ShaderName[] = [...ALWAYS];
  if (plan.layers > 1) names.push("next_layer");
  if (plan.castsShadows) names.push("cast_shadows");
  names.push(ENTRIES[plan.model]);
  // Each of these begins what it lacks. Two kernels compile at a time: beside the preview's short ones, then the model's,
  // which takes longest, and beside it all of the bake.
  const parts = [has(names), !bakes || cloth.fabrics.bake(), cloth.findOpenness(onFound)];
  if (parts.every((part) => part)) return { ...plan, isPreview: false };
  return canPreview ? PREVIEW : null;
}

function firstLine(fault: Error): string {
  return (fault.message.split("\n")[0] ?? "").trim().replace(/\.$/, "");
}

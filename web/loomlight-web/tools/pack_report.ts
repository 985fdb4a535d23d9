/** What this module packs a fabric, a mesh or an environment into, for a test that compares with the Python package. */
import type { Draft, FabricFields, Threads } from "loomlight-fabric";

import { planBake } from "../src/fabric/bake_plan.ts";
import type { Openness } from "../src/fabric/between_yarns.ts";
import { geometryOf, heightBounds } from "../src/fabric/geometry.ts";
import { lookOf, type Look } from "../src/fabric/look.ts";
import { opennessOf } from "../src/fabric/openness.ts";
import { packFabrics, prepare } from "../src/fabric/pack.ts";
import { DEFAULT_GROUPS } from "../src/generated.ts";
import { bakeRecord, bakeSteps } from "../src/gpu/bake_records.ts";

interface ThreadsQuestion {
  readonly colors: number[] | null;
  readonly spacingMm: number[] | null;
  readonly thicknessMm: number[] | null;
  readonly colorIndex: number[] | null;
}

export interface FabricQuestion {
  readonly fields: FabricFields;
  readonly ends: number;
  readonly picks: number;
  readonly drawdown: string;
  readonly warp: ThreadsQuestion;
  readonly weft: ThreadsQuestion;
  readonly uvSizeMm: [number, number];
  readonly openness: Openness | null;
  /** What the kernel `bake_openness` would write of that fabric, in place of `openness`. */
  readonly rays?: readonly number[];
}

/** Bytes of the buffers of a fabric with room for baked tables, and of what its bake is told. */
export function report(question: FabricQuestion): Record<string, Uint8Array> {
  const draft = draftOf(question);
  const given = lookOf(question.fields, draft, question.openness);
  const look = question.rays === undefined ? given : lookOf(question.fields, draft, opennessFrom(question.rays, given));
  const plan = planBake(look.layout, DEFAULT_GROUPS);
  const packed = packFabrics([prepare(look, question.uvSizeMm, plan)]);
  const parts = {
    fabrics: packed.fabrics.words,
    families: packed.families.words,
    words: packed.words,
    bake: bakeRecord(plan, packed.fabrics, 0).words,
    steps: bakeSteps(plan),
  };
  return Object.fromEntries(Object.entries(parts).map(([name, words]) => [name, new Uint8Array(words.buffer)]));
}

function opennessFrom(rays: readonly number[], { layout, appearance }: Look): Openness {
  const { warp, weft, opticalDepth } = appearance;
  const highest = heightBounds(geometryOf(layout), layout)[1];
  return opennessOf(Uint32Array.from(rays), highest, [warp.roughness, weft.roughness], opticalDepth);
}

function draftOf(question: FabricQuestion): Draft {
  const threads = (given: ThreadsQuestion): Threads => ({
    colors: given.colors && Float64Array.from(given.colors),
    spacingMm: given.spacingMm && Float64Array.from(given.spacingMm),
    thicknessMm: given.thicknessMm && Float64Array.from(given.thicknessMm),
    colorIndex: given.colorIndex && Int32Array.from(given.colorIndex),
  });
  return {
    name: "",
    ends: question.ends,
    picks: question.picks,
    drawdown: Uint8Array.from(question.drawdown, Number),
    warp: threads(question.warp),
    weft: threads(question.weft),
    loom: null,
    palette: null,
    notes: [],
    source: null,
  };
}

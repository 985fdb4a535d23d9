/** The one document of the page: everything that a view shows is a function of it. */
import { colouredDraft, type Artwork, type Draft, type FabricFields } from "loomlight-fabric";

import { STUDIO_AZIMUTH, STUDIO_ELEVATION } from "../view/studio.ts";

/** A fabric: its fields, and the draft that they name, before they colour and repeat it. */
export interface Fabric {
  readonly fields: FabricFields;
  readonly draft: Draft;
  /** The picture that the draft was read of, or woven of where the fields have weaves of its colours; if it is at hand. */
  readonly artwork?: Artwork;
}

/** The pieces of cloth that can be shown. */
export const SHAPES = ["drape", "flat", "curtain", "cylinder", "sphere", "mesh"] as const;
export type Shape = (typeof SHAPES)[number];

/** What lights the cloth beside the lamp. */
export const SURROUNDINGS = ["studio", "window", "sky", "none", "picture"] as const;
export type Surroundings = (typeof SURROUNDINGS)[number];

export interface Scene {
  readonly shape: Shape;
  /** Where the lamp stands, degrees: azimuth 0 in front, 90 to the right; elevation 90 above. */
  readonly lampAzimuth: number;
  readonly lampElevation: number;
  /** Of the lamp and of the surroundings; 1 as designed. */
  readonly lampStrength: number;
  readonly surroundings: Surroundings;
  readonly surroundingsStrength: number;
  /** Degrees about the vertical. */
  readonly surroundingsTurn: number;
  /** Stops. */
  readonly exposure: number;
  /** Colour temperature of the light that is shown as white, kelvin. */
  readonly whiteBalance: number;
}

/** Least and most of each number of a scene. */
export const SCENE_RANGES = {
  lampAzimuth: [-180, 180],
  lampElevation: [-10, 90],
  lampStrength: [0, 3],
  surroundingsStrength: [0, 3],
  surroundingsTurn: [-180, 180],
  exposure: [-4, 4],
  whiteBalance: [2000, 12000],
} as const satisfies Partial<Record<keyof Scene, readonly [number, number]>>;

/** How colours are computed: filtered over each pixel, or by so many samples of points in it; Python bakes the last two. */
export const MODELS = ["lobes", "point-1", "point-3", "point-256", "neural", "clustered"] as const;
export type Model = (typeof MODELS)[number];

export const COMPARISON_MODES = ["off", "fabrics", "models"] as const;

export interface Comparison {
  readonly mode: (typeof COMPARISON_MODES)[number];
  /** Where the wipe stands, 0 to 1 from the left. */
  readonly position: number;
  /** The fabric to the left of the wipe; null until one is kept. */
  readonly before: Fabric | null;
  readonly left: Model;
  readonly right: Model;
}

export const TABS = ["weave", "draft", "colour", "yarns", "finish", "light"] as const;
export type Tab = (typeof TABS)[number];

export const NOTICE_KINDS = ["fault", "warning", "done"] as const;

export interface Notice {
  readonly id: number;
  readonly kind: (typeof NOTICE_KINDS)[number];
  readonly text: string;
  /** What a button of the notice hands over: what was set aside because it could not be shown. */
  readonly offer?: "aside";
  /** What it speaks of: files that were opened last. It goes when others are. */
  readonly topic?: "file";
}

/** Fabrics that undo and redo walk over. */
export interface History {
  readonly past: readonly Fabric[];
  readonly future: readonly Fabric[];
  /** The gesture that made the present fabric: a drag of a slider is one step. */
  readonly stroke: string | null;
}

export interface State {
  readonly fabric: Fabric;
  readonly history: History;
  readonly scene: Scene;
  readonly comparison: Comparison;
  readonly tab: Tab;
  readonly notices: readonly Notice[];
}

export const FIRST_SCENE: Scene = {
  shape: "drape",
  lampAzimuth: STUDIO_AZIMUTH,
  lampElevation: STUDIO_ELEVATION,
  lampStrength: 1,
  surroundings: "studio",
  surroundingsStrength: 1,
  surroundingsTurn: 0,
  exposure: 0,
  whiteBalance: 6500,
};

export const FIRST_COMPARISON: Comparison = {
  mode: "off",
  position: 0.5,
  before: null,
  left: "point-1",
  right: "lobes",
};

/** The state with which the page begins. */
export function firstState(fabric: Fabric): State {
  return {
    fabric,
    history: { past: [], future: [], stroke: null },
    scene: FIRST_SCENE,
    comparison: FIRST_COMPARISON,
    tab: "weave",
    notices: [],
  };
}

const wovenOf = new WeakMap<Fabric, Draft>();

/** The draft in its colours, as it is woven: its repeat may be longer than that of the named draft. */
export function woven(fabric: Fabric): Draft {
  let draft = wovenOf.get(fabric);
  if (draft === undefined) {
    draft = colouredDraft(fabric.draft, fabric.fields);
    wovenOf.set(fabric, draft);
  }
  return draft;
}

/** What to call a fabric. */
export function nameOf(fabric: Fabric): string {
  return fabric.fields.name ?? (fabric.draft.name || fabric.fields.weave || "Untitled cloth");
}

/** A fabric whose draft is woven of an artwork that is at hand. */
export interface WovenOfArtwork extends Fabric {
  readonly artwork: Artwork;
}

/** Whether the draft is woven of a picture whose colours are weaves. */
export function isArtwork(fabric: Fabric): fabric is WovenOfArtwork {
  return fabric.artwork !== undefined && hasWeaves(fabric.fields);
}

/** Whether the fields say which weaves the colours of an artwork are. */
export function hasWeaves({ weaves }: FabricFields): boolean {
  return weaves !== undefined && Object.keys(weaves).length > 0;
}

/** Whether the fields name the draft by a weave's name, so that the fabric file alone holds it. */
export function isNamed(fabric: Fabric): boolean {
  return fabric.fields.weave !== undefined;
}

/** Colours of threads: one painted, one swapped for another wherever it is, or all in a new order. */
import { threadHexes, withThreadHexes, type FamilyName } from "loomlight-fabric";

import type { FabricAction } from "../state/actions.ts";
import { woven, type Fabric } from "../state/document.ts";

type ColourAction = Extract<FabricAction, { type: `colour/${string}` }>;

/** The fabric in other colours. */
export function withColourEdit(fabric: Fabric, action: ColourAction): Fabric {
  const hexes = threadHexes(woven(fabric), action.family);
  return withHexes(fabric, action.family, recoloured(hexes, action));
}

function recoloured(hexes: readonly string[], action: ColourAction): readonly string[] {
  switch (action.type) {
    case "colour/paint":
      return hexes.map((hex, thread) => (thread === action.thread ? action.hex : hex));
    case "colour/swap":
      return hexes.map((hex) => (hex === action.from ? action.to : hex));
    case "colour/order":
      return action.hexes;
  }
}

function withHexes(fabric: Fabric, family: FamilyName, hexes: readonly string[]): Fabric {
  const fields = withThreadHexes(fabric.fields, fabric.draft, family, hexes);
  const edited = { ...fabric, fields };
  woven(edited); // raises where the colours would make too long a repeat
  return edited;
}

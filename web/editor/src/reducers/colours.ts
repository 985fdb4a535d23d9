/** Colours of threads: one painted, one swapped for another wherever it is, or all in a new order. */
import { FAMILIES, InputError, MAXIMUM_THREADS, threadHexes, withThreadHexes, type FamilyName } from "loomlight-fabric";

import type { FabricAction } from "../state/actions.ts";
import { woven, type Fabric } from "../state/document.ts";
import { requireHex, requireOneOf, requireWhole } from "./checks.ts";

type ColourAction = Extract<FabricAction, { type: `colour/${string}` }>;

/**
 * The fabric in other colours.
 *
 * @throws InputError no colours, or more than a repeat may have.
 */
export function withColourEdit(fabric: Fabric, action: ColourAction): Fabric {
  const family = requireOneOf("family", action.family, FAMILIES);
  const hexes = threadHexes(woven(fabric), family);
  return withHexes(fabric, family, recoloured(hexes, action));
}

function recoloured(hexes: readonly string[], action: ColourAction): readonly string[] {
  const name = `${action.family} colour`;
  switch (action.type) {
    case "colour/paint": {
      const painted = requireWhole("thread", action.thread, 0, hexes.length - 1);
      const to = requireHex(name, action.hex);
      return hexes.map((hex, thread) => (thread === painted ? to : hex));
    }
    case "colour/swap": {
      const to = requireHex(name, action.to);
      return hexes.map((hex) => (hex === action.from ? to : hex));
    }
    case "colour/order": {
      if (!Array.isArray(action.hexes)) throw new InputError("An order of colours is a list.");
      requireWhole("threads of the order", action.hexes.length, 1, MAXIMUM_THREADS);
      return action.hexes.map((hex) => requireHex(name, hex));
    }
  }
}

function withHexes(fabric: Fabric, family: FamilyName, hexes: readonly string[]): Fabric {
  const fields = withThreadHexes(fabric.fields, fabric.draft, family, hexes);
  return { ...fabric, fields };
}

/** Fabrics of the user's own that the browser keeps beside the gallery. */
import { nameOf, type Fabric } from "../state/document.ts";
import { fabricFromJson, fabricText, fabricToJson } from "../state/fabric_json.ts";
import { entriesOf, KeptList } from "./kept_list.ts";

export interface OwnFabric {
  /** No other has it. */
  readonly name: string;
  readonly fabric: Fabric;
}

/** Fabrics, and characters of all of them, at most: browsers keep some five million in all. */
const MAX_FABRICS = 100;
const MAX_TEXT = 1_500_000;

const kept = new KeptList("own", ownFabricsOf);

/** The kept fabrics, the last one first. */
export const ownFabrics = (): readonly OwnFabric[] => kept.entries;

/** The kept fabrics in a component, which follows them. */
export const useOwnFabrics = kept.use;

/** The fabrics of a text; what cannot be shown is left out. */
export function ownFabricsOf(text: string | null): OwnFabric[] {
  const found: OwnFabric[] = [];
  for (const each of entriesOf(text, MAX_FABRICS))
    try {
      const { name, fabric } = each as { readonly name: unknown; readonly fabric: unknown };
      if (typeof name === "string" && found.every((other) => other.name !== name)) found.push({ name, fabric: fabricFromJson(fabric) });
    } catch {
      // Of another version, or damaged.
    }
  return found;
}

/**
 * Keeps a fabric under its name, or that and a number where another has it.
 *
 * @returns why it is not kept, in a sentence; null where it is.
 */
export function keepFabric(fabric: Fabric): string | null {
  const others = ownFabrics();
  const text = fabricText(fabric);
  const same = others.find((other) => fabricText(other.fabric) === text);
  if (same !== undefined) return `It is kept already, as ${same.name}.`;
  if (others.length >= MAX_FABRICS) return `The page keeps ${MAX_FABRICS} fabrics: remove one first.`;
  const stem = nameOf(fabric);
  let name = stem;
  for (let number = 2; others.some((other) => other.name === name); number++) name = `${stem} ${number}`;
  const next = [{ name, fabric }, ...others];
  if (textOf(next).length > MAX_TEXT) return "There is no more room for so large a draft: remove fabrics, or save this one as a file.";
  if (!replace(next)) return "The browser keeps no more: save the fabric as a file.";
  return null;
}

export function removeFabric(name: string): void {
  replace(ownFabrics().filter((other) => other.name !== name));
}

const textOf = (fabrics: readonly OwnFabric[]): string => JSON.stringify(fabrics.map(({ name, fabric }) => ({ name, fabric: fabricToJson(fabric) })));

/** Puts other fabrics in their place, unless the browser does not keep them. */
function replace(next: readonly OwnFabric[]): boolean {
  if (!kept.keep(textOf(next))) return false;
  kept.show(next);
  return true;
}

/** Colour cards that the browser keeps: a house's own standards. */
import { InputError, MAX_CARD, readColourCard, type CardColour, type ColourCard } from "loomlight-fabric";

import { tableOf } from "../state/json_table.ts";
import { entriesOf, KeptList } from "./kept_list.ts";

/** Files that are colour cards. */
export const CARDS = /\.(ase|gpl|csv)$/i;
/** Cards at most. */
const MAX_CARDS = 30;
/** Bytes of a file at most: 5,000 colours take a tenth of that. */
const MAX_BYTES = 4 * 2 ** 20;

const kept = new KeptList("cards", cardsOf);

/** The cards at hand, the last one that was added first. */
export const cards = (): readonly ColourCard[] => kept.entries;

/** The cards at hand in a component, which follows them. */
export const useCards = kept.use;

/** The cards of a text; what cannot be one is left out. */
export function cardsOf(text: string | null): ColourCard[] {
  return entriesOf(text, MAX_CARDS).flatMap((each) => {
    const { name, colours } = tableOf(each);
    const readable = Array.isArray(colours) ? colours.slice(0, MAX_CARD).filter(isColour) : [];
    return typeof name === "string" && readable.length > 0 ? [{ name, colours: readable }] : [];
  });
}

function isColour(value: unknown): value is CardColour {
  const { name, hex } = tableOf(value);
  return typeof name === "string" && typeof hex === "string" && /^#[0-9a-f]{6}$/.test(hex);
}

/**
 * Adds the card of a file; one of the same name gives way.
 *
 * @returns what the user is told: a sentence each.
 * @throws InputError a file that is no card.
 */
export async function addCard(file: File): Promise<readonly string[]> {
  if (file.size > MAX_BYTES) throw new InputError(`${file.name} is larger than ${MAX_BYTES >> 20} MiB; no colour card is.`);
  const { card, warnings } = readColourCard(new Uint8Array(await file.arrayBuffer()), file.name);
  const others = cards().filter(({ name }) => name !== card.name);
  if (others.length >= MAX_CARDS) throw new InputError(`The page keeps ${MAX_CARDS} colour cards: remove one first.`);
  const isKept = replace([card, ...others]);
  return isKept ? warnings : [...warnings, `${file.name} is in use, but the browser keeps no more: it is gone when the page is closed.`];
}

export function removeCard(name: string): void {
  replace(cards().filter((card) => card.name !== name));
}

function replace(next: readonly ColourCard[]): boolean {
  kept.show(next);
  return kept.keep(JSON.stringify(next));
}

interface Index {
  readonly of: readonly ColourCard[];
  readonly byName: ReadonlyMap<string, CardColour>;
  readonly names: ReadonlyMap<string, string>;
}
let indexed: Index | null = null;

/** Colours by name, and names by hex; of several the one on the first card. */
function index(): Index {
  const of = cards();
  if (indexed?.of === of) return indexed;
  const byName = new Map<string, CardColour>();
  const names = new Map<string, string>();
  for (const { name: card, colours } of [...of].reverse())
    for (const colour of [...colours].reverse()) {
      byName.set(colour.name.toLowerCase(), colour);
      names.set(colour.hex, `${colour.name} (${card})`);
    }
  return (indexed = { of, byName, names });
}

/** The colour of a card that is called so, whatever its capitals; null where none is. */
export function colourNamed(text: string): CardColour | null {
  return index().byName.get(text.trim().toLowerCase()) ?? null;
}

/** What cards call a colour; empty where none has it. */
export function nameOfColour(hex: string): string {
  return index().names.get(hex) ?? "";
}

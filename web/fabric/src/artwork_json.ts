/** Artworks as JSON, as the page keeps them and the server sends them (`src/loomlight/viewer/messages.py`). */
import { plainHex } from "./artwork_fields.ts";
import type { Artwork } from "./artwork.ts";
import { MAXIMUM_THREADS, type Structure } from "./draft.ts";
import { InputError } from "./errors.ts";
import { MAX_COLOURS } from "./generated.ts";
import { bitsToText, textToBits } from "./json.ts";
import type { ArtworkJson } from "./messages.ts";

/** The artwork as JSON. */
export function artworkToJson({ ends, rows, colours, index, drafts }: Artwork): ArtworkJson {
  const drawn = Object.entries(drafts).map(([name, { ends: across, picks, drawdown }]) => ({ name, ends: across, picks, drawdown: bitsToText(drawdown) }));
  return { ends, rows, colours: [...colours], runs: runsToText(index), drafts: drawn };
}

/**
 * The artwork of its JSON.
 *
 * @throws InputError values that are none of an artwork, or that do not belong together.
 */
export function artworkFromJson(given: unknown): Artwork {
  const { ends, rows, colours, runs, drafts = [] } = tableOf(given) as Partial<Record<keyof ArtworkJson, unknown>>;
  if (!isCount(ends) || !isCount(rows)) throw new InputError(`artwork.ends and artwork.rows are no whole numbers from 1 to ${MAXIMUM_THREADS}.`);
  const isColour = (colour: unknown): boolean => typeof colour === "string" && /^#[0-9a-f]{6}$/.test(colour) && plainHex(colour) === colour;
  if (!Array.isArray(colours) || colours.length < 1 || colours.length > MAX_COLOURS || !colours.every(isColour))
    throw new InputError(`artwork.colours lists no 1 to ${MAX_COLOURS} colours, "#rrggbb".`);
  if (typeof runs !== "string") throw new InputError("artwork.runs is no base64.");
  if (!Array.isArray(drafts)) throw new InputError("artwork.drafts is no list.");
  const named = drafts.map((draft: unknown): [string, Structure] => structureFromJson(tableOf(draft)));
  return { ends, rows, colours: colours as string[], index: textToRuns(runs, rows * ends, colours.length), drafts: Object.fromEntries(named) };
}

function structureFromJson({ name, ends, picks, drawdown }: Readonly<Record<string, unknown>>): [string, Structure] {
  if (typeof name !== "string" || !isCount(ends) || !isCount(picks) || typeof drawdown !== "string")
    throw new InputError("artwork.drafts holds a draft without a name, ends, picks or a drawdown.");
  return [name, { ends, picks, drawdown: textToBits(drawdown, ends * picks) }];
}

function tableOf(value: unknown): Readonly<Record<string, unknown>> {
  if (typeof value === "object" && value !== null && !Array.isArray(value)) return value as Readonly<Record<string, unknown>>;
  throw new InputError("the artwork is missing.");
}

function isCount(value: unknown): value is number {
  return typeof value === "number" && Number.isInteger(value) && 1 <= value && value <= MAXIMUM_THREADS;
}

/** Base64 of runs of equal values: a byte of the value, and the length in groups of 7 bits, the lowest first. */
function runsToText(index: Uint8Array): string {
  const parts: string[] = [];
  for (let at = 0; at < index.length; ) {
    const value = index[at]!;
    let length = 1;
    while (index[at + length] === value) length++;
    at += length;
    parts.push(String.fromCharCode(value));
    for (; length >= 128; length = Math.floor(length / 128)) parts.push(String.fromCharCode((length % 128) | 128));
    parts.push(String.fromCharCode(length));
  }
  return btoa(parts.join(""));
}

/**
 * `count` values, below `most`, of their runs.
 *
 * @throws InputError other than so many of them, or no base64.
 */
function textToRuns(text: string, count: number, most: number): Uint8Array {
  let binary: string;
  try {
    binary = atob(text);
  } catch {
    throw new InputError("artwork.runs is no base64.");
  }
  const index = new Uint8Array(count);
  let filled = 0;
  for (let at = 0; at < binary.length; ) {
    const value = binary.charCodeAt(at++);
    let [length, group] = [0, 0];
    for (let more = true; more; group++) {
      const byte = at < binary.length ? binary.charCodeAt(at++) : 0;
      length += (byte % 128) * 128 ** group;
      more = byte >= 128;
    }
    if (value >= most || length < 1 || filled + length > count) throw new InputError(`artwork.runs does not hold ${count} pixels of ${most} colours.`);
    index.fill(value, filled, filled + length);
    filled += length;
  }
  if (filled !== count) throw new InputError(`artwork.runs does not hold ${count} pixels of ${most} colours.`);
  return index;
}

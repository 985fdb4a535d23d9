/**
 * Artwork whose colours are weaves, as jacquard cloth is designed; see `weave/artwork.py`.
 *
 * One pixel is one end and one round of the wefts: a pick of each in turn, or in an order that is given. Weaves repeat
 * over the whole artwork, from its lower left corner. Floats that grow too long where areas meet are bound.
 */
import { orderText, weaveLists, weftOrder } from "./artwork_fields.ts";
import { bindFloats } from "./binding.ts";
import { parseColour } from "./colour.ts";
import { makeDraft, MAXIMUM_THREADS, PLAIN_THREADS, type Draft, type Structure } from "./draft.ts";
import { InputError } from "./errors.ts";
import { BACK_WEAVE, MAX_COLOURS, WEFT_COLOURS, type FabricFields } from "./generated.ts";
import { namedWeave } from "./named.ts";
import { gcd, lcm } from "./numbers.ts";
import { fromPalette, WARP_COLOUR } from "./palette.ts";
import { threadsPerCm } from "./spacing.ts";
import { DEFAULT_SETT_PER_CM } from "./textile.ts";

/** A picture of few colours, which are places of weaves. */
export interface Artwork {
  /** Columns of its pixels, and rows. */
  readonly ends: number;
  readonly rows: number;
  /** "#rrggbb" in small letters, at most 255. */
  readonly colours: readonly string[];
  /** Which of them each pixel has [rows·ends], the bottom row first. */
  readonly index: Uint8Array;
  /** Drawdowns of drafts' files that [weaves] names, by those names. */
  readonly drafts: Readonly<Record<string, Structure>>;
}

/** What follows from an artwork's weaves before it is woven. */
export interface ArtworkFacts {
  readonly wefts: number;
  /** Threads that a float may pass where areas meet. */
  readonly longestFloat: number;
  /** In a sentence, a weave that does not divide the artwork, which is cut where it repeats; null for none. */
  readonly cut: string | null;
}

/** An artwork as cloth. */
export interface WovenArtwork extends ArtworkFacts {
  /** Without colours if there is one weft; several have a colour each (`colorIndex` 1, 2 …). */
  readonly draft: Draft;
}

/** A weave for each colour and weft; null for a weft that lies free on the back, under every end. */
type Weaves = readonly (readonly (Structure | null)[])[];

/** Picks and ends over which the floats of a colour's own weaves are looked at. */
const OWN_THREADS = 4096;
const MM_PER_CM = 10;
/** By how much of its length a float may be longer where areas meet than anywhere within them. */
const LONGER = 1 / 3;
/** A draft of another program, or a picture of a drawdown, in place of a weave's name. */
export const DRAFT_FILE = /\.(wif|dtx|wpo|twa|png|jpe?g|tiff?|bmp|gif)$/i;

/**
 * The cloth of an artwork.
 *
 * @param file the picture's name, for messages and the draft's name.
 * @throws InputError a colour without a weave, an unknown weave, an order that is none, too many picks, or a float that
 *   cannot be bound.
 */
export function weaveArtwork(artwork: Artwork, fields: FabricFields, file: string): WovenArtwork {
  const plan = planOf(artwork, fields);
  const { lists, structures, cycle, extraFrom } = plan;
  const { ends, rows } = artwork;
  if (Math.max(ends, rows * cycle.length) > MAXIMUM_THREADS)
    throw new InputError(
      `${file} has ${ends} x ${rows} pixels, and each row is ${cycle.length} picks: that is ${ends} ends and ` +
        `${rows * cycle.length} picks, and at most ${MAXIMUM_THREADS} of each can be used.`,
    );
  const weaveOf = weavesByColour(artwork, [...lists.keys()], fields.artwork?.nearest ?? false, file);
  const places = weaveOf.map((weave) => structures[weave]!);
  const all = wovenOf(artwork, places, cycle);
  let [structure, loose]: [Structure, Uint8Array | null] = [all, looseOf(artwork, places, cycle)];
  let weftOf = Int32Array.from({ length: all.picks }, (_, pick) => cycle[pick % cycle.length]!);
  let spacingMm: Float64Array | null = null;
  if (extraFrom !== null) {
    const kept = keptPicks(all, loose, (pick) => weftOf[pick]! >= extraFrom - 1);
    spacingMm = regulatedSpacing(weftOf, kept, extraFrom, cycle.length, MM_PER_CM / rowsPerCm(fields));
    structure = { ends, picks: kept.length, drawdown: rowsOf(all.drawdown, ends, kept) };
    loose = loose === null ? null : rowsOf(loose, ends, kept);
    weftOf = Int32Array.from(kept, (pick) => weftOf[pick]!);
  }
  const facts = factsOf(artwork, plan, fields, file);
  bindFloats(structure, facts.longestFloat, loose);
  return { draft: draftOf(structure, weftOf, facts.wefts, spacingMm, stemOf(file)), ...facts };
}

/**
 * What follows from an artwork's weaves before it is woven; see `weaveArtwork`.
 *
 * @throws InputError an unknown weave, or an order that is none.
 */
export function artworkFacts(artwork: Artwork, fields: FabricFields, file: string): ArtworkFacts {
  return factsOf(artwork, planOf(artwork, fields), fields, file);
}

/** What [weaves] and [artwork] say. */
interface Plan {
  /** Names of weaves by colour, one a weft. */
  readonly lists: ReadonlyMap<string, readonly string[]>;
  readonly structures: Weaves;
  /** 0-based weft of each pick of a row. */
  readonly cycle: readonly number[];
  /** The first weft, from 1, that adds nothing to the length of the cloth; null for none. */
  readonly extraFrom: number | null;
}

function planOf({ drafts }: Artwork, fields: FabricFields): Plan {
  const lists = weaveLists(fields.weaves ?? {});
  const structures = structuresOf(lists, drafts);
  const order = fields.artwork?.order === undefined ? [] : weftOrder(fields.artwork.order, "artwork.order");
  const extraFrom = fields.artwork?.regulator ?? null;
  requireWeavable([...lists.keys()], structures, order, extraFrom);
  const cycle = order.length > 0 ? order.map((weft) => weft - 1) : structures[0]!.map((_, weft) => weft);
  return { lists, structures, cycle, extraFrom };
}

function factsOf(artwork: Artwork, { lists, structures, cycle }: Plan, fields: FabricFields, file: string): ArtworkFacts {
  return {
    wefts: structures[0]!.length,
    longestFloat: fields.artwork?.longest_float ?? ownLimit(structures, cycle),
    cut: cutOf(artwork, lists, structures, cycle, file),
  };
}

/** A file's name without folders and suffix. */
function stemOf(file: string): string {
  return file.replace(/^.*[/\\]/, "").replace(/(?!^)\.[^.]*$/, "");
}

/**
 * The drawdowns that [weaves] names, by colour and weft.
 *
 * @throws InputError one that is no weave, or a draft's file that is not at hand; the message names its colour.
 */
function structuresOf(lists: ReadonlyMap<string, readonly string[]>, drafts: Artwork["drafts"]): Weaves {
  const found = new Map<string, Structure | null>();
  for (const [colour, listed] of lists)
    for (const name of listed) if (!found.has(name)) found.set(name, structureOfName(name, colour, drafts));
  return [...lists.values()].map((listed) => listed.map((name) => found.get(name)!));
}

function structureOfName(name: string, colour: string, drafts: Artwork["drafts"]): Structure | null {
  if (name.trim().toLowerCase() === BACK_WEAVE) return null;
  if (Object.hasOwn(drafts, name)) return drafts[name]!;
  if (DRAFT_FILE.test(name))
    throw new InputError(`weaves."${colour}" = "${name.slice(0, 80)}" is a draft that is not at hand: open it together with the artwork, or name a weave.`);
  try {
    return namedWeave(name);
  } catch (error) {
    throw error instanceof InputError ? new InputError(`weaves."${colour}": ${error.message}`) : error;
  }
}

/** Raises InputError unless each colour binds a weft, the order names each, and not all are extra ones. */
function requireWeavable(colours: readonly string[], structures: Weaves, order: readonly number[], extraFrom: number | null): void {
  if (colours.length === 0) throw new InputError("the artwork has no weaves: give each of its colours one.");
  const free = structures.findIndex((weaves) => weaves.every((weave) => weave === null));
  if (free >= 0)
    throw new InputError(
      `weaves."${colours[free]!}" leaves every weft on the back, so that nothing binds the warp: give one of them a weave.`,
    );
  const wefts = structures[0]!.length;
  const named = new Set(order);
  if (order.length > 0 && (named.size !== wefts || Math.max(...named) !== wefts))
    throw new InputError(
      `artwork.order = "${orderText(order)}" does not fit ${wefts} weft${wefts === 1 ? "" : "s"}: it names each of 1 to ` +
        `${wefts}, and no other, as weaves has one a weft.`,
    );
  if (extraFrom !== null && !(2 <= extraFrom && extraFrom <= wefts))
    throw new InputError(
      `artwork.regulator = ${extraFrom} is none of the ${wefts} wefts of weaves: the cloth is taken up by those before ` +
        "it, at least the first, and stands still for it and later ones.",
    );
}

// ------------------------------------------------------------------------------------------------------- colours

/**
 * Of each of the artwork's colours, which of the colours with a weave it is.
 *
 * @throws InputError one that has no weave, if not the `nearest` is taken.
 */
function weavesByColour({ colours, index }: Artwork, named: readonly string[], nearest: boolean, file: string): number[] {
  const codes = named.map(codeOf);
  const found = colours.map((colour) => named.indexOf(colour));
  if (found.every((weave) => weave >= 0)) return found;
  const pixels = pixelsOf(index, colours.length);
  // Colours that no pixel has any more need no weave.
  const strange = found.flatMap((weave, at) => (weave < 0 && pixels[at]! > 0 ? [at] : []));
  if (strange.length > 0 && !nearest) throw unnamed(file, named, new Map(strange.map((at) => [codeOf(colours[at]!), pixels[at]!])));
  return found.map((weave, at) => (weave >= 0 ? weave : nearestOf(codeOf(colours[at]!), codes)));
}

/** How many pixels have each of so many colours. */
export function pixelsOf(index: Uint8Array, colours: number): number[] {
  const counts = Array<number>(colours).fill(0);
  for (const colour of index) counts[colour]!++;
  return counts;
}

/** A colour as a number of 24 bits. */
export const codeOf = (hex: string): number => parseInt(hex.slice(1), 16);
/** The colour of a number of 24 bits. */
export const hexOfCode = (code: number): string => `#${code.toString(16).padStart(6, "0")}`;

/** The nearest of some colours, by distance in sRGB. */
export function nearestOf(code: number, codes: readonly number[]): number {
  const away = (other: number): number =>
    [16, 8, 0].reduce((sum, shift) => sum + (((code >> shift) & 255) - ((other >> shift) & 255)) ** 2, 0);
  let [best, distance] = [0, Infinity];
  for (const [at, other] of codes.entries()) if (away(other) < distance) [best, distance] = [at, away(other)];
  return best;
}

/** A sentence about the colour without a weave that most pixels have; `others` are pixels by colour. */
export function unnamed(file: string, named: readonly string[], others: ReadonlyMap<number, number>): InputError {
  const [most, pixels] = [...others].reduce((a, b) => (b[1] > a[1] || (b[1] === a[1] && b[0] < a[0]) ? b : a));
  const near = named[nearestOf(most, named.map(codeOf))]!;
  const beside = others.size > 1 ? `, and ${others.size - 1} more colours without a weave` : "";
  const advice =
    others.size > MAX_COLOURS - named.length
      ? "reduce the picture to few colours without smoothing (an indexed PNG)"
      : "give it a weave, or paint them so";
  return new InputError(
    `${file} has ${pixels} pixels of "${hexOfCode(most)}"${beside}; weaves names no such colour, and "${near}" is ` +
      `nearest: ${advice}, or let nearest = true in [artwork] take the nearest.`,
  );
}

// ------------------------------------------------------------------------------------------------------- weaving

/** The structures of all colours and wefts, each where it belongs. */
function wovenOf({ ends, rows, index }: Pick<Artwork, "ends" | "rows" | "index">, places: Weaves, cycle: readonly number[]): Structure {
  const picks = rows * cycle.length;
  const drawdown = new Uint8Array(picks * ends);
  const counts = cycle.map((weft) => cycle.filter((other) => other === weft).length);
  const before = cycle.map((weft, place) => cycle.slice(0, place).filter((other) => other === weft).length);
  for (let row = 0; row < rows; row++)
    for (const [place, weft] of cycle.entries()) {
      // Of its own picks, which one this is.
      const own = row * counts[place]! + before[place]!;
      const lines = places.map((weaves) => lineOf(weaves[weft] ?? null, own));
      const first = (row * cycle.length + place) * ends;
      for (let end = 0; end < ends; end++) {
        const line = lines[index[row * ends + end]!]!;
        drawdown[first + end] = line[end % line.length]!;
      }
    }
  return { ends, picks, drawdown };
}

const UNDER_ALL = Uint8Array.of(1);

/** The crossings of one pick of a weave; a weft on the back has the warp on top everywhere. */
function lineOf(weave: Structure | null, pick: number): Uint8Array {
  if (weave === null) return UNDER_ALL;
  const first = (pick % weave.picks) * weave.ends;
  return weave.drawdown.subarray(first, first + weave.ends);
}

/** Where wefts lie free on the back [picks·ends]; null for nowhere. */
function looseOf({ ends, rows, index }: Artwork, places: Weaves, cycle: readonly number[]): Uint8Array | null {
  if (places.every((weaves) => weaves.every((weave) => weave !== null))) return null;
  const loose = new Uint8Array(rows * cycle.length * ends);
  for (const [place, weft] of cycle.entries()) {
    const free = places.map((weaves) => (weaves[weft] === null ? 1 : 0));
    for (let row = 0; row < rows; row++) {
      const first = (row * cycle.length + place) * ends;
      for (let end = 0; end < ends; end++) loose[first + end] = free[index[row * ends + end]!]!;
    }
  }
  return loose;
}

/** The picks that are woven: extra ones that lie on the back all the way are not. */
function keptPicks({ picks, ends }: Structure, loose: Uint8Array | null, isExtra: (pick: number) => boolean): number[] {
  const isFree = (pick: number): boolean => loose !== null && !loose.subarray(pick * ends, (pick + 1) * ends).includes(0);
  return Array.from({ length: picks }, (_, pick) => pick).filter((pick) => !(isExtra(pick) && isFree(pick)));
}

function rowsOf(table: Uint8Array, ends: number, rows: readonly number[]): Uint8Array {
  const found = new Uint8Array(rows.length * ends);
  for (const [at, row] of rows.entries()) found.set(table.subarray(row * ends, (row + 1) * ends), at * ends);
  return found;
}

/** Spacing of the picks that are kept, millimetres: those of a row share what its ground picks take up. */
function regulatedSpacing(weftOf: Int32Array, kept: readonly number[], extraFrom: number, picksARow: number, groundMm: number): Float64Array {
  const ground = weftOf.subarray(0, picksARow).filter((weft) => weft < extraFrom - 1).length;
  const shared = new Int32Array(weftOf.length / picksARow);
  const rowOf = (pick: number): number => Math.floor(pick / picksARow);
  for (const pick of kept) shared[rowOf(pick)]!++;
  return Float64Array.from(kept, (pick) => (groundMm * ground) / shared[rowOf(pick)]!);
}

/** Rows of an artwork per centimetre: the picks that take up cloth, square where the fields do not say. */
function rowsPerCm(fields: FabricFields): number {
  return threadsPerCm(fields, "weft") ?? threadsPerCm(fields, "warp") ?? DEFAULT_SETT_PER_CM;
}

/** A third more than the longest float within any area; floats that are never bound there do not count. */
function ownLimit(structures: Weaves, cycle: readonly number[]): number {
  let longest = 1;
  for (const weaves of structures) {
    const bound = weaves.flatMap((weave, weft) => (weave === null ? [] : [{ weave, count: cycle.filter((other) => other === weft).length }]));
    const rows = bound.reduce((repeat, { weave, count }) => cappedLcm(repeat, weave.picks / gcd(weave.picks, count), Math.max(1, Math.floor(OWN_THREADS / cycle.length))), 1);
    const ends = bound.reduce((repeat, { weave }) => cappedLcm(repeat, weave.ends, OWN_THREADS), 1);
    const alone = wovenOf({ ends, rows, index: new Uint8Array(rows * ends) }, [weaves], cycle);
    for (let end = 0; end < ends; end++) longest = Math.max(longest, longestFloat(alone.drawdown, end, ends, alone.picks));
    for (let pick = 0; pick < alone.picks; pick++)
      if (weaves[cycle[pick % cycle.length]!] !== null) longest = Math.max(longest, longestFloat(alone.drawdown, pick * ends, 1, ends));
  }
  return longest + Math.ceil(LONGER * longest);
}

/** The least common multiple, or `cap` where it is larger. */
function cappedLcm(a: number, b: number, cap: number): number {
  return a >= cap ? cap : Math.min(lcm(a, b), cap);
}

/** The longest run of equal crossings of a thread that repeats, 0 of one that never changes. */
function longestFloat(drawdown: Uint8Array, first: number, step: number, count: number): number {
  let [longest, begin, start] = [0, -1, -1];
  for (let index = 0; index < count; index++) {
    if (drawdown[first + index * step] === drawdown[first + ((index + count - 1) % count) * step]) continue;
    if (start < 0) begin = index;
    else longest = Math.max(longest, index - start);
    start = index;
  }
  return start < 0 ? 0 : Math.max(longest, begin + count - start);
}

/** A sentence about the first weave whose repeat does not divide the artwork; null for none. */
function cutOf({ ends, rows }: Artwork, lists: ReadonlyMap<string, readonly string[]>, structures: Weaves, cycle: readonly number[], file: string): string | null {
  const names = [...lists.values()];
  for (const [colour, weaves] of structures.entries())
    for (const [weft, weave] of weaves.entries()) {
      if (weave === null) continue;
      const picks = rows * cycle.filter((other) => other === weft).length;
      for (const [name, count, repeat] of [["ends", ends, weave.ends], ["picks", picks, weave.picks]] as const)
        if (count % repeat > 0)
          return (
            `${file} has ${count} ${name}, and "${names[colour]![weft]!}" repeats over ${repeat}: it is cut where the ` +
            `artwork repeats; ${count - (count % repeat)} or ${count - (count % repeat) + repeat} would do.`
          );
    }
  return null;
}

function draftOf(structure: Structure, weftOf: Int32Array, wefts: number, spacingMm: Float64Array | null, name: string): Draft {
  if (wefts === 1) return makeDraft(structure, { name, weft: { ...PLAIN_THREADS, spacingMm } });
  const palette = Float64Array.from([WARP_COLOUR, ...WEFT_COLOURS.slice(0, wefts)].flatMap((hex) => parseColour(hex, "weft")));
  const order = Array.from(weftOf, (weft) => weft + 1);
  return makeDraft(structure, {
    name,
    warp: fromPalette(structure.ends, [0], palette),
    weft: { ...fromPalette(structure.picks, order, palette), spacingMm },
    palette,
  });
}

/**
 * The text of a weaving information file: decoded, split into sections, and complained about.
 *
 * The format is that of Windows .ini files. Programs write it with any line ends and encodings, with words before
 * the first section, with values that are empty or lack their "=": all of that is read.
 */
import { InputError, type Warn } from "./errors.ts";

/** Bytes of a file that is read at most. */
export const MAXIMUM_BYTES = 64 * 2 ** 20;
const SHOWN = 60;

/** One section: its name as the file spells it, and its lines in order. */
export interface Section {
  readonly spelled: string;
  readonly lines: [string, string | null][];
}

/** The sections of a file by name: capitals, single spaces. */
export class WifText {
  readonly file: string;
  readonly sections: ReadonlyMap<string, Section>;
  private readonly values: ReadonlyMap<string, ReadonlyMap<string, readonly [string, string]>>;
  /** Receives whole sentences. */
  readonly report: Warn;

  constructor(file: string, sections: ReadonlyMap<string, Section>, warn: Warn) {
    this.file = file;
    this.sections = sections;
    this.report = warn;
    this.values = byKey(file, sections, warn);
  }

  has(section: string): boolean {
    return this.sections.has(section);
  }

  /** The value, or "" if the file does not say. */
  value(section: string, key: string): string {
    return this.values.get(section)?.get(key.toUpperCase())?.[1] ?? "";
  }

  /** Keys and values of a section, empty values included. */
  items(section: string): (readonly [string, string])[] {
    return [...(this.values.get(section)?.values() ?? [])];
  }

  /** The error for a value: file, section, key, value, and `what` is wrong and would be right. */
  fault(section: string, key: string, value: string, what: string): InputError {
    return new InputError(`${this.file}: ${place(section, key, value)} ${what}.`);
  }

  /** The same as a warning, for what can be used all the same. */
  warn(section: string, key: string, value: string, what: string): void {
    this.report(`${this.file}: ${place(section, key, value)} ${what}.`);
  }
}

function place(section: string, key: string, value: string): string {
  return `[${section}] ${shortened(key)}=${shortened(value)}`;
}

/** A value as messages show it: printable, and not long. */
export function shortened(text: string): string {
  const printable = text.slice(0, SHOWN + 1).replace(/[\p{C}\p{Zl}\p{Zp}]/gu, "?");
  return printable.length <= SHOWN ? printable : `${printable.slice(0, SHOWN)}…`;
}

/**
 * Text in UTF-16 or UTF-8 if marked or valid, otherwise in Windows-1252, which older programs write.
 *
 * NULs and marks of byte order are left out. A Ctrl-Z, which ends a text under DOS, ends it unless a section follows.
 */
export function decodeWif(content: Uint8Array): string {
  const text = decoded(content).replace(/[\0\ufeff]/g, "");
  const end = text.indexOf("\x1a");
  if (end < 0) return text;
  return text.indexOf("[", end) < 0 ? text.slice(0, end) : text.replaceAll("\x1a", " ");
}

function decoded(content: Uint8Array): string {
  const utf16 = utf16Of(content);
  // A single byte that was added at the end, such as a Ctrl-Z, is half a character.
  if (utf16 !== null) return new TextDecoder(utf16).decode(content.subarray(0, content.length & ~1));
  // What lies behind the end of a text may be any bytes.
  const end = content.indexOf(0x1a);
  const text = end < 0 || content.indexOf(0x5b, end) >= 0 ? content : content.subarray(0, end);
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(text);
  } catch {
    return new TextDecoder("windows-1252").decode(text);
  }
}

/** The byte order of UTF-16, by its mark or by NULs in one half of the bytes; null of other text. */
function utf16Of(content: Uint8Array): "utf-16le" | "utf-16be" | null {
  if (content[0] === 0xff && content[1] === 0xfe) return "utf-16le";
  if (content[0] === 0xfe && content[1] === 0xff) return "utf-16be";
  // NULs that fill up the end lie in both halves.
  let length = content.length;
  while (length > 0 && (content[length - 1] === 0 || content[length - 1] === 0x1a)) length--;
  const nuls: [number, number] = [0, 0];
  for (let at = 0; at < length; at++) if (content[at] === 0) nuls[at % 2]! += 1;
  const [even, odd] = nuls;
  if (length === 0 || Math.max(even, odd) < Math.max(length / 16, 1.5 * Math.min(even, odd))) return null;
  return odd > even ? "utf-16le" : "utf-16be";
}

/**
 * The sections of `text`; `file` is what messages call it.
 *
 * Text before the first section of a draft is passed over. Some programs leave out the line [WIF] alone: the keys of
 * that section, which then come first, are read all the same.
 *
 * @throws InputError no section of a draft.
 */
export function parseWifText(text: string, file: string, warn: Warn): WifText {
  let sections = new Map<string, Section>();
  const headless: Section = { spelled: "WIF", lines: [] };
  let current: Section | null = null;
  let isPrivate = false;
  for (const raw of text.split(/\r\n|\r|\n/)) {
    const line = raw.trim();
    const header = /^\[([^\]]*)\]/.exec(line)?.[1];
    if (header !== undefined && (current !== null || KNOWN_SECTIONS.has(sectionName(header)))) {
      const name = sectionName(header);
      current = sections.get(name) ?? { spelled: header.trim(), lines: [] };
      sections.set(name, current);
      isPrivate = name.startsWith("PRIVATE");
    } else if (line !== "" && !line.startsWith(";") && (isPrivate || !line.startsWith("#"))) {
      const equals = line.indexOf("=");
      const key = (equals < 0 ? line : line.slice(0, equals)).trim();
      if (current !== null) current.lines.push([key, equals < 0 ? null : line.slice(equals + 1).trim()]);
      else if (equals >= 0 && WIF_KEYS.has(key.toUpperCase()))
        headless.lines.push([key, line.slice(equals + 1).trim()]);
    }
  }
  if (sections.size === 0)
    throw new InputError(
      `${file} is no weaving information file: it has none of the sections of one, such as [WIF], [THREADING] or ` +
        "[LIFTPLAN].",
    );
  if (!sections.has("WIF")) {
    warn(
      `${file} has no section [WIF], which every weaving information file begins with; its other sections are read.`,
    );
    if (headless.lines.length > 0) sections = new Map([["WIF", headless], ...sections]);
  }
  return new WifText(file, sections, warn);
}

/** A section's name in capitals with single spaces. */
export function sectionName(spelled: string): string {
  return spelled.replaceAll("_", " ").toUpperCase().split(/\s+/).filter(Boolean).join(" ");
}

function byKey(
  file: string,
  sections: ReadonlyMap<string, Section>,
  warn: Warn,
): ReadonlyMap<string, ReadonlyMap<string, readonly [string, string]>> {
  const values = new Map<string, Map<string, readonly [string, string]>>();
  for (const [name, section] of sections) {
    const table = new Map<string, readonly [string, string]>();
    const several = new Map<string, string[]>();
    values.set(name, table);
    for (const [key, value] of section.lines) {
      const folded = foldedKey(key);
      const earlier = table.get(folded);
      if (earlier !== undefined && earlier[1] !== (value ?? "") && DRAFT_SECTIONS.has(name)) {
        const found = several.get(folded) ?? [earlier[1]];
        found.push(value ?? "");
        several.set(folded, found);
      }
      table.set(folded, [key, value ?? ""]);
    }
    const isOfSets = SECTIONS_OF_SETS.has(name);
    if (isOfSets)
      for (const [folded, found] of several)
        table.set(folded, [table.get(folded)![0], found.map((value) => value.split(";")[0]!).join(",")]);
    const first = [...several][0];
    if (first === undefined) continue;
    const [folded, found] = first;
    const times = found.length === 2 ? "twice" : `${found.length} times`;
    const others = several.size > 1 ? `, and ${several.size - 1} other keys are too` : "";
    warn(
      `${file}: [${name}] ${shortened(table.get(folded)![0])} is there ${times}, as '${shortened(found[0]!)}' and as ` +
        `'${shortened(found.at(-1)!)}'${others}; ${isOfSets ? "all of them are" : "the latter is"} used.`,
    );
  }
  return values;
}

/** Capitals; numbers without leading zeros, so that "07" and "7" are one thread. */
function foldedKey(key: string): string {
  const folded = key.toUpperCase();
  return /^[0-9]+$/.test(folded) ? folded.replace(/^0+(?=[0-9])/, "") : folded;
}

/** Sections whose values are sets: programs that write one member a line repeat the key. */
const SECTIONS_OF_SETS: ReadonlySet<string> = new Set(["THREADING", "TIEUP", "TREADLING", "LIFTPLAN"]);
const DRAFT_SECTIONS: ReadonlySet<string> = new Set([
  ...SECTIONS_OF_SETS,
  "WEAVING",
  "WARP",
  "WEFT",
  "COLOR PALETTE",
  "COLOR TABLE",
  ...["WARP", "WEFT"].flatMap((family) => ["COLORS", "SPACING", "THICKNESS"].map((what) => `${family} ${what}`)),
]);
/** Sections of the specification, one of which begins a draft. */
const KNOWN_SECTIONS: ReadonlySet<string> = new Set(["WIF", "CONTENTS", "TEXT", "NOTES", ...DRAFT_SECTIONS]);
const WIF_KEYS: ReadonlySet<string> = new Set(["VERSION", "DATE", "DEVELOPERS", "SOURCE PROGRAM", "SOURCE VERSION"]);

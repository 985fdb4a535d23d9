/** Colour cards: a house's standards with their names, of Adobe Swatch Exchange, GIMP palettes and tables (CSV). */
import { labToLinear, parseColour, toHex, type White } from "./colour.ts";
import { csvRows } from "./csv.ts";
import { InputError } from "./errors.ts";

export interface CardColour {
  readonly name: string;
  /** sRGB, "#rrggbb". */
  readonly hex: string;
}

export interface ColourCard {
  readonly name: string;
  readonly colours: readonly CardColour[];
}

/** A card, and what a sentence each says of colours that are not what the file has. */
export interface ReadCard {
  readonly card: ColourCard;
  readonly warnings: readonly string[];
}

/** Colours of a card at most: large books of standards have some 3,000. */
export const MAX_CARD = 5000;
const MAX_NAME = 80;
/** A channel further outside [0, 1] than rounding to 8 bits. */
const OUTSIDE = 0.5 / 255;

/**
 * The card of a file: `.ase`, `.gpl` or a table, by its name's ending.
 *
 * @throws InputError what is wrong in it, and where.
 */
export function readColourCard(bytes: Uint8Array, file: string): ReadCard {
  const stem = clean(file.replace(/\.[^.]*$/, "")) || "Colours";
  const reader = new Collector(file);
  const read = /\.ase$/i.test(file) ? readAse(bytes, reader) : /\.gpl$/i.test(file) ? readGpl(textOf(bytes), reader) : readTable(textOf(bytes), reader);
  return reader.finished(read ?? stem);
}

/** Takes colours, and counts those that cannot be as they are written. */
class Collector {
  private readonly colours: CardColour[] = [];
  private outside = 0;
  private inks = 0;

  private readonly file: string;

  constructor(file: string) {
    this.file = file;
  }

  fault(text: string): InputError {
    return new InputError(`${this.file}: ${text}`);
  }

  add(name: string, hex: string): void {
    if (this.colours.length >= MAX_CARD) throw this.fault(`it has more than ${MAX_CARD} colours; divide it into cards.`);
    this.colours.push({ name: clean(name) || hex, hex });
  }

  addLinear(name: string, linear: readonly number[]): void {
    if (linear.some((channel) => channel < -OUTSIDE || channel > 1 + OUTSIDE)) this.outside++;
    this.add(name, toHex(linear));
  }

  addLab(name: string, lab: readonly [number, number, number], white: White, where: string): void {
    const [lightness, a, b] = lab;
    if (!(lightness >= 0 && lightness <= 100 && Math.abs(a) <= 150 && Math.abs(b) <= 150))
      throw this.fault(`${where}: L = ${lightness}, a = ${a}, b = ${b} is no colour; L is 0 to 100, a and b are -150 to 150.`);
    this.addLinear(name, labToLinear(lab, white));
  }

  leaveInk(): void {
    this.inks++;
  }

  finished(name: string): ReadCard {
    if (this.colours.length === 0)
      throw this.fault(
        this.inks > 0 ? "its colours are amounts of ink (CMYK), which have no colour without a press's profile; save them as Lab or RGB." : "it has no colours.",
      );
    const warnings: string[] = [];
    if (this.inks > 0) warnings.push(`${this.file}: ${this.inks} colours are amounts of ink (CMYK), which have no colour without a press's profile; they are left out.`);
    if (this.outside > 0) warnings.push(`${this.file}: ${this.outside} colours lie outside sRGB; the nearest in each channel stand for them.`);
    return { card: { name, colours: this.colours }, warnings };
  }
}

const clean = (text: string): string => text.replace(/[\u0000-\u001f\u007f]+/g, " ").trim().slice(0, MAX_NAME);

function textOf(bytes: Uint8Array): string {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("windows-1252").decode(bytes);
  }
}

const GROUP_START = 0xc001;
const COLOUR_ENTRY = 0x0001;

/** Blocks of type, length and content; numbers have their high byte first. Lab is relative to D50, as Adobe's programs have it. */
function readAse(bytes: Uint8Array, reader: Collector): string | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 12 || String.fromCharCode(...bytes.subarray(0, 4)) !== "ASEF") throw reader.fault('it is no Adobe Swatch Exchange file: it does not begin with "ASEF".');
  const blocks = view.getUint32(8);
  let group: string | null = null;
  let at = 12;
  for (let block = 1; block <= blocks; block++) {
    const ends = at + 6 <= bytes.length ? at + 6 + view.getUint32(at + 2) : Infinity;
    if (ends > bytes.length) throw reader.fault(`it ends within block ${block} of ${blocks}: save or copy it again.`);
    const content = new DataView(bytes.buffer, bytes.byteOffset + at + 6, ends - at - 6);
    const kind = view.getUint16(at);
    try {
      if (kind === GROUP_START) group ??= nameAt(content).name || null;
      else if (kind === COLOUR_ENTRY) addAse(content, reader, `block ${block}`);
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      throw reader.fault(`block ${block} of ${blocks} is shorter than its colour: save or copy it again.`);
    }
    at = ends;
  }
  return group;
}

/** A count of UTF-16 units, these, and the place after them. */
function nameAt(content: DataView): { name: string; next: number } {
  const units = content.getUint16(0);
  let name = "";
  for (let unit = 0; unit < units; unit++) name += String.fromCharCode(content.getUint16(2 + 2 * unit));
  return { name: clean(name.replace(/\0+$/, "")), next: 2 + 2 * units };
}

function addAse(content: DataView, reader: Collector, where: string): void {
  const { name, next } = nameAt(content);
  const model = String.fromCharCode(...[0, 1, 2, 3].map((at) => content.getUint8(next + at))).trim().toUpperCase();
  const value = (at: number): number => {
    const read = content.getFloat32(next + 4 + 4 * at);
    if (!Number.isFinite(read)) throw reader.fault(`${where} ("${name}") has a value that is no number.`);
    return read;
  };
  if (model === "RGB") reader.add(name, encodedHex([value(0), value(1), value(2)], reader, where));
  else if (model === "GRAY") reader.add(name, encodedHex([value(0), value(0), value(0)], reader, where));
  else if (model === "LAB") reader.addLab(name, [100 * value(0), value(1), value(2)], "D50", where);
  else if (model === "CMYK") reader.leaveInk();
  else throw reader.fault(`${where} ("${name}") has the colour model "${clean(model)}"; RGB, Gray and LAB are read.`);
}

function encodedHex(encoded: readonly number[], reader: Collector, where: string): string {
  if (!encoded.every((part) => part >= 0 && part <= 1)) throw reader.fault(`${where}: ${encoded.join(", ")} is no colour; RGB and Gray are 0 to 1.`);
  return `#${encoded.map((part) => Math.round(255 * part).toString(16).padStart(2, "0")).join("")}`;
}

/** "GIMP Palette", lines of "Name: value", comments, and rows of red, green and blue from 0 to 255 with a name. */
function readGpl(text: string, reader: Collector): string | null {
  const lines = text.split(/\r\n?|\n/);
  if (lines[0]?.replace(/^\ufeff/, "").trim() !== "GIMP Palette") throw reader.fault('it is no GIMP palette: its first line is not "GIMP Palette".');
  let name: string | null = null;
  lines.slice(1).forEach((line, index) => {
    if (line.trim() === "" || line.trimStart().startsWith("#")) return;
    const said = /^([A-Za-z]+):(.*)$/.exec(line);
    if (said !== null) {
      if (said[1]!.toLowerCase() === "name") name = clean(said[2]!) || null;
      return;
    }
    const row = /^\s*(\d+)\s+(\d+)\s+(\d+)(?:\s+(.*))?$/.exec(line);
    const parts = row === null ? [] : row.slice(1, 4).map(Number);
    if (row === null || parts.some((part) => part > 255))
      throw reader.fault(`line ${index + 2}, "${clean(line).slice(0, 40)}", is no colour: write red, green and blue from 0 to 255, and a name.`);
    reader.add(row[4] ?? "", encodedHex(parts.map((part) => part / 255), reader, `line ${index + 2}`));
  });
  return name;
}

const HEADS = {
  name: /^(name|names|colou?r|colou?r name|code|standard|id|title)$/,
  hex: /^(hex|srgb|rgb hex|html|#)$/,
  L: /^(l|l\*|lab l|lightness|l\*? ?\(?d(50|65)\)?)$/,
  a: /^(a|a\*|lab a|a\*? ?\(?d(50|65)\)?)$/,
  b: /^(b|b\*|lab b|b\*? ?\(?d(50|65)\)?)$/,
} as const;
type Column = keyof typeof HEADS;

/**
 * A table with columns name and hex, or name, L, a and b, with or without a line of titles. Lab is relative to D65, as
 * everywhere in fabrics, unless "D50" is written in a title or in a comment (#) above.
 */
function readTable(text: string, reader: Collector): null {
  const { rows, comments } = csvRows(text.replace(/^\ufeff/, ""), (line) => reader.fault(`line ${line} has a quotation mark that is not closed.`));
  if (rows.length === 0) throw reader.fault("it is empty: write a name and a colour in each row.");
  const titles = rows[0]!.cells.map((cell) => cell.toLowerCase().replace(/_/g, " "));
  const columns = columnsOf(titles);
  const isTitled = columns !== null;
  const { name, hex, L, a, b } = columns ?? guessed(rows[0]!.cells);
  const white: White = /\bd50\b/i.test([...comments, ...(isTitled ? titles : [])].join(" ")) ? "D50" : "D65";
  for (const { cells, line } of rows.slice(isTitled ? 1 : 0)) {
    const called = name === undefined ? "" : (cells[name] ?? "");
    const written = hex === undefined ? "" : (cells[hex] ?? "");
    if (written !== "" && hex !== undefined) reader.add(called, hexOf(written, reader, line));
    else if (L !== undefined && a !== undefined && b !== undefined) {
      const lab = [L, a, b].map((column) => numberIn(cells[column])) as [number, number, number];
      if (lab.some(Number.isNaN)) throw reader.fault(`line ${line}: "${cells.join(", ").slice(0, 60)}" has no numbers L, a and b.`);
      reader.addLab(called, lab, white, `line ${line}`);
    } else throw reader.fault(`line ${line}: "${cells.join(", ").slice(0, 60)}" has no colour: write hex such as #20305c, or L, a and b.`);
  }
  return null;
}

type Columns = Partial<Record<Column, number>>;

/** Columns by their titles; null where the row has no title of a colour. */
function columnsOf(titles: readonly string[]): Columns | null {
  const found: Columns = {};
  for (const [column, head] of Object.entries(HEADS) as [Column, RegExp][]) {
    const at = titles.findIndex((title) => head.test(title));
    if (at >= 0) found[column] = at;
  }
  const isLab = found.L !== undefined && found.a !== undefined && found.b !== undefined;
  return found.hex !== undefined || isLab ? found : null;
}

/** Columns of a table without titles: a name and hex, or a name and three numbers. */
function guessed(cells: readonly string[]): Columns {
  const hex = cells.findIndex((cell) => HEX.test(cell));
  if (hex >= 0) return { hex, name: hex === 0 ? 1 : 0 };
  const first = cells.findIndex((_, at) => [at, at + 1, at + 2].every((each) => !Number.isNaN(numberIn(cells[each]))));
  return first < 0 ? {} : { name: first === 0 ? 3 : 0, L: first, a: first + 1, b: first + 2 };
}

const HEX = /^#?[0-9a-f]{6}$|^#[0-9a-f]{3}$/i;

function hexOf(text: string, reader: Collector, line: number): string {
  if (!HEX.test(text)) throw reader.fault(`line ${line}: "${text.slice(0, 40)}" is no colour: write hex such as #20305c.`);
  return toHex(parseColour(text.startsWith("#") ? text : `#${text}`, "colour"));
}

/** A number with a point or a comma; NaN of another text. */
function numberIn(text: string | undefined): number {
  const plain = (text ?? "").replace(",", ".").replace("\u2212", "-");
  return /^[-+]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : NaN;
}

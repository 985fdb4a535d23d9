/** Validation of a fabric's fields; each fault is one sentence: field, value, and what would be right. */
import { requireWeaves, weftOrder } from "./artwork_fields.ts";
import { closeMatch } from "./close_match.ts";
import { coloursInOrder, isOneColour, parseColour } from "./colour.ts";
import { InputError } from "./errors.ts";
import { FAMILIES, type ArtworkWeaves, type FamilyName, type FieldKind, type FieldTable, type SurfaceMaps } from "./fields.ts";
import { FABRIC, type FabricFields, YARN_PRESETS } from "./generated.ts";
import { general } from "./numbers.ts";
import { yarnTex } from "./yarn_count.ts";

type Plain = Record<string, unknown>;
type IsWhole = (value: unknown) => boolean;

/**
 * The fields of a fabric from plain values.
 *
 * @param isWhole whether a number is a whole one: in TOML 3 is and 3.0 is not.
 * @throws InputError an unknown field, a value of another type or range, a yarn count that cannot be read, contradicting fields.
 */
export function validateFields(values: unknown, isWhole: IsWhole = Number.isInteger): FabricFields {
  if (!isTable(values)) throw new InputError("the fabric is no table of fields.");
  const fields = validTable(values, FABRIC, [], isWhole) as FabricFields;
  requireConsistent(fields);
  return fields;
}

function isTable(value: unknown): value is Plain {
  if (typeof value !== "object" || value === null || Array.isArray(value)) return false;
  const prototype: unknown = Object.getPrototypeOf(value);
  return prototype === Object.prototype || prototype === null;
}

function validTable(values: Plain, table: FieldTable, parents: readonly string[], isWhole: IsWhole): Plain {
  const valid: Plain = {};
  for (const [key, kind] of Object.entries(table)) {
    const value = Object.hasOwn(values, key) ? values[key] : undefined;
    if (value === undefined || value === null) continue;
    const name = [...parents, key].join(".");
    if (kind.kind === "table") {
      if (!isTable(value)) throw cannotBeUsed(name, value, kind);
      const inner = validTable(value, kind.fields, [...parents, key], isWhole);
      if (Object.keys(inner).length > 0) valid[key] = inner;
    } else {
      valid[key] = validValue(value, kind, name, isWhole);
    }
  }
  const stranger = Object.keys(values).find((key) => !Object.hasOwn(table, key));
  if (stranger !== undefined) throw unknownField(stranger, table, parents);
  return valid;
}

function validValue(value: unknown, kind: FieldKind, name: string, isWhole: IsWhole): unknown {
  switch (kind.kind) {
    case "number":
    case "integer": {
      const number = typeof value === "bigint" ? Number(value) : value;
      const isKind = kind.kind === "number" || isWhole(value);
      if (typeof number !== "number" || !isKind || !(kind.low <= number && number <= kind.high))
        throw cannotBeUsed(name, value, kind);
      return number;
    }
    case "text":
      if (typeof value !== "string") throw cannotBeUsed(name, value, kind);
      if (value === "" && !kind.mayBeEmpty)
        throw new InputError(`${name} = "" is empty: write a value, or leave the field out.`);
      return value;
    case "maps":
      return validMaps(value, name);
    case "weaves":
      return validWeaves(value, name);
    case "boolean":
      if (typeof value !== "boolean") throw cannotBeUsed(name, value, kind);
      return value;
    case "yarn":
      return validYarn(value, name);
    case "colour":
      return validColour(value, name);
    case "colours":
      if (isOneColour(value)) return validColour(value, name);
      if (Array.isArray(value) && value.length === 0)
        throw new InputError(
          `${name} = [] holds no colour: write "#rrggbb", a linear RGB triple, or a list of these.`,
        );
      coloursInOrder(value, name).forEach((colour) => validColour(colour, name));
      return typeof value === "string" ? value : (value as unknown[]).map(plainNumbers);
    case "table":
      throw cannotBeUsed(name, value, kind);
  }
}

/** Maps as they are: tables of texts, numbers, truth values and lists; Python says more of what they hold. */
function validMaps(value: unknown, name: string): SurfaceMaps {
  if (!isTable(value))
    throw new InputError(`${name} = ${shown(value)} cannot be used: it is a table of pictures, a name each.`);
  return Object.fromEntries(
    Object.entries(value).map(([key, each]) => [key, validMap(each, `${name}.${key}`)]),
  );
}

function validMap(value: unknown, name: string): SurfaceMaps[string] {
  if (isTable(value)) return validMaps(value, name);
  if (typeof value === "bigint") return Number(value);
  if (Array.isArray(value)) return value.map((part) => (typeof part === "bigint" ? Number(part) : (part as string | number)));
  if (typeof value === "string" || typeof value === "number" || typeof value === "boolean") return value;
  throw new InputError(`${name} = ${shown(value)} cannot be used: write the path of a picture, "FILE.png", or a table.`);
}

/** Weaves of an artwork; what they name is looked up where it is woven. */
function validWeaves(value: unknown, name: string): ArtworkWeaves {
  if (!isTable(value)) throw new InputError(`${name} is no table: write a weave a colour, "#c00000" = "satin 8/3".`);
  return requireWeaves(value, name);
}

function validYarn(value: unknown, name: string): string {
  if (typeof value !== "string") throw cannotBeUsed(name, value, { kind: "yarn" });
  const given = value.trim().split(/\s+/).join(" ");
  const yarn = YARN_PRESETS.find((preset) => preset.name === given.toLowerCase());
  if (yarn === undefined)
    throw new InputError(
      `${name} = "${given.slice(0, 40)}" is no kind of yarn that has a name: write ` +
        `${YARN_PRESETS.map((preset) => `"${preset.name}"`).join(", ")}.`,
    );
  return yarn.name;
}

function validColour(value: unknown, name: string): unknown {
  const plain = plainNumbers(value);
  parseColour(plain, name);
  return plain;
}

/** A triple of integers as numbers; other values as they are. */
function plainNumbers(value: unknown): unknown {
  if (!Array.isArray(value)) return value;
  return value.map((part: unknown) => (typeof part === "bigint" ? Number(part) : part));
}

function cannotBeUsed(name: string, value: unknown, kind: FieldKind): InputError {
  return new InputError(`${name} = ${shown(value)} cannot be used: ${expected(kind)}.`);
}

function expected(kind: FieldKind): string {
  switch (kind.kind) {
    case "number":
      return `write a number from ${general(kind.low)} to ${general(kind.high)}`;
    case "integer":
      return `write a whole number from ${kind.low} to ${kind.high}`;
    case "table":
      return "it is a table of fields";
    case "boolean":
      return "write true or false";
    default:
      return "write text in quotes";
  }
}

/** A value as a file writes it, shortened. */
function shown(value: unknown, most = 60): string {
  const written = typeof value === "string" ? `"${value}"` : isTable(value) ? "a table" : plainText(value);
  const line = written.split(/\s+/).join(" ");
  return line.length <= most ? line : `${line.slice(0, most - 1)}…`;
}

function plainText(value: unknown): string {
  return Array.isArray(value) ? `[${value.map((part) => shown(part)).join(", ")}]` : String(value);
}

function unknownField(key: string, table: FieldTable, parents: readonly string[]): InputError {
  const home = parents.length > 0 ? `[${parents.join(".")}] has` : "a fabric file has";
  return new InputError(`${shown(key)} is no field that ${home}: ${placeOf(key, table)}`);
}

function placeOf(key: string, table: FieldTable): string {
  const homes = Object.entries(FABRIC).flatMap(([name, kind]) =>
    kind.kind === "table" && Object.hasOwn(kind.fields, key) ? [`[${name}]`] : [],
  );
  if (homes.length > 0) return `it belongs under ${homes.join(" or ")}.`;
  if (Object.hasOwn(FABRIC, key) && table !== FABRIC)
    return "it belongs at the top of the file, above the first table.";
  const known = Object.keys(table);
  const close = closeMatch(key.toLowerCase(), known);
  return close === null ? `known are ${known.join(", ")}.` : `did you mean ${close}?`;
}

function requireConsistent(fields: FabricFields): void {
  const sources = (["weave", "draft", "image"] as const).filter((key) => fields[key] !== undefined);
  if (sources.length === 0)
    throw new InputError(
      'it has no weave: write weave = "twill 3/1", draft = "file.wif" or image = "file.png".',
    );
  refuseTogether(fields, sources, "");
  requireArtwork(fields);
  refuseTogether(fields, ["ends_per_cm", "epi"], "");
  refuseTogether(fields, ["picks_per_cm", "ppi"], "");
  for (const family of FAMILIES) {
    refuseTogether(fields[family] ?? {}, ["width_mm", "gap"], `${family}.`);
    requireCount(fields[family]?.count, family);
  }
}

function requireArtwork({ image, weaves, artwork }: FabricFields): void {
  const isWoven = Object.keys(weaves ?? {}).length > 0;
  if (isWoven && image === undefined)
    throw new InputError('weaves say what the colours of an artwork are: write image = "artwork.png" with them.');
  if (artwork !== undefined && !isWoven)
    throw new InputError('[artwork] says how [weaves] are woven, and there are none: write "#c00000" = "satin 8/3" there.');
  if (artwork?.order !== undefined) weftOrder(artwork.order, "artwork.order");
}

function requireCount(count: string | undefined, family: FamilyName): void {
  try {
    if (count !== undefined) yarnTex(count);
  } catch (error) {
    throw error instanceof InputError ? new InputError(`${family}.count: ${error.message}`) : error;
  }
}

function refuseTogether(table: object, keys: readonly string[], prefix: string): void {
  const given = Object.entries(table).filter(([key]) => keys.includes(key));
  const [first, second] = keys.flatMap((key) => given.filter(([name]) => name === key));
  if (first === undefined || second === undefined) return;
  const say = ([key, value]: [string, unknown]): string => `${prefix}${key} = ${shown(value)}`;
  throw new InputError(`${say(first)} and ${say(second)} say the same thing twice: keep one of them.`);
}

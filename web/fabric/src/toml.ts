/** A fabric file as text (TOML 1.0), read and written. */
import { parse, TomlError } from "smol-toml";

import { InputError } from "./errors.ts";
import type { ArtworkWeaves, SurfaceMaps } from "./fields.ts";
import { FABRIC, type FabricFields } from "./generated.ts";
import { validateFields } from "./validate.ts";

/** Thread colours of the longest draft take some 100 kB; what is larger is not a fabric file. */
const MAX_FILE = 4 * 2 ** 20;

/**
 * The fields of a fabric file's text.
 *
 * @throws InputError no TOML, an unknown field, a value of another type or range, contradicting fields.
 */
export function readToml(text: string): FabricFields {
  if (text.length > MAX_FILE)
    throw new InputError(`it is larger than ${MAX_FILE >> 20} MiB; it is no fabric file.`);
  if (text.trim() === "") throw new InputError('it is empty: weave = "twill 3/1" alone would be a fabric.');
  return validateFields(parsed(text), (value) => typeof value === "bigint");
}

function parsed(text: string): unknown {
  try {
    return parse(text.replace(/^\uFEFF/, ""), { integersAsBigInt: true });
  } catch (error) {
    if (!(error instanceof TomlError)) throw error;
    const reason = (error.message.split("\n")[0] ?? "").replace(/^Invalid TOML document: /, "");
    throw new InputError(`it is no valid TOML: ${reason} (at line ${error.line}, column ${error.column}).`);
  }
}

/** The text of a fabric file with these fields; omitted fields are not written. */
export function writeToml(fields: FabricFields): string {
  const values = fields as Readonly<Record<string, unknown>>;
  const lines: string[] = [];
  const tables: string[] = [];
  for (const [key, kind] of Object.entries(FABRIC)) {
    const value = values[key];
    if (value === undefined) continue;
    if (kind.kind === "maps") {
      const inner = Object.entries(value as SurfaceMaps).map(([name, each]) => `${name} = ${literal(each)}`);
      if (inner.length > 0) tables.push(["", `[${key}]`, ...inner].join("\n"));
    } else if (kind.kind === "weaves") {
      const inner = Object.entries(value as ArtworkWeaves).map(([colour, each]) => `${quoted(colour)} = ${literal(each)}`);
      if (inner.length > 0) tables.push(["", `[${key}]`, ...inner].join("\n"));
    } else if (kind.kind !== "table") lines.push(`${key} = ${literal(value)}`);
    else {
      const inner = Object.keys(kind.fields).flatMap((field) => {
        const entry = (value as Record<string, unknown>)[field];
        return entry === undefined ? [] : [`${field} = ${literal(entry)}`];
      });
      if (inner.length > 0) tables.push(["", `[${key}]`, ...inner].join("\n"));
    }
  }
  return `${[...lines, ...tables].join("\n")}\n`;
}

function literal(value: unknown): string {
  if (typeof value === "string") return quoted(value);
  if (Array.isArray(value)) return `[${value.map(literal).join(", ")}]`;
  if (typeof value === "object" && value !== null)
    return `{ ${Object.entries(value).map(([key, each]) => `${key} = ${literal(each)}`).join(", ")} }`;
  return String(value);
}

function quoted(text: string): string {
  const named: Readonly<Record<string, string>> = { '"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t", "\r": "\\r" };
  const escaped = text.replace(
    /["\\\p{C}\p{Zl}\p{Zp}]/gu,
    (char) => named[char] ?? `\\U${char.codePointAt(0)!.toString(16).toUpperCase().padStart(8, "0")}`,
  );
  return `"${escaped}"`;
}

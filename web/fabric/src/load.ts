/** Fabrics from texts and files: which reader is for what. */
import { requireInterlacing, type Draft } from "./draft.ts";
import { InputError, type Warn } from "./errors.ts";
import type { FabricFields } from "./generated.ts";
import { namedWeave } from "./named.ts";
import { readWif } from "./wif_reader.ts";

/** Files at hand, by the name that a fabric file gives them. */
export type Files = Readonly<Record<string, Uint8Array>>;

/**
 * The draft that the fields name, before their colours are applied (see `colouredDraft`).
 *
 * @throws InputError an unknown weave, a draft that is not among the files, or one that is no draft.
 */
export function loadDraft(fields: FabricFields, files: Files = {}, warn: Warn = () => undefined): Draft {
  const draft = namedDraft(fields, files, warn);
  requireInterlacing(draft);
  return draft;
}

function namedDraft(fields: FabricFields, files: Files, warn: Warn): Draft {
  if (fields.weave !== undefined) return namedWeave(fields.weave);
  if (fields.image !== undefined)
    throw new InputError(`image = "${fields.image}" is a picture: open it as a file to read its drawdown.`);
  const file = fields.draft ?? "";
  const bytes = Object.hasOwn(files, file) ? files[file] : undefined;
  if (bytes === undefined)
    throw new InputError(`draft = "${file}" is not at hand: open it together with the fabric file.`);
  if (!file.toLowerCase().endsWith(".wif"))
    throw new InputError(`draft = "${file}" is not read here: export it as .wif from the program that made it.`);
  return readWif(bytes, file, warn);
}

/** Fabric files and weave drafts: named weaves, WIF, loom plans, colours and spacings. No DOM and no GPU. */
export * from "./colour.ts";
export * from "./colours.ts";
export * from "./defaults.ts";
export * from "./draft.ts";
export * from "./errors.ts";
export * from "./fields.ts";
export * from "./json.ts";
export * from "./load.ts";
export { deriveLoomPlan, movedShafts, planDrawdown, weaves } from "./loom.ts";
export { namedWeave, weaveNames } from "./named.ts";
export { fromPalette, pickRows, repeatDraft, WARP_COLOUR, WEFT_COLOUR, withPalette } from "./palette.ts";
export { draftOfPixels } from "./picture.ts";
export * from "./spacing.ts";
export * from "./textile.ts";
export { readToml, writeToml } from "./toml.ts";
export { validateFields } from "./validate.ts";
export { readWif } from "./wif_reader.ts";
export { writeWif } from "./wif_writer.ts";

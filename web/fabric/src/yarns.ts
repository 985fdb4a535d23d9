/** Kinds of yarn by name: what a fabric file need not say of a yarn of that fibre and spinning. */
import type { FamilyName } from "./fields.ts";
import { type FabricFields, YARN_PRESETS, type YarnFields, type YarnPreset } from "./generated.ts";
import { COTTON_DENSITY, DEFAULT_PACKING } from "./textile.ts";

/** Fields with what kinds of yarn say of the fields of [warp] and [weft] that the file omits. */
export function withYarns(fields: FabricFields): FabricFields {
  const filled = (family: FamilyName): YarnFields | undefined => {
    const preset = presetOf(fields, family);
    return preset === null ? fields[family] : { ...preset.fields, ...fields[family], yarn: preset.name };
  };
  const [warp, weft] = [filled("warp"), filled("weft")];
  return { ...fields, ...(warp && { warp }), ...(weft && { weft }) };
}

/** Density of the fibre, g/cm³, and packing of the yarn of a family: cotton's by default. */
export function yarnDensity(fields: FabricFields, family: FamilyName): { density: number; packing: number } {
  return presetOf(fields, family) ?? { density: COTTON_DENSITY, packing: DEFAULT_PACKING };
}

function presetOf(fields: FabricFields, family: FamilyName): YarnPreset | null {
  const name = fields[family]?.yarn ?? fields.yarn;
  return YARN_PRESETS.find((preset) => preset.name === name) ?? null;
}

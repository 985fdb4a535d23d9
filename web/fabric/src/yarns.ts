/** Kinds of yarn by name: what a fabric file need not say of a yarn of that fibre and spinning. */
import type { FamilyName } from "./fields.ts";
import { type FabricFields, GAP, YARN_PRESETS, type YarnFields, type YarnPreset } from "./generated.ts";
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

/** Of a family that names no kind: round, of cotton's weight. */
const ANY: YarnPreset = { name: "", fields: {}, density: COTTON_DENSITY, packing: DEFAULT_PACKING, gap: GAP, spread: 1 };

/** Kind of yarn of a family; without a name a round one of cotton's density and packing. */
export function kindOf(fields: FabricFields, family: FamilyName): YarnPreset {
  return presetOf(fields, family) ?? ANY;
}

function presetOf(fields: FabricFields, family: FamilyName): YarnPreset | null {
  const name = fields[family]?.yarn ?? fields.yarn;
  return YARN_PRESETS.find((preset) => preset.name === name) ?? null;
}

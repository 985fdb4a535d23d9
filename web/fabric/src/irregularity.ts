/** How yarns vary along themselves, as numbers; see `src/loomlight/fabric/resolve.py` and `scattering/appearance.py`. */
import type { FamilyName } from "./fields.ts";
import { type FabricFields, IRREGULARITY, IRREGULARITY_FIELDS, type YarnFields } from "./generated.ts";
import { withYarns } from "./yarns.ts";

const FIELDS = Object.entries(IRREGULARITY_FIELDS);
type Name = (typeof IRREGULARITY_FIELDS)[keyof typeof IRREGULARITY_FIELDS]["name"];

/** Numbers of one family as in Python's `Irregularity`, but for the colour of neps; lengths in millimetres. */
export type Irregularity = Readonly<Record<Name, number>>;

/** The irregularity of a family of a fabric: its own fields, else those of its kind of yarn, as much as [variation] says. */
export function irregularityOf(fields: FabricFields, family: FamilyName): Irregularity {
  const table: YarnFields = withYarns(fields)[family] ?? {};
  const amount = fields.variation?.irregularity ?? IRREGULARITY;
  const valueOf = ([key, { standard, isAmount }]: (typeof FIELDS)[number]): number => {
    const value = (table[key as keyof typeof IRREGULARITY_FIELDS] as number | undefined) ?? standard;
    return isAmount ? value * amount : value;
  };
  const found = Object.fromEntries(FIELDS.map((field) => [field[1].name, valueOf(field)])) as Irregularity;
  return isIrregular(found) ? found : EVEN;
}

/** Whether yarns vary at all. */
export function isIrregular(yarn: Irregularity): boolean {
  return FIELDS.some(([, { name, isAmount }]) => isAmount && yarn[name] > 0);
}

const EVEN = Object.fromEntries(FIELDS.map(([, { name, standard }]) => [name, standard])) as Irregularity;

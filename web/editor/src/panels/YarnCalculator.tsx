/** Yarn for a piece of this cloth: ends, picks, metres and grams of each colour. */
import { FAMILIES, needsCsv, PLAN_RANGES, yarnNeeds, type WeavingPlan, type YarnNeed } from "loomlight-fabric";
import { useMemo, useState } from "preact/hooks";

import { FAMILY_NAMES } from "../controls/symbols.ts";
import { Fault, numberOf, useWritten } from "../controls/written.tsx";
import { download, stemOf } from "../files.ts";
import { isPossible, keepPlan, readPlan } from "../keeping/plan.ts";
import { woven, type Fabric } from "../state/document.ts";

const FIELDS: readonly (readonly [keyof WeavingPlan, string, string, string])[] = [
  ["lengthM", "Length", "m", "Of the finished cloth"],
  ["widthCm", "Width", "cm", "Of the finished cloth"],
  ["warpTakeUp", "Warp take-up", "%", "How much longer the yarn is than the finished cloth: crimp and shrinkage. Empty: the weave's crimp"],
  ["weftTakeUp", "Weft take-up", "%", "How much longer the yarn is than the finished cloth is wide. Empty: the weave's crimp"],
  ["loomWasteM", "Loom waste", "m", "Warp that stays on the loom, once a piece"],
  ["weftWaste", "Weft waste", "%", "Lost at selvedges and on bobbins"],
];
/** Yarns that are listed one by one; the table that is saved has all of them. */
const MAX_LISTED = 24;

export function YarnCalculator({ fabric }: { readonly fabric: Fabric }) {
  const [plan, setPlan] = useState(readPlan);
  const needs = useMemo(() => yarnNeeds(fabric.fields, woven(fabric), plan), [fabric, plan]);
  const change = (name: keyof WeavingPlan, value: number | null): void => {
    const next = { ...plan, [name]: value };
    keepPlan(next);
    setPlan(next);
  };
  return (
    <section class="group">
      <h2>Yarn for a piece</h2>
      <div class="plan-fields">
        {FIELDS.map(([name, label, unit, tip]) => (
          <PlanField
            key={name}
            name={name}
            label={label}
            unit={unit}
            tip={tip}
            value={plan[name]}
            following={name === "warpTakeUp" ? needs.takeUp.warp : name === "weftTakeUp" ? needs.takeUp.weft : null}
            onValue={(value) => change(name, value)}
          />
        ))}
      </div>
      <table class="needs" data-testid="yarn-needs">
        <thead>
          <tr>
            <th scope="col">Yarn</th>
            <th scope="col">Threads</th>
            <th scope="col">m</th>
            <th scope="col">g</th>
          </tr>
        </thead>
        <tbody>
          {needs.yarns.slice(0, MAX_LISTED).map((yarn) => (
            <tr key={`${yarn.family} ${yarn.hex}`}>
              <th scope="row">
                <i style={{ background: yarn.hex }} />
                {FAMILY_NAMES[yarn.family]} {yarn.hex}
              </th>
              <Amounts yarns={[yarn]} />
            </tr>
          ))}
        </tbody>
        <tfoot>
          {FAMILIES.map((family) => (
            <tr key={family}>
              <th scope="row">{FAMILY_NAMES[family]}</th>
              <Amounts yarns={needs.yarns.filter((yarn) => yarn.family === family)} />
            </tr>
          ))}
        </tfoot>
      </table>
      {needs.yarns.length > MAX_LISTED && <p class="note">Of {needs.yarns.length} yarns {MAX_LISTED} are listed; the table has all.</p>}
      <p class="note">
        Each end is {shown(needs.endM, 2)} m long.
        {!needs.isCounted && " Without yarn counts, grams are those of round yarns as wide as the threads: set both counts above."}
      </p>
      <button type="button" class="button" data-testid="needs-save" onClick={() => download(`${stemOf(fabric)}-yarn.csv`, needsCsv(needs), "text/csv")}>
        Save as a table (.csv)
      </button>
    </section>
  );
}

function Amounts({ yarns }: { yarns: readonly YarnNeed[] }) {
  const sum = (of: (yarn: YarnNeed) => number): number => yarns.reduce((total, yarn) => total + of(yarn), 0);
  const [metres, grams] = [sum((yarn) => yarn.metres), sum((yarn) => yarn.grams)];
  return (
    <>
      <td>{shown(sum((yarn) => yarn.threads), 0)}</td>
      <td>{shown(metres, metres < 100 ? 1 : 0)}</td>
      <td>{shown(grams, grams < 100 ? 1 : 0)}</td>
    </>
  );
}

const shown = (value: number, digits: number): string => value.toLocaleString("en", { maximumFractionDigits: digits });

interface FieldProps {
  readonly name: keyof WeavingPlan;
  readonly label: string;
  readonly unit: string;
  readonly tip: string;
  readonly value: number | null;
  /** What follows from the weave where the field is empty; null where it may not be. */
  readonly following: number | null;
  readonly onValue: (value: number | null) => void;
}

function PlanField({ name, label, unit, tip, value, following, onValue }: FieldProps) {
  const written = useWritten(value === null ? "" : String(value), (text) => {
    const number = text.trim() === "" && following !== null ? null : numberOf(text);
    const [low, high] = PLAN_RANGES[name];
    if (!isPossible(name, number) || (number === null && text.trim() !== "")) return `${label} = "${text}" cannot be: write a number from ${low} to ${high}.`;
    onValue(number);
    return null;
  });
  return (
    <>
      <label class="tip" for={`plan-${name}`} data-tip={tip}>
        {label}
      </label>
      <input {...written.input} id={`plan-${name}`} class="text" inputMode="decimal" placeholder={following === null ? "" : following.toFixed(1)} data-testid={`plan-${name}`} />
      <span class="hint">{unit}</span>
      <Fault text={written.fault} />
    </>
  );
}

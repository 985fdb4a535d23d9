/** Warp and weft yarns: how they shine, how they lie, how thick they are. */
import {
  bendsOf,
  clamp,
  clothFacts,
  FAMILIES,
  type FamilyName,
  familySpacing,
  familyWidth,
  IRREGULARITY_FIELDS,
  isInputError,
  NEP_COLOUR,
  parseColour,
  settsOfWeight,
  threadsPerCm,
  toHex,
  withYarns,
  YARN_PRESETS,
  yarnTex,
} from "loomlight-fabric";
import { useRef, useState } from "preact/hooks";

import { Segmented } from "../controls/Segmented.tsx";
import { newStroke, Slider } from "../controls/Slider.tsx";
import { CLOTH_QUANTITIES, YARN_QUANTITIES } from "../controls/symbols.ts";
import { Fault, numberOf, useWritten } from "../controls/written.tsx";
import { woven, type Fabric } from "../state/document.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";
import { YarnCalculator } from "./YarnCalculator.tsx";

interface Props {
  readonly fabric: Fabric;
  readonly dispatch: Dispatch;
}

interface PanelProps extends Props {
  /** Whether the cloth is shown flat, without light. */
  readonly isFlat: boolean;
}

type Choice = FamilyName | "both";

export function YarnsPanel({ fabric, dispatch, isFlat }: PanelProps) {
  const [choice, choose] = useState<Choice>("both");
  const families = choice === "both" ? FAMILIES : [choice];
  return (
    <>
      <Segmented
        label="Which yarns"
        testid="yarns"
        choices={[
          ["both", "Both"],
          ["warp", "Warp"],
          ["weft", "Weft"],
        ]}
        value={choice}
        onChoose={choose}
      />
      {isFlat && <p class="note is-flat">Here the cloth is shown flat: sett, openness and count show; lustre, twist and relief need WebGPU.</p>}
      <section class="group">
        <h2>Sett</h2>
        {choice !== "weft" && <SettSlider fabric={fabric} dispatch={dispatch} family="warp" />}
        {choice !== "warp" && <SettSlider fabric={fabric} dispatch={dispatch} family="weft" />}
        <WeightField fabric={fabric} dispatch={dispatch} />
      </section>
      <section class="group">
        <h2>Yarn</h2>
        <KindField fabric={fabric} dispatch={dispatch} families={families} />
        <CountField fabric={fabric} dispatch={dispatch} families={families} />
        {["gap", "specular", "roughness", "specular_grazing", "translucency"].map((key) => (
          <YarnSlider key={key} fabric={fabric} dispatch={dispatch} families={families} name={key} />
        ))}
        <ColourField fabric={fabric} dispatch={dispatch} families={families} {...TINT} />
      </section>
      <section class="group">
        <h2>How it is spun</h2>
        {["twist_deg", "plies", "ply_twist_deg", "fibre_tilt_deg", "slub", "hairiness"].map((key) => (
          <YarnSlider key={key} fabric={fabric} dispatch={dispatch} families={families} name={key} />
        ))}
      </section>
      <section class="group">
        <h2>How uneven it is</h2>
        {Object.keys(IRREGULARITY_FIELDS).map((key) => (
          <YarnSlider key={key} fabric={fabric} dispatch={dispatch} families={families} name={key} />
        ))}
        <ColourField fabric={fabric} dispatch={dispatch} families={families} {...NEP_COLOUR_FIELD} />
      </section>
      <section class="group">
        <h2>How it lies</h2>
        {["height_scale", "inclination_deg"].map((key) => (
          <YarnSlider key={key} fabric={fabric} dispatch={dispatch} families={families} name={key} />
        ))}
      </section>
      <YarnCalculator fabric={fabric} />
    </>
  );
}

function SettSlider({ fabric, dispatch, family }: Props & { readonly family: FamilyName }) {
  const field = family === "warp" ? "ends_per_cm" : "picks_per_cm";
  const own = threadsPerCm(fabric.fields, family);
  const spacing = familySpacing(fabric.fields, family, woven(fabric));
  const value = (10 * spacing.length) / spacing.reduce((sum, length) => sum + length, 0);
  return (
    <Slider
      field={field}
      quantity={CLOTH_QUANTITIES[field]!}
      value={value}
      isOwn={own !== null}
      onValue={(number, stroke) => refusalOf(dispatch, { type: "field/set", field, value: number, stroke })}
      onReset={() => dispatch({ type: "fields/set", values: { [field]: undefined, [family === "warp" ? "epi" : "ppi"]: undefined } })}
    />
  );
}

interface FamiliesProps extends Props {
  readonly families: readonly FamilyName[];
}

/** One value for a field of one family or of both. */
function ofAll(families: readonly FamilyName[], name: string, value: unknown): Record<string, unknown> {
  return Object.fromEntries(families.map((family) => [`${family}.${name}`, value]));
}

function YarnSlider({ fabric, dispatch, families, name }: FamiliesProps & { readonly name: string }) {
  const family = families[0]!;
  const value = valueOf(fabric, family, name);
  const isOwn = families.some((each) => (fabric.fields[each] as Record<string, unknown> | undefined)?.[name] !== undefined);
  const label = families.length === 2 ? "both" : family;
  return (
    <Slider
      field={`${label}.${name}`}
      quantity={YARN_QUANTITIES[name]!}
      value={value}
      isOwn={isOwn}
      onValue={(number, stroke) => refusalOf(dispatch, { type: "fields/set", values: ofAll(families, name, number), stroke })}
      onReset={() => dispatch({ type: "fields/set", values: ofAll(families, name, undefined) })}
    />
  );
}

/** A quantity as it is in use: the family's own, or what follows from the weave and the draft. */
function valueOf(fabric: Fabric, family: FamilyName, name: string): number {
  const own = (withYarns(fabric.fields)[family] as Record<string, unknown> | undefined)?.[name];
  if (typeof own === "number") return own;
  const draft = woven(fabric);
  if (name === "gap") {
    const spacing = familySpacing(fabric.fields, family, draft);
    const width = familyWidth(fabric.fields, family, draft, spacing);
    return clamp(1 - width[0]! / spacing[0]!, 0, 0.95);
  }
  if (name === "inclination_deg") return bendsOf(draft)[family].inclinationDeg;
  if (name === "twist_deg") return bendsOf(draft)[family].twistDeg;
  return YARN_QUANTITIES[name]!.standard;
}

/** What the yarn is spun of: other defaults for everything below. */
function KindField({ fabric, dispatch, families }: FamiliesProps) {
  const kinds = families.map((family) => fabric.fields[family]?.yarn ?? fabric.fields.yarn ?? "");
  const kind = kinds.every((each) => each === kinds[0]) ? kinds[0]! : "mixed";
  const label = families.length === 2 ? "both" : families[0]!;
  return (
    <div class="row is-field">
      <label class="tip" data-tip="Other defaults of openness, gloss, roughness, translucency, twist and unevenness (yarn)" for={`kind-${label}`}>
        Kind of yarn
      </label>
      <select
        id={`kind-${label}`}
        class="text"
        value={kind}
        data-testid={`field-${label}.yarn`}
        onChange={(event) => dispatch({ type: "fields/set", values: ofAll(families, "yarn", event.currentTarget.value || undefined) })}
      >
        {kind === "mixed" && <option value="mixed">mixed</option>}
        <option value="">any</option>
        {YARN_PRESETS.map(({ name }) => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
    </div>
  );
}

function CountField({ fabric, dispatch, families }: FamiliesProps) {
  const count = fabric.fields[families[0]!]?.count ?? "";
  const label = families.length === 2 ? "both" : families[0]!;
  const written = useWritten(count, (text) =>
    refusalOf(dispatch, { type: "fields/set", values: ofAll(families, "count", text.trim() === "" ? undefined : text.trim()) }),
  );
  return (
    <div class="row is-field">
      <label class="tip" data-tip="Gives the width of a round yarn of that count and kind, in place of the openness. As mills write it: 20s, 2/60 Nm, 75/36 dtex" for={`count-${label}`}>
        Yarn count
      </label>
      <input {...written.input} id={`count-${label}`} class="text" placeholder="30 tex, Ne 40/2, 20s …" data-testid={`field-${label}.count`} />
      {count !== "" && written.fault === "" && <span class="hint">{shownTex(yarnTex(count))} tex</span>}
      <Fault text={written.fault.replace(/^\w+\.count: /, "")} />
    </div>
  );
}

function shownTex(tex: number): string {
  return tex < 10 ? tex.toFixed(1) : tex.toFixed(0);
}

/** What a square metre weighs; with counts of both yarns it can be set, and the sett follows. */
function WeightField({ fabric, dispatch }: Props) {
  const { weight, isCounted } = clothFacts(fabric.fields, woven(fabric));
  const written = useWritten(weight.toFixed(0), (text) => {
    const number = numberOf(text);
    if (number === null) return `"${text}" is no number.`;
    try {
      const setts = settsOfWeight(fabric.fields, woven(fabric), number);
      return refusalOf(dispatch, { type: "fields/set", values: { ends_per_cm: setts.warp, picks_per_cm: setts.weft } });
    } catch (error) {
      if (!isInputError(error)) throw error;
      return error.message;
    }
  });
  return (
    <div class="row is-field">
      <label class="tip" for="weight" data-tip="Threads per metre times their tex and crimp (Peirce 1937). Give both yarns a count, and you can set it: the sett follows">
        Weight
      </label>
      {isCounted ? (
        <>
          <input {...written.input} id="weight" class="text" inputMode="decimal" data-testid="weight" />
          <span class="hint">g/m²</span>
          <Fault text={written.fault} />
        </>
      ) : (
        <output id="weight" class="hint" data-testid="weight">
          unknown: it takes the yarn count of {uncounted(fabric)}
        </output>
      )}
    </div>
  );
}

/** The families whose yarns have no count, in words. */
function uncounted({ fields }: Fabric): string {
  return FAMILIES.filter((family) => fields[family]?.count === undefined).join(" and ");
}

interface ColourProps {
  readonly name: "specular_tint" | "nep_color";
  readonly label: string;
  readonly tip: string;
  /** sRGB, where the fabric says none. */
  readonly standard: string;
  /** The standard in words. */
  readonly called: string;
}

/** The colour of the highlight: that of dyed fibres' surface is white, of metal thread its own. */
const TINT: ColourProps = {
  name: "specular_tint",
  label: "Colour of the lustre",
  tip: "Multiplies the fibres' highlight: white but for metal threads (specular_tint)",
  standard: "#ffffff",
  called: "white",
};
const NEP_COLOUR_FIELD: ColourProps = {
  name: "nep_color",
  label: "Colour of the neps",
  tip: "As cloth of nothing else shows it (nep_color)",
  standard: NEP_COLOUR,
  called: "undyed",
};

function ColourField({ fabric, dispatch, families, name, label, tip, standard, called }: FamiliesProps & ColourProps) {
  const which = families.length === 2 ? "both" : families[0]!;
  const own = fabric.fields[families[0]!]?.[name];
  const hex = own === undefined ? standard : toHex(parseColour(own, name));
  const stroke = useRef(newStroke());
  const set = (value: string | undefined): string | null =>
    refusalOf(dispatch, { type: "fields/set", values: ofAll(families, name, value), stroke: stroke.current });
  return (
    <div class="row">
      <label class="tip" for={`${name}-${which}`} data-tip={tip}>
        {label}
      </label>
      <input
        id={`${name}-${which}`}
        type="color"
        value={hex}
        data-testid={`field-${which}.${name}`}
        onPointerDown={() => (stroke.current = newStroke())}
        onInput={(event) => set(event.currentTarget.value)}
      />
      {own !== undefined && (
        <button type="button" class="reset" onClick={() => set(undefined)} aria-label={`${label}: back to ${called}`} title={`Back to ${called}`}>
          ↺
        </button>
      )}
    </div>
  );
}

/** Warp and weft yarns: how they shine, how they lie, how thick they are. */
import {
  bendsOf,
  clothFacts,
  familySpacing,
  familyWidth,
  FAMILIES,
  InputError,
  parseColour,
  settsOfWeight,
  threadsPerCm,
  toHex,
  withYarns,
  yarnTex,
  YARN_PRESETS,
  type FamilyName,
} from "loomlight-fabric";
import { useRef, useState } from "preact/hooks";

import { Segmented } from "../controls/Segmented.tsx";
import { newStroke, Slider } from "../controls/Slider.tsx";
import { CLOTH_QUANTITIES, YARN_QUANTITIES } from "../controls/symbols.ts";
import { woven, type Fabric } from "../state/document.ts";
import type { Dispatch } from "../state/store.ts";

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
        {["gap", "specular", "roughness", "translucency"].map((key) => (
          <YarnSlider key={key} fabric={fabric} dispatch={dispatch} families={families} name={key} />
        ))}
        <TintField fabric={fabric} dispatch={dispatch} families={families} />
      </section>
      <section class="group">
        <h2>How it is spun</h2>
        {["twist_deg", "plies", "ply_twist_deg", "fibre_tilt_deg", "slub", "hairiness"].map((key) => (
          <YarnSlider key={key} fabric={fabric} dispatch={dispatch} families={families} name={key} />
        ))}
      </section>
      <section class="group">
        <h2>How it lies</h2>
        {["height_scale", "inclination_deg"].map((key) => (
          <YarnSlider key={key} fabric={fabric} dispatch={dispatch} families={families} name={key} />
        ))}
      </section>
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
      onValue={(number, stroke) => dispatch({ type: "field/set", field, value: number, stroke })}
      onReset={() => {
        dispatch({ type: "field/set", field, value: undefined });
        dispatch({ type: "field/set", field: family === "warp" ? "epi" : "ppi", value: undefined });
      }}
    />
  );
}

interface FamiliesProps extends Props {
  readonly families: readonly FamilyName[];
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
      onValue={(number, stroke) => {
        for (const each of families) dispatch({ type: "field/set", field: `${each}.${name}`, value: number, stroke });
      }}
      onReset={() => {
        for (const each of families) dispatch({ type: "field/set", field: `${each}.${name}`, value: undefined, stroke: "reset" });
      }}
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
    return Math.min(Math.max(1 - width[0]! / spacing[0]!, 0), 0.95);
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
      <label class="tip" data-tip="Other defaults of gloss, roughness, translucency and twist (yarn)" for={`kind-${label}`}>
        Kind of yarn
      </label>
      <select
        id={`kind-${label}`}
        class="text"
        value={kind}
        data-testid={`field-${label}.yarn`}
        onChange={(event) => {
          const value = event.currentTarget.value || undefined;
          for (const each of families) dispatch({ type: "field/set", field: `${each}.yarn`, value, stroke: `yarn-${value}` });
        }}
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
  const tex = count === "" ? null : `${Math.round(yarnTex(count))} tex`;
  const label = families.length === 2 ? "both" : families[0]!;
  return (
    <div class="row is-field">
      <label class="tip" data-tip="Gives the width of a round yarn of that count and kind, in place of the openness" for={`count-${label}`}>
        Yarn count
      </label>
      <input
        id={`count-${label}`}
        class="text"
        type="text"
        placeholder="30 tex, Ne 40/2 …"
        value={count}
        data-testid={`field-${label}.count`}
        onChange={(event) => {
          const text = event.currentTarget.value.trim();
          for (const each of families)
            dispatch({ type: "field/set", field: `${each}.count`, value: text === "" ? undefined : text, stroke: `count-${text}` });
        }}
      />
      {tex !== null && <span class="hint">{tex}</span>}
    </div>
  );
}

/** What a square metre weighs; with counts of both yarns it can be set, and the sett follows. */
function WeightField({ fabric, dispatch }: Props) {
  const { weight, isCounted } = clothFacts(fabric.fields, woven(fabric));
  const [fault, setFault] = useState("");
  const apply = (text: string): void => {
    try {
      const setts = settsOfWeight(fabric.fields, woven(fabric), Number(text.replace(",", ".")));
      const stroke = newStroke();
      dispatch({ type: "field/set", field: "ends_per_cm", value: setts.warp, stroke });
      dispatch({ type: "field/set", field: "picks_per_cm", value: setts.weft, stroke });
      setFault("");
    } catch (error) {
      if (!(error instanceof InputError)) throw error;
      setFault(error.message);
    }
  };
  return (
    <div class="row is-field">
      <label class="tip" for="weight" data-tip="Threads per metre times their tex and crimp (Peirce 1937). Give both yarns a count, and you can set it: the sett follows">
        Weight
      </label>
      {isCounted ? (
        <>
          <input id="weight" class="text" type="text" inputMode="decimal" value={weight.toFixed(0)} aria-invalid={fault !== ""} data-testid="weight" onChange={(event) => apply(event.currentTarget.value)} />
          <span class="hint">g/m²</span>
        </>
      ) : (
        <output id="weight" class="hint" data-testid="weight">
          at most {weight.toFixed(0)} g/m², without counts
        </output>
      )}
      {fault !== "" && (
        <span class="fault" role="alert">
          {fault}
        </span>
      )}
    </div>
  );
}

/** The colour of the highlight: that of dyed fibres' surface is white, of metal thread its own. */
function TintField({ fabric, dispatch, families }: FamiliesProps) {
  const label = families.length === 2 ? "both" : families[0]!;
  const own = fabric.fields[families[0]!]?.specular_tint;
  const hex = own === undefined ? "#ffffff" : toHex(parseColour(own, "specular_tint"));
  const stroke = useRef(newStroke());
  const set = (value: string | undefined): void => {
    for (const family of families) dispatch({ type: "field/set", field: `${family}.specular_tint`, value, stroke: stroke.current });
  };
  return (
    <div class="row">
      <label class="tip" for={`tint-${label}`} data-tip="Multiplies the fibres' highlight: white but for metal threads (specular_tint)">
        Colour of the lustre
      </label>
      <input
        id={`tint-${label}`}
        type="color"
        value={hex}
        data-testid={`field-${label}.specular_tint`}
        onPointerDown={() => (stroke.current = newStroke())}
        onInput={(event) => set(event.currentTarget.value)}
      />
      {own !== undefined && (
        <button type="button" class="reset" onClick={() => set(undefined)} aria-label="Colour of the lustre: back to white" title="Back to white">
          ↺
        </button>
      )}
    </div>
  );
}

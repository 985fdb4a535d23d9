/** The finish of the whole cloth: print, nap, unevenness, and how the shade falls. */
import { useEffect, useRef } from "preact/hooks";

import { Segmented } from "../controls/Segmented.tsx";
import { Slider } from "../controls/Slider.tsx";
import { CLOTH_QUANTITIES } from "../controls/symbols.ts";
import type { Fabric } from "../state/document.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";
import type { Print } from "../view/cloth_view.ts";

interface Props {
  readonly fabric: Fabric;
  readonly dispatch: Dispatch;
  readonly print: Print | null;
  /** Whether the cloth is shown flat, without light. */
  readonly isFlat: boolean;
  readonly onPrint: (file: File | undefined) => void;
  readonly onPrintOff: () => void;
}

export function FinishPanel({ fabric, dispatch, print, isFlat, onPrint, onPrintOff }: Props) {
  const slider = (field: string) => {
    const own = valueAt(fabric, field);
    const quantity = CLOTH_QUANTITIES[field]!;
    return (
      <Slider
        key={field}
        field={field}
        quantity={quantity}
        value={own ?? quantity.standard}
        isOwn={own !== undefined}
        onValue={(value, stroke) => refusalOf(dispatch, { type: "field/set", field, value, stroke })}
        onReset={() => dispatch({ type: "field/set", field, value: undefined })}
      />
    );
  };
  const seed = fabric.fields.variation?.seed ?? 0;
  return (
    <>
      {isFlat && <p class="note is-flat">Here the cloth is shown flat: the print shows; nap, sparkle, light between yarns and depth need WebGPU.</p>}
      <section class="group">
        <h2>Print</h2>
        <p class="note">A picture over the cloth, as a printer lays it on. It is not part of the fabric file.</p>
        <div class="print">
          {print !== null && <Thumbnail print={print} />}
          <label class="button">
            <input
              type="file"
              class="visually-hidden"
              accept="image/*"
              data-testid="print-file"
              onChange={(event) => {
                onPrint(event.currentTarget.files?.[0]);
                event.currentTarget.value = "";
              }}
            />
            <span class="tip" title="Albedo map: multiplies the diffuse albedos over the unit of uv">
              {print === null ? "Choose a picture" : "Another picture"}
            </span>
          </label>
          {print !== null && (
            <button type="button" class="button" data-testid="print-off" onClick={onPrintOff}>
              Remove
            </button>
          )}
        </div>
      </section>
      <section class="group">
        <h2>Surface</h2>
        {slider("sheen.strength")}
        {slider("sheen.roughness")}
      </section>
      <section class="group">
        <h2>Character</h2>
        {slider("variation.irregularity")}
        {slider("variation.colour_noise")}
        {slider("variation.fibre_noise")}
        {slider("wear")}
        <div class="row">
          <span class="tip" data-tip="The seed of the variation: another piece of the same cloth">
            Piece {seed}
          </span>
          <button
            type="button"
            class="button"
            data-testid="another-piece"
            onClick={() => dispatch({ type: "field/set", field: "variation.seed", value: (seed + 1) % 1000 })}
          >
            Cut another piece
          </button>
        </div>
      </section>
      <section class="group">
        <h2>Light between yarns</h2>
        <Segmented
          label="Light between yarns"
          testid="between-yarns"
          choices={[
            ["on", "On"],
            ["off", "Off"],
          ]}
          value={fabric.fields.interreflection === false ? "off" : "on"}
          onChoose={(chosen) =>
            dispatch({ type: "field/set", field: "interreflection", value: chosen === "off" ? false : undefined })
          }
        />
        <p class="note">
          Yarns light each other, and a colour is what flat cloth of that yarn shows.
        </p>
      </section>
      <section class="group">
        <h2>Depth</h2>
        {slider("diffuse_blend")}
        {slider("optical_depth")}
      </section>
    </>
  );
}

function Thumbnail({ print }: { readonly print: Print }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => canvas.current!.getContext("2d")!.drawImage(print.canvas, 0, 0, 144, 144), [print]);
  return <canvas ref={canvas} width={144} height={144} role="img" aria-label={`Print: ${print.name}`} />;
}

function valueAt(fabric: Fabric, field: string): number | undefined {
  let value: unknown = fabric.fields;
  for (const key of field.split(".")) value = (value as Record<string, unknown> | undefined)?.[key];
  return typeof value === "number" ? value : undefined;
}

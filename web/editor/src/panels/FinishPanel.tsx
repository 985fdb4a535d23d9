/** The finish of the whole cloth: nap, unevenness, and how the shade falls. */
import { Segmented } from "../controls/Segmented.tsx";
import { Slider } from "../controls/Slider.tsx";
import { CLOTH_QUANTITIES } from "../controls/symbols.ts";
import type { Fabric } from "../state/document.ts";
import type { Dispatch } from "../state/store.ts";

interface Props {
  readonly fabric: Fabric;
  readonly dispatch: Dispatch;
}

export function FinishPanel({ fabric, dispatch }: Props) {
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
        onValue={(value, stroke) => dispatch({ type: "field/set", field, value, stroke })}
        onReset={() => dispatch({ type: "field/set", field, value: undefined })}
      />
    );
  };
  const isBetween = fabric.fields.interreflection === true;
  const seed = fabric.fields.variation?.seed ?? 0;
  return (
    <>
      <section class="group">
        <h2>Nap</h2>
        {slider("sheen.strength")}
        {slider("sheen.roughness")}
      </section>
      <section class="group">
        <h2>Character</h2>
        {slider("variation.colour_noise")}
        {slider("variation.fibre_noise")}
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
        <h2>Depth</h2>
        <p class="tip" data-tip="Light that goes from yarn to yarn: white cloth is white, and colours are those that flat cloth shows">
          Light between yarns
        </p>
        <Segmented
          label="Light between yarns"
          testid="between-yarns"
          choices={[
            ["off", "Off"],
            ["on", "On"],
          ]}
          value={isBetween ? "on" : "off"}
          onChoose={(choice) =>
            dispatch({ type: "field/set", field: "interreflection", value: choice === "on" ? true : undefined })
          }
        />
        {slider("diffuse_blend")}
        {slider("optical_depth")}
      </section>
    </>
  );
}

function valueAt(fabric: Fabric, field: string): number | undefined {
  let value: unknown = fabric.fields;
  for (const key of field.split(".")) value = (value as Record<string, unknown> | undefined)?.[key];
  return typeof value === "number" ? value : undefined;
}

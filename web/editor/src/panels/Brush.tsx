/** The colour that threads are painted with: one in use, or any other. */
import { coloursInUse, threadHexes } from "loomlight-fabric";

import { ColourText, STANDARDS } from "../controls/ColourText.tsx";
import { useCards } from "../keeping/cards.ts";
import { woven, type Fabric } from "../state/document.ts";

interface Props {
  readonly fabric: Fabric;
  readonly value: string;
  readonly onValue: (hex: string) => void;
}

/** Colours of dyed yarns, for a start. */
const DYES = ["#1d2536", "#30497a", "#3a6ea8", "#6f8f6b", "#c8a24a", "#b4552d", "#7d2b33", "#e6dfce"];
const MAX = 10;
/** Names of standards that fields propose; others are written, or chosen from their card. */
const MAX_PROPOSED = 500;

export function Brush({ fabric, value, onValue }: Props) {
  const draft = woven(fabric);
  const standards = useCards().flatMap(({ colours }) => colours).slice(0, MAX_PROPOSED);
  const used = coloursInUse([...threadHexes(draft, "warp"), ...threadHexes(draft, "weft")]).map(({ hex }) => hex);
  const hexes = [...new Set([...used.slice(0, MAX), ...DYES])];
  return (
    <div class="brush" role="group" aria-label="Colour to paint threads with">
      <span class="tip" data-tip="Then click or drag along the colour bars: above the threading for ends, at the right for picks">
        Paint with
      </span>
      {hexes.map((hex) => (
        <button
          key={hex}
          type="button"
          class={`chip${hex === value ? " is-chosen" : ""}`}
          style={{ background: hex }}
          aria-label={`Paint with ${hex}`}
          aria-pressed={hex === value}
          data-testid={`brush-${hex.slice(1)}`}
          onClick={() => onValue(hex)}
        />
      ))}
      <label class="chip chip-other" title="Another colour">
        <span class="visually-hidden">Another colour</span>
        <input type="color" value={value} data-testid="brush-other" onInput={(event) => onValue(event.currentTarget.value)} />
      </label>
      <ColourText
        hex={value}
        label="Colour to paint with, written"
        field="colour"
        testid="brush-written"
        onHex={(hex) => {
          onValue(hex);
          return null;
        }}
      />
      <datalist id={STANDARDS}>
        {standards.map(({ name }, index) => (
          <option key={index} value={name} />
        ))}
      </datalist>
    </div>
  );
}

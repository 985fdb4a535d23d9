/** Buttons for what can be done to the selected crossings. */
import type { BlockChange } from "loomlight-fabric";
import { useState } from "preact/hooks";

import { Fault } from "../controls/written.tsx";
import type { Selection } from "./selection.ts";

/** Each change: what its button shows, its name, and its key. */
const CHANGES: readonly (readonly [BlockChange, string, string, string])[] = [
  ["mirror-ends", "⇋", "Mirror left and right", "H"],
  ["mirror-picks", "⥮", "Mirror up and down", "V"],
  ["turn", "↻", "Turn by a quarter", "R"],
  ["face", "◩", "Bring the other thread on top", "I"],
  ["shift-left", "←", "Shift to the left", "Alt ←"],
  ["shift-up", "↑", "Shift up", "Alt ↑"],
  ["shift-down", "↓", "Shift down", "Alt ↓"],
  ["shift-right", "→", "Shift to the right", "Alt →"],
];

/** Weaves that are proposed; any other name of a weave can be written. */
const WEAVES = ["plain", "basket 2/2", "twill 2/2", "twill 3/1", "twill 1/3", "satin 5/2", "sateen 5/2", "satin 8/3", "sateen 8/3", "herringbone 2/2 8"];

export function SelectionBar({ selection }: { readonly selection: Selection }) {
  const { region, copied, isSelecting } = selection;
  const [weave, setWeave] = useState("plain");
  const isNone = region === null;
  const button = (id: string, text: string, title: string, act: () => void, isDisabled = isNone) => (
    <button type="button" class="button" title={title} data-testid={`selection-${id}`} disabled={isDisabled} onClick={act}>
      {text}
    </button>
  );
  return (
    <div class="selection-bar" role="toolbar" aria-label="Selection">
      <button
        type="button"
        class="button"
        aria-pressed={isSelecting}
        title="Drag to select crossings; without it, Shift and drag, or Shift and arrows"
        data-testid="selection-mode"
        onClick={() => selection.setSelecting(!isSelecting)}
      >
        Select
      </button>
      {button("copy", "Copy", "Copy (Ctrl C)", selection.copy)}
      {button("cut", "Cut", "Copy, and leave the weft on top (Ctrl X)", selection.cut)}
      {button("paste", "Paste", "Paste from the selection's lower left corner on (Ctrl V)", () => selection.paste(), copied === null)}
      {button("fill-copy", "Fill with copy", "Fill the selection with repeats of the copy (Ctrl Shift V)", selection.fillWithCopy, isNone || copied === null)}
      <span class="selection-changes">
        {CHANGES.map(([change, sign, name, key]) => (
          <button key={change} type="button" class="button" disabled={isNone} aria-label={name} title={`${name} (${key})`} data-testid={`selection-${change}`} onClick={() => selection.change(change)}>
            {sign}
          </button>
        ))}
      </span>
      {button("repeat", "Repeat", "Repeat the selection over the whole draft (T)", selection.repeat)}
      <form
        class="selection-fill"
        onSubmit={(event) => {
          event.preventDefault();
          selection.fill(weave);
        }}
      >
        <input class="text" value={weave} list="selection-weaves" spellcheck={false} aria-label="Weave to fill the selection with" data-testid="selection-weave" onInput={(event) => setWeave(event.currentTarget.value)} />
        <datalist id="selection-weaves">
          {WEAVES.map((name) => (
            <option key={name} value={name} />
          ))}
        </datalist>
        <button type="submit" class="button" disabled={isNone} title="Fill the selection with this weave" data-testid="selection-fill">
          Fill
        </button>
      </form>
      <output data-testid="selection">
        {region === null
          ? "Nothing is selected."
          : `${region.ends} × ${region.picks} from end ${region.firstEnd + 1}, pick ${region.firstPick + 1}`}
      </output>
      <Fault text={selection.fault} />
    </div>
  );
}

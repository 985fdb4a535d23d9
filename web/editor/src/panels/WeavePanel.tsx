/** The gallery: whole fabrics, one's own and those that come with the page, and weaves by name as tiles drawn as drawdowns. */
import { loadDraft, toHex, type Draft } from "loomlight-fabric";
import { useEffect, useRef, useState } from "preact/hooks";

import type { GalleryEntry } from "loomlight-fabric";
import { Fault, useWritten } from "../controls/written.tsx";
import type { Fabric } from "../state/document.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";
import { ArtworkSection } from "./ArtworkSection.tsx";
import { isFound } from "./found.ts";
import { Gallery } from "./Gallery.tsx";

interface Props {
  readonly fabric: Fabric;
  readonly gallery: readonly GalleryEntry[];
  readonly dispatch: Dispatch;
  /** Chooses files to open. */
  readonly onOpen: () => void;
}

const GROUPS: readonly (readonly [string, readonly string[]])[] = [
  ["Plain", ["plain", "basket 2/2", "warp rib 2/2", "weft rib 2/2", "crepe", "waffle 8"]],
  ["Twill", ["twill 2/1", "twill 2/2", "twill 3/1", "twill 1/3 s", "twill 3/1/1/2", "herringbone 2/2 8", "diamond 2/2 8"]],
  ["Satin", ["satin 5/2", "satin 8/3", "sateen 5/2", "sateen 8/3"]],
  ["Colour and weave", ["houndstooth 4", "shepherd's check 12", "glen check 2", "gingham 8", "log cabin 8", "hairline", "pinstripe 12", "denim", "chambray"]],
  ["Figured", ["argyle 64", "diamond figure 96", "damask 160"]],
];
/** Threads of a weave that a tile shows, each way. */
const TILE_THREADS = 24;
const TILE_SIDE = 96;
/** Threads of weaves without colours of their own. */
const WARP = "#2f3f66";
const WEFT = "#fffdf8";

export function WeavePanel({ fabric, gallery, dispatch, onOpen }: Props) {
  const current = fabric.fields.weave ?? "";
  const written = useWritten(current, (text) => (text.trim() === "" ? null : refusalOf(dispatch, { type: "weave/choose", weave: text })));
  const [sought, seek] = useState("");
  const groups = GROUPS.map(([title, weaves]) => [title, weaves.filter((weave) => isFound(sought, weave, title))] as const).filter(([, weaves]) => weaves.length > 0);
  return (
    <>
      <ArtworkSection fabric={fabric} dispatch={dispatch} />
      <input
        class="text gallery-search"
        type="search"
        value={sought}
        placeholder="Search: wool twill, satin, Ne 40"
        aria-label="Search fabrics and weaves"
        data-testid="gallery-search"
        onInput={(event) => seek(event.currentTarget.value)}
      />
      <Gallery fabric={fabric} gallery={gallery} sought={sought} dispatch={dispatch} />
      <section class="group">
        <h2>Weaves</h2>
        <form
          class="row"
          onSubmit={(event) => {
            event.preventDefault();
            written.enter(written.text);
          }}
        >
          <label class="tip" for="weave-name" data-tip="Any weave by its name, with your own numbers: twill 5/1/1/1 s, satin 12/5, houndstooth 6">
            By name
          </label>
          <input {...written.input} onChange={undefined} id="weave-name" class="text" placeholder="twill 3/1/1/2 s" data-testid="weave-name" />
          <button type="submit" class="button" data-testid="weave-apply">
            Weave
          </button>
          <Fault text={written.fault} />
        </form>
        <p class="note">
          Or your own: drop a draft (.wif), a picture of a drawdown, an artwork whose colours are weaves, or a fabric on the page, or{" "}
          <button type="button" class="text-button" data-testid="open-own" onClick={onOpen}>
            choose a file
          </button>
          .
        </p>
        {groups.map(([title, weaves]) => (
          <div key={title}>
            <h3>{title}</h3>
            <div class="tiles">
              {weaves.map((weave) => (
                <WeaveTile
                  key={weave}
                  weave={weave}
                  isChosen={weave === current}
                  onChoose={() => dispatch({ type: "weave/choose", weave })}
                />
              ))}
            </div>
          </div>
        ))}
      </section>
    </>
  );
}

function WeaveTile({ weave, isChosen, onChoose }: { weave: string; isChosen: boolean; onChoose: () => void }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => drawDrawdown(canvas.current!, loadDraft({ weave })), [weave]);
  return (
    <button type="button" class={`tile${isChosen ? " is-chosen" : ""}`} aria-pressed={isChosen} data-testid={`weave-${weave.replace(/[ /]/g, "-")}`} onClick={onChoose}>
      <canvas ref={canvas} width={TILE_SIDE} height={TILE_SIDE} aria-hidden="true" />
      <span>{weave}</span>
    </button>
  );
}

/** The drawdown: filled where the warp is on top, in the thread on top's colour where the weave brings colours. */
function drawDrawdown(canvas: HTMLCanvasElement, draft: Draft): void {
  const context = canvas.getContext("2d")!;
  const isFigured = draft.ends > 3 * TILE_THREADS;
  const hasColours = draft.palette !== null;
  const threads = isFigured ? draft.ends : hasColours ? Math.max(TILE_THREADS, Math.min(draft.ends, 48)) : smallTile(draft);
  const cell = TILE_SIDE / threads;
  context.fillStyle = WEFT;
  context.fillRect(0, 0, TILE_SIDE, TILE_SIDE);
  for (let pick = 0; pick < threads; pick++)
    for (let end = 0; end < threads; end++) {
      const [row, column] = [pick % draft.picks, end % draft.ends];
      const isUp = draft.drawdown[row * draft.ends + column] === 1;
      context.fillStyle = hasColours
        ? hexOf((isUp ? draft.warp : draft.weft).colors!, isUp ? column : row)
        : isUp
          ? WARP
          : WEFT;
      const [left, top] = [Math.round(end * cell), Math.round(TILE_SIDE - (pick + 1) * cell)];
      context.fillRect(left, top, Math.round((end + 1) * cell) - left, Math.round(TILE_SIDE - pick * cell) - top);
    }
}

/** So many threads that small repeats are seen a few times in large cells. */
function smallTile(draft: Draft): number {
  const repeat = Math.max(draft.ends, draft.picks);
  return repeat <= 4 ? 12 : repeat <= 8 ? 16 : TILE_THREADS;
}

function hexOf(colors: Float64Array, thread: number): string {
  return toHex(colors.subarray(3 * thread, 3 * thread + 3));
}

/** The draft over the whole stage: any number of threads, scrolled and zoomed; only the cells in sight are drawn. */
import { clamp, loomOf, type Region } from "loomlight-fabric";
import { useEffect, useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";

import { Icon } from "../controls/Icon.tsx";
import { useSize } from "../controls/use_size.ts";
import { woven, type Fabric } from "../state/document.ts";
import type { Dispatch } from "../state/store.ts";
import { DraftGrid } from "./DraftGrid.tsx";
import { fittingCell, planSize, type Window } from "./draft_grid.ts";
import { useFingers } from "./fingers.ts";
import type { Selection } from "./selection.ts";
import { SelectionBar } from "./SelectionBar.tsx";

interface Props {
  readonly fabric: Fabric;
  readonly dispatch: Dispatch;
  readonly brush: string;
  readonly marks: Uint8Array | null;
  readonly selection: Selection;
  /** Threads to bring into sight, another object each time they are asked for. */
  readonly sought: Region | null;
  readonly onClose: () => void;
}

/** Screen pixels a cell. */
const SMALLEST = 5;
const LARGEST = 36;
/** Room around the drawing, and for the bars that scroll it. */
const MARGIN = 20;
/** Threads of either family that are in sight at least. */
const MIN_THREADS = 4;

export function DraftWindow({ fabric, dispatch, brush, marks, selection, sought, onClose }: Props) {
  const draft = woven(fabric);
  const loom = useMemo(() => loomOf(draft), [draft]);
  const plan = useMemo(() => planSize(loom), [loom]);
  const area = useRef<HTMLDivElement>(null);
  const { width, height } = useSize(area);
  const [chosen, choose] = useState<number | null>(null);
  // The first threads in sight; pick 1 is where one begins to read.
  const [first, setFirst] = useState({ end: 0, pick: 0 });
  const whole = { columns: draft.ends + plan.columns, rows: draft.picks + plan.rows };
  const fitting = fittingCell(whole, { width: width - MARGIN, height: height - MARGIN }, SMALLEST, LARGEST);
  const cell = chosen ?? Math.max(fitting, 12);
  const inSight = (pixels: number, ofPlan: number, threads: number): number =>
    Math.min(threads, Math.max(MIN_THREADS, Math.floor((pixels - MARGIN) / cell) - ofPlan));
  const ends = inSight(width, plan.columns, draft.ends);
  const picks = inSight(height, plan.rows, draft.picks);
  const atMost = (threads: number, most: number): number => clamp(threads, 0, most);
  const firstEnd = atMost(first.end, draft.ends - ends);
  const firstPick = atMost(first.pick, draft.picks - picks);
  const window: Window = { firstEnd, firstPick, ends, picks };

  // Pick 1 is at the bottom: scrolling down goes towards it.
  const show = (end: number, pick: number): void => {
    area.current!.scrollLeft = end * cell;
    area.current!.scrollTop = (draft.picks - picks - pick) * cell;
  };
  // The same threads stay in sight at every zoom and size.
  useLayoutEffect(() => show(firstEnd, firstPick), [cell, width, height, draft.ends, draft.picks]);
  const onScroll = ({ scrollLeft, scrollTop }: HTMLElement): void => {
    const end = Math.round(scrollLeft / cell);
    const pick = draft.picks - picks - Math.round(scrollTop / cell);
    if (end !== first.end || pick !== first.pick) setFirst({ end, pick });
  };
  const step = (right: number, up: number): void =>
    setFirst((before) => {
      const next = { end: atMost(before.end + right, draft.ends - ends), pick: atMost(before.pick + up, draft.picks - picks) };
      show(next.end, next.pick);
      return next;
    });
  // Its middle goes to the middle of the window.
  useLayoutEffect(() => {
    if (sought === null || width === 0) return;
    const end = atMost(sought.firstEnd + Math.floor((sought.ends - ends) / 2), draft.ends - ends);
    const pick = atMost(sought.firstPick + Math.floor((sought.picks - picks) / 2), draft.picks - picks);
    setFirst({ end, pick });
    show(end, pick);
  }, [sought, width === 0]);
  useEffect(() => {
    const before = document.activeElement;
    area.current!.querySelector("canvas")?.focus();
    return () => before instanceof HTMLElement && before.focus();
  }, []);
  const sized = (pixels: number): void => choose(atMost(Math.round(pixels) - SMALLEST, LARGEST - SMALLEST) + SMALLEST);
  const zoom = (steps: number): void => sized(cell + steps);
  const rest = useRef({ x: 0, y: 0 });
  const fingers = useFingers((right, down, ratio, cellBefore) => {
    // Whole threads; what is left of the way counts for the next ones.
    const [x, y] = [rest.current.x + right, rest.current.y + down];
    const [across, along] = [Math.trunc(x / cell), Math.trunc(y / cell)];
    rest.current = { x: x - across * cell, y: y - along * cell };
    if (across !== 0 || along !== 0) step(-across, along);
    sized(cellBefore * ratio);
  }, cell);

  return (
    <section
      class="draft-window"
      aria-label="Draft in the whole window"
      data-testid="draft-window"
      onKeyDown={(event) => {
        // In a field Escape brings back what was written.
        if (event.key === "Escape" && !(event.target instanceof HTMLInputElement && event.target.type === "text")) onClose();
      }}
      onWheel={(event) => {
        if (!event.ctrlKey) return;
        event.preventDefault();
        zoom(event.deltaY < 0 ? 1 : -1);
      }}
    >
      <div class="draft-window-bar">
        <output data-testid="draft-in-sight">
          Ends {firstEnd + 1}–{firstEnd + ends} of {draft.ends}, picks {firstPick + 1}–{firstPick + picks} of {draft.picks}
        </output>
        <label class="zoom">
          <span>Cells</span>
          <input type="range" min={SMALLEST} max={LARGEST} step={1} value={cell} aria-label="Size of the cells" data-testid="draft-zoom" onInput={(event) => choose(event.currentTarget.valueAsNumber)} />
        </label>
        <button type="button" class="icon-button" aria-label="Close" title="Back to the cloth (Esc)" data-testid="draft-window-close" onClick={onClose}>
          <Icon name="close" />
        </button>
      </div>
      <SelectionBar selection={selection} />
      <div
        class="draft-window-area"
        ref={area}
        tabIndex={-1}
        onScroll={(event) => onScroll(event.currentTarget)}
        {...fingers}
      >
        <div
          class="draft-window-size"
          style={{
            width: `${Math.max(width, (plan.columns + ends) * cell + MARGIN) + (draft.ends - ends) * cell}px`,
            height: `${Math.max(height, (plan.rows + picks) * cell + MARGIN) + (draft.picks - picks) * cell}px`,
          }}
        >
          <DraftGrid fabric={fabric} dispatch={dispatch} window={window} brush={brush} cell={cell} marks={marks} selection={selection} onEdge={step} />
        </div>
      </div>
    </section>
  );
}

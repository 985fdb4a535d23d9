/** The draft editor: drawing, numbers of threads and shafts, and the kind of plan. */
import { longFloats, loomOf, ORDERS, threadHexes, within, type Float, type Order, type Region } from "loomlight-fabric";
import { useMemo, useRef, useState } from "preact/hooks";

import { Icon } from "../controls/Icon.tsx";
import { Segmented } from "../controls/Segmented.tsx";
import { Stepper } from "../controls/Stepper.tsx";
import { useSize } from "../controls/use_size.ts";
import { isNamed, woven, type Fabric } from "../state/document.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";
import { Brush } from "./Brush.tsx";
import { DraftGrid } from "./DraftGrid.tsx";
import { fittingCell, layoutOf, panelWindow, WINDOW } from "./draft_grid.ts";
import { DraftWindow } from "./DraftWindow.tsx";
import { FloatReport, regionOf } from "./FloatReport.tsx";
import { useSelection } from "./selection.ts";

/** Screen pixels a cell: where smaller ones would be needed to show all, the drawing has a bar to scroll it. */
const SMALLEST = 4;
const LARGEST = 26;

interface Props {
  readonly fabric: Fabric;
  readonly dispatch: Dispatch;
}

export function DraftPanel({ fabric, dispatch }: Props) {
  const draft = woven(fabric);
  const loom = useMemo(() => loomOf(draft), [draft]);
  const [page, setPage] = useState({ end: 0, pick: 0 });
  const [brush, setBrush] = useState<string | null>(null);
  const firstEnd = Math.min(page.end, Math.floor((draft.ends - 1) / WINDOW) * WINDOW);
  const firstPick = Math.min(page.pick, Math.floor((draft.picks - 1) / WINDOW) * WINDOW);
  const window = panelWindow(draft, firstEnd, firstPick);
  const frame = useRef<HTMLDivElement>(null);
  const { width } = useSize(frame);
  const [isWide, setWide] = useState(false);
  const cells = layoutOf(loom, window);
  // As wide as the panel; what is higher is scrolled.
  const cell = fittingCell({ columns: cells.columns, rows: 1 }, { width, height: Infinity }, SMALLEST, LARGEST);
  const colour = brush ?? threadHexes(draft, "weft")[0] ?? "#ffffff";
  const isLiftplan = loom.tieup === null;
  const [limit, setLimit] = useState<number | null>(null);
  const floats = useMemo(() => (limit === null ? null : longFloats(draft, limit)), [draft.drawdown, limit]);
  const selection = useSelection(draft, dispatch);
  const [sought, seek] = useState<Region | null>(null);
  /** Selects a float and brings it into sight. */
  const goTo = (float: Float): void => {
    const found = within(regionOf(float), draft)!;
    selection.select(found);
    seek({ ...found });
    const pageOf = (thread: number): number => Math.floor(thread / WINDOW) * WINDOW;
    setPage({ end: pageOf(found.firstEnd), pick: pageOf(found.firstPick) });
  };
  return (
    <>
      <p class="note">
        Click a crossing to bring the other thread on top; or change threading, tie-up and treadling, and the cloth follows.
        {isNamed(fabric) && " Your first change makes this weave a draft of your own."}
      </p>
      <div class="draft-scroll" ref={frame}>
        {!isWide && width > 0 && <DraftGrid fabric={fabric} dispatch={dispatch} window={window} brush={colour} cell={cell} marks={floats?.marks ?? null} selection={{ ...selection, isSelecting: false }} />}
      </div>
      {isWide && <DraftWindow fabric={fabric} dispatch={dispatch} brush={colour} marks={floats?.marks ?? null} selection={selection} sought={sought} onClose={() => setWide(false)} />}
      {!isWide && <Pages label="Ends" first={firstEnd} count={draft.ends} onFirst={(end) => setPage({ ...page, end })} />}
      {!isWide && <Pages label="Picks" first={firstPick} count={draft.picks} onFirst={(pick) => setPage({ ...page, pick })} />}
      <button type="button" class="button" aria-pressed={isWide} data-testid="draft-wide" onClick={() => setWide(!isWide)}>
        <Icon name="frame" />
        {isWide ? "Back to the cloth" : "Draft in the whole window"}
      </button>
      <Brush fabric={fabric} value={colour} onValue={setBrush} />
      <section class="group">
        <h2>Loom</h2>
        <Segmented
          label="Plan"
          testid="plan"
          choices={[
            ["treadling", "Tie-up and treadling"],
            ["liftplan", "Lift plan"],
          ]}
          value={isLiftplan ? "liftplan" : "treadling"}
          onChoose={(kind) => dispatch({ type: "draft/plan", kind })}
        />
        <div class="steppers">
          <Stepper label="Ends" testid="ends" value={draft.ends} onValue={(ends) => refusalOf(dispatch, { type: "draft/size", ends, picks: draft.picks })} />
          <Stepper label="Picks" testid="picks" value={draft.picks} onValue={(picks) => refusalOf(dispatch, { type: "draft/size", ends: draft.ends, picks })} />
          <Stepper label="Shafts" testid="shafts" value={loom.shafts} onValue={(shafts) => refusalOf(dispatch, { type: "draft/shafts", shafts, treadles: loom.treadles })} />
          {!isLiftplan && (
            <Stepper label="Treadles" testid="treadles" value={loom.treadles} onValue={(treadles) => refusalOf(dispatch, { type: "draft/shafts", shafts: loom.shafts, treadles })} />
          )}
        </div>
        <OrderChoice part="threading" label="Thread" dispatch={dispatch} />
        {!isLiftplan && <OrderChoice part="treadling" label="Treadle" dispatch={dispatch} />}
        <button type="button" class="button" data-testid="turn-over" onClick={() => dispatch({ type: "draft/over" })}>
          Turn the cloth over
        </button>
      </section>
      <FloatReport floats={floats} limit={limit} onLimit={setLimit} onFloat={goTo} />
    </>
  );
}

const ORDER_NAMES: Readonly<Record<Order, string>> = {
  straight: "straight: 1 2 3 4",
  reversed: "reversed: 4 3 2 1",
  point: "point: 1 2 3 4 3 2",
  broken: "broken: 1 2 4 3",
};

/** Threads all ends, or treadles all picks, in an order. */
function OrderChoice({ part, label, dispatch }: { part: "threading" | "treadling"; label: string; dispatch: Dispatch }) {
  return (
    <div class="row is-field">
      <label for={`order-of-${part}`}>{label}</label>
      <select
        id={`order-of-${part}`}
        class="text"
        value=""
        data-testid={`order-of-${part}`}
        onChange={(event) => {
          const order = event.currentTarget.value as Order;
          event.currentTarget.value = "";
          dispatch({ type: "draft/order", part, order });
        }}
      >
        <option value="">choose an order …</option>
        {ORDERS.map((order) => (
          <option key={order} value={order}>
            {ORDER_NAMES[order]}
          </option>
        ))}
      </select>
    </div>
  );
}

function Pages({ label, first, count, onFirst }: { label: string; first: number; count: number; onFirst: (first: number) => void }) {
  if (count <= WINDOW) return null;
  return (
    <div class="row pages">
      <span>
        {label} {first + 1} to {Math.min(first + WINDOW, count)} of {count}
      </span>
      <button type="button" class="button" disabled={first === 0} onClick={() => onFirst(Math.max(first - WINDOW, 0))}>
        Earlier
      </button>
      <button type="button" class="button" disabled={first + WINDOW >= count} onClick={() => onFirst(first + WINDOW)}>
        Later
      </button>
    </div>
  );
}

/** The draft editor: drawing, numbers of threads and shafts, and the kind of plan. */
import { longFloats, loomOf, MAXIMUM_THREADS, ORDERS, threadHexes, type LongFloats, type Order } from "loomlight-fabric";
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

/** Screen pixels a cell: smaller ones are scrolled sideways. */
const SMALLEST = 7;
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
  return (
    <>
      <p class="note">
        Click a crossing to bring the other thread on top; or change threading, tie-up and treadling, and the cloth follows.
        {isNamed(fabric) && " Your first change makes this weave a draft of your own."}
      </p>
      <div class="draft-scroll" ref={frame}>
        {!isWide && width > 0 && <DraftGrid fabric={fabric} dispatch={dispatch} window={window} brush={colour} cell={cell} marks={floats?.marks ?? null} />}
      </div>
      {isWide && <DraftWindow fabric={fabric} dispatch={dispatch} brush={colour} marks={floats?.marks ?? null} onClose={() => setWide(false)} />}
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
      <FloatReport floats={floats} limit={limit} onLimit={setLimit} />
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

interface FloatReportProps {
  readonly floats: LongFloats | null;
  readonly limit: number | null;
  readonly onLimit: (limit: number | null) => void;
}

/** Marks floats that cross more threads than one wants, and says how many there are. */
function FloatReport({ floats, limit, onLimit }: FloatReportProps) {
  return (
    <section class="group">
      <h2>Floats</h2>
      <label class="row">
        <input type="checkbox" checked={limit !== null} data-testid="floats-marked" onChange={(event) => onLimit(event.currentTarget.checked ? 5 : null)} />
        <span>Mark long floats</span>
      </label>
      {limit !== null && (
        <Stepper
          label="Longer than"
          testid="floats-limit"
          value={limit}
          onValue={(value) => {
            if (!Number.isInteger(value) || value < 1 || value > MAXIMUM_THREADS) return `Write a whole number from 1 to ${MAXIMUM_THREADS}.`;
            onLimit(value);
            return null;
          }}
        />
      )}
      {floats !== null && (
        <p class="note" data-testid="floats">
          {floats.onFace + floats.onBack === 0 ? "None is longer. " : `${floats.onFace} on the face (spots), ${floats.onBack} on the back (rings) a repeat. `}
          Longest: warp {floats.longest.warpFace} on the face, {floats.longest.warpBack} on the back; weft {floats.longest.weftFace} and {floats.longest.weftBack}.
        </p>
      )}
    </section>
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

/** The draft editor: drawing, numbers of threads and shafts, and the kind of plan. */
import { loomOf, threadHexes } from "loomlight-fabric";
import { useMemo, useState } from "preact/hooks";

import { Icon } from "../controls/Icon.tsx";
import { Segmented } from "../controls/Segmented.tsx";
import { Fault, numberOf, useWritten } from "../controls/written.tsx";
import { isNamed, woven, type Fabric } from "../state/document.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";
import { Brush } from "./Brush.tsx";
import { DraftGrid } from "./DraftGrid.tsx";
import { WINDOW } from "./draft_grid.ts";

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
  const shown = Math.min(Math.max(draft.ends, draft.picks), WINDOW) + Math.min(loom.shafts, 40);
  const cell = shown <= 8 ? 26 : shown <= 10 ? 22 : shown <= 18 ? 18 : shown <= 26 ? 14 : shown <= 40 ? 11 : 8;
  const colour = brush ?? threadHexes(draft, "weft")[0] ?? "#ffffff";
  const isLiftplan = loom.tieup === null;
  return (
    <>
      <p class="note">
        Click a crossing to bring the other thread on top; or change threading, tie-up and treadling, and the cloth follows.
        {isNamed(fabric) && " Your first change makes this weave a draft of your own."}
      </p>
      <DraftGrid fabric={fabric} dispatch={dispatch} firstEnd={firstEnd} firstPick={firstPick} brush={colour} cell={cell} />
      <Pages label="Ends" first={firstEnd} count={draft.ends} onFirst={(end) => setPage({ ...page, end })} />
      <Pages label="Picks" first={firstPick} count={draft.picks} onFirst={(pick) => setPage({ ...page, pick })} />
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
        <button type="button" class="button" data-testid="turn-over" onClick={() => dispatch({ type: "draft/over" })}>
          Turn the cloth over
        </button>
      </section>
    </>
  );
}

interface StepperProps {
  readonly label: string;
  readonly testid: string;
  readonly value: number;
  /** Why a number is refused, or null. */
  readonly onValue: (value: number) => string | null;
}

function Stepper({ label, testid, value, onValue }: StepperProps) {
  const written = useWritten(String(value), (text) => {
    const number = numberOf(text);
    return number === null ? `"${text}" is no number.` : onValue(number);
  });
  return (
    <div class="stepper" role="group" aria-label={label}>
      <span>{label}</span>
      <button type="button" aria-label={`${label}: one less`} data-testid={`${testid}-less`} onClick={() => written.enter(String(value - 1))}>
        <Icon name="minus" />
      </button>
      <input {...written.input} inputMode="numeric" aria-label={label} data-testid={`${testid}-count`} />
      <button type="button" aria-label={`${label}: one more`} data-testid={`${testid}-more`} onClick={() => written.enter(String(value + 1))}>
        <Icon name="plus" />
      </button>
      <Fault text={written.fault} />
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

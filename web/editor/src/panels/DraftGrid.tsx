/** The draft as weaving software draws it, on a canvas; each part is edited by pointer and by keys. */
import { clamp, FACE, loomOf, threadHexes, within, type LoomPlan, type Region } from "loomlight-fabric";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";

import { newStroke } from "../controls/Slider.tsx";
import { woven, type Fabric } from "../state/document.ts";
import type { Dispatch } from "../state/store.ts";
import { cellAt, crossingNear, described, isFilled, layoutOf, nextPart, placeOf, stepped, type Cell, type Layout, type Window } from "./draft_grid.ts";
import { between, type Crossing, type Selection } from "./selection.ts";

interface Props {
  readonly fabric: Fabric;
  readonly dispatch: Dispatch;
  /** The threads that are drawn. */
  readonly window: Window;
  /** The colour that thread bars are painted with. */
  readonly brush: string;
  /** Screen pixels a cell. */
  readonly cell: number;
  /** Bits of each crossing that lies in a float that is too long; null marks none. */
  readonly marks: Uint8Array | null;
  readonly selection: Selection;
  /** The cursor would leave the window, to the right or up by so many threads. */
  readonly onEdge?: (right: number, up: number) => void;
}

/** Cells that are painted by one movement. */
interface Drag {
  readonly stroke: string;
  readonly isOn: boolean;
  readonly cell: Cell;
  last: string;
  /** Whether its first cell is painted: a finger paints once it moves or is lifted. */
  isMade: boolean;
}

interface Colours {
  readonly warp: readonly string[];
  readonly weft: readonly string[];
}

export function DraftGrid({ fabric, dispatch, window, brush, cell: size, marks, selection, onEdge }: Props) {
  const { firstEnd, firstPick, ends, picks } = window;
  const canvas = useRef<HTMLCanvasElement>(null);
  const draft = woven(fabric);
  const loom = useMemo(() => loomOf(draft), [draft]);
  const layout = useMemo(() => layoutOf(loom, window), [loom, firstEnd, firstPick, ends, picks]);
  const [cursor, setCursor] = useState<Cell>({ part: "drawdown", column: 0, row: 0 });
  const [isFocused, setFocused] = useState(false);
  const drag = useRef<Drag | null>(null);
  // Where the selection began that pointer or keys are drawing.
  const anchor = useRef<Crossing | null>(null);
  const isDragged = useRef(false);
  const selectedBefore = useRef<Region | null>(null);
  const { region } = selection;

  useEffect(() => {
    const colours = { warp: threadHexes(draft, "warp"), weft: threadHexes(draft, "weft") };
    draw(canvas.current!, fabric, loom, layout, colours, size, marks, region, isFocused ? cursor : null);
  }, [fabric, loom, layout, size, cursor, isFocused, draft, marks, region?.firstEnd, region?.firstPick, region?.ends, region?.picks]);

  const edit = (cell: Cell, isOn: boolean, stroke: string): void => {
    const end = firstEnd + cell.column;
    const pick = firstPick + cell.row;
    switch (cell.part) {
      case "drawdown":
        return dispatch({ type: "draft/crossing", pick, end, isUp: isOn, stroke });
      case "threading":
        return dispatch({ type: "draft/thread", end, shaft: cell.row + 1, stroke });
      case "tieup":
        return dispatch({ type: "draft/tie", treadle: cell.column, shaft: cell.row + 1, isIn: isOn, stroke });
      case "treadling":
        return dispatch({ type: "draft/press", pick, treadle: cell.column + 1, stroke });
      case "liftplan":
        return dispatch({ type: "draft/lift", pick, shaft: cell.column + 1, isIn: isOn, stroke });
      case "warp":
        return dispatch({ type: "colour/paint", family: "warp", thread: end, hex: brush, stroke });
      case "weft":
        return dispatch({ type: "colour/paint", family: "weft", thread: pick, hex: brush, stroke });
    }
  };

  const cellOf = (event: PointerEvent): Cell | null => {
    const box = canvas.current!.getBoundingClientRect();
    return cellAt(layout, (event.clientX - box.left) / size, (event.clientY - box.top) / size);
  };

  const crossingOf = (cell: Cell): Crossing => ({ end: firstEnd + cell.column, pick: firstPick + cell.row });

  const onPointerDown = (event: PointerEvent): void => {
    // A second finger scrolls or sizes: what the first one began is no edit.
    if (!event.isPrimary) return abandon();
    const cell = cellOf(event);
    if (cell === null || event.button !== 0) return;
    canvas.current!.setPointerCapture(event.pointerId);
    if (cell.part === "drawdown" && (selection.isSelecting || event.shiftKey)) {
      // Shift goes on from where the selection began.
      if (!event.shiftKey || anchor.current === null) anchor.current = region !== null && event.shiftKey ? { end: region.firstEnd, pick: region.firstPick } : crossingOf(cell);
      isDragged.current = true;
      selectedBefore.current = region;
      setCursor(cell);
      return selection.select(between(anchor.current, crossingOf(cell)));
    }
    const isOn = !isFilled(draft, loom, layout, cell);
    drag.current = { stroke: newStroke(), isOn, last: key(cell), cell, isMade: false };
    setCursor(cell);
    if (event.pointerType !== "touch") begin(drag.current);
  };

  /** Makes the edit of the cell where a drag began, once. */
  const begin = (dragged: Drag): void => {
    if (!dragged.isMade) edit(dragged.cell, dragged.isOn, dragged.stroke);
    dragged.isMade = true;
  };

  const abandon = (): void => {
    if (isDragged.current) selection.select(selectedBefore.current);
    drag.current = null;
    isDragged.current = false;
  };

  const onPointerMove = (event: PointerEvent): void => {
    if (isDragged.current) {
      const box = canvas.current!.getBoundingClientRect();
      const { cell, right, up } = crossingNear(layout, (event.clientX - box.left) / size, (event.clientY - box.top) / size);
      // Beyond the edge the window follows.
      if (right !== 0 || up !== 0) onEdge?.(right, up);
      setCursor(cell);
      return selection.select(between(anchor.current!, crossingOf(cell)));
    }
    const dragged = drag.current;
    const cell = cellOf(event);
    if (dragged === null || cell === null || cell.part !== dragged.cell.part || key(cell) === dragged.last) return;
    begin(dragged);
    dragged.last = key(cell);
    edit(cell, dragged.isOn, dragged.stroke);
  };

  const onPointerUp = (): void => {
    if (drag.current !== null) begin(drag.current);
    drag.current = null;
    isDragged.current = false;
  };

  const onKeyDown = (event: KeyboardEvent): void => {
    const here = cursor.part === "drawdown" ? crossingOf(cursor) : { end: firstEnd, pick: firstPick };
    if (selection.onKey(event, here)) return event.preventDefault();
    const moves: Readonly<Record<string, readonly [number, number]>> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const move = moves[event.key];
    if (move !== undefined) {
      const next = stepped(layout, cursor, ...move);
      const isEdge = key(next) === key(cursor);
      if (isEdge) onEdge?.(...move);
      setCursor(next);
      if (event.shiftKey && cursor.part === "drawdown") {
        if (region === null || anchor.current === null) anchor.current = here;
        const [right, up] = isEdge && onEdge !== undefined ? move : [0, 0];
        const to = crossingOf(next);
        const at = (value: number, threads: number): number => clamp(value, 0, threads - 1);
        selection.select(between(anchor.current, { end: at(to.end + right, draft.ends), pick: at(to.pick + up, draft.picks) }));
      }
    }
    else if (event.key === "PageDown") setCursor(nextPart(layout, cursor, 1));
    else if (event.key === "PageUp") setCursor(nextPart(layout, cursor, -1));
    else if (event.key === " " || event.key === "Enter") edit(cursor, !isFilled(draft, loom, layout, cursor), newStroke());
    else return;
    event.preventDefault();
  };

  const said = described(layout, cursor, isFilled(draft, loom, layout, cursor));
  return (
    <>
      <canvas
        ref={canvas}
        class="draft-grid"
        tabIndex={0}
        role="application"
        aria-label={`Draft of ${draft.ends} ends and ${draft.picks} picks. Arrow keys move, space changes a cell, page up and down change the part, shift and arrows select.`}
        aria-describedby="draft-cell"
        data-testid="draft-grid"
        data-cell={size}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={onPointerUp}
        onPointerCancel={abandon}
        onKeyDown={onKeyDown}
        onFocus={() => setFocused(true)}
        onBlur={() => setFocused(false)}
      />
      <p id="draft-cell" class="visually-hidden" aria-live="polite">
        {isFocused ? said : ""}
      </p>
    </>
  );
}

const key = (cell: Cell): string => `${cell.part} ${cell.column} ${cell.row}`;

const INK = "#2b3552";
const PAPER = "#fffdf8";
const LINE = "#dcd4c4";
const FIFTH = "#bfb49e";

function draw(
  canvas: HTMLCanvasElement,
  fabric: Fabric,
  loom: LoomPlan,
  layout: Layout,
  colours: Colours,
  size: number,
  marks: Uint8Array | null,
  selected: Region | null,
  cursor: Cell | null,
): void {
  const draft = woven(fabric);
  const ratio = Math.min(devicePixelRatio, 2);
  const [width, height] = [layout.columns * size + 1, layout.rows * size + 1];
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext("2d")!;
  context.scale(ratio, ratio);
  const { firstEnd, firstPick } = layout.window;
  for (const box of layout.boxes) {
    for (let row = 0; row < box.rows; row++)
      for (let column = 0; column < box.columns; column++) {
        const cell: Cell = { part: box.part, column, row };
        const isOn = isFilled(draft, loom, layout, cell);
        const [x, y] = [(box.left + column) * size, (box.top + box.rows - 1 - row) * size];
        context.fillStyle =
          box.part === "drawdown"
            ? ((isOn ? colours.warp[firstEnd + column] : colours.weft[firstPick + row]) ?? PAPER)
            : box.part === "warp"
              ? (colours.warp[firstEnd + column] ?? PAPER)
              : box.part === "weft"
                ? (colours.weft[firstPick + row] ?? PAPER)
                : PAPER;
        context.fillRect(x, y, size, size);
        if (box.part === "drawdown") {
          yarnEdge(context, isOn, x, y, size);
          floatMark(context, marks?.[(firstPick + row) * draft.ends + firstEnd + column] ?? 0, x, y, size);
        } else if (isOn && box.part !== "warp" && box.part !== "weft") mark(context, x, y, size);
      }
    lines(context, box, size);
  }
  selectionFrame(context, layout, selected, size);
  const place = cursor === null ? null : placeOf(layout, cursor);
  if (place !== null) {
    context.strokeStyle = "#b4552d";
    context.lineWidth = 2;
    context.strokeRect(place.x * size, place.y * size, size, size);
  }
}

/** The part of the selection in sight, tinted and framed. */
function selectionFrame(context: CanvasRenderingContext2D, layout: Layout, selected: Region | null, size: number): void {
  if (selected === null) return;
  const { firstEnd, firstPick, ends, picks } = layout.window;
  const seen = within({ ...selected, firstEnd: selected.firstEnd - firstEnd, firstPick: selected.firstPick - firstPick }, { ends, picks });
  if (seen === null) return;
  const { x, y } = placeOf(layout, { part: "drawdown", column: seen.firstEnd, row: seen.firstPick + seen.picks - 1 })!;
  const box = [x * size, y * size, seen.ends * size, seen.picks * size] as const;
  // Seen on threads of any colour: a tint, and a dark frame in a light one.
  context.fillStyle = "rgb(255 184 60 / 38%)";
  context.fillRect(...box);
  for (const [colour, width] of [["#ffffff", 4], ["#0f63ad", 2]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.strokeRect(...box);
  }
}

/** Dark edges along the thread on top tell which one it is, whatever the colours are. */
function yarnEdge(context: CanvasRenderingContext2D, isWarp: boolean, x: number, y: number, size: number): void {
  context.fillStyle = "rgb(0 0 0 / 22%)";
  const edge = Math.max(1, size * 0.14);
  if (isWarp) {
    context.fillRect(x, y, edge, size);
    context.fillRect(x + size - edge, y, edge, size);
  } else {
    context.fillRect(x, y, size, edge);
    context.fillRect(x, y + size - edge, size, edge);
  }
}

/** A filled spot in a float that is too long on the face, a ring on the back. */
function floatMark(context: CanvasRenderingContext2D, bits: number, x: number, y: number, size: number): void {
  if (bits === 0) return;
  context.beginPath();
  context.arc(x + size / 2, y + size / 2, size * 0.22, 0, 2 * Math.PI);
  context.fillStyle = context.strokeStyle = "#d8481f";
  context.lineWidth = Math.max(1, size * 0.1);
  if ((bits & FACE) !== 0) context.fill();
  else context.stroke();
}

function mark(context: CanvasRenderingContext2D, x: number, y: number, size: number): void {
  context.fillStyle = INK;
  const inset = size * 0.16;
  context.beginPath();
  context.roundRect(x + inset, y + inset, size - 2 * inset, size - 2 * inset, size * 0.16);
  context.fill();
}

function lines(
  context: CanvasRenderingContext2D,
  box: { left: number; top: number; columns: number; rows: number },
  size: number,
): void {
  context.lineWidth = 1;
  const [left, top] = [box.left * size + 0.5, box.top * size + 0.5];
  const [right, bottom] = [left + box.columns * size, top + box.rows * size];
  const line = (isFifth: boolean, from: [number, number], to: [number, number]): void => {
    context.strokeStyle = isFifth ? FIFTH : LINE;
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(...to);
    context.stroke();
  };
  for (let column = 0; column <= box.columns; column++)
    line(column % 4 === 0, [left + column * size, top], [left + column * size, bottom]);
  for (let row = 0; row <= box.rows; row++)
    line(row % 4 === 0, [left, bottom - row * size], [right, bottom - row * size]);
}

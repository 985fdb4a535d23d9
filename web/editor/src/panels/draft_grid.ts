/**
 * Where the parts of a draft drawing lie: warp colours and threading above the drawdown, treadling or liftplan and
 * weft colours to its right, tie-up in the corner. End 1 is at the left, pick 1 at the bottom, as cloth lies.
 */
import { clamp, isUp, type Draft, type LoomPlan } from "loomlight-fabric";

export type Part = "drawdown" | "threading" | "tieup" | "treadling" | "liftplan" | "warp" | "weft";

/** One cell: column and row count from 0, from the left and from the bottom of its part. */
export interface Cell {
  readonly part: Part;
  readonly column: number;
  readonly row: number;
}

interface Box {
  readonly part: Part;
  /** In cells, from the left and from the top. */
  readonly left: number;
  readonly top: number;
  readonly columns: number;
  readonly rows: number;
}

/** The threads that are drawn: a draft of thousands is drawn in windows. */
export interface Window {
  readonly firstEnd: number;
  readonly firstPick: number;
  readonly ends: number;
  readonly picks: number;
}

export interface Layout {
  readonly boxes: readonly Box[];
  readonly columns: number;
  readonly rows: number;
  readonly window: Window;
}

/** Ends, and picks, that a panel draws at once. */
export const WINDOW = 64;
/** Shafts and treadles beyond these are not drawn: such drafts are edited in the drawdown. */
const MAX_SHAFTS = 40;
/** Cells between two parts. */
const SPACE = 1;

/** Cells that everything but the crossings takes up: threading and warp colours above, the plan and weft colours beside. */
export function planSize(loom: LoomPlan): { columns: number; rows: number } {
  const { shafts, columns } = shownOf(loom);
  return { columns: SPACE + (columns > 0 ? columns + SPACE : 0) + 1, rows: 1 + SPACE + (shafts > 0 ? shafts + SPACE : 0) };
}

/** Shafts that are drawn, and columns of the treadling or the lift plan. */
function shownOf(loom: LoomPlan): { shafts: number; columns: number } {
  const shafts = loom.shafts <= MAX_SHAFTS ? loom.shafts : 0;
  const columns = loom.tieup === null ? loom.shafts : loom.treadles;
  return { shafts, columns: shafts > 0 && columns <= MAX_SHAFTS ? columns : 0 };
}

/** The largest whole number of pixels a cell with which so many cells fit into an area, within bounds. */
export function fittingCell(
  cells: { readonly columns: number; readonly rows: number },
  area: { readonly width: number; readonly height: number },
  smallest: number,
  largest: number,
): number {
  const fit = Math.floor(Math.min((area.width - 1) / cells.columns, (area.height - 1) / cells.rows));
  return clamp(fit, smallest, largest);
}

/** The threads from one of each family on, as many as a panel draws. */
export function panelWindow(draft: Draft, firstEnd: number, firstPick: number): Window {
  return { firstEnd, firstPick, ends: Math.min(WINDOW, draft.ends - firstEnd), picks: Math.min(WINDOW, draft.picks - firstPick) };
}

export function layoutOf(loom: LoomPlan, window: Window): Layout {
  const { ends, picks } = window;
  const { shafts, columns } = shownOf(loom);
  const isLiftplan = loom.tieup === null;
  const top = 1 + SPACE + (shafts > 0 ? shafts + SPACE : 0);
  const right = ends + SPACE;
  const boxes: Box[] = [
    { part: "warp", left: 0, top: 0, columns: ends, rows: 1 },
    { part: "drawdown", left: 0, top, columns: ends, rows: picks },
  ];
  if (shafts > 0) boxes.push({ part: "threading", left: 0, top: 1 + SPACE, columns: ends, rows: shafts });
  if (columns > 0) {
    boxes.push({ part: isLiftplan ? "liftplan" : "treadling", left: right, top, columns, rows: picks });
    if (!isLiftplan) boxes.push({ part: "tieup", left: right, top: 1 + SPACE, columns, rows: shafts });
  }
  const weftLeft = right + (columns > 0 ? columns + SPACE : 0);
  boxes.push({ part: "weft", left: weftLeft, top, columns: 1, rows: picks });
  return { boxes, columns: weftLeft + 1, rows: top + picks, window };
}

/** The cell at a place, in cells from the left and the top; null between the parts. */
export function cellAt(layout: Layout, x: number, y: number): Cell | null {
  for (const box of layout.boxes) {
    const column = Math.floor(x - box.left);
    const row = box.rows - 1 - Math.floor(y - box.top);
    if (column >= 0 && column < box.columns && row >= 0 && row < box.rows) return { part: box.part, column, row };
  }
  return null;
}

/** The crossing nearest to a place, and how far beyond the drawdown the place is: a thread to the right or up, or none. */
export function crossingNear(layout: Layout, x: number, y: number): { cell: Cell; right: number; up: number } {
  const box = layout.boxes.find((each) => each.part === "drawdown")!;
  const column = Math.floor(x - box.left);
  const row = box.rows - 1 - Math.floor(y - box.top);
  const beyond = (at: number, count: number): number => (at < 0 ? -1 : at >= count ? 1 : 0);
  const inside = (at: number, count: number): number => clamp(at, 0, count - 1);
  const cell: Cell = { part: "drawdown", column: inside(column, box.columns), row: inside(row, box.rows) };
  return { cell, right: beyond(column, box.columns), up: beyond(row, box.rows) };
}

/** Where a cell is drawn, in cells from the left and the top. */
export function placeOf(layout: Layout, cell: Cell): { x: number; y: number } | null {
  const box = layout.boxes.find((each) => each.part === cell.part);
  return box === undefined ? null : { x: box.left + cell.column, y: box.top + box.rows - 1 - cell.row };
}

/** Whether a cell is filled: warp on top, or thread, tie, treadle or lift there. */
export function isFilled(draft: Draft, loom: LoomPlan, layout: Layout, cell: Cell): boolean {
  const end = layout.window.firstEnd + cell.column;
  const pick = layout.window.firstPick + cell.row;
  switch (cell.part) {
    case "drawdown":
      return isUp(draft, pick, end);
    case "threading":
      return loom.threading[end]?.includes(cell.row + 1) ?? false;
    case "tieup":
      return loom.tieup?.[cell.column]?.includes(cell.row + 1) ?? false;
    case "treadling":
      return loom.treadling?.[pick]?.includes(cell.column + 1) ?? false;
    case "liftplan":
      return loom.liftplan?.[pick]?.includes(cell.column + 1) ?? false;
    default:
      return true;
  }
}

/** The cell one step away within its part; at an edge it stays. */
export function stepped(layout: Layout, cell: Cell, right: number, up: number): Cell {
  const box = layout.boxes.find((each) => each.part === cell.part);
  if (box === undefined) return { part: "drawdown", column: 0, row: 0 };
  return {
    part: cell.part,
    column: clamp(cell.column + right, 0, box.columns - 1),
    row: clamp(cell.row + up, 0, box.rows - 1),
  };
}

/** The first cell of the part after, or before, that of a cell. */
export function nextPart(layout: Layout, cell: Cell, step: 1 | -1): Cell {
  const at = layout.boxes.findIndex((box) => box.part === cell.part);
  const count = layout.boxes.length;
  return { part: layout.boxes[(at + step + count) % count]!.part, column: 0, row: 0 };
}

/** A cell in words. */
export function described(layout: Layout, cell: Cell, isOn: boolean): string {
  const end = layout.window.firstEnd + cell.column + 1;
  const pick = layout.window.firstPick + cell.row + 1;
  switch (cell.part) {
    case "drawdown":
      return `End ${end}, pick ${pick}: ${isOn ? "warp" : "weft"} on top`;
    case "threading":
      return `End ${end}, shaft ${cell.row + 1}: ${isOn ? "threaded" : "empty"}`;
    case "tieup":
      return `Treadle ${cell.column + 1}, shaft ${cell.row + 1}: ${isOn ? "tied" : "not tied"}`;
    case "treadling":
      return `Pick ${pick}, treadle ${cell.column + 1}: ${isOn ? "pressed" : "not pressed"}`;
    case "liftplan":
      return `Pick ${pick}, shaft ${cell.column + 1}: ${isOn ? "lifted" : "down"}`;
    case "warp":
      return `Colour of end ${end}`;
    case "weft":
      return `Colour of pick ${pick}`;
  }
}

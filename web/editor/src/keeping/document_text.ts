/** The document as text: the fabric, what it is compared with, the light, and steps of undo and redo. */
import { withScene } from "../reducers/scene.ts";
import { FIRST_COMPARISON, FIRST_SCENE, type Fabric, type History, type Scene, type State } from "../state/document.ts";
import { fabricFromJson, fabricText } from "../state/fabric_json.ts";
import { tableOf } from "../state/json_table.ts";

/** Characters of all steps at most: browsers keep some five million in all. */
const MAX_HISTORY = 1_000_000;
/** Steps at most: each is checked when the page starts. */
const MAX_STEPS = 60;

interface Options {
  /** Without it no steps are kept; with it the latest, as many as there is room for. */
  readonly withHistory?: boolean;
  /** What the page's address carried when the document was kept, after "#". */
  readonly address?: string;
}

/** The text of a document. */
export function documentText(state: State, { withHistory = true, address = "" }: Options = {}): string {
  const { before } = state.comparison;
  const { past, future } = state.history;
  const pastTexts = withHistory ? latest([...past].reverse(), MAX_HISTORY).reverse() : [];
  const futureTexts = withHistory ? latest(future, MAX_HISTORY - lengthOf(pastTexts)) : [];
  const parts = {
    fabric: fabricText(state.fabric),
    before: before === null ? "null" : fabricText(before),
    scene: JSON.stringify(state.scene),
    past: `[${pastTexts.join()}]`,
    future: `[${futureTexts.join()}]`,
    address: JSON.stringify(address),
  };
  return `{${Object.entries(parts).map(([name, text]) => `"${name}":${text}`).join()}}`;
}

function latest(fabrics: readonly Fabric[], room: number): string[] {
  const texts: string[] = [];
  for (const fabric of fabrics.slice(0, MAX_STEPS)) {
    const text = fabricText(fabric);
    room -= text.length + 1;
    if (room < 0) break;
    texts.push(text);
  }
  return texts;
}

const lengthOf = (texts: readonly string[]): number => texts.reduce((sum, text) => sum + text.length + 1, 0);

/** What a document's text says of a state. */
export interface Kept extends Pick<State, "fabric" | "history" | "scene" | "comparison"> {
  readonly address: string;
}

/**
 * The document of a text. What is not the fabric's is left out where it cannot be read.
 *
 * @throws InputError a fabric that cannot be, or SyntaxError no JSON.
 */
export function documentOf(text: string): Kept {
  const kept = tableOf(JSON.parse(text));
  const fabric = fabricFromJson(kept["fabric"]);
  const history: History = {
    past: readable(listOf(kept["past"]).reverse()).reverse(),
    future: readable(listOf(kept["future"])),
    stroke: null,
  };
  const [before = null] = readable([kept["before"]]);
  const address = typeof kept["address"] === "string" ? kept["address"] : "";
  return { fabric, history, scene: sceneOf(kept["scene"]), comparison: { ...FIRST_COMPARISON, before }, address };
}

/** The first fabrics of a list, up to one that cannot be read: a step beyond it would skip it. */
function readable(list: readonly unknown[]): Fabric[] {
  const fabrics: Fabric[] = [];
  try {
    for (const json of list) fabrics.push(fabricFromJson(json));
  } catch {
    // What was made before a fault stays.
  }
  return fabrics;
}

function listOf(value: unknown): unknown[] {
  return Array.isArray(value) ? value.slice(0, MAX_STEPS) : [];
}

/** The scene of its JSON; a value that cannot be is that of a fresh page. A mesh or picture of the user's own is not kept. */
function sceneOf(json: unknown): Scene {
  let scene = FIRST_SCENE;
  for (const [key, value] of Object.entries(tableOf(json))) {
    if (value === "mesh" || value === "picture") continue;
    try {
      scene = withScene(scene, { [key]: value });
    } catch {
      // Of another version of the page.
    }
  }
  return scene;
}

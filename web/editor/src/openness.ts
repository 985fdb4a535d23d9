/**
 * How open the yarns of fabrics are, which light between yarns needs, and joint visibility of light and view: of
 * Python, where there is a server; else the renderer's kernel finds the first and does without the other.
 *
 * It follows from the geometry, so the server is asked only for a geometry that is new; while its answer is on the
 * way, the last one serves. An edit of colours asks nothing.
 */
import { IRREGULARITY_FIELDS, messageOf } from "loomlight-fabric";
import type { Openness } from "loomlight-web";

import type { Fabric } from "./state/document.ts";

/** A new geometry is asked for once so many milliseconds passed without another. */
const CALM_MS = 150;
const MAX_KEPT = 32;

/** Fields that say nothing of the geometry, nor of roughness and depth. */
const OTHERS = new Set(["name", "description", "interreflection", "sheen", "variation"]);
const OTHERS_OF_YARNS = new Set([
  "specular",
  "specular_tint",
  "specular_grazing",
  "translucency",
  "diffuse_reflect",
  "diffuse_transmit",
  "specular_reflect",
  "specular_transmit",
  "plies",
  "ply_twist_deg",
  "fibre_tilt_deg",
  "slub",
  "hairiness",
  ...Object.keys(IRREGULARITY_FIELDS),
  "nep_color",
]);

export class OpennessSource {
  private readonly ask: (fabric: Fabric) => Promise<Openness>;
  private readonly onAnswer: () => void;
  private readonly onFault: (sentence: string) => void;
  private readonly kept = new Map<string, Openness>();
  /** Geometries that are kept or on their way. */
  private readonly asked = new Set<string>();
  private waiting: readonly Fabric[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  private last: Openness | null = null;
  private fault = "";

  /**
   * @param ask asks the server.
   * @param onAnswer is called when `of` has become another.
   * @param onFault is told in one sentence why there is no answer, once for each sentence.
   */
  constructor(
    ask: (fabric: Fabric) => Promise<Openness>,
    onAnswer: () => void,
    onFault: (sentence: string) => void,
  ) {
    [this.ask, this.onAnswer, this.onFault] = [ask, onAnswer, onFault];
  }

  /** What is known of a fabric's yarns; null before the first answer. */
  of(fabric: Fabric): Openness | null {
    return this.kept.get(geometryKey(fabric)) ?? this.last;
  }

  /** Says which fabrics are shown: what is not known of them is asked for soon. */
  show(fabrics: readonly Fabric[]): void {
    this.waiting = fabrics.filter((fabric) => !this.asked.has(geometryKey(fabric)));
    clearTimeout(this.timer);
    if (this.waiting.length > 0) this.timer = setTimeout(() => this.askForAll(), CALM_MS);
  }

  private askForAll(): void {
    for (const fabric of this.waiting) {
      const key = geometryKey(fabric);
      if (this.asked.has(key)) continue;
      this.asked.add(key);
      this.ask(fabric).then(
        (openness) => this.keep(key, openness),
        (error: unknown) => this.tell(key, messageOf(error)),
      );
    }
    this.waiting = [];
  }

  private keep(key: string, openness: Openness): void {
    this.kept.set(key, openness);
    this.last = openness;
    this.fault = "";
    const oldest = this.kept.keys().next().value;
    if (this.kept.size > MAX_KEPT && oldest !== undefined) {
      this.kept.delete(oldest);
      this.asked.delete(oldest);
    }
    this.onAnswer();
  }

  private tell(key: string, sentence: string): void {
    // The server may be there again when the fabric is shown next.
    this.asked.delete(key);
    if (sentence !== this.fault) this.onFault(sentence);
    this.fault = sentence;
  }
}

/** Equal for fabrics that are as open; the drawdown and threads of a draft count as the arrays that they are. */
export function geometryKey({ fields, draft }: Fabric): string {
  const arrays = [draft.drawdown, ...[draft.warp, draft.weft].flatMap((of) => [of.spacingMm, of.thicknessMm])];
  const told = JSON.stringify(entriesOf(fields, OTHERS));
  return [told, draft.ends, draft.picks, ...arrays.map(numberOf)].join();
}

/** Fields that decide, by name; a table without any is left out. */
function entriesOf(table: object, others: ReadonlySet<string>): (readonly [string, unknown])[] {
  return Object.entries(table)
    .filter(([name, value]) => value !== undefined && !others.has(name))
    .map(([name, value]) => [name, decisive(name, value)] as const)
    .filter(([, value]) => value !== null)
    .sort(([one], [other]) => (one < other ? -1 : 1));
}

function decisive(name: string, value: unknown): unknown {
  // A list of colours may repeat later than the weave, and the repeat is longer then.
  if (name === "color" || name === "albedo") return Array.isArray(value) ? value.length : null;
  if (typeof value !== "object" || value === null) return value;
  const entries = entriesOf(value, OTHERS_OF_YARNS);
  return entries.length > 0 ? entries : null;
}

const numbers = new WeakMap<object, number>();
let given = 0;

function numberOf(array: object | null): number {
  if (array === null) return 0;
  const known = numbers.get(array) ?? ++given;
  numbers.set(array, known);
  return known;
}

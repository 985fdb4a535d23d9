/** Models whose tables Python makes: asked of the server, one request at a time, for the newest fabric. */
import { messageOf } from "loomlight-fabric";

import type { Fabric, Model } from "../state/document.ts";

export const SERVED_MODELS = ["neural", "clustered"] as const satisfies readonly Model[];
export type ServedModel = (typeof SERVED_MODELS)[number];

export function isServed(model: Model): model is ServedModel {
  return (SERVED_MODELS as readonly Model[]).includes(model);
}

/** What tables are asked for: of cloth in layers those of the page's own models too, as Python alone finds layers. */
export type TableName = ServedModel | "lobes" | "point";

/** The tables of a model for a fabric, as the server's answer. */
export type TableSource = (model: TableName, fabric: Fabric) => Promise<Uint8Array>;

interface Tables {
  readonly fabric: Fabric;
  readonly content: Uint8Array;
}

export class ServedModels {
  private readonly source: TableSource;
  private readonly onArrival: () => void;
  private readonly onFault: (sentence: string) => void;
  private readonly found = new Map<TableName, Tables>();
  private readonly wanted = new Map<TableName, Fabric>();
  private readonly busy = new Set<TableName>();
  /** What was said last, so that each edit does not say it again. */
  private readonly said = new Map<TableName, string>();

  constructor(source: TableSource, onArrival: () => void, onFault: (sentence: string) => void) {
    [this.source, this.onArrival, this.onFault] = [source, onArrival, onFault];
  }

  /**
   * The newest tables that are here, maybe of an older edit; those of this fabric are asked for.
   *
   * @returns null for none yet, or for ones of another cloth, which the page shows by itself meanwhile.
   */
  tables(model: TableName, fabric: Fabric): Uint8Array | null {
    const found = this.found.get(model);
    if (found?.fabric !== fabric && this.wanted.get(model) !== fabric) {
      this.wanted.set(model, fabric);
      void this.ask(model);
    }
    return found !== undefined && isEdit(found.fabric, fabric) ? found.content : null;
  }

  private async ask(model: TableName): Promise<void> {
    if (this.busy.has(model)) return;
    this.busy.add(model);
    for (let asked: Fabric | undefined; asked !== this.wanted.get(model); ) {
      asked = this.wanted.get(model)!;
      try {
        this.found.set(model, { fabric: asked, content: await this.source(model, asked) });
        this.said.delete(model);
        this.onArrival();
      } catch (error) {
        this.say(model, messageOf(error));
      }
    }
    this.busy.delete(model);
  }

  private say(model: TableName, sentence: string): void {
    if (this.said.get(model) === sentence) return;
    this.said.set(model, sentence);
    this.onFault(sentence);
  }
}

/** Whether two fabrics are one cloth before and after an edit, as far as sizes tell. */
function isEdit({ draft: before }: Fabric, { draft: after }: Fabric): boolean {
  return before.ends === after.ends && before.picks === after.picks;
}

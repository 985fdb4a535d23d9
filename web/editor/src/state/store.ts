/** Holds the document and tells views of its changes. */
import { isInputError } from "loomlight-fabric";

import { reduce } from "../reducers/index.ts";
import type { Action } from "./actions.ts";
import type { State } from "./document.ts";

export type Dispatch = (action: Action) => void;
type Listener = (state: State, before: State) => void;

export class Store {
  private present: State;
  private readonly listeners = new Set<Listener>();

  constructor(first: State) {
    this.present = first;
  }

  get state(): State {
    return this.present;
  }

  /** Applies an action; what makes no cloth is told as a notice and changes nothing else. */
  readonly dispatch: Dispatch = (action) => {
    const before = this.present;
    try {
      this.present = reduce(before, action);
    } catch (error) {
      if (!isInputError(error)) throw error;
      this.present = reduce(before, { type: "notice/add", kind: "fault", text: sentence(error.message) });
    }
    if (this.present === before) return;
    for (const listener of this.listeners) listener(this.present, before);
  };

  /** Calls `listener` after each change until the returned function is called. */
  subscribe(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

/** A message with a capital and a full stop. */
export function sentence(text: string): string {
  const begun = /^(it|none|the) /.test(text) ? text[0]!.toUpperCase() + text.slice(1) : text;
  return /[.!?]$/.test(begun) ? begun : `${begun}.`;
}

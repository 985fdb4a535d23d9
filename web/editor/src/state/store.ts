/** Holds the document and tells views of its changes. */
import { isInputError, messageOf } from "loomlight-fabric";

import { reduce } from "../reducers/index.ts";
import type { Action } from "./actions.ts";
import type { State } from "./document.ts";

/** Applies an action; `onRefused` is told in a sentence why it changes nothing, in place of a notice. */
export type Dispatch = (action: Action, onRefused?: (sentence: string) => void) => void;
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

  /** Applies an action. What makes no cloth, or fails, is told and changes nothing else: no action ends the page. */
  readonly dispatch: Dispatch = (action, onRefused) => {
    const before = this.present;
    let next: State;
    try {
      next = reduce(before, action);
    } catch (error) {
      const text = refusal(error);
      if (onRefused !== undefined) return onRefused(text);
      next = reduce(before, { type: "notice/add", kind: "fault", text });
    }
    this.replace(next);
  };

  /** Puts another state in the place of the present one. */
  replace(next: State): void {
    const before = this.present;
    if (next === before) return;
    this.present = next;
    for (const listener of this.listeners) listener(next, before);
  }

  /** Calls `listener` after each change until the returned function is called. */
  subscribe(listener: Listener): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

/** Why actions are refused, the first of those that are; null where all were applied. */
export function refusalOf(dispatch: Dispatch, ...actions: Action[]): string | null {
  let found: string | null = null;
  for (const action of actions) if (found === null) dispatch(action, (sentence) => (found = sentence));
  return found;
}

function refusal(error: unknown): string {
  if (isInputError(error)) return sentence(error.message);
  return `This could not be done, and nothing was changed: ${sentence(messageOf(error))}`;
}

/** A message with a capital and a full stop. */
export function sentence(text: string): string {
  const begun = /^(it|none|the) /.test(text) ? text[0]!.toUpperCase() + text.slice(1) : text;
  return /[.!?]$/.test(begun) ? begun : `${begun}.`;
}

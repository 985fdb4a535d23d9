/** A list that the browser keeps as JSON and that components follow. */
import { useEffect, useState } from "preact/hooks";

import { read, write, type Slot } from "./slots.ts";

/** The entries of a kept text, so many at most; none of a text that is no list. */
export function entriesOf(text: string | null, most: number): unknown[] {
  try {
    const json: unknown = JSON.parse(text ?? "null");
    return Array.isArray(json) ? json.slice(0, most) : [];
  } catch {
    // Of another version of the page.
    return [];
  }
}

export class KeptList<Entry> {
  private present: readonly Entry[] | null = null;
  private readonly listeners = new Set<() => void>();
  private readonly slot: Slot;
  private readonly parse: (text: string | null) => readonly Entry[];

  /** `parse` makes entries of what the slot keeps, and leaves out what cannot be one. */
  constructor(slot: Slot, parse: (text: string | null) => readonly Entry[]) {
    this.slot = slot;
    this.parse = parse;
  }

  /** The list at hand. */
  get entries(): readonly Entry[] {
    return (this.present ??= this.parse(read(this.slot)));
  }

  /** Keeps a text; false where the browser does not. */
  keep(text: string): boolean {
    return write(this.slot, text);
  }

  /** Shows another list; it lasts as long as the page, unless its text is kept. */
  show(next: readonly Entry[]): void {
    this.present = next;
    for (const listener of this.listeners) listener();
  }

  /** The list in a component, which follows it. */
  readonly use = (): readonly Entry[] => {
    const [, setCount] = useState(0);
    useEffect(() => {
      const listener = (): void => setCount((count) => count + 1);
      this.listeners.add(listener);
      return () => void this.listeners.delete(listener);
    }, []);
    return this.entries;
  };
}

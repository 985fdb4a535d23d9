/** Values in writing: typing is free, and what cannot be is told beside the field while the last value stays in use. */
import { createContext } from "preact";
import { useContext, useEffect, useState } from "preact/hooks";

import { inWords } from "./symbols.ts";

/** The fabric that is edited: with another one, as after undo, what was said of the last entry holds no more. */
export const Edited = createContext<unknown>(null);

export interface Written {
  readonly text: string;
  /** Why what is written is not in use; empty where it is. */
  readonly fault: string;
  /** What an `input` of the text needs. */
  readonly input: {
    readonly type: "text";
    readonly value: string;
    readonly spellcheck: boolean;
    readonly "aria-invalid": boolean;
    readonly onInput: (event: { readonly currentTarget: HTMLInputElement }) => void;
    readonly onChange: (event: { readonly currentTarget: HTMLInputElement }) => void;
    readonly onKeyDown: (event: KeyboardEvent) => void;
  };
  /** Uses another text at once. */
  readonly enter: (text: string) => void;
}

/**
 * State of a text field.
 *
 * @param value what is in use, as it is written.
 * @param apply uses a text; the sentence that says why not, or null.
 */
export function useWritten(value: string, apply: (text: string) => string | null): Written {
  const [text, setText] = useState(value);
  const [fault, setFault] = useState("");
  const reset = (): void => {
    setText(value);
    setFault("");
  };
  useEffect(reset, [value, useContext(Edited)]);
  const enter = (entered: string): void => {
    const refused = entered === value ? null : apply(entered);
    setFault(refused === null ? "" : inWords(refused));
    // The same value in other words is shown as it is always written.
    setText(refused === null ? value : entered);
  };
  return {
    text,
    fault,
    enter,
    input: {
      type: "text",
      value: text,
      spellcheck: false,
      "aria-invalid": fault !== "",
      onInput: (event) => setText(event.currentTarget.value),
      onChange: (event) => enter(event.currentTarget.value),
      onKeyDown: (event) => event.key === "Escape" && reset(),
    },
  };
}

/** The sentence beside a field. */
export function Fault({ text }: { readonly text: string }) {
  if (text === "") return null;
  return (
    <span class="fault" role="alert">
      {text}
    </span>
  );
}

/**
 * A number as people write it: with a comma or a point, and either minus.
 *
 * @returns null for another text.
 */
export function numberOf(text: string): number | null {
  const plain = text.trim().replace(",", ".").replace("\u2212", "-");
  return /^[-+]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : null;
}

/** A slider with its number, for one quantity. */
import { clamp } from "loomlight-fabric";
import { useId, useRef } from "preact/hooks";

import type { Quantity } from "./symbols.ts";
import { Fault, numberOf, useWritten } from "./written.tsx";

interface Props {
  readonly field: string;
  readonly quantity: Quantity;
  /** What is in use: the fabric's own value or the one that follows from the weave. */
  readonly value: number;
  /** Whether the fabric says so itself. */
  readonly isOwn: boolean;
  /** `stroke` names the gesture, so that a drag is one step of undo; the answer says why a value is refused, or null. */
  readonly onValue: (value: number, stroke: string) => string | null;
  readonly onReset?: () => void;
}

const MINUS = "\u2212";
let strokes = 0;

/** A name that no other gesture has. */
export function newStroke(): string {
  strokes += 1;
  return `stroke-${strokes}`;
}

export function Slider({ field, quantity, value, isOwn, onValue, onReset }: Props) {
  const id = useId();
  const stroke = useRef(newStroke());
  const { label, tip, low, high, step, unit, ends } = quantity;
  const bounded = clamp(value, low, high);
  const share = ((bounded - low) / (high - low)) * 100;
  // Where both directions matter the bar grows from zero.
  const origin = -low > high / 2 ? (-low / (high - low)) * 100 : 0;
  const written = useWritten(shownNumber(value, step), (text) => {
    const number = numberOf(text);
    return number === null ? `"${text}" is no number.` : onValue(number, newStroke());
  });
  return (
    <div class={`slider${isOwn ? " is-own" : ""}`} data-field={field}>
      <div class="slider-head">
        <label for={id} class="tip" data-tip={tip}>
          {label}
        </label>
        {isOwn && onReset !== undefined && (
          <button type="button" class="reset" onClick={onReset} aria-label={`${label}: back to the weave's own`} title="Back to the weave's own">
            ↺
          </button>
        )}
        <span class="slider-number">
          <input {...written.input} inputMode="decimal" aria-label={`${label}, number`} data-testid={`number-${field}`} />
          {unit !== undefined && <span class="unit">{unit}</span>}
        </span>
      </div>
      <Fault text={written.fault} />
      <input
        id={id}
        type="range"
        min={low}
        max={high}
        step={step}
        value={bounded}
        title={tip}
        aria-description={tip}
        data-testid={`field-${field}`}
        style={{ "--from": `${Math.min(share, origin)}%`, "--to": `${Math.max(share, origin)}%` }}
        onPointerDown={() => (stroke.current = newStroke())}
        onKeyDown={() => (stroke.current = `key-${field}`)}
        onInput={(event) => onValue(event.currentTarget.valueAsNumber, stroke.current)}
      />
      {ends !== undefined && (
        <div class="slider-ends" aria-hidden="true">
          <span>{ends[0]}</span>
          <span>{ends[1]}</span>
        </div>
      )}
    </div>
  );
}

function shownNumber(value: number, step: number): string {
  const digits = step >= 1 ? (Number.isInteger(value) ? 0 : 1) : step >= 0.1 ? 1 : 2;
  return value.toFixed(digits).replace(/^-(?=.*[1-9])/, MINUS).replace(/^-/, "");
}

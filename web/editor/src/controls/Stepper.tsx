/** A whole number with a step down and a step up. */
import { Icon } from "./Icon.tsx";
import { Fault, numberOf, useWritten } from "./written.tsx";

interface Props {
  readonly label: string;
  readonly testid: string;
  readonly value: number;
  /** Why a number is refused, or null. */
  readonly onValue: (value: number) => string | null;
}

export function Stepper({ label, testid, value, onValue }: Props) {
  const written = useWritten(String(value), (text) => {
    const number = numberOf(text);
    return number === null ? `"${text}" is no number.` : onValue(number);
  });
  return (
    <div class="stepper" role="group" aria-label={label}>
      <span>{label}</span>
      <button type="button" aria-label={`${label}: one less`} data-testid={`${testid}-less`} onClick={() => written.enter(String(value - 1))}>
        <Icon name="minus" />
      </button>
      <input {...written.input} inputMode="numeric" aria-label={label} data-testid={`${testid}-count`} />
      <button type="button" aria-label={`${label}: one more`} data-testid={`${testid}-more`} onClick={() => written.enter(String(value + 1))}>
        <Icon name="plus" />
      </button>
      <Fault text={written.fault} />
    </div>
  );
}

/** A choice of one among a few. */
interface Props<T extends string> {
  readonly label: string;
  readonly choices: readonly (readonly [T, string])[];
  readonly value: T;
  readonly onChoose: (value: T) => void;
  readonly testid: string;
  readonly isDisabled?: boolean;
}

export function Segmented<T extends string>({ label, choices, value, onChoose, testid, isDisabled = false }: Props<T>) {
  return (
    <div class="segmented" role="radiogroup" aria-label={label}>
      {choices.map(([choice, text]) => (
        <label key={choice} class={choice === value ? "is-chosen" : ""}>
          <input
            type="radio"
            name={testid}
            checked={choice === value}
            disabled={isDisabled}
            data-testid={`${testid}-${choice}`}
            onChange={() => onChoose(choice)}
          />
          <span>{text}</span>
        </label>
      ))}
    </div>
  );
}

/** A colour in writing: sRGB hex, or L*a*b* as instruments give it. */
import { InputError, parseColour, toHex } from "loomlight-fabric";
import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";

interface Props {
  readonly hex: string;
  readonly label: string;
  /** What messages call the colour. */
  readonly field: string;
  readonly testid: string;
  readonly onHex: (hex: string) => void;
  /** What stands beside it, before a fault. */
  readonly after?: ComponentChildren;
}

export function ColourText({ hex, label, field, testid, onHex, after }: Props) {
  const [fault, setFault] = useState("");
  const [text, setText] = useState(hex);
  useEffect(() => {
    setText(hex);
    setFault("");
  }, [hex]);
  const apply = (): void => {
    try {
      const read = toHex(parseColour(text, field));
      setFault("");
      if (read === hex) setText(hex);
      else onHex(read);
    } catch (error) {
      if (!(error instanceof InputError)) throw error;
      setFault(error.message);
    }
  };
  return (
    <>
      <input
        class="colour-text"
        type="text"
        value={text}
        spellcheck={false}
        aria-label={label}
        aria-invalid={fault !== ""}
        data-testid={testid}
        onInput={(event) => setText(event.currentTarget.value)}
        onChange={apply}
      />
      {after}
      {fault !== "" && (
        <span class="fault" role="alert">
          {fault}
        </span>
      )}
    </>
  );
}

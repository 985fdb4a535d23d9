/** A colour in writing: sRGB hex, or L*a*b* as instruments give it. */
import { isInputError, parseColour, toHex } from "loomlight-fabric";
import type { ComponentChildren } from "preact";

import { Fault, useWritten } from "./written.tsx";

interface Props {
  readonly hex: string;
  readonly label: string;
  /** What messages call the colour. */
  readonly field: string;
  readonly testid: string;
  readonly onHex: (hex: string) => string | null;
  /** What stands beside it, before a fault. */
  readonly after?: ComponentChildren;
}

export function ColourText({ hex, label, field, testid, onHex, after }: Props) {
  const written = useWritten(hex, (text) => {
    try {
      const read = toHex(parseColour(text, field));
      return read === hex ? null : onHex(read);
    } catch (error) {
      if (!isInputError(error)) throw error;
      return error.message;
    }
  });
  return (
    <>
      <input {...written.input} class="colour-text" aria-label={label} data-testid={testid} />
      {after}
      <Fault text={written.fault} />
    </>
  );
}

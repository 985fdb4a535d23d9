/** A colour in writing: sRGB hex, L*a*b* as instruments give it, or the name of a standard on a colour card. */
import { isInputError, parseColour, toHex } from "loomlight-fabric";
import type { ComponentChildren } from "preact";

import { colourNamed, nameOfColour } from "../keeping/cards.ts";
import { Fault, useWritten } from "./written.tsx";

/** The list of names that a field of a colour proposes; `Brush` has it. */
export const STANDARDS = "standard-names";

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
      const read = colourNamed(text)?.hex ?? toHex(parseColour(text, field));
      return read === hex ? null : onHex(read);
    } catch (error) {
      if (!isInputError(error)) throw error;
      return error.message;
    }
  });
  return (
    <>
      <input {...written.input} class="colour-text" list={STANDARDS} title={nameOfColour(hex)} aria-label={label} data-testid={testid} />
      {after}
      <Fault text={written.fault} />
    </>
  );
}

/** Asks what a picture of many colours is: an artwork whose colours are weaves, a drawdown, a print, or a mistake. */
import { MAX_COLOURS } from "loomlight-fabric";
import { useEffect, useRef } from "preact/hooks";

import type { Meaning } from "./files.ts";

export type Meant = Meaning | "print" | "cloth";

interface Props {
  readonly name: string;
  readonly colours: number;
  readonly onAnswer: (meant: Meant) => void;
}

export function PhotographQuestion({ name, colours, onAnswer }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current!.showModal(), []);
  const isArtwork = colours <= MAX_COLOURS;
  const choice = (meant: Meant, text: string, isPrimary = false) => (
    <button type="button" class={`button${isPrimary ? " is-primary" : ""}`} data-testid={`picture-is-${meant}`} onClick={() => onAnswer(meant)}>
      {text}
    </button>
  );
  return (
    <dialog ref={dialog} class="export" aria-label="What this picture is" data-testid="photograph" onCancel={() => onAnswer("nothing")}>
      <h2>{isArtwork ? "An artwork?" : "A photograph?"}</h2>
      <p>
        {name} has {colours.toLocaleString("en")} colours. In an artwork each colour is a weave
        {isArtwork ? "" : `, and at most ${MAX_COLOURS} can be: save it with few colours, without smoothing (an indexed PNG), to weave it`}. A drawdown has one pixel a
        crossing, dark where the warp is on top and light where the weft is.
      </p>
      <div class="row">
        {isArtwork && choice("artwork", "Make its colours weaves", true)}
        {choice("print", "Print it on the cloth", !isArtwork)}
        {choice("cloth", "It is a photograph of cloth")}
        {choice("drawdown", "Read it as a drawdown")}
        {choice("nothing", "Leave it")}
      </div>
    </dialog>
  );
}

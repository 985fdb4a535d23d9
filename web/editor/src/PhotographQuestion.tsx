/** Asks what a picture is that has more colours than a drawdown: one pixel a crossing, a print, or a mistake. */
import { useEffect, useRef } from "preact/hooks";

export type Meant = "drawdown" | "print" | "cloth" | "nothing";

interface Props {
  readonly name: string;
  readonly onAnswer: (meant: Meant) => void;
}

export function PhotographQuestion({ name, onAnswer }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current!.showModal(), []);
  const choice = (meant: Meant, text: string, isPrimary = false) => (
    <button type="button" class={`button${isPrimary ? " is-primary" : ""}`} data-testid={`picture-is-${meant}`} onClick={() => onAnswer(meant)}>
      {text}
    </button>
  );
  return (
    <dialog ref={dialog} class="export" aria-label="What this picture is" data-testid="photograph" onCancel={() => onAnswer("nothing")}>
      <h2>A photograph?</h2>
      <p>{name} has more than a dozen colours. A drawdown has one pixel a crossing, dark where the warp is on top and light where the weft is.</p>
      <div class="row">
        {choice("print", "Print it on the cloth", true)}
        {choice("cloth", "It is a photograph of cloth")}
        {choice("drawdown", "Read it as a drawdown")}
        {choice("nothing", "Leave it")}
      </div>
    </dialog>
  );
}

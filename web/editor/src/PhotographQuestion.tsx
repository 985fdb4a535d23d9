/** Asks what a picture of many colours is: an artwork whose colours are weaves, a drawdown, a print, or a mistake. */
import { inMainColours, MAX_COLOURS } from "loomlight-fabric";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";

import { Stepper } from "./controls/Stepper.tsx";
import type { Meaning, Unclear } from "./files.ts";
import type { Pixels } from "./view/cloth_view.ts";

export type Meant = Meaning | "print" | "cloth";

interface Props {
  readonly picture: Unclear;
  readonly onAnswer: (meant: Meant) => void;
}

/** Colours to begin with, and the most: more areas than that are too small to be woven. */
const MAIN_COLOURS = 6;
const MOST_COLOURS = 24;
/** Pixels of the preview's longer side. */
const PREVIEW = 320;

export function PhotographQuestion({ picture, onAnswer }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const [mainColours, setMainColours] = useState(MAIN_COLOURS);
  useEffect(() => dialog.current!.showModal(), []);
  const { file, colours } = picture;
  const isArtwork = colours <= MAX_COLOURS;
  const choice = (key: string, meant: Meant, text: string, isPrimary = false) => (
    <button type="button" class={`button${isPrimary ? " is-primary" : ""}`} data-testid={`picture-is-${key}`} autofocus={isPrimary} onClick={() => onAnswer(meant)}>
      {text}
    </button>
  );
  const setCount = (count: number): string | null => {
    if (!Number.isInteger(count) || count < 2 || count > MOST_COLOURS) return `An artwork is reduced to 2 to ${MOST_COLOURS} colours.`;
    setMainColours(count);
    return null;
  };
  return (
    <dialog ref={dialog} class="export" aria-label="What this picture is" data-testid="photograph" onCancel={() => onAnswer("nothing")}>
      <h2>An artwork, or a photograph?</h2>
      <p>
        {file.name} has {colours.toLocaleString("en")} colours. In an artwork each colour is a weave
        {isArtwork ? "" : `, and at most ${MAX_COLOURS} can be`}. A drawdown has one pixel a crossing, dark where the warp is on top and light where the weft is.
      </p>
      <Preview pixels={picture.pixels} mainColours={mainColours} />
      <div class="steppers">
        <Stepper label="Main colours" testid="picture-colours" value={mainColours} onValue={setCount} />
      </div>
      <div class="picture-meanings">
        {choice("main-colours", { mainColours }, `Weave its ${mainColours} main colours`, true)}
        {isArtwork && choice("artwork", "artwork", `Make all ${colours} colours weaves`)}
        {choice("print", "print", "Print it on the cloth")}
        {choice("cloth", "cloth", "It is a photograph of cloth")}
        {choice("drawdown", "drawdown", "Read it as a drawdown")}
        {choice("nothing", "nothing", "Leave it")}
      </div>
    </dialog>
  );
}

/** The picture in its main colours, small. */
function Preview({ pixels, mainColours }: { readonly pixels: Pixels; readonly mainColours: number }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const small = useMemo(() => smaller(pixels), [pixels]);
  useEffect(() => {
    const { data, width, height } = small;
    canvas.current!.getContext("2d")!.putImageData(new ImageData(inMainColours(data, width, height, mainColours), width, height), 0, 0);
  }, [small, mainColours]);
  return <canvas ref={canvas} class="picture-preview" width={small.width} height={small.height} role="img" aria-label={`The picture in ${mainColours} colours`} />;
}

/** Every so many pixels of a picture. */
function smaller({ data, width, height }: Pixels): Pixels {
  const step = Math.ceil(Math.max(width, height) / PREVIEW);
  const [columns, rows] = [Math.ceil(width / step), Math.ceil(height / step)];
  const found = new Uint8ClampedArray(4 * columns * rows);
  for (let row = 0, to = 0; row < rows; row++)
    for (let column = 0; column < columns; column++, to += 4) {
      const at = 4 * (row * step * width + column * step);
      found.set(data.subarray(at, at + 4), to);
    }
  return { width: columns, height: rows, data: found };
}

/** Colours: the palette of each family, bars of its threads, and its order as weavers write it. */
import { coloursInUse, FAMILIES, isInputError, threadHexes, type FamilyName } from "loomlight-fabric";
import { useEffect, useRef, useState } from "preact/hooks";

import { ColourText } from "../controls/ColourText.tsx";
import { newStroke } from "../controls/Slider.tsx";
import { FAMILY_NAMES } from "../controls/symbols.ts";
import { Fault, useWritten } from "../controls/written.tsx";
import { woven, type Fabric } from "../state/document.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";
import { Brush } from "./Brush.tsx";
import { ColourCards } from "./ColourCards.tsx";
import { orderText, parseOrder } from "./colour_order.ts";

interface Props {
  readonly fabric: Fabric;
  readonly dispatch: Dispatch;
}

/** Colours of a family that are listed one by one. */
const MAX_LISTED = 16;

export function ColourPanel({ fabric, dispatch }: Props) {
  const [brush, setBrush] = useState<string | null>(null);
  const hexes = { warp: threadHexes(woven(fabric), "warp"), weft: threadHexes(woven(fabric), "weft") };
  const colour = brush ?? hexes.weft[0] ?? "#ffffff";
  return (
    <>
      <Brush fabric={fabric} value={colour} onValue={setBrush} />
      <p class="note">Each colour can be written: #30497a, lab(31 6 -32) as a spectrophotometer says it (D65), or the name of a standard on a card below.</p>
      {FAMILIES.map((family) => (
        <Family key={family} family={family} hexes={hexes[family]} brush={colour} fabric={fabric} dispatch={dispatch} />
      ))}
      <button
        type="button"
        class="button"
        data-testid="colours-exchange"
        onClick={() => {
          const stroke = newStroke();
          const { warp, weft } = hexes;
          dispatch({ type: "colour/order", family: "warp", hexes: weft, stroke });
          dispatch({ type: "colour/order", family: "weft", hexes: warp, stroke });
        }}
      >
        Exchange warp and weft
      </button>
      <ColourCards value={colour} onValue={setBrush} />
    </>
  );
}

interface FamilyProps extends Props {
  readonly family: FamilyName;
  readonly hexes: readonly string[];
  readonly brush: string;
}

function Family({ family, hexes, brush, dispatch }: FamilyProps) {
  const used = coloursInUse(hexes);
  const stroke = useRef(newStroke());
  return (
    <section class="group">
      <h2>{FAMILY_NAMES[family]}</h2>
      <ThreadBar family={family} hexes={hexes} brush={brush} dispatch={dispatch} />
      <ul class="palette">
        {used.slice(0, MAX_LISTED).map(({ hex, count }, index) => (
          <li key={index}>
            <input
              type="color"
              value={hex}
              aria-label={`${FAMILY_NAMES[family]} colour ${index + 1}`}
              data-testid={`colour-${family}-${index}`}
              onPointerDown={() => (stroke.current = newStroke())}
              onInput={(event) =>
                dispatch({ type: "colour/swap", family, from: hex, to: event.currentTarget.value, stroke: stroke.current })
              }
            />
            <ColourText
              hex={hex}
              label={`${FAMILY_NAMES[family]} colour ${index + 1}, written`}
              field={`${family} colour ${index + 1}`}
              testid={`written-${family}-${index}`}
              onHex={(to) => refusalOf(dispatch, { type: "colour/swap", family, from: hex, to, stroke: newStroke() })}
              after={
                <span class="hint">
                  {count} {count === 1 ? "thread" : "threads"}
                </span>
              }
            />
          </li>
        ))}
        {used.length > MAX_LISTED && <li class="hint">and {used.length - MAX_LISTED} more</li>}
      </ul>
      <Order family={family} hexes={hexes} brush={brush} dispatch={dispatch} />
    </section>
  );
}

type PartProps = Omit<FamilyProps, "fabric">;

/** The threads of one repeat side by side: drag along it to paint. */
function ThreadBar({ family, hexes, brush, dispatch }: PartProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const stroke = useRef("");
  useEffect(() => {
    const { current } = canvas;
    const context = current!.getContext("2d")!;
    const { width, height } = current!;
    hexes.forEach((hex, thread) => {
      const left = Math.round((thread * width) / hexes.length);
      context.fillStyle = hex;
      context.fillRect(left, 0, Math.round(((thread + 1) * width) / hexes.length) - left, height);
      if (width / hexes.length < 8) return;
      context.fillStyle = "rgb(0 0 0 / 14%)";
      context.fillRect(left, 0, 2, height);
    });
  }, [hexes]);
  const paint = (event: PointerEvent): void => {
    const box = canvas.current!.getBoundingClientRect();
    const thread = Math.floor(((event.clientX - box.left) / box.width) * hexes.length);
    if (thread < 0 || thread >= hexes.length || hexes[thread] === brush) return;
    dispatch({ type: "colour/paint", family, thread, hex: brush, stroke: stroke.current });
  };
  return (
    <canvas
      ref={canvas}
      class="thread-bar"
      width={680}
      height={40}
      role="img"
      aria-label={`Colours of ${hexes.length} ${family === "warp" ? "ends" : "picks"} of a repeat; drag to paint them, or write their order below`}
      data-testid={`threads-${family}`}
      onPointerDown={(event) => {
        stroke.current = newStroke();
        event.currentTarget.setPointerCapture(event.pointerId);
        paint(event);
      }}
      onPointerMove={(event) => event.buttons !== 0 && paint(event)}
    />
  );
}

/** The order as weavers write it: "4a 4b" is four threads of the first colour, four of the second. */
function Order({ family, hexes, brush, dispatch }: PartProps) {
  const written = useWritten(orderText(hexes), (text) => {
    try {
      return refusalOf(dispatch, { type: "colour/order", family, hexes: parseOrder(text, hexes, brush) });
    } catch (error) {
      if (!isInputError(error)) throw error;
      return error.message;
    }
  });
  return (
    <form class="row" onSubmit={(event) => event.preventDefault()}>
      <label class="tip" for={`order-${family}`} data-tip="4a 4b: four threads of the first colour, four of the second; z is the colour you paint with">
        Order
      </label>
      <input {...written.input} id={`order-${family}`} class="text" data-testid={`order-${family}`} />
      <Fault text={written.fault} />
    </form>
  );
}

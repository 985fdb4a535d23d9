/** The lamp, the surroundings and the exposure. */
import { useRef } from "preact/hooks";

import { Segmented } from "../controls/Segmented.tsx";
import { Slider } from "../controls/Slider.tsx";
import type { Quantity } from "../controls/symbols.ts";
import { SCENE_RANGES, type Scene, type Surroundings } from "../state/document.ts";
import { refusalOf, type Dispatch } from "../state/store.ts";

interface Props {
  readonly scene: Scene;
  readonly dispatch: Dispatch;
  /** Opens a picture of surroundings of the user's own. */
  readonly onPicture: () => void;
  /** Whether the cloth is shown flat, without light. */
  readonly isFlat: boolean;
}

type SceneNumber = keyof typeof SCENE_RANGES;

const quantity = (field: SceneNumber, label: string, tip: string, step: number, rest: Partial<Quantity> = {}): Quantity => ({
  label,
  tip,
  low: SCENE_RANGES[field][0],
  high: SCENE_RANGES[field][1],
  step,
  standard: 0,
  ...rest,
});

const QUANTITIES: Readonly<Record<SceneNumber, Quantity>> = {
  lampStrength: quantity("lampStrength", "Brightness", "Irradiance of the lamp, times that as designed", 0.05),
  lampAzimuth: quantity("lampAzimuth", "Around the cloth", "Azimuth of the lamp: 0 in front, 90 to the right", 1, { unit: "°" }),
  lampElevation: quantity("lampElevation", "Height", "Elevation of the lamp above the horizon", 1, { unit: "°" }),
  surroundingsStrength: quantity("surroundingsStrength", "Brightness of the room", "Radiance of the surroundings, times that as designed", 0.05),
  surroundingsTurn: quantity("surroundingsTurn", "Turn the room", "Turns the surroundings about the vertical", 1, { unit: "°" }),
  exposure: quantity("exposure", "Exposure", "Stops: each doubles the light", 0.1, { ends: ["darker", "brighter"] }),
  whiteBalance: quantity("whiteBalance", "White balance", "Colour temperature of the light that is shown as white; 6500 changes nothing", 50, {
    unit: "\u00a0K",
    ends: ["cooler", "warmer"],
  }),
};

const CHOICES: readonly (readonly [Surroundings, string])[] = [
  ["studio", "Studio"],
  ["window", "Window"],
  ["sky", "Sky"],
  ["none", "Dark"],
  ["picture", "Yours"],
];

export function LightPanel({ scene, dispatch, onPicture, isFlat }: Props) {
  const slider = (field: SceneNumber) => (
    <Slider
      field={`scene.${field}`}
      quantity={QUANTITIES[field]}
      value={scene[field]}
      isOwn={false}
      onValue={(value) => refusalOf(dispatch, { type: "scene/set", scene: { [field]: value } })}
    />
  );
  return (
    <>
      {isFlat && <p class="note is-flat">Here the cloth is shown flat: light needs a browser with WebGPU.</p>}
      <section class="group">
        <h2>Lamp</h2>
        <LampDial scene={scene} dispatch={dispatch} />
        {slider("lampStrength")}
        {slider("lampAzimuth")}
        {slider("lampElevation")}
      </section>
      <section class="group">
        <h2>Room</h2>
        <Segmented
          label="Surroundings"
          testid="surroundings"
          choices={CHOICES}
          value={scene.surroundings}
          onChoose={(surroundings) => (surroundings === "picture" ? onPicture() : dispatch({ type: "scene/set", scene: { surroundings } }))}
        />
        {slider("surroundingsStrength")}
        {slider("surroundingsTurn")}
      </section>
      <section class="group">
        <h2>Picture</h2>
        {slider("exposure")}
        {slider("whiteBalance")}
      </section>
    </>
  );
}

/** The lamp over the cloth, seen from the front: drag it. */
function LampDial({ scene, dispatch }: Pick<Props, "scene" | "dispatch">) {
  const dial = useRef<SVGSVGElement>(null);
  const around = (scene.lampAzimuth * Math.PI) / 180;
  const reach = 1 - Math.max(scene.lampElevation, 0) / 90;
  const [x, y] = [50 + 42 * reach * Math.sin(around), 50 + 42 * reach * Math.cos(around)];
  const place = (event: PointerEvent): void => {
    if (event.buttons === 0 || dial.current === null) return;
    const box = dial.current.getBoundingClientRect();
    const [u, v] = [((event.clientX - box.left) / box.width) * 100 - 50, ((event.clientY - box.top) / box.height) * 100 - 50];
    const radius = Math.min(Math.hypot(u, v) / 42, 1);
    const lampAzimuth = Math.round((Math.atan2(u, v) * 180) / Math.PI);
    dispatch({ type: "scene/set", scene: { lampAzimuth, lampElevation: Math.round(90 * (1 - radius)) } });
  };
  return (
    <svg
      ref={dial}
      class="lamp-dial"
      viewBox="0 0 100 100"
      role="img"
      aria-label={`Lamp at ${scene.lampAzimuth}° round and ${scene.lampElevation}° up, seen from above; drag it, or use the sliders below`}
      data-testid="lamp-dial"
      onPointerDown={(event) => {
        event.currentTarget.setPointerCapture(event.pointerId);
        place(event);
      }}
      onPointerMove={place}
    >
      <circle cx="50" cy="50" r="42" class="dial-rim" />
      <circle cx="50" cy="50" r="21" class="dial-ring" />
      <path d="M50 8v84M8 50h84" class="dial-ring" />
      <rect x="42" y="42" width="16" height="16" rx="2" class="dial-cloth" />
      <line x1="50" y1="50" x2={x} y2={y} class="dial-ray" />
      <circle cx={x} cy={y} r="6" class="dial-lamp" />
      <text x="50" y="99" text-anchor="middle" class="dial-text">
        you
      </text>
    </svg>
  );
}

/** The cloth, with what belongs to looking at it: shapes, distance, the wipe, the frame time. */
import { clamp, messageOf } from "loomlight-fabric";
import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

import { Icon } from "./controls/Icon.tsx";
import type { OpennessSource } from "./openness.ts";
import { MODELS, nameOf, type Comparison, type Fabric, type Model, type Shape, type State } from "./state/document.ts";
import type { Dispatch } from "./state/store.ts";
import { makeView, type ClothView, type Print, type SurroundingsPicture } from "./view/cloth_view.ts";
import { builtInShape, type ClothShape } from "./view/meshes.ts";
import { isServed, type TableSource } from "./view/served_models.ts";
import type { PictureSource } from "./view/stage_pictures.ts";

interface Props {
  /** Makes tables of models that the page does not bake itself. */
  readonly tables: TableSource;
  /** Has the stage rendered by Python; null where that cannot be. */
  readonly pictures: PictureSource | null;
  /** Whether there is Python to make them. */
  readonly hasPython: boolean;
  readonly state: State;
  readonly dispatch: Dispatch;
  readonly ownMesh: ClothShape | null;
  readonly surroundings: SurroundingsPicture | null;
  /** Where openness of yarns comes from; null without Python. */
  readonly openness: OpennessSource | null;
  /** How often it has answered so far. */
  readonly answers: number;
  readonly print: Print | null;
  /** Chooses a mesh file. */
  readonly onMesh: () => void;
  readonly onView: (view: ClothView | null) => void;
  /** Copies the camera of a piece in a picture of so many pixels. */
  readonly onCamera: (piece: ClothShape, size: readonly [number, number]) => void;
  /** What lies over the foot of the cloth. */
  readonly children?: ComponentChildren;
}

const SHAPE_NAMES: readonly (readonly [Shape, string])[] = [
  ["drape", "Drape"],
  ["flat", "Swatch"],
  ["curtain", "Curtain"],
  ["cylinder", "Roll"],
  ["sphere", "Ball"],
  ["mesh", "Yours"],
];

/** What is said of a picture by Python. */
const RENDERED = { asked: "the server renders this …", shown: "rendered by the server" } as const;

/** By mouse or by two fingers. */
const CLOSER = matchMedia("(pointer: coarse)").matches ? "pinch to come closer" : "scroll to come closer";

/** What each model is called, and what it is for the tooltip. */
export const MODEL_NAMES: Readonly<Record<Model, readonly [string, string]>> = {
  lobes: ["Filtered", "lobes: averaged over the footprint of each pixel"],
  "point-1": ["1 sample", "point: one sample a pixel"],
  "point-3": ["3 samples", "point: three samples a pixel"],
  "point-256": ["256 samples", "point: 256 samples a pixel"],
  neural: ["Network", "neural: a network trained on all fabrics, averaged over the footprint; baked by Python"],
  clustered: ["Clusters", "clustered: normals in clusters, averaged over the footprint; baked by Python"],
};

const NEEDS_PYTHON = "Python makes the tables of this model, and this page runs without it: start loomlight view.";

export function Stage(props: Props) {
  const { tables, pictures, hasPython, state, dispatch, ownMesh, surroundings, print, openness, answers, onMesh, onView, onCamera, children } = props;
  const host = useRef<HTMLDivElement>(null);
  const [view, setView] = useState<ClothView | null>(null);
  const [reason, setReason] = useState<string | null>(null);
  const [lost, setLost] = useState<string | null>(null);
  const [piece, setPiece] = useState<ClothShape | null>(null);
  const [frameMs, setFrameMs] = useState(0);
  const [zoom, setZoom] = useState(0);
  const [isTouched, setTouched] = useState(false);
  const [preparing, setPreparing] = useState<string | null>("Preparing the light …");
  const [refining, setRefining] = useState<string | null>(null);
  const [broken, setBroken] = useState<unknown>(null);
  // What fails between renders is for whoever guards the stage.
  if (broken !== null) throw broken;
  const { fabric, scene, comparison } = state;

  const onFault = (text: string): void => dispatch({ type: "notice/add", kind: "fault", text });

  useEffect(() => {
    let made: ClothView | null = null;
    let isGone = false;
    void makeView(host.current!, tables, pictures, onFault).then(({ view: next, reason: why }) => {
      if (isGone) return next.dispose();
      made = next;
      setView(next);
      setReason(why);
      onView(next);
      void next.lost.then((text) => !isGone && setLost(text));
    });
    return () => {
      isGone = true;
      made?.dispose();
      onView(null);
    };
  }, []);

  useEffect(() => {
    let isStale = false;
    if (scene.shape === "mesh") setPiece(ownMesh);
    else
      builtInShape(scene.shape).then(
        (shape) => !isStale && setPiece(shape),
        (error: Error) => dispatch({ type: "notice/add", kind: "fault", text: error.message }),
      );
    return () => void (isStale = true);
  }, [scene.shape, ownMesh]);

  useEffect(() => {
    if (view === null || lost !== null) return;
    try {
      // Without Python the renderer finds it.
      const opennessOf = (of: Fabric) => openness?.of(of);
      view.show({ fabric, scene, comparison, piece, surroundings, print, opennessOf });
      if (view.kind === "webgpu") openness?.show(comparison.before === null ? [fabric] : [fabric, comparison.before]);
    } catch (error) {
      dispatch({ type: "notice/add", kind: "fault", text: messageOf(error) });
    }
  }, [view, fabric, scene, comparison, piece, surroundings, print, answers]);

  useEffect(() => {
    if (view === null || lost !== null) return;
    let handle = 0;
    let told = 0;
    const draw = (now: number): void => {
      try {
        view.frame();
      } catch (error) {
        return setBroken(error);
      }
      if (now - told > 250) {
        told = now;
        const { frameMs: last, preparing: words, refining: share, rendered } = view.statistics();
        setFrameMs(last);
        setPreparing(words);
        setRefining(rendered !== null ? RENDERED[rendered] : share === null ? null : `refining ${Math.floor(100 * share)} %`);
        setZoom(view.zoom);
      }
      handle = requestAnimationFrame(draw);
    };
    handle = requestAnimationFrame(draw);
    return () => cancelAnimationFrame(handle);
  }, [view, lost]);

  const isWiping = comparison.mode === "models" ? view?.kind !== "canvas" : comparison.mode === "fabrics" && comparison.before !== null;
  return (
    <section class="stage" aria-label="Cloth">
      <div class="stage-view" ref={host} onPointerDown={() => setTouched(true)} onWheel={() => setTouched(true)} />
      {children}
      {isWiping && <Wipe comparison={comparison} dispatch={dispatch} right={nameOf(fabric)} hasPython={hasPython} />}
      {lost !== null && <Lost text={lost} />}
      {reason !== null && lost === null && (
        <div class="stage-reason" role="status" data-testid="no-webgpu">
          <details>
            <summary>The cloth is shown flat, without light.</summary>
            <p>
              {reason} Drafts, colours and saving work as ever.{" "}
              <a href="https://caniuse.com/webgpu" rel="noreferrer">
                Browsers that have it
              </a>
            </p>
          </details>
        </div>
      )}
      <div class="stage-bar">
        {view?.kind !== "canvas" && <div class="shapes" role="radiogroup" aria-label="Shape of the cloth">
          {SHAPE_NAMES.map(([shape, text]) => (
            <label key={shape} class={shape === scene.shape ? "is-chosen" : ""}>
              <input
                type="radio"
                name="shape"
                checked={shape === scene.shape}
                data-testid={`shape-${shape}`}
                onClick={() => shape === "mesh" && onMesh()}
                onChange={() => (shape === "mesh" && ownMesh === null ? undefined : dispatch({ type: "scene/set", scene: { shape } }))}
              />
              <span>{text}</span>
            </label>
          ))}
        </div>}
        <label class="zoom">
          <span>room</span>
          <input
            type="range"
            min={0}
            max={1}
            step={0.005}
            value={zoom}
            aria-label="Distance, from across the room to a single yarn"
            data-testid="zoom"
            onInput={(event) => {
              if (view === null) return;
              view.zoom = event.currentTarget.valueAsNumber;
              setZoom(view.zoom);
              setTouched(true);
            }}
          />
          <span>yarn</span>
        </label>
        <button type="button" class="icon-button" aria-label="Show the whole cloth" title="Show the whole cloth" data-testid="frame-whole" onClick={() => view?.frameWhole()}>
          <Icon name="frame" />
        </button>
        {view?.kind === "webgpu" && (
          <button
            type="button"
            class="icon-button"
            aria-label="Copy camera"
            title="Copy this view as a command of loomlight render"
            data-testid="copy-camera"
            disabled={piece === null}
            onClick={() => onCamera(piece!, [host.current!.clientWidth, host.current!.clientHeight])}
          >
            <Icon name="camera" />
          </button>
        )}
        {refining !== null ? (
          <output class="refining" title="This adapter takes long for a picture as fine as the screen" data-testid="refining">
            {refining}
          </output>
        ) : (
          <output class="frame-time" title="Time of the last frame" data-testid="frame-time">
            {frameMs > 0 ? `${frameMs < 10 ? frameMs.toFixed(1) : Math.round(frameMs)} ms` : "–"}
          </output>
        )}
      </div>
      {preparing !== null && lost === null && (
        <p class="stage-hint" role="status" data-testid="preparing">
          {preparing}
        </p>
      )}
      {preparing === null && !isTouched && !isWiping && view !== null && lost === null && (
        <p class="stage-hint">{view.kind === "webgpu" ? `Drag to turn · ${CLOSER}` : `Drag to move · ${CLOSER}`}</p>
      )}
    </section>
  );
}

interface WipeProps {
  readonly comparison: Comparison;
  readonly dispatch: Dispatch;
  readonly right: string;
  readonly hasPython: boolean;
}

function Wipe({ comparison, dispatch, right, hasPython }: WipeProps) {
  const frame = useRef<HTMLDivElement>(null);
  const move = (event: PointerEvent): void => {
    if (event.buttons === 0) return;
    const box = frame.current!.getBoundingClientRect();
    const position = clamp((event.clientX - box.left) / box.width, 0, 1);
    dispatch({ type: "comparison/set", comparison: { position } });
  };
  const isModels = comparison.mode === "models";
  const left = comparison.before === null ? "" : nameOf(comparison.before);
  return (
    <div class="wipe" ref={frame}>
      <div
        class="wipe-line"
        style={{ left: `${comparison.position * 100}%` }}
        role="slider"
        tabIndex={0}
        aria-label="Wipe between before and after"
        aria-valuemin={0}
        aria-valuemax={100}
        aria-valuenow={Math.round(comparison.position * 100)}
        data-testid="wipe"
        onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
        onPointerMove={move}
        onKeyDown={(event) => {
          const step = event.key === "ArrowLeft" ? -0.02 : event.key === "ArrowRight" ? 0.02 : 0;
          if (step === 0) return;
          event.preventDefault();
          const position = clamp(comparison.position + step, 0, 1);
          dispatch({ type: "comparison/set", comparison: { position } });
        }}
      />
      <span class="wipe-name wipe-left">{isModels ? <ModelChoice side="left" comparison={comparison} dispatch={dispatch} hasPython={hasPython} /> : `Before: ${left}`}</span>
      <span class="wipe-name wipe-right">{isModels ? <ModelChoice side="right" comparison={comparison} dispatch={dispatch} hasPython={hasPython} /> : `After: ${right}`}</span>
    </div>
  );
}

function ModelChoice({ side, comparison, dispatch, hasPython }: Omit<WipeProps, "right"> & { readonly side: "left" | "right" }) {
  const isOff = (model: Model): boolean => isServed(model) && !hasPython;
  return (
    <select
      aria-label={`Model on the ${side}`}
      value={comparison[side]}
      title={MODEL_NAMES[comparison[side]][1]}
      data-testid={`model-${side}`}
      onChange={(event) => dispatch({ type: "comparison/set", comparison: { [side]: event.currentTarget.value as Model } })}
    >
      {MODELS.map((model) => (
        <option key={model} value={model} disabled={isOff(model)} title={isOff(model) ? NEEDS_PYTHON : MODEL_NAMES[model][1]}>
          {MODEL_NAMES[model][0]}
          {isOff(model) && " (needs loomlight view)"}
        </option>
      ))}
    </select>
  );
}

function Lost({ text }: { readonly text: string }) {
  return (
    <div class="stage-lost" role="alert" data-testid="lost">
      <h2>The graphics device is gone</h2>
      <p>{text} Your cloth is kept; reload to go on where you were.</p>
      <button type="button" class="button is-primary" data-testid="reload" onClick={() => location.reload()}>
        Reload
      </button>
    </div>
  );
}

/** Files for other programs: a picture at any size, maps, a glTF file, a baked material. */
import { clamp, messageOf } from "loomlight-fabric";
import { useEffect, useRef, useState } from "preact/hooks";

import type { Server } from "./api.ts";
import { Segmented } from "./controls/Segmented.tsx";
import { Fault, numberOf, useWritten } from "./controls/written.tsx";
import { download, pngOf, stemOf } from "./files.ts";
import type { Fabric } from "./state/document.ts";
import { fabricForServer } from "./state/fabric_json.ts";
import { sentence } from "./state/store.ts";
import type { ClothView } from "./view/cloth_view.ts";

interface Props {
  readonly fabric: Fabric;
  readonly server: Server | null;
  readonly view: ClothView | null;
  readonly onClose: () => void;
}

const KINDS = ["picture", "maps", "gltf", "loom"] as const;
type Kind = (typeof KINDS)[number];
const KIND_NAMES: readonly (readonly [Kind, string])[] = [
  ["picture", "Picture"],
  ["maps", "Maps"],
  ["gltf", "glTF"],
  ["loom", "Material"],
];
const WHAT: Readonly<Record<Kind, string>> = {
  picture: "The cloth as you see it, as a .png of any size. The page makes it by itself.",
  maps: "One repeat as textures: colour, normal, height, roughness, opacity and more, each a .png, in a .zip. They tile without a seam.",
  gltf: "A sheet of 10 cm with textures fitted to the cloth, as a .glb: for Blender, engines and viewers.",
  loom: "The cloth as baked for loomlight's renderers, a .loom.",
};
const NEEDS_PYTHON = "Python makes this file, and this page runs without it: start loomlight view, or use the commands loomlight bake-maps, export and bake.";
/** Models whose materials are baked in seconds. */
const BAKED = ["lobes", "point", "clustered", "neural"] as const;
const MAX_PICTURE = 8192;
const MAX_MAP = 4096;

/** What is being done: since when, and the share of it, where that is known. */
interface Work {
  readonly began: number;
  readonly share: number | null;
}

export function ExportDialog({ fabric, server, view, onClose }: Props) {
  const dialog = useRef<HTMLDialogElement>(null);
  const [kind, setKind] = useState<Kind>("picture");
  const [width, setWidth] = useState(1920);
  const [height, setHeight] = useState(1080);
  const [isTransparent, setTransparent] = useState(true);
  const [texels, setTexels] = useState(1024);
  const [model, setModel] = useState<(typeof BAKED)[number]>("lobes");
  const [work, setWork] = useState<Work | null>(null);
  const [seconds, setSeconds] = useState(0);
  const [fault, setFault] = useState<string | null>(null);
  const [done, setDone] = useState<string | null>(null);
  const isGone = useRef(false);

  useEffect(() => {
    dialog.current!.showModal();
    return () => void (isGone.current = true);
  }, []);

  useEffect(() => {
    if (work === null) return;
    const timer = setInterval(() => setSeconds(Math.floor((performance.now() - work.began) / 1000)), 250);
    return () => clearInterval(timer);
  }, [work?.began]);

  // What is said of a file holds for what was chosen then.
  useEffect(() => {
    setDone(null);
    setFault(null);
  }, [kind, width, height, isTransparent, texels, model, fabric]);

  const isServed = kind !== "picture";
  const isOff = isServed && (server === null || !server.hasPython);

  /** The file that was asked for: its name, content and type. */
  const made = async (report: (share: number) => void): Promise<readonly [string, BlobPart, string]> => {
    const stem = stemOf(fabric);
    if (kind === "picture") {
      if (view === null) throw new Error("There is no picture yet.");
      const png = await pngOf(await view.picture({ width, height, isTransparent, onProgress: report }));
      return [`${stem}.png`, png, "image/png"];
    }
    const json = fabricForServer(fabric);
    if (kind === "maps") return [`${stem}-maps.zip`, await server!.save("zip", json, { size: texels }), "application/zip"];
    if (kind === "gltf") return [`${stem}.glb`, await server!.save("glb", json), "model/gltf-binary"];
    return [`${stem}.loom`, await server!.save("loom", json, { model }), "application/octet-stream"];
  };

  const start = async (): Promise<void> => {
    const began = performance.now();
    setSeconds(0);
    setFault(null);
    setDone(null);
    setWork({ began, share: null });
    try {
      const [name, content, type] = await made((share) => setWork({ began, share }));
      if (isGone.current) return;
      download(name, content, type);
      setDone(`${name} is saved.`);
    } catch (error) {
      setFault(sentence(messageOf(error)));
    }
    setWork(null);
  };

  return (
    <dialog ref={dialog} class="export" aria-label="Export" onClose={onClose} data-testid="export">
      <h2>Export</h2>
      <Segmented label="What to export" choices={KIND_NAMES} value={kind} onChoose={setKind} testid="export-kind" isDisabled={work !== null} />
      <p>{WHAT[kind]}</p>
      {kind === "picture" && (
        <div class="row">
          <Whole label="Width" unit="pixels" value={width} low={1} high={MAX_PICTURE} onValue={setWidth} testid="export-width" />
          <Whole label="Height" unit="pixels" value={height} low={1} high={MAX_PICTURE} onValue={setHeight} testid="export-height" />
          <label class="export-check">
            <input type="checkbox" checked={isTransparent} data-testid="export-transparent" onChange={(event) => setTransparent(event.currentTarget.checked)} />
            Transparent background
          </label>
        </div>
      )}
      {kind === "maps" && <Whole label="Longer side" unit="texels" value={texels} low={16} high={MAX_MAP} onValue={setTexels} testid="export-texels" />}
      {kind === "loom" && (
        <label>
          Model{" "}
          <select value={model} data-testid="export-model" onChange={(event) => setModel(event.currentTarget.value as typeof model)}>
            {BAKED.map((each) => (
              <option key={each}>{each}</option>
            ))}
          </select>
        </label>
      )}
      {isOff && (
        <p class="export-fault" data-testid="export-needs-python">
          {NEEDS_PYTHON}
        </p>
      )}
      <div class="export-said" role="status" data-testid="export-status">
        {work !== null && (
          <>
            <progress {...(work.share === null ? {} : { value: work.share })} aria-label="Progress" data-testid="export-progress" />
            <span>{work.share === null ? `${isServed ? "Python is at work" : "Working"}: ${seconds} s` : `${Math.floor(100 * work.share)} %, ${seconds} s`}</span>
          </>
        )}
        {done !== null && <span data-testid="export-done">{done}</span>}
        {fault !== null && (
          <span class="export-fault" role="alert" data-testid="export-fault">
            {fault}
          </span>
        )}
      </div>
      <div class="export-buttons">
        <button type="button" class="button" data-testid="export-close" onClick={() => dialog.current!.close()}>
          Close
        </button>
        <button type="button" class="button is-primary" disabled={isOff || work !== null} data-testid="export-start" onClick={() => void start()}>
          Export
        </button>
      </div>
    </dialog>
  );
}

interface WholeProps {
  readonly label: string;
  readonly unit: string;
  readonly value: number;
  readonly low: number;
  readonly high: number;
  readonly onValue: (value: number) => void;
  readonly testid: string;
}

/** A whole number; what is out of range becomes the nearest that is not. */
function Whole({ label, unit, value, low, high, onValue, testid }: WholeProps) {
  const written = useWritten(String(value), (text) => {
    const number = numberOf(text);
    if (number === null) return `"${text}" is no number.`;
    onValue(clamp(Math.round(number), low, high));
    return null;
  });
  return (
    <label title={`${low} to ${high} ${unit}`}>
      {label} <input {...written.input} inputMode="numeric" data-testid={testid} /> {unit}
      <Fault text={written.fault} />
    </label>
  );
}

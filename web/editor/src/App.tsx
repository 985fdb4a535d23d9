/** The whole page. */
import { messageOf } from "loomlight-fabric";
import { useEffect, useMemo, useRef, useState } from "preact/hooks";

import type { Server } from "./api.ts";
import { ServerError } from "./api.ts";
import { CaptureDialog, warningsOf } from "./CaptureDialog.tsx";
import { Edited } from "./controls/written.tsx";
import { ExportDialog } from "./ExportDialog.tsx";
import { ACCEPTED, download, MESHES, NoDraft, openFabric, pngOf, saveFabric, stemOf, wifFile, type Meaning, type Unclear } from "./files.ts";
import { Guard } from "./Guard.tsx";
import type { Health } from "./health.ts";
import { addCard, CARDS } from "./keeping/cards.ts";
import { linkOf } from "./link.ts";
import { Notices } from "./Notices.tsx";
import { PhotographQuestion, type Meant } from "./PhotographQuestion.tsx";
import { OpennessSource } from "./openness.ts";
import { ColourPanel } from "./panels/ColourPanel.tsx";
import { DraftPanel } from "./panels/DraftPanel.tsx";
import { FinishPanel } from "./panels/FinishPanel.tsx";
import { LightPanel } from "./panels/LightPanel.tsx";
import { WeavePanel } from "./panels/WeavePanel.tsx";
import { YarnsPanel } from "./panels/YarnsPanel.tsx";
import { MODEL_NAMES, Stage } from "./Stage.tsx";
import { TABS, type Notice, type Tab } from "./state/document.ts";
import { fabricForServer, fabricFromJson } from "./state/fabric_json.ts";
import type { Store } from "./state/store.ts";
import { TopBar, type SaveFormat } from "./TopBar.tsx";
import { renderCommand } from "./view/camera_options.ts";
import type { ClothView, Print, SurroundingsPicture } from "./view/cloth_view.ts";
import type { ClothShape } from "./view/meshes.ts";
import type { TableSource } from "./view/served_models.ts";

interface Props {
  readonly store: Store;
  readonly server: Server | null;
  readonly health: Health;
  readonly onView: (view: ClothView | null) => void;
}

const TAB_NAMES: Readonly<Record<Tab, string>> = {
  weave: "Weave",
  draft: "Draft",
  colour: "Colour",
  yarns: "Yarns",
  finish: "Finish",
  light: "Light",
};
const CAPTURE_NEEDS_SERVER =
  "A fabric is made of a photograph by Python, and this page runs without it: start `loomlight view`, or use the command `loomlight capture`.";
/** Pictures of surroundings. */
const SURROUNDINGS = /\.(hdr|exr)$/i;

export function App({ store, server, health, onView }: Props) {
  const [state, setState] = useState(store.state);
  const [ownMesh, setOwnMesh] = useState<ClothShape | null>(null);
  const [surroundings, setSurroundings] = useState<SurroundingsPicture | null>(null);
  const [print, setPrint] = useState<Print | null>(null);
  const [isDropping, setDropping] = useState(false);
  const [isFlat, setFlat] = useState(false);
  const [isExporting, setExporting] = useState(false);
  const [question, setQuestion] = useState<{ readonly picture: Unclear; readonly answer: (meant: Meant) => void } | null>(null);
  const [photograph, setPhotograph] = useState<File | null>(null);
  const view = useRef<ClothView | null>(null);
  const chooser = useRef<HTMLInputElement>(null);
  const { dispatch } = store;

  useEffect(() => {
    // A part that fails in the first render changes the state before this one listens.
    setState(store.state);
    return store.subscribe(setState);
  }, [store]);

  const tell = (kind: Notice["kind"], text: string, topic?: Notice["topic"]): void =>
    dispatch({ type: "notice/add", kind, text, ...(topic === undefined ? {} : { topic }) });

  const [answers, setAnswers] = useState(0);
  const openness = useMemo(() => {
    if (server === null || !server.hasPython) return null;
    return new OpennessSource(
      (fabric) => server.openness(fabricForServer(fabric)),
      () => setAnswers((count) => count + 1),
      (sentence) => tell("warning", `Light between yarns is not up to date. ${sentence}`),
    );
  }, [server]);

  const tables: TableSource = async (model, fabric) => {
    if (server === null || !server.hasPython)
      throw new ServerError(`The model ${MODEL_NAMES[model === "point" ? "point-1" : model][0]} is baked by Python, and this page runs without it: start \`loomlight view\`.`);
    return server.tables(model, fabricForServer(fabric));
  };

  /** Runs what may fail with a sentence for the user. */
  const attempt = async (act: () => Promise<void>, topic?: Notice["topic"]): Promise<void> => {
    try {
      await act();
    } catch (error) {
      if (!(error instanceof NoDraft)) tell("fault", messageOf(error), topic);
    }
  };

  /** What a picture of many colours is; a print is laid on the cloth. */
  const askOf = async (picture: Unclear): Promise<Meaning> => {
    const meant = await new Promise<Meant>((answer) => setQuestion({ picture, answer }));
    setQuestion(null);
    if (meant === "print") await openPrint(picture.file);
    else if (meant === "cloth") startCapture(picture.file);
    else return meant;
    return "nothing";
  };

  const startCapture = (file: File): void => {
    if (server === null || !server.hasPython || server.host !== null) throw new ServerError(CAPTURE_NEEDS_SERVER);
    setPhotograph(file);
  };

  const open = (files: readonly File[]): Promise<void> => {
    // What was said of earlier files is no more of use.
    dispatch({ type: "notice/clear", topic: "file" });
    return attempt(async () => {
      const mesh = files.find((file) => MESHES.test(file.name));
      const picture = files.find((file) => SURROUNDINGS.test(file.name));
      if (mesh !== undefined) {
        const { readOwnMesh } = await import("./view/own_mesh.ts");
        const { shape, warnings } = await readOwnMesh(mesh, server);
        setOwnMesh(shape);
        for (const warning of warnings) tell("warning", warning, "file");
        dispatch({ type: "scene/set", scene: { shape: "mesh" } });
      }
      if (picture !== undefined) {
        const { readSurroundings } = await import("./view/surroundings_file.ts");
        setSurroundings(await readSurroundings(picture));
        dispatch({ type: "scene/set", scene: { surroundings: "picture" } });
      }
      // A table beside a fabric file is one of its measurements.
      const cards = files.some((file) => /\.toml$/i.test(file.name)) ? [] : files.filter((file) => CARDS.test(file.name));
      for (const card of cards) {
        for (const warning of await addCard(card)) tell("warning", warning, "file");
        dispatch({ type: "tab/show", tab: "colour" });
      }
      const rest = files.filter((file) => file !== mesh && file !== picture && !cards.includes(file));
      if (rest.length === 0) return;
      const { fabric, warnings } = await openFabric(rest, server, askOf);
      dispatch({ type: "fabric/open", fabric });
      if (fabric.artwork !== undefined) dispatch({ type: "tab/show", tab: "weave" });
      for (const warning of warnings.slice(0, 2)) tell("warning", warning, "file");
    }, "file");
  };

  const choose = (accepted: string): void => {
    const input = chooser.current!;
    input.accept = accepted;
    input.value = "";
    input.click();
  };

  const openPrint = (file: File | undefined): Promise<void> =>
    attempt(async () => {
      if (file === undefined) return;
      const { readPrint } = await import("./view/print_file.ts");
      setPrint(await readPrint(file));
    });

  const save = (format: SaveFormat): Promise<void> =>
    attempt(async () => {
      const { fabric } = store.state;
      if (format === "toml") await saveFabric(fabric);
      if (format === "wif") {
        const file = wifFile(fabric);
        download(file.name, file.content);
      }
      if (format === "png") {
        if (view.current === null) throw new Error("There is no picture yet.");
        download(`${stemOf(fabric)}.png`, await pngOf(await view.current.readPixels()), "image/png");
      }
      if (format === "export") setExporting(true);
    });

  const copyLink = (): Promise<void> =>
    attempt(async () => {
      const link = await linkOf(store.state.fabric);
      if (link === null)
        return tell("warning", "This draft is too large for a link: save the fabric and send its files.");
      history.replaceState(null, "", `#${link}`);
      try {
        await navigator.clipboard.writeText(location.href);
        tell("done", "The link is copied: it carries the whole fabric.");
      } catch {
        tell("done", "The page's address now carries the whole fabric: copy it from above.");
      }
    });

  const copyCamera = (piece: ClothShape, size: readonly [number, number]): Promise<void> =>
    attempt(async () => {
      const orbit = view.current?.orbit ?? null;
      if (orbit === null) return;
      const command = renderCommand({ stem: stemOf(store.state.fabric), scene: store.state.scene, piece, orbit, size });
      try {
        await navigator.clipboard.writeText(command);
        tell("done", "The camera is copied as a command: save the fabric beside the mesh, and run it there.");
      } catch {
        tell("fault", `This page may not write to the clipboard; the command is: ${command}`);
      }
    });

  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => {
      const isText = event.target instanceof HTMLInputElement && event.target.type === "text";
      if (!(event.ctrlKey || event.metaKey) || isText) return;
      const key = event.key.toLowerCase();
      if (key === "z") dispatch({ type: event.shiftKey ? "history/redo" : "history/undo" });
      else if (key === "y") dispatch({ type: "history/redo" });
      else if (key === "s") void save("toml");
      else if (key === "o") choose(ACCEPTED);
      else return;
      event.preventDefault();
    };
    addEventListener("keydown", onKey);
    return () => removeEventListener("keydown", onKey);
  }, []);

  const panels: Readonly<Record<Tab, () => preact.ComponentChildren>> = {
    weave: () => <WeavePanel fabric={state.fabric} gallery={server?.session.gallery ?? []} dispatch={dispatch} onOpen={() => choose(ACCEPTED)} />,
    draft: () => <DraftPanel fabric={state.fabric} dispatch={dispatch} />,
    colour: () => <ColourPanel fabric={state.fabric} dispatch={dispatch} />,
    yarns: () => <YarnsPanel fabric={state.fabric} dispatch={dispatch} isFlat={isFlat} />,
    finish: () => (
      <FinishPanel
        fabric={state.fabric}
        dispatch={dispatch}
        print={print}
        isFlat={isFlat}
        onPrint={(file) => void openPrint(file)}
        onPrintOff={() => setPrint(null)}
      />
    ),
    light: () => <LightPanel scene={state.scene} dispatch={dispatch} isFlat={isFlat} onPicture={() => choose(".hdr,.exr")} />,
  };
  /** Another one for everything that panels and cloth show. */
  const seen = useMemo(() => ({}), [state.fabric, state.scene, state.comparison]);
  return (
    <div
      class="page"
      onDragOver={(event) => {
        event.preventDefault();
        setDropping(true);
      }}
      onDragLeave={(event) => event.relatedTarget === null && setDropping(false)}
      onDrop={(event) => {
        event.preventDefault();
        setDropping(false);
        void open([...(event.dataTransfer?.files ?? [])]);
      }}
    >
      <Guard part="top bar" store={store} health={health} shown={state.fabric}>
        <TopBar state={state} dispatch={dispatch} isFlat={isFlat} onOpen={() => choose(ACCEPTED)} onSave={(format) => void save(format)} onLink={server?.host == null ? () => void copyLink() : null} />
      </Guard>
      <Guard part="cloth" store={store} health={health} shown={seen}>
        <Stage
          tables={tables}
          pictures={server !== null && server.hasPython && server.host === null ? (stage, signal) => server.picture(stage, signal) : null}
          hasPython={server?.hasPython ?? false}
          state={state}
          dispatch={dispatch}
          ownMesh={ownMesh}
          surroundings={surroundings}
          print={print}
          openness={openness}
          answers={answers}
          onMesh={() => choose(".obj,.ply,.glb,.gltf")}
          onCamera={(piece, size) => void copyCamera(piece, size)}
          onView={(made) => {
            view.current = made;
            setFlat(made?.kind === "canvas");
            onView(made);
          }}
        >
          <Notices notices={state.notices} onDismiss={(id) => dispatch({ type: "notice/dismiss", id })} />
        </Stage>
      </Guard>
      <aside class="panel" aria-label="Fabric">
        <Tabs tab={state.tab} onTab={(tab) => dispatch({ type: "tab/show", tab })} />
        <div class="panel-body" role="tabpanel" id="panel" aria-labelledby={`tab-${state.tab}`} tabIndex={-1}>
          <Guard key={state.tab} part={`${TAB_NAMES[state.tab].toLowerCase()} panel`} store={store} health={health} shown={seen}>
            <Edited.Provider value={state.fabric}>{panels[state.tab]()}</Edited.Provider>
          </Guard>
        </div>
      </aside>
      <input
        ref={chooser}
        type="file"
        multiple
        hidden
        aria-label="Files to open"
        data-testid="files"
        onChange={(event) => void open([...(event.currentTarget.files ?? [])])}
      />
      {isExporting && (
        <Guard part="export" store={store} health={health} shown={seen}>
          <ExportDialog fabric={state.fabric} server={server} view={view.current} onClose={() => setExporting(false)} />
        </Guard>
      )}
      {question !== null && <PhotographQuestion picture={question.picture} onAnswer={question.answer} />}
      {photograph !== null && (
        <CaptureDialog
          file={photograph}
          server={server!}
          onFound={(found) => {
            dispatch({ type: "fabric/open", fabric: fabricFromJson(found.fabric) });
            tell("done", `${photograph.name}: ${found.summary}.`, "file");
            for (const warning of warningsOf(found)) tell("warning", warning, "file");
          }}
          onClose={() => setPhotograph(null)}
        />
      )}
      {isDropping && (
        <div class="dropping" aria-hidden="true">
          Drop a draft, an artwork, a fabric or a mesh
        </div>
      )}
    </div>
  );
}

function Tabs({ tab, onTab }: { tab: Tab; onTab: (tab: Tab) => void }) {
  const onKeyDown = (event: KeyboardEvent): void => {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (step === 0) return;
    const next = TABS[(TABS.indexOf(tab) + step + TABS.length) % TABS.length]!;
    onTab(next);
    document.getElementById(`tab-${next}`)?.focus();
  };
  return (
    <div class="tabs" role="tablist" aria-label="What to change" onKeyDown={onKeyDown}>
      {TABS.map((each) => (
        <button
          key={each}
          id={`tab-${each}`}
          type="button"
          role="tab"
          aria-selected={each === tab}
          aria-controls="panel"
          tabIndex={each === tab ? 0 : -1}
          data-testid={`tab-${each}`}
          onClick={() => onTab(each)}
        >
          {TAB_NAMES[each]}
        </button>
      ))}
    </div>
  );
}

/** Starts the page: with the fabric of its address, else the one kept by the browser, else the session's. */
import { loadDraft } from "loomlight-fabric";
import { render } from "preact";

import { Server } from "./api.ts";
import { App } from "./App.tsx";
import { keep, restore } from "./autosave.ts";
import { fabricOfGallery, isEmbedded } from "./embedding.ts";
import { fabricOfLink, linkOf } from "./link.ts";
import { firstState, type Fabric, type State } from "./state/document.ts";
import { fabricFromJson } from "./state/fabric_json.ts";
import { Store } from "./state/store.ts";
import "./style.css";
import { exposeForTests } from "./test_handle.ts";

/** After an edit the fabric is kept once so many milliseconds passed without another. */
const CALM_MS = 400;

async function start(): Promise<void> {
  const { server, problem } = await connect();
  const { state, notice } = await initial(server);
  const store = new Store(state);
  if (problem !== null) store.dispatch({ type: "notice/add", kind: "warning", text: problem });
  if (notice !== null) store.dispatch({ type: "notice/add", kind: "fault", text: notice });
  if (isEmbedded(location.search)) document.body.classList.add("is-embedded");
  else keepChanges(store);
  const handle = exposeForTests(store);
  const root = document.getElementById("app")!;
  root.replaceChildren();
  render(<App store={store} server={server} onView={handle.setView} />, root);
}

async function connect(): Promise<{ server: Server | null; problem: string | null }> {
  try {
    return { server: await Server.connect(), problem: null };
  } catch (error) {
    return { server: null, problem: error instanceof Error ? error.message : String(error) };
  }
}

async function initial(server: Server | null): Promise<{ state: State; notice: string | null }> {
  let notice: string | null = null;
  try {
    const linked = await fabricOfLink(location.hash);
    if (linked !== null) return { state: firstState(linked), notice };
  } catch {
    notice = "The page's address carries a fabric that cannot be read: it may have been cut. Another one is shown.";
  }
  const named = fabricOfGallery(location.search, server?.session ?? null);
  if (named !== null) return { state: firstState(named), notice };
  const given = server === null ? null : fabricFromJson(server.session.fabric);
  const kept = restore();
  const opened = sessionStorage.getItem(OPENED);
  const asked = server === null ? "" : server.session.fabric.name;
  // A fabric that the server was started for comes before the one that was kept from another.
  if (kept !== null && (given === null || opened === asked)) {
    const state = firstState(kept.fabric);
    return { state: { ...state, scene: kept.scene, comparison: { ...state.comparison, before: kept.before } }, notice };
  }
  sessionStorage.setItem(OPENED, asked);
  return { state: firstState(given ?? FALLBACK()), notice };
}

/** Names the session's fabric that this window began with: a reload then goes on with what was kept. */
const OPENED = "loomlight.opened";

function FALLBACK(): Fabric {
  const fields = { weave: "houndstooth 4", ends_per_cm: 11, picks_per_cm: 11, gap: 0.05 };
  return { fields, draft: loadDraft(fields) };
}

function keepChanges(store: Store): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const write = (): void => {
    keep(store.state);
    void linkOf(store.state.fabric).then((link) => history.replaceState(null, "", link === null ? location.pathname : `#${link}`));
  };
  store.subscribe((state, before) => {
    if (state.fabric === before.fabric && state.scene === before.scene && state.comparison === before.comparison) return;
    clearTimeout(timer);
    timer = setTimeout(write, CALM_MS);
  });
  addEventListener("pagehide", () => keep(store.state));
}

void start();

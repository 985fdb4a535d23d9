/** Starts the page, keeps what changes, and holds it up where a part of it fails. */
import { messageOf } from "loomlight-fabric";
import { render } from "preact";

import { Server } from "./api.ts";
import { App } from "./App.tsx";
import { isEmbedded } from "./embedding.ts";
import { Health } from "./health.ts";
import { keep, keepGood } from "./keeping/autosave.ts";
import { survived } from "./keeping/starts.ts";
import { linkOf } from "./link.ts";
import { follow } from "./notebook.ts";
import { asideText, fallenBack, startOf } from "./start.ts";
import { sentence, Store } from "./state/store.ts";
import "./style.css";
import { exposeForTests } from "./test_handle.ts";

/** After an edit the fabric is kept once so many milliseconds passed without another. */
const CALM_MS = 400;
/** A page that has stood so long is one that its document can be shown on. */
const STANDS_MS = 1500;

async function start(): Promise<void> {
  const { server, problem } = await connect();
  const { state, notices, isRestored } = await startOf(server);
  const store = new Store(state);
  if (problem !== null) store.dispatch({ type: "notice/add", kind: "warning", text: problem });
  for (const notice of notices) store.dispatch({ type: "notice/add", ...notice });
  let isStanding = !isRestored;
  const isHosted = server !== null && server.host !== null;
  const isKeeping = !isEmbedded(location.search) && !isHosted;
  const health = new Health((part, error) => {
    const { fabric } = store.state;
    if (isKeeping) keep(store.state);
    if (isStanding || fabric !== state.fabric) return;
    // What was given back fails at once: the last good one takes its place.
    isStanding = true;
    const reason = `the ${part} fails (${sentence(messageOf(error))})`;
    store.replace(fallenBack(store.state, reason, server));
    store.dispatch({ type: "notice/add", kind: "fault", text: asideText(`${reason}.`), offer: "aside" });
  });
  if (isKeeping) keepChanges(store, health);
  else if (isHosted) follow(store, server);
  else document.body.classList.add("is-embedded");
  listenForFaults(store);
  setTimeout(() => {
    isStanding = true;
    if (!isHosted) survived();
    if (isKeeping && health.isWell) keepGood(store.state);
  }, STANDS_MS);
  const handle = exposeForTests(store);
  const root = document.getElementById("app")!;
  root.replaceChildren();
  render(<App store={store} server={server} health={health} onView={handle.setView} />, root);
}

async function connect(): Promise<{ server: Server | null; problem: string | null }> {
  try {
    return { server: await Server.connect(), problem: null };
  } catch (error) {
    return { server: null, problem: messageOf(error) };
  }
}

function keepChanges(store: Store, health: Health): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let isTold = false;
  const write = (): void => {
    const { state } = store;
    if (!keep(state) && !isTold) {
      isTold = true;
      store.dispatch({ type: "notice/add", kind: "warning", text: "The browser has no room to keep this fabric: save it as a file." });
    }
    if (health.isWell) keepGood(state);
    void linkOf(state.fabric).then((link) => {
      // A fabric that has been edited since has an address of its own on the way.
      if (store.state.fabric === state.fabric) history.replaceState(null, "", link === null ? location.pathname : `#${link}`);
    });
  };
  store.subscribe((state, before) => {
    if (state.fabric === before.fabric && state.scene === before.scene && state.comparison === before.comparison) return;
    clearTimeout(timer);
    timer = setTimeout(write, CALM_MS);
  });
  addEventListener("pagehide", () => keep(store.state));
}

/** Faults that no part of the page catches, as those of a click, are told; the page goes on. */
function listenForFaults(store: Store): void {
  const tell = (error: unknown): void => {
    const text = messageOf(error);
    store.dispatch({ type: "notice/add", kind: "fault", text: `Something failed, and your cloth is kept: ${sentence(text)}` });
  };
  // Without an error it is a browser's own remark, as that of a resize that took two frames.
  addEventListener("error", (event) => event.error instanceof Error && tell(event.error));
  addEventListener("unhandledrejection", (event) => tell(event.reason));
}

start().catch((error: unknown) => {
  const text = messageOf(error);
  document.getElementById("app")!.textContent = `The page cannot start: ${sentence(text)} What you made is kept; reload to try again.`;
});

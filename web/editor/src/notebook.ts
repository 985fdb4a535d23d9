/** Keeps the page and a widget of a notebook at one fabric. */
import { messageOf } from "loomlight-fabric";

import type { Server } from "./api.ts";
import type { Fabric } from "./state/document.ts";
import { fabricForServer, fabricFromJson } from "./state/fabric_json.ts";
import type { Store } from "./state/store.ts";

/** An edit is told once so many milliseconds passed without another: a drag is one. */
const CALM_MS = 150;

/** Tells Python of edits, and opens what Python sets, as one step of undo. */
export function follow(store: Store, server: Server): void {
  /** What Python has. */
  let known: Fabric = store.state.fabric;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const refuse = (error: unknown): void =>
    store.dispatch({ type: "notice/add", kind: "fault", text: messageOf(error) });
  const tell = (): void => {
    const { fabric } = store.state;
    if (fabric === known) return;
    known = fabric;
    server.tell(fabricForServer(fabric)).catch(refuse);
  };
  server.host!.onFabric = (json) => {
    clearTimeout(timer);
    try {
      known = fabricFromJson(json);
      store.dispatch({ type: "fabric/open", fabric: known });
      known = store.state.fabric;
    } catch (error) {
      refuse(error);
    }
  };
  store.subscribe((state, before) => {
    if (state.fabric === before.fabric || state.fabric === known) return;
    clearTimeout(timer);
    timer = setTimeout(tell, CALM_MS);
  });
}

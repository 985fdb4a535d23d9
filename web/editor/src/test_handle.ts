/** `window.loomlight`: what tests of the page read. */
import { linkOf } from "./link.ts";
import type { Fabric } from "./state/document.ts";
import { fabricForServer } from "./state/fabric_json.ts";
import type { Store } from "./state/store.ts";
import type { ClothView } from "./view/cloth_view.ts";

interface Handle {
  setView(view: ClothView | null): void;
}

declare global {
  interface Window {
    loomlight?: {
      /** The fabric as the server takes it. */
      fabric(): ReturnType<typeof fabricForServer>;
      /** Whether the address carries the fabric as it is now: it follows an edit after a while. */
      isAddressed(): Promise<boolean>;
      /** sRGB pixels of the cloth, as a plain list. */
      readPixels(): Promise<{ width: number; height: number; data: number[] }>;
      statistics(): Record<string, unknown> | null;
      view(): ClothView | null;
      state(): Store["state"];
    };
  }
}

/** Puts the handle on the window; the view is set once there is one. */
export function exposeForTests(store: Store): Handle {
  let view: ClothView | null = null;
  window.loomlight = {
    fabric: () => fabricForServer(store.state.fabric as Fabric),
    isAddressed: async () => location.hash === `#${await linkOf(store.state.fabric)}`,
    readPixels: async () => {
      if (view === null) throw new Error("no view yet");
      const { width, height, data } = await view.readPixels();
      return { width, height, data: [...data] };
    },
    statistics: () => view?.statistics() ?? null,
    view: () => view,
    state: () => store.state,
  };
  return {
    setView: (made) => {
      view = made;
    },
  };
}

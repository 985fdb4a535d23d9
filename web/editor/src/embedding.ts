/**
 * What surrounds the page: its address asks for `?fabric=denim`, one of the gallery, and for `&embed=1`, the cloth alone;
 * a widget of a notebook shows it in a frame and answers in place of a server.
 */
import type { Session } from "loomlight-fabric";
import type { Fabric } from "./state/document.ts";
import { fabricFromJson } from "./state/fabric_json.ts";

/** The fabric of the gallery that an address names; null where it names none, or one that is not there. */
export function fabricOfGallery(search: string, session: Session | null): Fabric | null {
  const name = new URLSearchParams(search).get("fabric");
  const entry = session?.gallery.find(({ id }) => id === name);
  return entry === undefined ? null : fabricFromJson(entry);
}

/** Whether the page lies in a frame of another page, which shows the cloth alone and keeps nothing. */
export function isEmbedded(search: string): boolean {
  return new URLSearchParams(search).get("embed") === "1";
}

/** A message of the notebook: the answer to a request by its number, or a fabric that was set in Python. */
interface FromHost {
  readonly answer?: number;
  readonly status?: number;
  readonly fabric?: unknown;
  readonly buffer?: ArrayBuffer;
}

/** The notebook that shows the page, whose `viewer/widget.js` carries requests to Python. */
export class FrameHost {
  private readonly port: MessagePort;
  private readonly waiting = new Map<number, (response: Response) => void>();
  private asked = 0;
  /** Is called with the JSON of a fabric that was set in Python. */
  onFabric: (json: unknown) => void = () => undefined;

  private constructor(port: MessagePort) {
    this.port = port;
    port.onmessage = ({ data }: MessageEvent<FromHost>) => {
      if (data.fabric !== undefined) return this.onFabric(data.fabric);
      this.waiting.get(data.answer!)?.(new Response(data.buffer ?? null, { status: data.status ?? 200 }));
      this.waiting.delete(data.answer!);
    };
  }

  /** Says to the page around this one that it is there, and waits for the way to it. */
  static connect(): Promise<FrameHost> {
    return new Promise((resolve) => {
      addEventListener("message", function greet(event) {
        if (event.source !== parent || event.ports.length === 0) return;
        removeEventListener("message", greet);
        resolve(new FrameHost(event.ports[0]!));
      });
      parent.postMessage("loomlight", "*");
    });
  }

  /** Asks Python as a server would be asked. A kernel at work answers when it is free. */
  ask(place: string, body: string | ArrayBuffer): Promise<Response> {
    const buffer = typeof body === "string" ? new TextEncoder().encode(body).buffer : body;
    const ask = ++this.asked;
    return new Promise((resolve) => {
      this.waiting.set(ask, resolve);
      this.port.postMessage({ ask, place, buffer });
    });
  }
}

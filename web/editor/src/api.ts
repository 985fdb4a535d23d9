/**
 * What the page asks of its server: the session, WIF files, materials, tables of models and openness of yarns.
 *
 * `loomlight view` serves `api/session`. A static export names `session.json` instead (the `meta` element
 * `loomlight-session` of the page), and has no Python behind it: `hasPython` is false, and what needs the server
 * says so. A widget's page names `frame`, and asks the notebook around it. Draft JSON is what `src/loomlight/viewer/messages.py` reads and writes.
 */

import type { CaptureJson, CaptureLine, DraftJson, FabricJson, Session } from "loomlight-fabric";
import type { Openness } from "loomlight-web";

import { FrameHost } from "./embedding.ts";

export interface SaveOptions {
  /** Of a baked material. */
  readonly model?: string;
  /** Texels of the longer side of maps. */
  readonly size?: number;
}

/** A request that the server refused, or that did not reach it; the message is one sentence. */
export class ServerError extends Error {
  override name = "ServerError";
}

const GONE = "The server does not answer: start loomlight view again. What you made here is kept.";
const ALONE = "This page has no Python behind it: run loomlight view for that.";

/** The server, or the static folder, that the page came from. */
export class Server {
  readonly session: Session;
  /** The notebook that shows the page; null for a page of its own. */
  readonly host: FrameHost | null;

  private constructor(session: Session, host: FrameHost | null) {
    [this.session, this.host] = [session, host];
  }

  /** Reads the session; the page's address may carry the token of a server that is not on this machine. */
  static async connect(): Promise<Server> {
    const place = document.querySelector<HTMLMetaElement>('meta[name="loomlight-session"]')?.content ?? "api/session";
    if (place === "frame") {
      const host = await FrameHost.connect();
      return new Server((await (await checked(await host.ask("api/session", ""))).json()) as Session, host);
    }
    const response = await reach(place, {});
    return new Server((await response.json()) as Session, null);
  }

  get hasPython(): boolean {
    return this.session.has_python;
  }

  /** The draft in a file that only Python reads (pictures, DTX, WPO, TWA), or in a WIF. */
  async readDraft(file: File): Promise<DraftJson & { warnings: string[] }> {
    if (file.size > this.session.largest_upload) {
      const largest = Math.floor(this.session.largest_upload / 2 ** 20);
      throw new ServerError(`${file.name} is larger than ${largest} MiB; no draft that can be used is.`);
    }
    const response = await this.post(`api/wif?name=${encodeURIComponent(file.name)}`, await file.arrayBuffer());
    return (await response.json()) as DraftJson & { warnings: string[] };
  }

  /** The mesh in a file as Python reads it, cut into pieces where it has no uv; see `serverMeshOf`. */
  async mesh(file: File): Promise<ArrayBuffer> {
    return (await this.post(`api/mesh?name=${encodeURIComponent(file.name)}`, await file.arrayBuffer())).arrayBuffer();
  }

  /** The bytes of a file of a fabric: a baked material of `model`, maps of `size` texels in a zip, or a glTF file. */
  async save(format: "loom" | "zip" | "glb", fabric: FabricJson, options: SaveOptions = {}): Promise<Uint8Array<ArrayBuffer>> {
    const response = await this.post("api/save", JSON.stringify({ format, ...options, ...fabric }));
    return new Uint8Array(await response.arrayBuffer());
  }

  /** Tables that Python bakes, as the bytes of a safetensors file; `model` is "neural" or "clustered". */
  async tables(model: string, fabric: FabricJson): Promise<Uint8Array<ArrayBuffer>> {
    const response = await this.post("api/tables", JSON.stringify({ model, ...fabric }));
    return new Uint8Array(await response.arrayBuffer());
  }

  /** How much of the sky a fabric's yarns see. */
  async openness(fabric: FabricJson): Promise<Openness> {
    const response = await this.post("api/openness", JSON.stringify(fabric));
    return (await response.json()) as Openness;
  }

  /** The picture of a stage by Python, which takes seconds; see `requestOf`. */
  async picture(stage: Uint8Array<ArrayBuffer>, signal: AbortSignal): Promise<Blob> {
    return (await this.post("api/picture", stage, signal)).blob();
  }

  /**
   * The fabric that a photograph of cloth shows, so many millimetres wide; it takes minutes.
   *
   * @param report is told the share that is done.
   */
  async capture(file: File, millimetres: number, light: string, report: (share: number) => void, signal: AbortSignal): Promise<CaptureJson> {
    const asked = new URLSearchParams({ name: file.name, width_mm: String(millimetres), light });
    const response = await this.post(`api/capture?${asked}`, await file.arrayBuffer(), signal);
    for await (const line of linesOf(response.body!)) {
      const { share, found, error } = JSON.parse(line) as CaptureLine;
      if (error != null) throw new ServerError(error);
      if (found != null) return found;
      report(share);
    }
    throw new ServerError(GONE);
  }

  /** Tells the notebook of an edit; does nothing for a page of its own. */
  async tell(fabric: FabricJson): Promise<void> {
    if (this.host !== null) await this.post("api/fabric", JSON.stringify(fabric));
  }

  private async post(place: string, body: string | ArrayBuffer | Uint8Array<ArrayBuffer>, signal?: AbortSignal): Promise<Response> {
    if (!this.hasPython) throw new ServerError(ALONE);
    if (this.host !== null) {
      if (ArrayBuffer.isView(body)) throw new ServerError(ALONE);
      return checked(await this.host.ask(place, body));
    }
    const token = this.session.token;
    return reach(place, { method: "POST", body, signal: signal ?? null, headers: token === null ? {} : { "X-Loomlight-Token": token } });
  }
}

/** Lines of a text, each as it comes. */
async function* linesOf(body: ReadableStream<Uint8Array>): AsyncGenerator<string> {
  const reader = body.pipeThrough(new TextDecoderStream() as TransformStream<Uint8Array, string>).getReader();
  let held = "";
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    const lines = (held + part.value).split("\n");
    held = lines.pop()!;
    yield* lines;
  }
}

async function reach(place: string, request: RequestInit): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(place, request);
  } catch {
    throw new ServerError(GONE);
  }
  return checked(response);
}

async function checked(response: Response): Promise<Response> {
  if (!response.ok) {
    const refusal = (await response.json().catch(() => null)) as { error?: string } | null;
    throw new ServerError(refusal?.error ?? `The server answers ${response.status} ${response.statusText}.`);
  }
  return response;
}

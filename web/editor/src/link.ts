/** The page's address carries the fabric: its JSON, deflated, in base64 for addresses. */
import type { Fabric } from "./state/document.ts";
import { fabricFromJson, fabricText } from "./state/fabric_json.ts";

/** Longer addresses are cut by some programs. */
const MAX = 12_000;
const KEY = "f=";

/** The part of an address after "#" that carries the fabric; null where it would be too long to share. */
export async function linkOf(fabric: Fabric): Promise<string | null> {
  const bytes = await through(new TextEncoder().encode(fabricText(fabric)), new CompressionStream("deflate-raw"));
  const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  const link = KEY + text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return link.length > MAX ? null : link;
}

/**
 * The fabric that the part of an address after "#" carries; null if it carries none.
 *
 * @throws InputError a fabric that cannot be; any other error for a link that was cut.
 */
export async function fabricOfLink(hash: string): Promise<Fabric | null> {
  const json = await jsonOfLink(hash);
  return json === null ? null : fabricFromJson(json);
}

/**
 * The JSON of that fabric, whatever it holds.
 *
 * @throws Error a link that was cut.
 */
export async function jsonOfLink(hash: string): Promise<unknown> {
  const text = hash.replace(/^#/, "");
  if (!text.startsWith(KEY)) return null;
  const binary = atob(text.slice(KEY.length).replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(binary, (unit) => unit.charCodeAt(0));
  const json = new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw")));
  return JSON.parse(json);
}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array> {
  const out = new Blob([bytes]).stream().pipeThrough(stream as ReadableWritablePair<Uint8Array, BufferSource>);
  return new Uint8Array(await new Response(out as ReadableStream<Uint8Array<ArrayBuffer>>).arrayBuffer());
}

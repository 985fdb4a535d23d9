/** Files that are opened, dropped on the page, and saved. */
import {
  draftFromJson,
  draftOfPixels,
  InputError,
  loadDraft,
  looksPhotographed,
  readToml,
  readWif,
  requireInterlacing,
  withoutArtwork,
  writeToml,
  writeWif,
  type Draft,
  type FabricFields,
} from "loomlight-fabric";

import type { Server } from "./api.ts";
import { fabricOfAside } from "./aside_file.ts";
import { draftFile } from "./reducers/draft.ts";
import { isNamed, nameOf, woven, type Fabric } from "./state/document.ts";
import type { Pixels } from "./view/cloth_view.ts";

const PICTURES = /\.(png|jpe?g|gif|bmp|webp)$/i;
/** Drafts of other programs, which Python reads. */
const OTHER_DRAFTS = /\.(dtx|wpo|twa|tiff?)$/i;
/** Larger than any draft that can be used: 64 MiB, as Python reads. */
const MAX = 64 * 2 ** 20;

/** A file that is a mesh. */
export const MESHES = /\.(obj|glb|gltf|ply|usd[acz]?)$/i;
/** What the dialogue offers. */
export const ACCEPTED = ".toml,.json,.wif,.dtx,.wpo,.twa,.png,.obj,.ply,.glb,.usd,.usda,.usdc,.usdz,.hdr,.exr,.ase,.gpl,.csv,.jpg,.jpeg,.webp";

export interface Opened {
  readonly fabric: Fabric;
  readonly warnings: readonly string[];
}

/** Asks whether a picture that looks like a photograph is a drawdown all the same. */
export type Ask = (file: File) => Promise<boolean>;

/** A picture that was not to be read after all. */
export class NoDraft extends Error {}

/**
 * The fabric of files that belong together: a fabric file and its draft, or a draft alone.
 *
 * @throws NoDraft a picture that looks like a photograph, and is one.
 * @throws InputError no such files, or ones that cannot be used; the message names the file.
 */
export async function openFabric(files: readonly File[], server: Server | null, ask: Ask): Promise<Opened> {
  const warnings: string[] = [];
  const warn = (text: string): number => warnings.push(text);
  const aside = files.find((file) => /\.json$/i.test(file.name));
  if (aside !== undefined) return openAside(aside);
  const toml = files.find((file) => /\.toml$/i.test(file.name));
  const draft = files.find((file) => file !== toml);
  for (const file of files)
    if (file.size > MAX)
      throw new InputError(`${file.name} is larger than ${MAX >> 20} MiB; no draft or fabric that can be used is.`);
  if (toml !== undefined) {
    const text = await toml.text();
    const fields = speakingOf(toml.name, () => readToml(text));
    const maps = Object.keys(fields.maps ?? {}).join(", ");
    if (maps !== "") warn(`${toml.name} has maps of ${maps}: the page keeps them, and loomlight render shows them.`);
    if (fields.weave !== undefined) return { fabric: { fields, draft: speakingOf(toml.name, () => loadDraft(fields)) }, warnings };
    if (Object.keys(fields.weaves ?? {}).length > 0)
      throw new InputError(`${toml.name} weaves an artwork, which the page does not read yet: \`loomlight view ${toml.name}\` shows it.`);
    const named = fields.draft ?? fields.image ?? "";
    if (draft === undefined)
      throw new InputError(`${toml.name} needs its draft, ${named}: open both files together.`);
    return { fabric: { fields, draft: await readDraft(draft, server, ask, warn) }, warnings };
  }
  if (draft === undefined) throw new InputError("No file was chosen.");
  const read = await readDraft(draft, server, ask, warn);
  const fields: FabricFields = PICTURES.test(draft.name) ? { image: draft.name } : { draft: draft.name };
  return { fabric: { fields, draft: read }, warnings };
}

/** What of a file of what was set aside can be, and in a sentence what cannot. */
async function openAside(file: File): Promise<Opened> {
  try {
    const { fabric, faults } = await fabricOfAside(await file.text());
    return { fabric, warnings: faults.length === 0 ? [] : [`${file.name} was opened without what cannot be: ${faults.join(" ")}`] };
  } catch (error) {
    if (!(error instanceof Error)) throw error;
    throw new InputError(`${file.name}: ${error.message}`);
  }
}

async function readDraft(file: File, server: Server | null, ask: Ask, warn: (text: string) => void): Promise<Draft> {
  const draft = await draftOfFile(file, server, ask, warn);
  return speakingOf(file.name, () => {
    requireInterlacing(draft);
    return draft;
  });
}

async function draftOfFile(file: File, server: Server | null, ask: Ask, warn: (text: string) => void): Promise<Draft> {
  if (/\.wif$/i.test(file.name)) return readWif(new Uint8Array(await file.arrayBuffer()), file.name, warn);
  if (PICTURES.test(file.name)) return draftOfPicture(file, ask);
  if (OTHER_DRAFTS.test(file.name)) {
    if (server === null || !server.hasPython)
      throw new InputError(`${file.name} is read by \`loomlight view\`, which this page runs without: export it as .wif.`);
    const { warnings, ...json } = await server.readDraft(file);
    warnings.forEach(warn);
    return draftFromJson(json);
  }
  throw new InputError(`${file.name} is neither a fabric (.toml) nor a draft (.wif or a picture of a drawdown).`);
}

async function draftOfPicture(file: File, ask: Ask): Promise<Draft> {
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(file);
  } catch {
    throw new InputError(`${file.name} is no picture that this browser reads.`);
  }
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext("2d")!;
  context.drawImage(bitmap, 0, 0);
  const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  if (looksPhotographed(data) && !(await ask(file))) throw new NoDraft();
  return draftOfPixels(data, bitmap.width, bitmap.height, file.name);
}

function speakingOf<T>(file: string, read: () => T): T {
  try {
    return read();
  } catch (error) {
    if (error instanceof InputError && !error.message.includes(file)) throw new InputError(`${file}: ${error.message}`);
    throw error;
  }
}

/** File names without what file systems dislike. */
export function stemOf(fabric: Fabric): string {
  return draftFile(nameOf(fabric)).replace(/\.wif$/, "");
}

/** The fabric file, and beside it the draft where no weave's name stands for it. */
export function fabricFiles(fabric: Fabric): { name: string; content: string }[] {
  const stem = stemOf(fabric);
  if (isNamed(fabric)) return [{ name: `${stem}.toml`, content: writeToml(fabric.fields) }];
  const fields = withoutArtwork(fabric.fields, fabric.draft);
  return [
    { name: `${stem}.toml`, content: writeToml({ ...fields, draft: `${stem}.wif` }) },
    { name: `${stem}.wif`, content: writeWif(fabric.draft) },
  ];
}

/** The draft with the colours of every thread, as a weaving information file. */
export function wifFile(fabric: Fabric): { name: string; content: string } {
  return { name: `${stemOf(fabric)}.wif`, content: writeWif({ ...woven(fabric), name: nameOf(fabric) }) };
}

/** Pixels as a .png, their opacity included. */
export async function pngOf({ width, height, data }: Pixels): Promise<Blob> {
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext("2d")!.putImageData(new ImageData(data, width, height), 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

/** Hands a file to the browser's downloads. */
export function download(name: string, content: BlobPart, type = "text/plain"): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

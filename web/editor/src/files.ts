/** Files that are opened, dropped on the page, and saved. */
import {
  artworkOfPixels,
  colourCount,
  DRAFT_FILE,
  draftFromJson,
  draftOfPixels,
  firstWeaves,
  inMainColours,
  InputError,
  loadDraft,
  looksPhotographed,
  makeDraft,
  MAX_COLOURS,
  pixelsOfArtwork,
  readToml,
  readWif,
  requireInterlacing,
  requireSize,
  weaveArtwork,
  weaveLists,
  withoutArtwork,
  writeToml,
  writeWif,
  type Draft,
  type FabricFields,
  type Structure,
} from "loomlight-fabric";

import type { Server } from "./api.ts";
import { fabricOfAside } from "./aside_file.ts";
import { draftFile } from "./reducers/draft.ts";
import { hasWeaves, isArtwork, isNamed, nameOf, woven, type Fabric, type WovenOfArtwork } from "./state/document.ts";
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

/**
 * What a picture is whose colours do not tell: a design whose colours are weaves, one of so many main colours, a drawdown,
 * or none to be woven.
 */
export type Meaning = "artwork" | "drawdown" | "nothing" | { readonly mainColours: number };

/** A picture of which one has to ask, as it has more colours than a drawing. */
export interface Unclear {
  readonly file: File;
  readonly colours: number;
  readonly pixels: Pixels;
}

/** Asks what a picture is. */
export type Ask = (picture: Unclear) => Promise<Meaning>;

/** A picture that was not to be read after all. */
export class NoDraft extends Error {}

/**
 * The fabric of files that belong together: a fabric file and its draft or artwork, or one of these alone.
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
    if (hasWeaves(fields)) return { fabric: await openArtwork(toml, fields, files, server, warn), warnings };
    const named = fields.draft ?? fields.image ?? "";
    if (draft === undefined)
      throw new InputError(`${toml.name} needs its draft, ${named}: open both files together.`);
    return { fabric: { fields, draft: await readDraft(draft, server, warn) }, warnings };
  }
  if (draft === undefined) throw new InputError("No file was chosen.");
  if (PICTURES.test(draft.name)) return { fabric: await openPicture(draft, ask), warnings };
  return { fabric: { fields: { draft: draft.name }, draft: await readDraft(draft, server, warn) }, warnings };
}

/** The fabric of a fabric file whose artwork, and drafts' files among its weaves, are opened with it. */
async function openArtwork(toml: File, fields: FabricFields, files: readonly File[], server: Server | null, warn: (text: string) => void): Promise<Fabric> {
  const image = fields.image ?? "";
  const named = (path: string): File | undefined => files.find((file) => file.name === path.replace(/^.*[/\\]/, ""));
  const names = [...new Set([...weaveLists(fields.weaves ?? {}).values()].flat())].filter((name) => DRAFT_FILE.test(name));
  // A picture that was renamed is the one that is no weave.
  const picture = named(image) ?? files.find((file) => PICTURES.test(file.name) && !names.some((name) => named(name) === file));
  if (picture === undefined) throw new InputError(`${toml.name} needs its artwork, ${image}: open both files together.`);
  const drafts: Record<string, Structure> = {};
  for (const name of names) {
    const file = named(name);
    if (file === undefined) throw new InputError(`${toml.name} needs the draft ${name}, one of its weaves: open it together with the others.`);
    const { ends, picks, drawdown } = await readDraft(file, server, warn);
    drafts[name] = { ends, picks, drawdown };
  }
  const { data, width, height } = await pixelsOf(picture);
  return speakingOf(toml.name, () => {
    const artwork = { ...artworkOfPixels(data, width, height, picture.name, fields), drafts };
    const { draft, cut } = weaveArtwork(artwork, fields, picture.name);
    if (cut !== null) warn(cut);
    return { fields: { ...fields, image: picture.name }, draft, artwork };
  });
}

/**
 * The fabric of a picture: of two colours a drawdown, of more an artwork, if there are not so many that one has to ask.
 *
 * A drawdown keeps its picture, so that it can be read as artwork after all.
 */
async function openPicture(file: File, ask: Ask): Promise<Fabric> {
  const pixels = await pixelsOf(file);
  const { data, width, height } = pixels;
  const colours = colourCount(data);
  const meaning = looksPhotographed(data) ? await ask({ file, colours, pixels }) : colours > 2 ? "artwork" : "drawdown";
  if (meaning === "nothing") throw new NoDraft();
  if (typeof meaning === "object") return artworkOf(inMainColours(data, width, height, meaning.mainColours), width, height, file.name);
  if (meaning === "artwork") return artworkOf(data, width, height, file.name);
  const draft = draftOfPixels(data, width, height, file.name);
  requireWoven(draft, file.name);
  const artwork = colours <= MAX_COLOURS ? artworkOfPixels(data, width, height, file.name) : null;
  return { fields: { image: file.name }, draft, ...(artwork === null ? {} : { artwork }) };
}

/** The fabric of a picture each of whose colours is a weave. */
function artworkOf(data: Uint8ClampedArray, width: number, height: number, image: string): Fabric {
  const artwork = artworkOfPixels(data, width, height, image);
  const fields: FabricFields = { image, weaves: firstWeaves(artwork) };
  return { fields, draft: weaveArtwork(artwork, fields, image).draft, artwork };
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

async function readDraft(file: File, server: Server | null, warn: (text: string) => void): Promise<Draft> {
  const draft = await draftOfFile(file, server, warn);
  requireWoven(draft, file.name);
  return draft;
}

function requireWoven(draft: Draft, file: string): void {
  speakingOf(file, () => requireInterlacing(draft));
}

async function draftOfFile(file: File, server: Server | null, warn: (text: string) => void): Promise<Draft> {
  if (/\.wif$/i.test(file.name)) return readWif(new Uint8Array(await file.arrayBuffer()), file.name, warn);
  if (PICTURES.test(file.name)) {
    const { data, width, height } = await pixelsOf(file);
    return draftOfPixels(data, width, height, file.name);
  }
  if (OTHER_DRAFTS.test(file.name)) {
    if (server === null || !server.hasPython)
      throw new InputError(`${file.name} is read by \`loomlight view\`, which this page runs without: export it as .wif.`);
    const { warnings, ...json } = await server.readDraft(file);
    warnings.forEach(warn);
    return draftFromJson(json);
  }
  throw new InputError(`${file.name} is neither a fabric (.toml) nor a draft (.wif or a picture of a drawdown).`);
}

/** The pixels of a picture, as its file has them. */
async function pixelsOf(file: File): Promise<Pixels> {
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(file, { colorSpaceConversion: "none" });
  } catch {
    throw new InputError(`${file.name} is no picture that this browser reads.`);
  }
  const { width, height } = bitmap;
  try {
    requireSize(width, height, file.name);
    const context = new OffscreenCanvas(width, height).getContext("2d")!;
    context.drawImage(bitmap, 0, 0);
    return { width, height, data: context.getImageData(0, 0, width, height).data };
  } catch (error) {
    if (error instanceof InputError) throw error;
    throw new InputError(`${file.name} has ${width} x ${height} pixels, more than this browser reads.`);
  } finally {
    bitmap.close();
  }
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

/** A file to be saved; of a picture its pixels. */
export interface SavedFile {
  readonly name: string;
  readonly content: string | Pixels;
}

/** The fabric file, and beside it the draft where no weave's name stands for it, or the artwork. */
export function fabricFiles(fabric: Fabric): SavedFile[] {
  const stem = stemOf(fabric);
  if (isArtwork(fabric)) return artworkFiles(fabric, stem);
  if (isNamed(fabric)) return [{ name: `${stem}.toml`, content: writeToml(fabric.fields) }];
  const fields = withoutArtwork(fabric.fields, fabric.draft);
  return [
    { name: `${stem}.toml`, content: writeToml({ ...fields, draft: `${stem}.wif` }) },
    { name: `${stem}.wif`, content: writeWif(fabric.draft) },
  ];
}

/** The fabric file of an artwork, the artwork, and drafts whose names are no weaves. */
function artworkFiles({ fields, artwork }: WovenOfArtwork, stem: string): SavedFile[] {
  const taken = new Set<string>();
  const renamed = new Map<string, string>();
  for (const name of Object.keys(artwork.drafts)) {
    const base = name.replace(/^.*[/\\]/, "").replace(/\.[^.]*$/, "");
    let free = `${base}.wif`;
    for (let number = 2; taken.has(free); number++) free = `${base}-${number}.wif`;
    taken.add(free);
    renamed.set(name, free);
  }
  const called = (weave: string): string => renamed.get(weave) ?? weave;
  const weaves = Object.entries(fields.weaves ?? {}).map(([colour, given]) => [colour, typeof given === "string" ? called(given) : given.map(called)]);
  const toml = writeToml({ ...fields, image: `${stem}.png`, weaves: Object.fromEntries(weaves) });
  const { ends: width, rows: height } = artwork;
  return [
    { name: `${stem}.toml`, content: toml },
    { name: `${stem}.png`, content: { width, height, data: pixelsOfArtwork(artwork) } },
    ...[...renamed].map(([name, file]) => ({ name: file, content: writeWif(makeDraft(artwork.drafts[name]!, { name: file.replace(/\.wif$/, "") })) })),
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

/** Hands the fabric file, and what lies beside it, to the browser's downloads. */
export async function saveFabric(fabric: Fabric): Promise<void> {
  for (const { name, content } of fabricFiles(fabric)) {
    if (typeof content === "string") download(name, content, "application/toml");
    else download(name, await pngOf(content), "image/png");
  }
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

/**
 * Renders the scenes of a JSON file with the built module and writes their pictures, for a test that compares them with
 * the Python package's. Run by Deno, whose WebGPU needs no browser:
 *
 *     deno run -A --unstable-webgpu render_report.ts MODULE QUESTIONS FOLDER
 */
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import process from "node:process";
import { pathToFileURL } from "node:url";

import type { Camera, ClothRenderer, Environment, FrameReport, Ground, Light, Mesh, ModelName, Openness, Statistics } from "../src/index.ts";

/** What is set anew before a picture; what is missing stays as it was. */
interface Step {
  readonly pieces?: readonly {
    readonly mesh: Mesh;
    readonly fabric: string;
    readonly uvSizeMm: [number, number];
    readonly openness: Openness | null;
  }[];
  /** The text of a fabric file for the first piece, as an edit. */
  readonly fabric?: string;
  /** Of that fabric. */
  readonly openness?: Openness | null;
  readonly model?: readonly [ModelName, samples: number];
  /** A model whose tables Python packed, and the file of them in the folder. */
  readonly tables?: readonly [ModelName, file: string];
  readonly lights?: readonly Light[];
  readonly environment?: Environment | null;
  readonly environmentSamples?: number;
  readonly turn?: number;
  readonly exposure?: number;
  readonly ground?: Ground | null;
  readonly camera?: Camera;
  readonly passes?: number;
}

interface Scene {
  readonly size: [number, number];
  /** A picture each, files `SCENE.STEP.linear` and `SCENE.STEP.srgb`. */
  readonly steps: readonly Step[];
}

interface Report {
  readonly adapter: string;
  readonly isSoftware: boolean;
  /** Of each step of each scene, since the step before. */
  readonly statistics: Statistics[][];
  readonly areas: { readonly resting: FrameReport[]; readonly bakes: number };
  readonly pace: { readonly moving: FrameReport[]; readonly resting: FrameReport[] };
  readonly loss: { readonly sentence: string; readonly framesWhileLost: FrameReport[] };
  /** What WebGPU complained of outside of any promise. */
  readonly complaints: string[];
}

const [module, questions, folder] = process.argv.slice(2) as [string, string, string];
const web = (await import(pathToFileURL(module).href)) as typeof import("../src/index.ts");
const devices: GPUDevice[] = [];
const complaints: string[] = [];

/** Keeps each device that the module asks for, so that it can be lost. */
function watchDevices(): void {
  const request = GPUAdapter.prototype.requestDevice;
  GPUAdapter.prototype.requestDevice = async function (descriptor) {
    const device = await request.call(this, descriptor);
    device.addEventListener("uncapturederror", (event) => complaints.push((event as GPUUncapturedErrorEvent).error.message));
    devices.push(device);
    return device;
  };
}

async function take(renderer: ClothRenderer, step: Step): Promise<void> {
  if (step.model) renderer.setModel(step.model[0], { samples: step.model[1] });
  if (step.pieces)
    renderer.setPieces(
      step.pieces.map(({ mesh, fabric, uvSizeMm, openness }) => ({ mesh, uvSizeMm, openness, ...web.fabricOf(fabric) })),
    );
  if (step.fabric !== undefined) {
    const { fields, draft } = web.fabricOf(step.fabric);
    renderer.setFabric(0, fields, draft, step.openness);
  }
  if (step.tables) renderer.setTables(step.tables[0], readFileSync(join(folder, step.tables[1])));
  if (step.lights) renderer.setLights(step.lights);
  if (step.environment !== undefined) {
    const samples = step.environmentSamples;
    renderer.setEnvironment(step.environment, samples === undefined ? {} : { samples });
  }
  if (step.turn !== undefined) renderer.turnEnvironment(step.turn);
  if (step.exposure !== undefined) renderer.setExposure(step.exposure);
  if (step.ground !== undefined) renderer.setGround(step.ground);
  if (step.camera) renderer.setCamera(step.camera);
  await renderer.render(step.passes ?? 1);
}

async function store(renderer: ClothRenderer, name: string): Promise<void> {
  const [{ data }, linear] = [await renderer.readPixels(), await renderer.readLinear()];
  writeFileSync(join(folder, `${name}.srgb`), data);
  writeFileSync(join(folder, `${name}.linear`), new Uint8Array(linear.data.buffer));
}

function difference(after: Statistics, before: Statistics): Statistics {
  const counts = ["bakeKernels", "bakes", "openings", "writes", "writtenBytes", "passes"] as const;
  return { ...after, ...Object.fromEntries(counts.map((name) => [name, after[name] - before[name]])) };
}

/** Frames as a page asks for them, until `isEnough` or so many were made. */
async function frames(renderer: ClothRenderer, most: number, isEnough: (frame: FrameReport) => boolean, before?: () => void) {
  const reports: FrameReport[] = [];
  while (reports.length < most && !(reports.length > 0 && isEnough(reports.at(-1)!))) {
    before?.();
    reports.push(renderer.frame());
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  return reports;
}

/** A renderer that may take no time at all while the camera moves, and any time at rest. */
async function pace(shareWith: ClothRenderer, { size, steps }: Scene): Promise<Report["pace"]> {
  const renderer = await web.ClothRenderer.create({ size, shareWith, budget: { moving: 0, submission: Infinity, resting: Infinity } });
  await take(renderer, steps[0]!);
  renderer.setModel(steps[0]!.model![0], { samples: steps[0]!.model![1], passes: 2 });
  const { origin, target } = steps[0]!.camera!;
  let moves = 0;
  const move = (): void => renderer.setCamera({ origin: [origin[0] + 1e-5 * moves++, origin[1], origin[2]], target });
  const moving = await frames(renderer, 8, () => false, move);
  const resting = await frames(renderer, 200, ({ isComplete }) => isComplete);
  await store(renderer, "rest");
  renderer.destroy();
  return { moving, resting };
}

/** A picture that is made of areas at rest, by a renderer that finds its tables kept and bakes none. */
async function areas(shareWith: ClothRenderer, { size, steps }: Scene): Promise<Report["areas"]> {
  const kept = new Map<string, Uint32Array<ArrayBuffer>>();
  let tell = (): void => undefined;
  const told = new Promise<void>((resolve) => (tell = resolve));
  const tables = {
    get: async (key: string) => kept.get(key) ?? null,
    put: (key: string, words: Uint32Array<ArrayBuffer>) => {
      kept.set(key, words);
      tell();
    },
  };
  const first = await web.ClothRenderer.create({ size, shareWith, budget: null, tables });
  await take(first, steps[0]!);
  await told;
  first.setEnvironment(null);
  await first.render(1);
  await store(first, "whole");
  first.destroy();
  const renderer = await web.ClothRenderer.create({ size, shareWith, budget: { moving: 0, submission: 0, resting: 0 }, tables });
  const { passes: _, ...step } = steps[0]!;
  await take(renderer, { ...step, environment: null });
  renderer.setModel(step.model![0], { samples: step.model![1], passes: 7 });
  const resting = await frames(renderer, 2000, ({ isComplete }) => isComplete);
  await store(renderer, "areas");
  const { bakes } = renderer.statistics;
  renderer.destroy();
  return { resting, bakes };
}

/** Loses the device, as a driver does that begins anew, and goes on. */
async function loss(renderer: ClothRenderer): Promise<Report["loss"]> {
  const { lost } = renderer;
  devices[0]!.destroy();
  const sentence = await lost;
  const framesWhileLost = await frames(renderer, 3, () => false);
  await renderer.rebuild();
  await renderer.render(1);
  await store(renderer, "rebuilt");
  return { sentence, framesWhileLost };
}

watchDevices();
const scenes = JSON.parse(readFileSync(questions, "utf8")) as Scene[];
const first = await web.ClothRenderer.create({ size: scenes[0]!.size, budget: null });
const statistics: Statistics[][] = [];
for (const [number, scene] of scenes.entries()) {
  const renderer = number === 0 ? first : await web.ClothRenderer.create({ size: scene.size, budget: null, shareWith: first });
  statistics.push([]);
  for (const [index, step] of scene.steps.entries()) {
    const before = renderer.statistics;
    await take(renderer, step);
    await store(renderer, `${number}.${index}`);
    statistics[number]!.push(difference(renderer.statistics, before));
  }
}
const report: Report = {
  adapter: first.adapter.name,
  isSoftware: first.adapter.isSoftware,
  statistics,
  pace: await pace(first, scenes[0]!),
  areas: await areas(first, scenes[0]!),
  loss: await loss(first),
  complaints,
};
writeFileSync(join(folder, "report.json"), JSON.stringify(report));
process.exit(0);

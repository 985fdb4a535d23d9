/** Fabrics as shaders read them: one record a fabric, and 32-bit words of all tables; see `realtime/words.py`. */
import {
  CELL_MAX_LEVELS,
  FIBRES_ACROSS,
  LIFT,
  NO_OPENNESS,
  ALBEDO_MIN_BOX,
  MIN_OPEN_SHARE,
  SQUARE_SCALE,
} from "../generated.ts";
import { RecordArray, WordTable, type Values } from "../records.ts";
import { ALBEDO_NUMBERS, type FamilyAppearance } from "./albedos.ts";
import { JOINT_WORDS, packOpenness } from "./between_yarns.ts";
import type { BakePlan } from "./bake_plan.ts";
import { detailNumbers, isDetailed } from "./detail.ts";
import { colourTables, type ColourTables } from "./footprint_albedos.ts";
import { geometryOf, heightBounds, type Geometry } from "./geometry.ts";
import { coverOfThreads, depthPerGain, irregularTable, type IrregularTable } from "./irregularity.ts";
import { halfWidth, hasIrregularYarns, sizeOf, type ClothLayout, type FamilyLayout, type Look } from "./look.ts";
import { meanLayerShares } from "./openness.ts";
import { pairwiseSum } from "./sums.ts";
import { areAlike, finestOf, type FamilyTables } from "./threads.ts";

/** Fabrics as buffers. */
export interface Packed {
  readonly fabrics: RecordArray;
  /** Of the warp and the weft of each. */
  readonly families: RecordArray;
  readonly words: Uint32Array<ArrayBuffer>;
}

/** What one fabric is packed from; `plan` is of its tables of `lobes`, which kernels will write. */
export interface Ingredients {
  readonly look: Look;
  readonly geometry: Geometry;
  readonly colours: readonly [ColourTables, ColourTables];
  readonly uvSizeMm: readonly [number, number];
  readonly plan: BakePlan | null;
}

/** Geometry and colours of a look; those of the fabric before are kept where they are the same. */
export function prepare(
  look: Look,
  uvSizeMm: readonly [number, number],
  plan: BakePlan | null,
  before: Ingredients | null = null,
): Ingredients {
  const isSame = before !== null && sameThreads(before.look.layout, look.layout);
  const geometry = isSame ? before.geometry : geometryOf(look.layout);
  const isColoured =
    isSame &&
    sameNumbers(before.look.appearance.warp.albedos, look.appearance.warp.albedos) &&
    sameNumbers(before.look.appearance.weft.albedos, look.appearance.weft.albedos);
  const colours = isColoured ? before.colours : coloursOf(look, geometry);
  return { look, geometry, colours, uvSizeMm, plan };
}

/** Records of fabrics and the words of their tables. */
export function packFabrics(fabrics: readonly Ingredients[]): Packed {
  const table = new WordTable();
  const records = new RecordArray("Fabric", fabrics.length);
  const families = new RecordArray("Family", 2 * fabrics.length);
  fabrics.forEach((fabric, number) => {
    records.set(number, { warp: 2 * number, weft: 2 * number + 1 });
    records.set(number, { uv_width: fabric.uvSizeMm[0], uv_height: fabric.uvSizeMm[1] });
    packFabric(records, families, number, table, fabric);
    if (fabric.plan !== null) records.set(number, lobesValues(table, fabric.plan, fabric.look), "lobes.");
  });
  return { fabrics: records, families, words: table.words() };
}

/** Whether two layouts differ in nothing that tables are made of. */
export function sameLayout(one: ClothLayout, other: ClothLayout): boolean {
  return (
    sameThreads(one, other) &&
    (["warp", "weft"] as const).every(
      (family) => one[family].twist === other[family].twist && one[family].heightScale === other[family].heightScale,
    )
  );
}

function sameThreads(one: ClothLayout, other: ClothLayout): boolean {
  const alike = (a: FamilyLayout, b: FamilyLayout): boolean =>
    a.inclination === b.inclination &&
    sameNumbers(a.spacing, b.spacing) &&
    sameNumbers(a.width, b.width);
  return (
    one.ends === other.ends &&
    one.picks === other.picks &&
    sameNumbers(one.warpOnTop, other.warpOnTop) &&
    alike(one.warp, other.warp) &&
    alike(one.weft, other.weft)
  );
}

function sameNumbers(one: ArrayLike<number>, other: ArrayLike<number>): boolean {
  if (one.length !== other.length) return false;
  for (let i = 0; i < one.length; i++) if (one[i] !== other[i]) return false;
  return true;
}

function coloursOf(look: Look, geometry: Geometry): [ColourTables, ColourTables] {
  const { ends, picks, warpOnTop } = look.layout;
  const weftOnTop = new Uint8Array(ends * picks);
  for (let pick = 0; pick < picks; pick++)
    for (let end = 0; end < ends; end++) weftOnTop[end * picks + pick] = 1 - warpOnTop[pick * ends + end]!;
  return [
    colourTables(look.appearance.warp.albedos, geometry.warp, geometry.weft, warpOnTop),
    colourTables(look.appearance.weft.albedos, geometry.weft, geometry.warp, weftOnTop),
  ];
}

function packFabric(
  records: RecordArray,
  families: RecordArray,
  number: number,
  table: WordTable,
  { look, geometry, colours }: Ingredients,
): void {
  const { layout, appearance } = look;
  const { warp, weft } = geometry;
  families.set(2 * number, familyValues(table, warp, layout.warp, appearance.warp, appearance.opticalDepth));
  families.set(2 * number + 1, familyValues(table, weft, layout.weft, appearance.weft, appearance.opticalDepth));
  families.set(2 * number, colourValues(table, warp, colours[0]));
  families.set(2 * number + 1, colourValues(table, weft, colours[1]));
  const areIrregular = hasIrregularYarns(appearance);
  const [fineX, fineY] = geometry.finest;
  const [low, high] = heightBounds(geometry, layout);
  const meanHole = openShare(warp) * openShare(weft);
  records.set(number, {
    run_words: table.addWords(geometry.words),
    ends: layout.ends,
    max_heights: table.addWords(geometry.maxHeights),
    max_height_columns: Math.ceil(layout.ends / 2),
    height_low: low,
    height_high: high,
    lift: LIFT * Math.min(fineX, fineY),
    threads_per_x: 1 / fineX,
    threads_per_y: 1 / fineY,
    per_relief: 1 / Math.max(high - low, 1e-6),
    diffuse_blend: appearance.diffuseBlend,
    optical_depth: appearance.opticalDepth,
    grazing_gain: appearance.grazingGain,
    grazing_loss: appearance.grazingLoss,
    sheen_strength: appearance.sheenStrength,
    sheen_roughness: appearance.sheenRoughness,
    fibre_noise: appearance.fibreNoise,
    // Irregular yarns vary from thread to thread by their own process.
    colour_noise: areIrregular ? 0 : appearance.colourNoise,
    seed: appearance.seed,
    layer_bound: Math.max(appearance.warp.layerBound, appearance.weft.layerBound),
    fibre_size: Math.min(fineX, fineY) / FIBRES_ACROSS,
    has_yarns: 1,
    has_detail: isDetailed(appearance.warp.detail) || isDetailed(appearance.weft.detail) ? 1 : 0,
    openness: appearance.openness === null ? NO_OPENNESS : packOpenness(table, appearance.openness),
    mean_hole: meanHole,
    is_open: meanHole > MIN_OPEN_SHARE ? 1 : 0,
    is_irregular: areIrregular ? 1 : 0,
    warp_on_top: pairwiseSum(layout.warpOnTop) / layout.warpOnTop.length,
    is_coloured: colours.some(({ quantities }) => quantities > 1) ? 1 : 0,
  });
  if (areIrregular)
    irregularValues(table, [warp, weft], appearance).forEach((values, family) => families.set(2 * number + family, values));
}

/** How the yarns of both families vary; families that vary alike share a table. */
function irregularValues(table: WordTable, threads: readonly FamilyTables[], appearance: Look["appearance"]): Values[] {
  const first = new Map<IrregularTable, number>();
  return [appearance.warp, appearance.weft].map(({ irregularity, albedos, nepAlbedo }, family) => {
    const cover = coverOfThreads(threads[family]!);
    const own = irregularTable(irregularity, cover, depthPerGain(albedos), appearance.colourNoise);
    const place = first.get(own) ?? table.addWords(own.integrals);
    first.set(own, place);
    const [thickness, ofCover, tone, nep] = own.units;
    const [red, green, blue] = nepAlbedo;
    return {
      irregular_table: place,
      irregular_thickness: thickness,
      irregular_cover: ofCover,
      irregular_tone: tone,
      irregular_nep: nep,
      cover,
      nep_red: red,
      nep_green: green,
      nep_blue: blue,
    };
  });
}

/** Share of the repeat that no thread of a family covers, seen along the normal. */
function openShare(threads: FamilyTables): number {
  const sizes = threads.upper.map((upper, thread) => upper - threads.lower[thread]!);
  const covered = threads.halfWidth.map((half, thread) => Math.min(2 * half, sizes[thread]!));
  return 1 - pairwiseSum(covered) / pairwiseSum(sizes);
}

function familyValues(
  table: WordTable,
  threads: FamilyTables,
  layout: FamilyLayout,
  appearance: FamilyAppearance,
  opticalDepth: number,
): Values {
  const [turned, through] = meanLayerShares(appearance.roughness, opticalDepth);
  const count = threads.lower.length;
  const size = threads.upper[0]! - threads.lower[0]!;
  const bins = Math.ceil(threads.period / finestOf(threads)) + 1;
  const isAlike = areAlike(threads);
  const rows: number[] = [];
  for (let thread = 0; thread < (isAlike ? 1 : count); thread++) {
    const tilt = threads.inclination[thread]!;
    rows.push(Math.sin(tilt), Math.tan(tilt / 2), threads.arc[thread]!, threads.edgeDrop[thread]!);
  }
  const values: Record<string, number> = {
    is_alike: isAlike ? 1 : 0,
    count,
    inverse_count: 1 / count,
    half_inverse_count: 0.5 / count,
    size,
    inverse_size: 1 / size,
    half_width: threads.halfWidth[0]!,
    start: threads.lower[0]!,
    period: threads.period,
    inverse_period: 1 / threads.period,
    bins,
    height_scale: layout.heightScale,
    twist_sine: Math.sin(layout.twist),
    twist_cosine: Math.cos(layout.twist),
    level: threads.highest / CELL_MAX_LEVELS,
    roughness: appearance.roughness,
    layer_turned: turned,
    layer_through: through,
    bend_table: table.addNumbers(rows),
    ...detailNumbers(appearance.detail, meanWidth(layout), layout.twist),
  };
  if (!isAlike) {
    const first = threads.lower[0]!;
    values["first_thread_table"] = table.addWords(firstThreads(threads, bins));
    const places: number[] = [];
    for (let thread = 0; thread < count; thread++)
      places.push(
        threads.lower[thread]! - first,
        threads.upper[thread]! - first,
        threads.centre[thread]! - first,
        threads.halfWidth[thread]!,
      );
    values["place_table"] = table.addNumbers(places);
  }
  const { albedos } = appearance;
  const areOneColour = albedos.every((value, i) => Math.abs(value - albedos[i % ALBEDO_NUMBERS]!) <= 1e-12);
  values["albedo_table"] = table.addNumbers(areOneColour ? albedos.subarray(0, ALBEDO_NUMBERS) : albedos);
  values["albedo_stride"] = areOneColour ? 0 : ALBEDO_NUMBERS;
  return values;
}

/** Mean visible width of the threads, millimetres. */
function meanWidth(layout: FamilyLayout): number {
  const widths = layout.spacing.map((_, thread) => 2 * halfWidth(layout, thread));
  return pairwiseSum(widths) / widths.length;
}

/** The last thread whose cell begins at or before each bin's edge. */
function firstThreads(threads: FamilyTables, bins: number): Uint32Array {
  const found = new Uint32Array(bins);
  const first = threads.lower[0]!;
  let thread = 0;
  for (let bin = 0; bin < bins; bin++) {
    const edge = bin * (threads.period / bins);
    while (thread + 1 < threads.lower.length && threads.lower[thread + 1]! - first <= edge) thread++;
    found[bin] = thread;
  }
  return found;
}

function colourValues(table: WordTable, threads: FamilyTables, colours: ColourTables): Values {
  const count = threads.lower.length;
  const before = new Float64Array(2 * (count + 1));
  for (let thread = 0; thread < count; thread++) {
    before[2 * thread + 2] = before[2 * thread]! + 2 * threads.halfWidth[thread]!;
    before[2 * thread + 3] = before[2 * thread + 1]! + (threads.upper[thread]! - threads.lower[thread]!);
  }
  const values: Record<string, number> = {
    before: table.addNumbers(before),
    visible_total: before[2 * count]!,
    smallest_box: (ALBEDO_MIN_BOX * threads.period) / count,
    quantities: colours.quantities,
    colour_mean: table.addNumbers(colours.mean),
    colour_axes: table.addNumbers(colours.axes),
    area_unit: colours.unit,
    crossing_area: colours.crossing,
  };
  values["cloth_mean"] = values["colour_mean"]!;
  if (colours.quantities > 1) {
    values["colour_threads"] = table.addNumbers(colours.threads);
    values["colour_areas"] = table.addWords(colours.areas);
  }
  return values;
}

/** Fields of `Lobes` that follow from the draft and the number of groups; kernels find out the others. */
function lobesValues(table: WordTable, plan: BakePlan, { layout, joint }: Look): Values {
  const [width, height] = sizeOf(layout);
  const thread = Math.sqrt(((width / layout.ends) * height) / layout.picks);
  const values: Record<string, number> = {
    is_baked: 1,
    inverse_base_size: 1 / plan.baseSize,
    last_level: plan.levels.length - 1,
    levels: table.addNumbers(plan.levels.flatMap((level) => [...level, 0])),
    face_nodes: plan.levels.at(-1)![0] + 1,
    packs: plan.sizes["packs"]!,
    threads_per_mm: 1 / thread,
    unit_level: Math.log2(Math.max(thread, SQUARE_SCALE * plan.baseSize)),
  };
  for (const [name, size] of Object.entries(plan.tableWords)) values[name] = table.reserve(size);
  values["joint"] = joint === null ? table.reserve(JOINT_WORDS) : table.addWords(Uint32Array.from(joint));
  return values;
}

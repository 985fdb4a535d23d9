/** The generated shaders that the page runs, from the folder of the Python package. */
import addBackground from "@shaders/wgsl/add_background.wgsl?raw";
import bakeCoverage from "@shaders/wgsl/bake_coverage.wgsl?raw";
import bakeGroups from "@shaders/wgsl/bake_groups.wgsl?raw";
import bakeOpenness from "@shaders/wgsl/bake_openness.wgsl?raw";
import bakePoints from "@shaders/wgsl/bake_points.wgsl?raw";
import bakeRays from "@shaders/wgsl/bake_rays.wgsl?raw";
import bakeTables from "@shaders/wgsl/bake_tables.wgsl?raw";
import castShadows from "@shaders/wgsl/cast_shadows.wgsl?raw";
import firstLayer from "@shaders/wgsl/first_layer.wgsl?raw";
import nextLayer from "@shaders/wgsl/next_layer.wgsl?raw";
import rasterFragment from "@shaders/wgsl/raster_fragment.wgsl?raw";
import rasterVertex from "@shaders/wgsl/raster_vertex.wgsl?raw";
import shadeClustered from "@shaders/wgsl/shade_clustered.wgsl?raw";
import shadeLobes from "@shaders/wgsl/shade_lobes.wgsl?raw";
import shadePoints from "@shaders/wgsl/shade_points.wgsl?raw";
import shadeNeural from "@shaders/wgsl/shade_neural.wgsl?raw";
import toneMap from "@shaders/wgsl/tone_map.wgsl?raw";

const TEXTS = {
  add_background: addBackground,
  bake_coverage: bakeCoverage,
  bake_groups: bakeGroups,
  bake_openness: bakeOpenness,
  bake_points: bakePoints,
  bake_rays: bakeRays,
  bake_tables: bakeTables,
  cast_shadows: castShadows,
  first_layer: firstLayer,
  next_layer: nextLayer,
  raster_fragment: rasterFragment,
  raster_vertex: rasterVertex,
  shade_clustered: shadeClustered,
  shade_lobes: shadeLobes,
  shade_points: shadePoints,
  shade_neural: shadeNeural,
  tone_map: toneMap,
} as const;

export type ShaderName = keyof typeof TEXTS;

/** The text of a shader. */
export function shaderText(name: ShaderName): string {
  return TEXTS[name];
}

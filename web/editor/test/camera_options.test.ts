/** The camera as a command. */
import { orbitBetween, turned } from "loomlight-web";
import { describe, expect, it } from "vitest";

import { FIRST_SCENE, type Scene } from "../src/state/document.ts";
import { cameraOptions, renderCommand } from "../src/view/camera_options.ts";
import { ownShape } from "../src/view/meshes.ts";

const ORBIT = orbitBetween([0.25, 0.5, 1], [0.25, 0.5, 0]);
const MESH = ownShape({ positions: [0, 0, 0, 1, 0, 0, 0, 1, 0], normals: [0, 0, 1, 0, 0, 1, 0, 0, 1], uv: [0, 0, 1, 0, 0, 1], triangles: [0, 1, 2] }, [1000, 1000]);
const command = (scene: Partial<Scene>, file?: { name: string; metresPerUnit: number }, stem = "denim"): string =>
  renderCommand({ stem, scene: { ...FIRST_SCENE, ...scene }, piece: file === undefined ? MESH : { ...MESH, file }, orbit: ORBIT, size: [640, 480] });

describe("a camera as options", () => {
  it("has angles within half a turn, and lengths to a ten-thousandth of the distance", () => {
    expect(cameraOptions(ORBIT)).toBe("--view 0,0 --target 0.25,0.5,0 --distance 1 --focal-length 51.978");
    expect(cameraOptions(turned(ORBIT, 0.5, 0))).toMatch(/^--view -90,0 /);
    expect(cameraOptions({ ...ORBIT, target: [0.123456789, -0.00000001, 0], distance: 0.0123456789 })).toContain("--target 0.123457,0,0 --distance 0.012346 ");
  });
});

describe("the command of a view", () => {
  it("names fabric, shape, size and the studio's light", () => {
    expect(command({})).toBe(`loomlight render denim.toml -o denim.png --scene drape --size 640x480 ${cameraOptions(ORBIT)} --light-from -56,33`);
    expect(command({ surroundings: "sky", exposure: 0.5, whiteBalance: 4000, shape: "flat" })).toMatch(/--scene flat .*978 --exposure 0.5 --white-balance 4000$/);
    expect(command({ lampElevation: -5 })).not.toContain("--light-from");
  });

  it("names the user's mesh, and its unit where that is no metre", () => {
    expect(command({ shape: "mesh" }, { name: "coat.glb", metresPerUnit: 1 })).toContain("--mesh coat.glb --size");
    expect(command({ shape: "mesh" }, { name: "my $coat's.obj", metresPerUnit: 0.01 / 3 })).toContain("--mesh 'my $coat'\\''s.obj' --metres-per-unit 0.00333333 --size");
    expect(command({}, undefined, "a b")).toMatch(/^loomlight render 'a b.toml' -o 'a b.png'/);
  });

  it("is refused for the curtain, which is the page's own", () => expect(() => command({ shape: "curtain" })).toThrow(/none: copy the camera of another shape/));
});

import { BoxGeometry, BufferGeometry, HemisphereLight, Mesh, OrthographicCamera, PerspectiveCamera, PlaneGeometry, PointLight, DirectionalLight, Scene } from "three";
import { expect, test } from "vitest";

import { cameraOf } from "../src/three/camera.ts";
import { lightsOf } from "../src/three/lights.ts";
import { joinMeshes, rectangle } from "../src/scene/mesh.ts";
import { casterOf, castersOf, meshOf } from "../src/three/mesh.ts";

test("a mesh is given where it stands in the world, metres", () => {
  const parent = new Scene();
  const mesh = new Mesh(new PlaneGeometry(2, 2));
  mesh.position.set(10, 0, 0);
  mesh.rotation.y = Math.PI / 2;
  parent.add(mesh);
  const { positions, normals, uv, triangles } = meshOf(mesh, 0.01);
  const xs = Array.from(positions).filter((_, i) => i % 3 === 0);
  xs.forEach((x) => expect(x).toBeCloseTo(0.1, 12));
  expect(Array.from(normals).slice(0, 3).map((value) => Math.round(value * 1e9) / 1e9 + 0)).toEqual([1, 0, 0]);
  expect([uv.length, triangles.length]).toEqual([8, 6]);
});

test("a mesh without uv, or without normals, is refused by its name", () => {
  const mesh = new Mesh(new BoxGeometry());
  mesh.name = "shirt";
  mesh.geometry.deleteAttribute("uv");
  expect(() => meshOf(mesh, 1)).toThrow('The mesh "shirt" has no uv');
  const bare = new Mesh(new BoxGeometry());
  bare.geometry.deleteAttribute("normal");
  expect(() => meshOf(bare, 1)).toThrow("computeVertexNormals");
  expect(() => meshOf(new Mesh(new BufferGeometry()), 1)).toThrow("has no positions");
});

test("a camera keeps its field of view along the shorter side", () => {
  const camera = new PerspectiveCamera(40, 2, 0.1, 10);
  camera.position.set(0, 1, 5);
  camera.lookAt(0, 1, 0);
  camera.updateMatrixWorld();
  const { fieldOfView, origin, target, near } = cameraOf(camera, 200, 100, 0.1);
  expect(fieldOfView).toBeCloseTo(40, 9);
  expect(origin).toEqual([0, 0.1, 0.5]);
  expect(target[2]).toBeCloseTo(-0.5, 9);
  expect(near).toBeCloseTo(0.01, 12);
  const tall = new PerspectiveCamera(40, 0.5);
  const across = (2 * Math.atan(Math.tan((20 * Math.PI) / 180) * 0.5) * 180) / Math.PI;
  expect(cameraOf(tall, 100, 200, 1).fieldOfView).toBeCloseTo(across, 9);
  expect(() => cameraOf(new OrthographicCamera(), 100, 100, 1)).toThrow("PerspectiveCamera");
});

test("lights are what three's own materials would be lit by", () => {
  const scene = new Scene();
  const sun = new DirectionalLight(0xffffff, 2);
  sun.position.set(0, 3, 0);
  const lamp = new PointLight(0xff0000, 8);
  lamp.position.set(1, 0, 0);
  const hidden = new DirectionalLight();
  hidden.visible = false;
  scene.add(sun, lamp, hidden, new HemisphereLight(0xffffff, 0x000000, Math.PI));
  scene.updateMatrixWorld();
  const { lights, environment } = lightsOf(scene, 0.5);
  expect(lights).toEqual([
    { kind: "directional", towards: [0, 3, 0], irradiance: [2, 2, 2] },
    { kind: "point", position: [0.5, 0, 0], intensity: [2, 0, 0] },
  ]);
  const { pixels, width, height } = environment!.picture;
  expect(pixels.length).toBe(3 * width * height);
  expect([pixels[0], pixels[pixels.length - 1]]).toEqual([1, 0]);
  expect(lightsOf(new Scene(), 1)).toEqual({ lights: [], environment: null });
});

test("what casts shadows is what three draws and lets cast them, where it stands", () => {
  const scene = new Scene();
  const cloth = new Mesh(new PlaneGeometry());
  const box = new Mesh(new BoxGeometry());
  const bare = new Mesh(new BoxGeometry());
  const hidden = new Mesh(new BoxGeometry());
  for (const mesh of [cloth, box, hidden]) mesh.castShadow = true;
  hidden.visible = false;
  box.position.set(4, 0, 0);
  scene.add(cloth, box, bare, hidden);
  scene.updateMatrixWorld();
  expect(castersOf(scene, new Set([cloth]))).toEqual([box]);
  const { positions, triangles } = casterOf(box, 0.5);
  expect([Math.min(...Array.from(positions).filter((_, i) => i % 3 === 0)), triangles.length]).toEqual([1.75, 36]);
});

test("what casts shadows comes behind the cloth and is of no piece", () => {
  const piece = rectangle(1, 1);
  const caster = { positions: [0, 0, 1, 1, 0, 1, 0, 1, 1], triangles: [0, 1, 2] };
  const { corners, faces, shown, positions } = joinMeshes([piece, piece], [caster, caster]);
  expect([faces, shown.faces, shown.vertices, positions.length]).toEqual([6, 4, 8, 42]);
  expect(Array.from(corners.subarray(18))).toEqual([0, 0, 1, 1, 2, 2]);
  expect(Array.from(corners.subarray(12, 18))).toEqual([8, 9, 10, 11, 12, 13]);
});

/** Four fabrics among three's own objects, in one light, each in the shadow of the others: drag to turn, scroll to come closer. */
import { clothe, fabricOf } from "loomlight-web/three";
import {
  BoxGeometry,
  Color,
  CylinderGeometry,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  TorusKnotGeometry,
  WebGLRenderer,
  type BufferGeometry,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const canvas = document.querySelector("canvas")!;
const status = document.querySelector("p")!;
const three = new WebGLRenderer({ canvas, antialias: true });
three.shadowMap.enabled = true;
three.shadowMap.type = PCFShadowMap;
const scene = new Scene();
scene.background = new Color(0xefe9dc);
const camera = new PerspectiveCamera(30, 1, 0.005, 10);
camera.position.set(0.3, 0.35, 0.95);
const controls = new OrbitControls(camera, canvas);

const sun = new DirectionalLight(0xfff2e0, 3);
sun.position.set(0.5, 1, 0.7);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
sun.shadow.normalBias = 0.002;
Object.assign(sun.shadow.camera, { left: -0.6, right: 0.6, top: 0.6, bottom: -0.6, near: 0.1, far: 3 });
scene.add(sun, new HemisphereLight(0xdde8ff, 0x8a6f50, 1));

/** A mesh in the scene, metres, that casts shadows on three's objects and on cloth. */
function place(geometry: BufferGeometry, position: readonly [number, number, number], material = new MeshStandardMaterial()): Mesh {
  const mesh = new Mesh(geometry, material);
  mesh.position.set(...position);
  mesh.castShadow = mesh.receiveShadow = true;
  scene.add(mesh);
  return mesh;
}

// Drawn by three.
const table = place(new PlaneGeometry(1.4, 1), [0, -0.13, 0], new MeshStandardMaterial({ color: 0xb59a78 }));
table.rotation.x = -Math.PI / 2;
place(new SphereGeometry(0.035, 48, 24), [0.13, -0.095, 0.17], new MeshStandardMaterial({ color: 0xc8b273, metalness: 0.4, roughness: 0.35 }));
place(new BoxGeometry(0.02, 0.3, 0.02), [-0.08, 0.02, 0.2], new MeshStandardMaterial({ color: 0x4d5a52 }));

// Drawn as cloth; yarns have their true size by `uvSizeMm`, the millimetres that the unit of u and of v are.
const knot = place(new TorusKnotGeometry(0.08, 0.03, 200, 32), [0, 0, 0]);
const cushion = place(new SphereGeometry(0.1, 64, 32), [0.3, -0.07, 0]);
cushion.scale.y = 0.6;
const bolt = place(new CylinderGeometry(0.045, 0.045, 0.32, 64, 1), [-0.28, -0.085, 0.08]);
bolt.rotation.set(0, 0.5, Math.PI / 2);
const screen = place(new PlaneGeometry(0.5, 0.34), [0.06, 0.04, -0.22]);

const fabrics = [
  [knot, 'weave = "houndstooth"\nyarn = "wool"\nends_per_cm = 12\n', [900, 190]],
  [cushion, 'weave = "satin 5/2"\nends_per_cm = 60\npicks_per_cm = 40\nyarn = "silk"\nwarp.color = "#7d2b33"\nweft.color = "#7d2b33"\n', [628, 230]],
  [bolt, 'weave = "twill 3/1"\nends_per_cm = 26\npicks_per_cm = 18\nwarp.color = "#20305c"\nweft.color = "#d8d2c4"\n', [283, 320]],
  // Light passes through its holes onto cloth; onto the table three lets none through.
  [screen, 'weave = "plain"\nends_per_cm = 14\npicks_per_cm = 14\ngap = 0.45\nwarp.color = "#e6dfce"\nweft.color = "#e6dfce"\n', [500, 340]],
] as const;

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  three.setPixelRatio(Math.min(devicePixelRatio, 2));
  three.setSize(innerWidth, innerHeight, false);
}

addEventListener("resize", resize);
resize();
three.setAnimationLoop(() => {
  controls.update();
  three.render(scene, camera);
});

Promise.all(fabrics.map(([mesh, text, uvSizeMm]) => clothe(mesh, fabricOf(text), { uvSizeMm }))).then(
  ([first]) => {
    status.textContent = "Drag to turn, scroll to come closer.";
    // For the console, and for tests.
    Object.assign(window, { example: { scene, sun, layer: first!.layer } });
  },
  (error: Error) => (status.textContent = error.message),
);

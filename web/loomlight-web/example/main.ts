/** A knot of three.js in houndstooth, on a table that three draws: drag to turn it, scroll to come closer. */
import { clothe, fabricOf } from "loomlight-web/three";
import {
  Color,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  TorusKnotGeometry,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const canvas = document.querySelector("canvas")!;
const status = document.querySelector("p")!;
const three = new WebGLRenderer({ canvas, antialias: true });
const scene = new Scene();
scene.background = new Color(0xefe9dc);
const camera = new PerspectiveCamera(30, 1, 0.005, 10);
camera.position.set(0.3, 0.25, 0.6);
const controls = new OrbitControls(camera, canvas);
const sun = new DirectionalLight(0xfff2e0, 3);
sun.position.set(0.5, 1, 0.7);
const table = new Mesh(new PlaneGeometry(1, 1), new MeshStandardMaterial({ color: 0xb59a78 }));
table.rotation.x = -Math.PI / 2;
table.position.y = -0.13;
// Metres; the cloth's yarns have their true size.
const knot = new Mesh(new TorusKnotGeometry(0.08, 0.03, 200, 32), new MeshStandardMaterial());
scene.add(sun, new HemisphereLight(0xdde8ff, 0x8a6f50, 1), table, knot);

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

const fabric = fabricOf('weave = "houndstooth"\nyarn = "wool"\nends_per_cm = 12\n');
clothe(knot, fabric, { uvSizeMm: [900, 190] }).then(
  () => (status.textContent = "Drag to turn, scroll to come closer."),
  (error: Error) => (status.textContent = error.message),
);

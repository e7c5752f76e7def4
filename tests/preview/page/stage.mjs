// What the page's modules stand on in a browser: three.js, a viewer, a few elements. Imported before them.
import { createRequire } from "node:module";

const require = createRequire(new URL("../../../web/package.json", import.meta.url));
export const THREE = require("three");

globalThis.MeshCat = { THREE, Viewer: undefined };

const ELEMENTS = new Map();

/** An element that remembers its listeners; the same for the same selector. */
export function element(selector) {
  if (!ELEMENTS.has(selector)) ELEMENTS.set(selector, Object.assign(new EventTarget(), { disabled: false, hidden: false }));
  return ELEMENTS.get(selector);
}

globalThis.document = { querySelector: element, createElement: () => ({}) };

/** A viewer whose camera hangs as meshcat's does: below a node that is turned. */
export function makeViewer(width = 800, height = 600) {
  const scene = new THREE.Scene(), holder = new THREE.Group(), camera = new THREE.PerspectiveCamera(28, width / height);
  scene.rotation.x = -Math.PI / 2;
  scene.updateMatrixWorld(true);
  holder.rotation.x = 0.3;
  holder.add(camera);
  const controls = Object.assign(new THREE.EventDispatcher(), {
    target: new THREE.Vector3(), enabled: true, minDistance: 0, maxDistance: Infinity,
    update() {
      holder.updateMatrixWorld(true);
      camera.lookAt(this.target);
      camera.updateMatrixWorld(true);
    },
  });
  const box = { left: 0, top: 0, width, height };
  const renderer = { domElement: Object.assign(new EventTarget(), { getBoundingClientRect: () => box }) };
  return { scene, camera, controls, renderer, scene_tree: {}, set_dirty() {} };
}

/** The same numbers each time, from 0 to 1. */
export function makeRandom(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** How a point of three.js' world is seen, -1 to 1 in both directions. */
export function seenAt(viewer, point) {
  viewer.camera.updateMatrixWorld(true);
  return point.clone().project(viewer.camera);
}

// Bodies as triangles: they have the inertia that they stand for, their corners face outwards, rays and eyes meet them.
import assert from "node:assert/strict";
import test from "node:test";
import { makeRandom } from "./stage.mjs";
const { capsuleMesh, coreMesh, drumMesh, blockMesh, gyration, hitOf, icosphere, silhouette } =
  await import("../../../server/kindsl/frontends/preview/page/picture/shapes.js");

const AXES = [0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1];
const CORES = [[1, 1, 1, 1, 1], [0.2, 0.2, 1, 0.12, 1], [1, 0.9, 0.05, 0.9, 0.12], [1, 0.6, 0.3, 0.3, 0.4]].map(([a, b, c, e1, e2]) => ({
  center: [0.1, -0.2, 0.3], axes: AXES, semi_axes: [a, b, c], gyration: [a / 2, b / 2, c / 2.1], exponents: [e1, e2], density: 1,
}));

const points = ({ positions }) => Array.from({ length: positions.length / 3 }, (_, i) => [...positions.slice(3 * i, 3 * i + 3)]);
const faces = (mesh) => Array.from({ length: mesh.faces.length / 3 }, (_, i) => [...mesh.faces.slice(3 * i, 3 * i + 3)]);
const local = (p, { center, axes }) => [0, 1, 2].map((i) => [0, 1, 2].reduce((sum, k) => sum + (p[k] - center[k]) * axes[3 * i + k], 0));

test("a drawn body has the radii of gyration of its link, however few its triangles", () => {
  for (const core of CORES) {
    for (const cuts of [1, 2, 3]) {
      const mesh = coreMesh(core, icosphere(cuts)), drawn = gyration(points(mesh).map((p) => local(p, core)), faces(mesh));
      drawn.forEach((value, i) => assert.ok(Math.abs(value / core.gyration[i] - 1) < 1e-5, `${value} ${core.gyration[i]}`));
    }
  }
});

test("all faces are seen from outside, and close", () => {
  const sphere = icosphere(2);
  const meshes = [...CORES.map((core) => coreMesh(core, sphere)), capsuleMesh([0, 0, 0], [1, 2, 3], 0.1, sphere)];
  for (const mesh of meshes) {
    const at = points(mesh), edges = new Set();
    for (const [a, b, c] of faces(mesh)) for (const [from, to] of [[a, b], [b, c], [c, a]]) edges.add(`${from} ${to}`);
    for (const edge of edges) assert.ok(edges.has(edge.split(" ").reverse().join(" ")));
    assert.ok(gyration(at, faces(mesh)).every(Number.isFinite));
  }
  for (const mesh of [drumMesh(0.5, -1, 1, 12), blockMesh(0.5, 0, 1)]) {
    const at = points(mesh);
    for (const [a, b, c] of faces(mesh)) {
      const [u, v] = [b, c].map((i) => at[i].map((value, k) => value - at[a][k]));
      const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      const own = [...mesh.normals.slice(3 * a, 3 * a + 3)];
      assert.ok(normal[0] * own[0] + normal[1] * own[1] + normal[2] * own[2] > 0);
    }
  }
});

test("a drum is a cylinder and a block a cuboid of the size asked for", () => {
  const drum = points(drumMesh(0.5, -1, 2, 28)), block = points(blockMesh(0.3, -1, 2));
  assert.ok(drum.every(([x, y, z]) => Math.hypot(x, y) < 0.5 + 1e-6 && z >= -1 && z <= 2));
  for (const [x, y] of block) assert.ok([0, 0.3].some((value) => Math.abs(Math.abs(x) - value) < 1e-6) && Math.abs(y) < 0.3 + 1e-6);
});

test("a ray meets what it points at from outside, nothing beside it", () => {
  const ball = capsuleMesh([0, 0, 0], [0, 0, 0], 1, icosphere(3)), random = makeRandom(4);
  for (let i = 0; i < 50; i++) {
    const way = [random() - 0.5, random() - 0.5, random() - 0.5], length = Math.hypot(...way), d = way.map((value) => value / length);
    const distance = hitOf(ball, d.map((value) => -3 * value), d);
    assert.ok(distance !== null && Math.abs(distance - 2) < 0.01);
    assert.equal(hitOf(ball, d.map((value) => 3 * value), d), null);
  }
  assert.equal(hitOf(ball, [2, 0, 5], [0, 0, -1]), null);
});

test("the silhouette of a ball is a circle about the eye's line of sight", () => {
  const ball = capsuleMesh([0, 0, 0], [0, 0, 0], 1, icosphere(3)), edges = silhouette(ball, [0, 0, 4]);
  assert.ok(edges.length > 20);
  for (const [from, to] of edges) for (const [, , z] of [from, to]) assert.ok(Math.abs(z - 0.25) < 0.2);
  const ends = edges.flat().map((p) => p.map((value) => value.toFixed(5)).join());
  for (const end of new Set(ends)) assert.equal(ends.filter((other) => other === end).length, 2);
});

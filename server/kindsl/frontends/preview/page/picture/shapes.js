// Shapes of bodies as triangles, in the coordinates of the link or joint that carries them: plain numbers, no three.js.

/** @import { Core } from "../messages.js" */
/** @import { Vector } from "../base/types.js" */
/** @typedef {{ readonly corners: readonly Vector[], readonly faces: readonly (readonly number[])[] }} Sphere unit vectors, triangles seen from outside */
/** @typedef {{ readonly positions: Float32Array, readonly normals: Float32Array, readonly faces: Uint32Array }} Mesh three numbers a corner, three corners a face */

/** @param {readonly number[]} a @param {readonly number[]} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @type {(v: readonly number[]) => Vector} */
const unit = ([x, y, z]) => {
  const length = Math.hypot(x, y, z) || 1;
  return [x / length, y / length, z / length];
};
/** @param {number} x @param {number} exponent */
const power = (x, exponent) => Math.sign(x) * Math.abs(x) ** exponent;

/**
 * Directions spread over a sphere: an icosahedron whose faces are cut into four so many times.
 * @param {number} cuts
 * @returns {Sphere}
 */
export function icosphere(cuts) {
  const t = (1 + Math.sqrt(5)) / 2;
  /** @type {Vector[]} */
  const corners = [
    [-1, t, 0], [1, t, 0], [-1, -t, 0], [1, -t, 0], [0, -1, t], [0, 1, t], [0, -1, -t], [0, 1, -t], [t, 0, -1], [t, 0, 1],
    [-t, 0, -1], [-t, 0, 1],
  ].map(unit);
  let faces = [
    [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
    [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1],
  ];
  for (let cut = 0; cut < cuts; cut++) {
    /** @type {Map<number, number>} */
    const known = new Map();
    const half = (/** @type {number} */ a, /** @type {number} */ b) => {
      const key = Math.min(a, b) * 1e6 + Math.max(a, b), found = known.get(key);
      if (found !== undefined) return found;
      corners.push(unit([0, 1, 2].map((i) => corners[a][i] + corners[b][i])));
      known.set(key, corners.length - 1);
      return corners.length - 1;
    };
    faces = faces.flatMap(([a, b, c]) => {
      const x = half(a, b), y = half(b, c), z = half(c, a);
      return [[a, x, z], [b, y, x], [c, z, y], [x, y, z]];
    });
  }
  return { corners, faces };
}

/**
 * The farthest point of a superquadric in a direction, both along its own axes.
 * @param {Pick<Core, "semi_axes" | "exponents">} core
 * @param {Vector} direction
 * @returns {Vector}
 */
export function support({ semi_axes: [a, b, c], exponents: [e1, e2] }, [n, m, k]) {
  const x = n * a, y = m * b, z = k * c, across = 2 - e2;
  const turn = Math.atan2(power(y, 1 / across), power(x, 1 / across)), co = Math.cos(turn), si = Math.sin(turn);
  const reach = Math.abs(co) > Math.abs(si) ? Math.abs(x) / Math.abs(co) ** across : Math.abs(y) / Math.abs(si) ** across;
  const rise = Math.atan2(power(z, 1 / (2 - e1)), reach ** (1 / (2 - e1))), ring = Math.cos(rise) ** e1;
  return [a * ring * power(co, e2), b * ring * power(si, e2), c * power(Math.sin(rise), e1)];
}

/**
 * How far a superquadric reaches from its middle along a direction, a unit vector in the link's axes.
 * @param {Core} core
 * @param {Vector} direction
 */
export function halfWidth(core, direction) {
  const { axes } = core, [x, y, z] = [0, 3, 6].map((axis) => dot(direction, axes.slice(axis, axis + 3)));
  return dot([x, y, z], support(core, [x, y, z]));
}

/**
 * A superquadric, stretched so that these few triangles have its radii of gyration exactly.
 * @param {Core} core
 * @param {Sphere} sphere
 * @returns {Mesh}
 */
export function coreMesh(core, { corners, faces }) {
  const points = corners.map((direction) => support(core, direction)), drawn = gyration(points, faces);
  const stretch = core.gyration.map((wanted, i) => wanted / drawn[i]), { axes, center } = core;
  /** @type {(v: readonly number[], start: Vector) => Vector} */
  const turned = ([x, y, z], start) => {
    const along = (/** @type {number} */ i) => start[i] + x * axes[i] + y * axes[3 + i] + z * axes[6 + i];
    return [along(0), along(1), along(2)];
  };
  return meshOf(
    points.map((point) => turned(point.map((value, i) => value * stretch[i]), center)),
    corners.map((direction) => turned(direction, [0, 0, 0])), faces);
}

/**
 * The radii of gyration of a uniform polyhedron around the origin, along x, y and z.
 * @param {readonly Vector[]} points
 * @param {readonly (readonly number[])[]} faces
 */
export function gyration(points, faces) {
  let volume = 0;
  const squares = [0, 0, 0];
  for (const [i, j, k] of faces) {
    const a = points[i], b = points[j], c = points[k], six = dot(a, cross(b, c));
    volume += six / 6;
    for (const x of [0, 1, 2]) {
      squares[x] += (six / 60) * (a[x] ** 2 + b[x] ** 2 + c[x] ** 2 + a[x] * b[x] + a[x] * c[x] + b[x] * c[x]);
    }
  }
  return squares.map((square) => Math.sqrt(square / volume));
}

/** @type {(a: Vector, b: Vector) => Vector} */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/**
 * A rod with round ends.
 * @param {Vector} from
 * @param {Vector} to
 * @param {number} radius
 * @param {Sphere} sphere
 * @returns {Mesh}
 */
export function capsuleMesh(from, to, radius, { corners, faces }) {
  const way = [0, 1, 2].map((i) => to[i] - from[i]);
  /** @type {Vector[]} */
  const points = corners.map((n) => {
    const [x, y, z] = dot(n, way) > 0 ? to : from;
    return [x + radius * n[0], y + radius * n[1], z + radius * n[2]];
  });
  return meshOf(points, corners, faces);
}

/**
 * A cylinder about z.
 * @param {number} radius
 * @param {number} low
 * @param {number} high
 * @param {number} sides
 */
export const drumMesh = (radius, low, high, sides) => prism(radius, low, high, sides, false);
/**
 * A cuboid along z whose sides are so far from it.
 * @param {number} half
 * @param {number} low
 * @param {number} high
 */
export const blockMesh = (half, low, high) => prism(half * Math.SQRT2, low, high, 4, true);

/**
 * @param {number} radius
 * @param {number} low
 * @param {number} high
 * @param {number} sides
 * @param {boolean} isEdged Whether its sides are flat rather than round.
 * @returns {Mesh}
 */
function prism(radius, low, high, sides, isEdged) {
  /** @type {Vector[]} */
  const points = [];
  /** @type {Vector[]} */
  const normals = [];
  /** @type {number[][]} */
  const faces = [];
  const at = (/** @type {number} */ side) => (2 * Math.PI * (side + 0.5)) / sides;
  /** @type {(side: number, r: number, z: number, normal: Vector) => void} */
  const put = (side, r, z, normal) => {
    points.push([r * Math.cos(at(side)), r * Math.sin(at(side)), z]);
    normals.push(normal);
  };
  /** @type {(angle: number) => Vector} */
  const outwards = (angle) => [Math.cos(angle), Math.sin(angle), 0];
  for (let side = 0; side < sides; side++) {
    const first = points.length, middle = at(side + 0.5);
    for (const [corner, z] of [[side, low], [side + 1, low], [side + 1, high], [side, high]]) {
      put(corner, radius, z, outwards(isEdged ? middle : at(corner)));
    }
    faces.push([first, first + 1, first + 2], [first, first + 2, first + 3]);
    for (const [z, up] of [[low, -1], [high, 1]]) {
      const end = points.length;
      put(side, 0, z, [0, 0, up]);
      put(side, radius, z, [0, 0, up]);
      put(side + 1, radius, z, [0, 0, up]);
      faces.push(up > 0 ? [end, end + 1, end + 2] : [end, end + 2, end + 1]);
    }
  }
  return meshOf(points, normals, faces);
}

/** @type {(points: readonly Vector[], normals: readonly Vector[], faces: readonly (readonly number[])[]) => Mesh} */
const meshOf = (points, normals, faces) => ({
  positions: Float32Array.from(points.flat()), normals: Float32Array.from(normals.flat()), faces: Uint32Array.from(faces.flat()),
});

/**
 * How far along a ray a mesh is hit from outside; null where it is not.
 * @param {Mesh} mesh
 * @param {Vector} origin
 * @param {Vector} direction A unit vector.
 */
export function hitOf({ positions, faces }, origin, direction) {
  let nearest = Infinity;
  /** @type {(index: number) => Vector} */
  const at = (index) => [positions[3 * index] - origin[0], positions[3 * index + 1] - origin[1], positions[3 * index + 2] - origin[2]];
  for (let f = 0; f < faces.length; f += 3) {
    const a = at(faces[f]), b = at(faces[f + 1]), c = at(faces[f + 2]);
    const [u, v, w] = [dot(direction, cross(c, b)), dot(direction, cross(a, c)), dot(direction, cross(b, a))];
    if (u < 0 || v < 0 || w < 0 || u + v + w === 0) continue;
    const distance = (u * dot(a, direction) + v * dot(b, direction) + w * dot(c, direction)) / (u + v + w);
    if (distance > 0 && distance < nearest) nearest = distance;
  }
  return nearest === Infinity ? null : nearest;
}

/**
 * The edges of a convex mesh between what faces a point and what faces away from it, as pairs of corners.
 * @param {Mesh} mesh
 * @param {Vector} eye
 */
export function silhouette({ positions, faces }, eye) {
  /** @type {Map<number, readonly [number, number]>} */
  const edges = new Map(), count = positions.length / 3;
  /** @type {(index: number) => Vector} */
  const at = (index) => [positions[3 * index], positions[3 * index + 1], positions[3 * index + 2]];
  for (let f = 0; f < faces.length; f += 3) {
    const corners = [faces[f], faces[f + 1], faces[f + 2]], [a, b, c] = corners.map(at);
    if (dot(cross(minus(b, a), minus(c, a)), minus(eye, a)) <= 0) continue;
    for (const i of [0, 1, 2]) {
      const from = corners[i], to = corners[(i + 1) % 3], twin = to * count + from;
      if (!edges.delete(twin)) edges.set(from * count + to, [from, to]);
    }
  }
  return [...edges.values()].map(([from, to]) => /** @type {const} */ ([at(from), at(to)]));
}

/** @type {(a: Vector, b: Vector) => Vector} */
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

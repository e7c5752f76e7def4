// All marks of one shape and kind as one InstancedMesh: a draw call for each kind, not for each mark.

const {
  BufferAttribute, Color, CylinderGeometry, Group, InstancedMesh, LatheGeometry, Matrix4, MeshBasicMaterial, MeshLambertMaterial,
  SphereGeometry, Vector2,
} = MeshCat.THREE;
export const MANY = 60; // marks of a kind from which on each is drawn with few triangles
const VERY_MANY = 240; // and with fewer still
const ARROW = [[0, -3], [0.2, -3], [0.2, 5], [0.62, 5], [0, 7]]; // as in geometry.py, [radius, height]
const ORDER = { ghost: 1, inertia: 2, com: 3, "robot-com": 3, torque: 4 };
const ALWAYS_TRANSPARENT = ["com", "robot-com"];
const color = new Color(), matrix = new Matrix4();

export class Batches {
  constructor(scene) {
    this.scene = scene;
    this.byKey = new Map();
    this.sorted = null;
    this.holder = new Group();
    scene.viewer.scene.add(this.holder);
  }

  // Bring all instances up to date; called before a picture if anything has changed.
  update() {
    const { marks, hidden } = this.scene, version = `${marks.version} ${hidden.version}`;
    if (this.sorted !== version) this.sort();
    this.sorted = version;
    for (const batch of this.byKey.values()) this.refresh(batch);
  }

  sort() {
    const groups = new Map();
    for (const mark of this.scene.marks.values()) {
      if (this.scene.hidden.hides(mark)) continue;
      const key = `${mark.tree} ${mark.category} ${mark.shape.key}`;
      if (!groups.has(key)) groups.set(key, []);
      groups.get(key).push(mark);
    }
    for (const [key, batch] of this.byKey) if (!groups.has(key)) this.drop(key, batch);
    for (const [key, list] of groups) this.fill(key, list);
  }

  drop(key, { mesh }) {
    this.holder.remove(mesh);
    mesh.dispose();
    this.byKey.delete(key);
  }

  fill(key, list) {
    let batch = this.byKey.get(key);
    const sides = list.length < MANY ? 0 : list.length < VERY_MANY ? 9 : 6;
    if (batch && (batch.room < list.length || batch.sides !== sides)) {
      this.drop(key, batch);
      batch = null;
    }
    if (!batch) {
      const room = Math.ceil(1.3 * list.length) + 4, { shape, category } = list[0];
      const mesh = new InstancedMesh(geometryOf(list[0], sides), material(shape), room);
      mesh.frustumCulled = false;
      mesh.renderOrder = ORDER[category] || 0;
      mesh.setColorAt(0, color.setHex(0xffffff));
      this.holder.add(mesh);
      batch = { mesh, room, sides, category };
      this.byKey.set(key, batch);
    }
    batch.marks = list;
    batch.mesh.count = list.length;
    batch.mesh.userData.marks = list;
  }

  refresh({ mesh, marks, category }) {
    const { visible, opacity } = this.scene.view.get(category) || { visible: true, opacity: 1 };
    mesh.visible = visible;
    if (!visible) return;
    restyle(mesh.material, opacity, ALWAYS_TRANSPARENT.includes(category));
    if (!marks[0].shape.isLit) paintAxes(mesh.geometry, this.scene.colors);
    const array = mesh.instanceMatrix.array;
    marks.forEach((mark, i) => {
      this.scene.placeMark(mark, matrix);
      array.set(matrix.elements, 16 * i);
      mesh.setColorAt(i, color.setHex(this.scene.colorOf(mark)));
    });
    mesh.instanceMatrix.needsUpdate = true;
    mesh.instanceColor.needsUpdate = true;
  }

  // The meshes that a click can hit.
  get meshes() { return [...this.byKey.values()].map(({ mesh }) => mesh).filter((mesh) => mesh.visible); }
}

function material({ isLit, isOnTop }) {
  const look = { depthTest: !isOnTop };
  return isLit ? new MeshLambertMaterial(look) : new MeshBasicMaterial({ ...look, vertexColors: true });
}

function restyle(look, opacity, isAlways) {
  const transparent = opacity < 1 || isAlways;
  if (look.transparent !== transparent) look.needsUpdate = true;
  Object.assign(look, { opacity, transparent, depthWrite: opacity > 0.4 });
}

// A mark's shape, with so many sides around; 0 for as many as it was made with.
function geometryOf({ shape, category }, sides) {
  const { geometry } = shape, of = geometry.parameters || {};
  // A triad is painted for its kind, so it has a geometry of its own; a clone shares what is noted in it.
  if (!shape.isLit) return Object.assign(geometry.clone(), { userData: {} });
  if (!sides) return geometry;
  if (category === "axis") return arrow(sides);
  if (geometry.type.startsWith("Sphere")) return new SphereGeometry(of.radius, sides, Math.ceil(sides / 2) + 1);
  // Balls close the ends of what is a rod.
  const isRod = ["body", "base", "ghost"].includes(category);
  if (geometry.type.startsWith("Cylinder")) return new CylinderGeometry(of.radiusTop, of.radiusBottom, of.height, sides, 1, isRod);
  return geometry;
}

function arrow(sides) {
  const points = ARROW.map(([radius, height]) => new Vector2(radius, height));
  return new LatheGeometry(points, Math.max(4, sides - 2)).rotateX(Math.PI / 2);
}

// A triad's axes take the theme's colours: the largest of red, green and blue tells which axis it is.
function paintAxes(geometry, colors) {
  if (geometry.userData.painted === colors) return;
  geometry.userData.painted = colors;
  const given = geometry.userData.given || (geometry.userData.given = geometry.getAttribute("color").clone());
  const painted = new Float32Array(3 * given.count);
  for (let i = 0; i < given.count; i++) {
    const rgb = [given.getX(i), given.getY(i), given.getZ(i)], axis = "xyz"[rgb.indexOf(Math.max(...rgb))];
    color.setHex(colors[axis]).toArray(painted, 3 * i);
  }
  geometry.setAttribute("color", new BufferAttribute(painted, 3));
}

// Lights, camera and ground, sized to the robot. World z points up; the viewer turns it into three.js' y.
"use strict";

const KindslStage = (() => {
  const FIELD_OF_VIEW = 28; // degrees
  const FROM = [1.0, -1.35, 0.62]; // where the camera stands, seen from the robot
  const BORDER = 7; // around the robot, in radii of its bodies

  function toThree([x, y, z]) {
    return new MeshCat.THREE.Vector3(x, z, -y);
  }

  class Stage {
    constructor(viewer, scene) {
      this.viewer = viewer;
      this.scene = scene;
      viewer.gui.domElement.remove();
      viewer.hide_background();
      for (const path of [["Lights", "PointLightNegativeX"], ["Lights", "PointLightPositiveX"], ["Lights", "FillLight"],
        ["Lights", "SpotLight"], ["Grid"], ["Axes"]]) viewer.set_property(path, "visible", false);
      viewer.set_property(["Lights", "AmbientLight", "<object>"], "intensity", 0.36);
      this.addLights();
      viewer.camera.fov = FIELD_OF_VIEW;
      this.ground = null;
      this.framedSize = null;
      this.isUsersView = false;
      viewer.controls.addEventListener("start", () => { this.isUsersView = true; });
    }

    // The pane has another shape: frame the robot anew unless the user has turned it.
    resized() {
      if (this.framedSize !== null && !this.isUsersView) this.frame();
    }

    // Directional lights: unlike the viewer's own they do not depend on the robot's size.
    addLights() {
      const { DirectionalLight, HemisphereLight } = MeshCat.THREE;
      const lights = [[0.5, [3, -4, 6]], [0.16, [-5, 2, 2]]];
      for (const [intensity, from] of lights) {
        const light = new DirectionalLight(0xffffff, intensity);
        light.position.set(...from);
        this.viewer.scene.add(light);
      }
      const sky = new HemisphereLight(0xffffff, 0xb9c0c8, 0.2);
      sky.position.set(0, 0, 1);
      this.viewer.scene.add(sky);
    }

    // Frame the robot when it is new or has become another size; a user's own view stays otherwise.
    follow() {
      const { size } = this.scene.model;
      if (this.framedSize === null || size > 2 * this.framedSize || size < 0.5 * this.framedSize) this.frame();
    }

    frame() {
      const { size } = this.scene.model;
      const { camera, controls } = this.viewer;
      this.framedSize = size;
      this.isUsersView = false;
      const direction = toThree(FROM).normalize();
      const { target, distance } = this.fit(direction);
      camera.near = distance / 200;
      camera.far = distance * 100;
      controls.target.copy(target);
      camera.position.copy(this.fromWorld(target.clone().addScaledVector(direction, distance)));
      controls.minDistance = distance / 100;
      controls.maxDistance = distance * 30;
      controls.update();
      this.drawGround();
      this.viewer.set_dirty();
    }

    // Where to look, and from how far, so that all points of the robot are in the picture.
    fit(direction) {
      const right = new MeshCat.THREE.Vector3(0, 1, 0).cross(direction).normalize();
      const up = direction.clone().cross(right);
      const seen = this.points().map((p) => [p.dot(right), p.dot(up), p.dot(direction)]);
      const middle = [0, 1, 2].map((axis) => {
        const values = seen.map((point) => point[axis]);
        return (Math.min(...values) + Math.max(...values)) / 2;
      });
      const border = BORDER * this.scene.model.unit, tangent = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
      const aspect = this.viewer.camera.aspect || 1;
      const needed = seen.map(([x, y, z]) => z - middle[2] + Math.max(
        (Math.abs(x - middle[0]) + border) / (tangent * aspect), (Math.abs(y - middle[1]) + border) / tangent));
      const target = right.multiplyScalar(middle[0]).addScaledVector(up, middle[1]).addScaledVector(direction, middle[2]);
      return { target, distance: Math.max(...needed, 0.4 * this.scene.model.size) };
    }

    points() {
      const { poses, trees, model } = this.scene;
      const points = [[model.center[0], model.center[1], model.ground]];
      for (const [name, pose] of poses.robot.links) {
        points.push(KindslKinematics.origin(pose));
        for (const end of trees.robot.links.get(name).ends) points.push(KindslKinematics.transformPoint(pose, end));
      }
      for (const pose of poses.robot.frames.values()) points.push(KindslKinematics.origin(pose));
      return points.map(toThree);
    }

    // The camera hangs in nodes of the viewer's scene whose turns cancel out.
    fromWorld(position) {
      this.viewer.camera.parent.updateMatrixWorld(true);
      return this.viewer.camera.parent.worldToLocal(position);
    }

    // A grid with 1-2-5 spacing under the robot.
    drawGround() {
      const { size, ground, center } = this.scene.model;
      const spacing = roundSpacing(size / 8), half = spacing * Math.ceil((1.1 * size) / spacing);
      const lines = [], at = (value) => spacing * Math.round(value / spacing);
      for (let t = -half; t <= half + 1e-9; t += spacing) lines.push(t, -half, 0, t, half, 0, -half, t, 0, half, t, 0);
      const { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } = MeshCat.THREE;
      const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(lines, 3));
      const grid = new LineSegments(geometry, new LineBasicMaterial({ color: 0x9aa5b1, transparent: true }));
      if (this.ground) this.viewer.scene.remove(this.ground);
      grid.position.set(at(center[0]), at(center[1]), ground);
      grid.name = "ground";
      this.ground = grid;
      this.viewer.scene.add(grid);
      this.styleGround();
    }

    styleGround() {
      const { visible, opacity } = this.scene.view.get("ground");
      if (!this.ground) return;
      this.ground.visible = visible;
      this.ground.material.opacity = 0.55 * opacity;
      this.ground.position.z = this.scene.model.ground;
    }
  }

  function roundSpacing(length) {
    const power = 10 ** Math.floor(Math.log10(length));
    return power * [1, 2, 5, 10].find((step) => step * power >= length);
  }

  return { Stage, toThree };
})();

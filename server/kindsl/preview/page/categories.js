// The kinds of things drawn: their names in the legend, colours, and how they scale with the robot.
"use strict";

const KindslCategories = (() => {
  // `key` is the path element under a link's, joint's or frame's node; `kind` is what a click on it means.
  const CATEGORIES = [
    { key: "body", title: "Links", swatch: "#8ea3ba", opacity: 0.62, kind: "link", pick: 1 },
    { key: "base", title: "Base", swatch: "#56667a", opacity: 0.75, kind: "link", pick: 1 },
    { key: "revolute", title: "Revolute joints", swatch: "#d68a34", opacity: 1, kind: "joint", pick: 0 },
    { key: "prismatic", title: "Prismatic joints", swatch: "#2f9488", opacity: 1, kind: "joint", pick: 0 },
    { key: "axis", title: "Joint axes", swatch: "#3b4450", opacity: 1, kind: "joint", pick: 0 },
    { key: "link-frame", title: "Link frames", swatch: "triad", opacity: 1, kind: "link", pick: 0 },
    { key: "joint-frame", title: "Joint frames", swatch: "triad", opacity: 0.55, kind: "joint", pick: 0 },
    { key: "optional-frame", title: "Optional frames", swatch: "triad", opacity: 1, kind: "frame", pick: 0 },
    { key: "com", title: "Links' centres of mass", swatch: "#2b2f36", opacity: 1, kind: "link", pick: 0 },
    { key: "robot-com", title: "Robot's centre of mass", swatch: "#c2334d", opacity: 1, kind: null, pick: 9 },
    { key: "inertia", title: "Inertia ellipsoids", swatch: "#7d62b8", opacity: 0.22, kind: "link", pick: 2 },
    { key: "torque", title: "Gravity torques", swatch: "#b0408f", opacity: 1, kind: "joint", pick: 0, hidden: true },
    { key: "ghost", title: "Ghost (last saved)", swatch: "#5b7bd5", opacity: 0.3, kind: null, pick: 9 },
    { key: "ground", title: "Ground grid", swatch: "#b8c0ca", opacity: 1, kind: null, pick: 9 },
    { key: "names", title: "Names", swatch: "text", opacity: 1, kind: null, pick: 9 },
  ];

  // How a mark's size follows the robot's: `uniform` in all directions, `radial` across y only, `none`: true size.
  const SIZING = { segment: "radial", rail: "radial", ellipsoid: "none" };

  // /kindsl/TREE/GROUP/NAME/CATEGORY/MARK
  function parsePath(path) {
    const [, root, tree, group, name, category, mark] = path.split("/");
    return { root, tree, group, name: name && decodeURIComponent(name), category, mark };
  }

  function sizing(mark) {
    return SIZING[mark.split("-")[0]] || "uniform";
  }

  return { CATEGORIES, byKey: new Map(CATEGORIES.map((c) => [c.key, c])), parsePath, sizing };
})();

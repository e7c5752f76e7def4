// Puts the page together: viewer, scene, panel and the line to the server (or the state of an exported page).
"use strict";

const kindsl = (() => {
  const pane = document.getElementById("pane");
  const viewer = new MeshCat.Viewer(pane);
  const scene = new KindslScene.Scene(viewer);
  const stage = new KindslStage.Stage(viewer, scene);
  const embedded = document.getElementById("embedded-state");
  const parameters = new Map();
  document.body.classList.toggle("picture", location.hash === "#picture");
  let connection = null, selected = null, hovered = null, cursor = null;

  const send = (message) => connection && connection.send(message);
  const showHighlight = () => scene.highlight(hovered || cursor || selected);

  const actions = {
    isStatic: Boolean(embedded),
    setJoint(name, value) {
      scene.q.set(name, value);
      scene.changed("value");
      send({ type: "set-joint", name, value });
    },
    setParameter: (name, value) => send({ type: "set-parameter", name, value }),
    setView(key, visible, opacity) {
      scene.setView(key, visible, opacity);
      stage.styleGround();
    },
    hover(chosen) {
      const isSame = JSON.stringify(chosen) === JSON.stringify(hovered);
      hovered = chosen;
      if (!isSame) showHighlight();
    },
    reveal(chosen) {
      if (["link", "joint", "frame"].includes(chosen.kind)) selected = chosen;
      cursor = null;
      showHighlight();
      send({ type: "reveal", ...chosen });
    },
    clear() {
      selected = cursor = null;
      showHighlight();
    },
    frame: () => stage.frame(),
  };

  const labels = new KindslLabels.Labels(scene, pane, actions);
  const picking = new KindslPicking.Picking(scene, pane, actions);
  const panel = new KindslPanel.Panel(scene, actions);
  const findings = new KindslFindings.Findings(pane, actions);
  const stale = { joints: true, parameters: true, findings: true, camera: true };

  function apply(message) {
    if (message.type === "parameter") { parameters.set(message.name, message); stale.parameters = true; }
    else if (message.type === "finding") { findings.findings.set(message.path, message); stale.findings = true; }
    else if (message.type === "status") { findings.status = message; stale.findings = true; }
    else if (message.type === "highlight") { cursor = message.name ? { kind: message.kind, name: message.name } : null; showHighlight(); }
    if (message.type === "delete") forget(message.path);
    scene.apply(message);
    viewer.set_dirty();
  }

  function forget(path) {
    for (const [name, parameter] of parameters) if (parameter.path === path || path === "/kindsl/parameters") { parameters.delete(name); stale.parameters = true; }
    for (const key of findings.findings.keys()) if (key === path || path === "/kindsl/findings") { findings.findings.delete(key); stale.findings = true; }
  }

  scene.onChange((what) => {
    if (["model", "joint", "delete", "value", "end"].includes(what)) stale.joints = true;
    if (what === "model") stale.camera = true;
  });
  scene.onRemove = forget;

  // Only meshcat's drawing commands and our own messages; anything else, such as `set_control`, is ignored.
  viewer.handle_command = apply;

  // The canvas fills its pane, not the window.
  viewer.set_3d_pane_size = function setPaneSize() {
    viewer.camera.aspect = pane.clientWidth / Math.max(1, pane.clientHeight);
    viewer.camera.updateProjectionMatrix();
    viewer.renderer.setSize(pane.clientWidth, pane.clientHeight);
    stage.resized();
    viewer.set_dirty();
  };

  const render = viewer.render.bind(viewer);
  function refresh() {
    scene.update();
    if (stale.camera && scene.trees.robot.links.size) { stage.follow(); stage.styleGround(); stale.camera = false; }
    if (stale.joints) { panel.updateJoints(); stale.joints = false; }
    if (stale.parameters) { panel.updateParameters(parameters); stale.parameters = false; }
    if (stale.findings) { findings.show(); stale.findings = false; }
    document.getElementById("robot").textContent = scene.model.name;
    document.getElementById("dof").textContent = scene.model.name ? `${scene.trees.robot.joints.size} joints, ${KindslPanel.format(scene.total.mass, 3)} kg` : "";
    KindslSelection.show(scene, selected, document.getElementById("selection"));
    panel.update();
  }
  viewer.render = () => { refresh(); render(); labels.place(); };

  function greeting() {
    const values = {};
    for (const parameter of parameters.values()) if (parameter.is_overridden) values[parameter.name] = parameter.value;
    return { type: "hello", joints: Object.fromEntries(scene.q), parameters: values };
  }

  function showState(state) {
    document.body.dataset.state = state;
    document.getElementById("state").textContent = { live: "live", reconnecting: "reconnecting…", exported: "exported" }[state];
  }

  function play(base64) {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const view = new DataView(bytes.buffer);
    for (let at = 0; at < bytes.length;) {
      const length = view.getUint32(at);
      viewer.handle_command_bytearray(bytes.slice(at + 4, at + 4 + length));
      at += 4 + length;
    }
  }

  if (embedded) { showState("exported"); play(embedded.textContent.trim()); }
  else connection = new KindslConnection.Connection({ onFrame: (frame) => viewer.handle_command_bytearray(frame), onState: showState, greeting });
  new ResizeObserver(() => viewer.set_3d_pane_size()).observe(pane);

  return { actions, apply, connection, findings, labels, panel, parameters, picking, refresh, scene, stage, viewer };
})();

// Puts the page together: viewer, scene, panel, and the line to the server or the state of an exported page.
"use strict";

const kindsl = (() => {
  const STATES = { live: "live", reconnecting: "reconnecting…", exported: "exported" };
  const byId = (id) => document.getElementById(id);
  const pane = byId("pane"), embedded = byId("embedded-state");
  const viewer = openViewer();
  const scene = new KindslScene.Scene(viewer);
  const stage = new KindslStage.Stage(viewer, scene);
  const inbox = new KindslInbox.Inbox(scene);
  let connection = null, selected = null, hovered = null;

  function openViewer() {
    try {
      return new MeshCat.Viewer(pane);
    } catch (error) {
      byId("overlay").hidden = false;
      byId("overlay").querySelector("h2").textContent = "The preview needs WebGL, which this browser does not offer";
      throw error;
    }
  }

  const send = (message) => connection && connection.send(message);
  const showHighlight = () => scene.highlight(hovered || inbox.cursor || selected);

  const actions = {
    isStatic: Boolean(embedded),
    setJoint(name, value) {
      scene.q.set(name, value);
      scene.changed("value");
      send({ type: "set-joint", name, value });
    },
    setParameter(name, value) {
      if (embedded) inbox.setParameter(name, value);
      else send({ type: "set-parameter", name, value });
    },
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
      inbox.cursor = null;
      showHighlight();
      send({ type: "reveal", ...chosen });
    },
    clear() {
      selected = inbox.cursor = null;
      showHighlight();
    },
  };

  const labels = new KindslLabels.Labels(scene, pane, actions);
  const picking = new KindslPicking.Picking(scene, pane, actions);
  const joints = new KindslJointRows.JointRows(scene, actions);
  const parameters = new KindslParameterRows.ParameterRows(actions);
  const findings = new KindslFindings.Findings(pane, inbox, actions);
  KindslLegend.fill(byId("legend"), actions.setView);
  byId("zero").addEventListener("click", () => joints.zero());
  byId("frame").addEventListener("click", () => stage.frame());
  inbox.onCursor = showHighlight;

  function frameRobot() {
    stage.follow();
    stage.styleGround();
  }

  function refresh() {
    scene.update();
    if (scene.isWhole && scene.trees.robot.links.size && inbox.isStale("camera")) frameRobot();
    if (inbox.isStale("joints")) joints.update();
    if (inbox.isStale("parameters")) parameters.update([...inbox.parameters.values()]);
    if (inbox.isStale("findings")) findings.show();
    joints.updateTorques();
    KindslSelection.show(scene, selected, byId("selection"));
    byId("robot").textContent = scene.model.name;
    byId("dof").textContent = scene.model.name ? KindslSelection.summary(scene) : "";
  }

  // Before each picture everything is brought up to date, after it the names are put in place.
  const render = viewer.render.bind(viewer);
  viewer.render = () => { refresh(); render(); labels.place(); };

  // Only meshcat's drawing commands and our own messages; anything else, such as `set_control`, is ignored.
  viewer.handle_command = (message) => inbox.take(message);

  // The canvas fills its pane, not the window.
  viewer.set_3d_pane_size = () => {
    viewer.camera.aspect = pane.clientWidth / Math.max(1, pane.clientHeight);
    viewer.camera.updateProjectionMatrix();
    viewer.renderer.setSize(pane.clientWidth, pane.clientHeight);
    stage.resized();
    viewer.set_dirty();
  };

  function onState(state) {
    document.body.dataset.state = state;
    byId("state").textContent = STATES[state];
  }

  document.body.classList.toggle("picture", location.hash === "#picture");
  const onFrame = (frame) => viewer.handle_command_bytearray(frame);
  const greeting = () => ({ type: "hello", joints: Object.fromEntries(scene.q), parameters: inbox.typedValues() });
  if (embedded) {
    onState("exported");
    KindslEmbedded.frames(embedded.textContent.trim()).forEach(onFrame);
  } else connection = new KindslConnection.Connection({ onFrame, onState, greeting });
  new ResizeObserver(() => viewer.set_3d_pane_size()).observe(pane);

  return { actions, connection, inbox, labels, picking, refresh, scene, stage, viewer };
})();

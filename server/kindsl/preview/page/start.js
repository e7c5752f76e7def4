// Puts the page together: viewer, scene, panel, and the line to the server or the state of an exported page.
"use strict";

const kindsl = (() => {
  const STATES = {
    connecting: "connecting…", live: "live", reconnecting: "reconnecting…", exported: "exported", stale: "stale", incomplete: "incomplete",
  };
  const byId = (id) => document.getElementById(id);
  const pane = byId("pane"), embedded = byId("embedded-state");
  const viewer = openViewer();
  const theme = new KindslTheme.Theme();
  const scene = new KindslScene.Scene(viewer, theme.colors);
  const page = { viewer, scene, theme, pane, isStatic: Boolean(embedded), connection: null };
  page.send = (message) => page.connection && page.connection.send(message);
  page.stage = new KindslStage.Stage(viewer, scene);
  page.camera = new KindslCamera.Camera(viewer, scene, pane);
  page.selection = new KindslSelection.Selection();
  page.presets = new KindslPresets.Presets(scene);
  page.units = new KindslUnits.Units();
  page.inbox = new KindslInbox.Inbox(scene);
  page.measure = new KindslMeasure.Measure(scene, page.units, pane);
  page.actions = KindslActions.make(page);
  page.labels = new KindslLabels.Labels(scene, pane, page.actions);
  page.picking = new KindslPicking.Picking(scene, pane, page.actions);
  page.lineArt = new KindslLineArt.LineArt(scene, pane);
  page.compass = new KindslCompass.Compass(scene, pane, page.camera);
  page.joints = new KindslJointRows.JointRows(scene, page.units, page.actions);
  page.parameters = new KindslParameterRows.ParameterRows(page.units, page.actions);
  page.tree = new KindslTree.Tree(scene, page.selection, page.actions);
  page.findings = new KindslFindings.Findings(pane, page.inbox, page.actions);
  page.legend = new KindslLegend.Legend(scene, page.presets, page.actions);
  page.address = new KindslAddress.Address(page);
  page.editing = new KindslEditing.Editing(page);
  page.history = new KindslHistory.History(takeState, putState, page.editing);
  page.keys = new KindslKeys.Keys(pane, page);
  page.motion = new KindslMotion.Motion(scene, {
    range: (joint) => page.joints.range(joint),
    onStep: () => {},
    onStop(names) {
      page.actions.tellPose(names.map((name) => [name, scene.q.get(name)]));
      page.actions.note();
    },
  });
  let connectionState = "connecting", isBegun = false;

  function openViewer() {
    // An encoder in the viewer takes the window for its worker and posts back every message, its own again and again.
    window.onmessage = null;
    try {
      return new MeshCat.Viewer(pane);
    } catch (error) {
      byId("notice").hidden = false;
      byId("notice").firstElementChild.textContent = "The preview needs WebGL, which this browser does not offer";
      throw error;
    }
  }

  // Pose and view, for undoing them.
  function takeState() {
    return JSON.stringify([[...scene.q].filter(([, value]) => value !== 0).sort(), KindslAddress.eyeText(page.camera.state())]);
  }

  function putState(text) {
    const [pose, eye] = JSON.parse(text), zeros = [...scene.q.keys()].map((name) => [name, 0]);
    page.actions.setPose(new Map([...zeros, ...pose]));
    if (eye !== KindslAddress.eyeText(page.camera.state())) page.camera.restore(KindslAddress.eyeOf(eye));
  }

  // The first whole robot: the view of the address, if there is one.
  function begin() {
    isBegun = true;
    page.address.restore();
    scene.update();
    page.history.begin();
  }

  function follow() {
    page.presets.refresh();
    page.labels.forget();
    page.camera.follow();
    page.stage.drawGround();
  }

  function refresh() {
    scene.update();
    const isDrawn = scene.isWhole && scene.trees.robot.links.size > 0;
    if (isDrawn && page.inbox.isStale("camera")) follow();
    if (isDrawn && !isBegun) begin();
    if (scene.isWhole && page.inbox.isStale("rows")) showRows();
    if (scene.isWhole && page.inbox.isStale("marks")) page.legend.showMore();
    if (page.inbox.isStale("values")) page.joints.update();
    if (page.inbox.isStale("parameters")) page.parameters.update([...page.inbox.parameters.values()]);
    if (page.inbox.isStale("findings")) {
      page.findings.show();
      showHead();
    }
    if (page.selection.chosen) KindslCard.show(scene, page.selection.chosen, byId("selection"));
    page.lineArt.update();
    page.measure.update((position) => page.labels.project(position));
    page.stage.styleGround();
  }

  function showRows() {
    page.joints.update();
    page.tree.update();
    page.legend.show();
    const { name } = scene.model;
    byId("robot").textContent = name;
    byId("pane-title").textContent = name;
    showHead();
  }

  // Nothing is called live that stands greyed in the picture.
  function showState() {
    const { state, is_former: isFormer } = page.inbox.status, isGrey = KindslFindings.GREY.has(state);
    const shown = connectionState === "live" && isGrey ? (isFormer ? "stale" : "incomplete") : connectionState;
    document.body.dataset.state = shown;
    byId("state").textContent = STATES[shown];
  }

  function showHead() {
    showState();
    const { status: told } = page.inbox;
    byId("dof").textContent = scene.model.name ? KindslCard.summary(scene, told) : "";
    byId("dof").title = told.lacks || "";
    const { findings: { counts }, inbox: { status } } = page, words = page.findings.words();
    KindslTitle.show({ name: scene.model.name, words, counts, state: status.state, connection: connectionState });
  }

  // Before each picture everything is brought up to date, after it the names are put in place.
  const render = viewer.render.bind(viewer);
  viewer.render = () => {
    refresh();
    render();
    page.labels.place();
    page.editing.place();
    page.compass.update();
  };

  // Only meshcat's drawing commands and our own messages; anything else, such as `set_control`, is ignored.
  viewer.handle_command = (message) => page.inbox.take(message);

  // The canvas fills its pane, not the window.
  viewer.set_3d_pane_size = () => {
    viewer.camera.aspect = pane.clientWidth / Math.max(1, pane.clientHeight);
    viewer.camera.updateProjectionMatrix();
    viewer.renderer.setSize(pane.clientWidth, pane.clientHeight);
    page.camera.resized();
    viewer.set_dirty();
  };

  function onState(state) {
    connectionState = state;
    showState();
    if (scene.model.name) showHead();
    if (state === "live") page.editing.rejoin();
  }

  theme.onChange = () => {
    scene.setColors(theme.colors);
    page.legend.show();
  };
  page.inbox.onEditing = (message) => page.editing.take(message);
  page.inbox.onForget = (path) => page.editing.forget(path);
  page.inbox.onCursor = (thing) => page.selection.follow(thing);
  page.inbox.onLines = (text) => KindslActions.showText("Lines to add to kindsl.toml", text);
  page.camera.onMove(page.actions.note);
  page.selection.onChange(() => {
    scene.highlight(page.selection.lit);
    KindslCard.show(scene, page.selection.chosen, byId("selection"));
  });

  const hash = new URLSearchParams(location.hash.slice(1));
  document.body.classList.toggle("picture", hash.has("picture"));
  const onFrame = (frame) => viewer.handle_command_bytearray(frame);
  const greeting = () => ({ type: "hello", joints: Object.fromEntries(scene.q), parameters: page.inbox.typedValues() });
  if (embedded) {
    onState("exported");
    KindslEmbedded.frames(embedded.textContent.trim()).forEach(onFrame);
  } else page.connection = new KindslConnection.Connection({ onFrame, onState, greeting });
  new ResizeObserver(() => viewer.set_3d_pane_size()).observe(pane);

  return page;
})();

// The extension's manifest where no process can be started: the entry for browsers, and no word of Python's interpreters.

const PROGRAMS = ["kindsl.interpreter", "kindsl.importStrategy", "kindsl.path", "kindsl.args"];
const COMMANDS = ["kindsl.openPreviewInBrowser", "kindsl.selectInterpreter"];
const TRUST = { supported: true };
const VIRTUAL = { supported: true };

/** Return the manifest of the package for browsers, made from that of the desktop's. */
export function webManifest({ main, extensionKind, scripts, devDependencies, ...manifest }) {
  const { taskDefinitions, problemPatterns, problemMatchers, ...contributes } = manifest.contributes;
  return {
    ...manifest,
    browser: "./out/browser.js",
    activationEvents: manifest.activationEvents.filter((event) => !event.startsWith("onTaskType:")),
    capabilities: { untrustedWorkspaces: TRUST, virtualWorkspaces: VIRTUAL },
    contributes: {
      ...contributes,
      commands: contributes.commands.filter(isOffered),
      menus: Object.fromEntries(Object.entries(contributes.menus).map(([place, items]) => [place, items.filter(isOffered)])),
      viewsWelcome: contributes.viewsWelcome.map((welcome) => ({ ...welcome, contents: withoutCommands(welcome.contents) })),
      walkthroughs: contributes.walkthroughs.map((walk) => ({ ...walk, steps: walk.steps.filter(({ id }) => id !== "python") })),
      configuration: { ...contributes.configuration, properties: withoutPrograms(contributes.configuration.properties) },
    },
  };
}

function isOffered({ command }) {
  return !COMMANDS.includes(command);
}

function withoutCommands(contents) {
  return contents.split("\n").filter((line) => !COMMANDS.some((command) => line.includes(`(command:${command})`))).join("\n");
}

function withoutPrograms(properties) {
  return Object.fromEntries(Object.entries(properties).filter(([name]) => !PROGRAMS.includes(name)));
}

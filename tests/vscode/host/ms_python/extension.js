// What the Python extension tells about environments, with a selection that the test makes.
"use strict";
const vscode = require("vscode");

exports.activate = () => {
  const changed = new vscode.EventEmitter();
  let path = "/nowhere/selected/python";
  return {
    environments: {
      getActiveEnvironmentPath: () => ({ path }),
      resolveEnvironment: async (environment) => ({ executable: { uri: vscode.Uri.file(environment.path) } }),
      onDidChangeActiveEnvironmentPath: changed.event,
    },
    select(selected) {
      path = selected;
      changed.fire({ path });
    },
  };
};

// What the panel tells the page in its frame: whether VS Code is light or dark, and its colours.

/** The page's names for colours, and the theme's variables that they come from, the preferred first. */
export const COLORS: Readonly<Record<string, readonly string[]>> = {
  paper: ["--vscode-sideBar-background", "--vscode-editor-background"],
  sky: ["--vscode-editor-background"],
  floor: ["--vscode-editor-background"],
  label: ["--vscode-editor-background"],
  ink: ["--vscode-foreground", "--vscode-editor-foreground"],
  faint: ["--vscode-descriptionForeground", "--vscode-foreground"],
  line: ["--vscode-panel-border", "--vscode-widget-border"],
  accent: ["--vscode-button-background"],
  "on-accent": ["--vscode-button-foreground"],
  error: ["--vscode-errorForeground"],
  warning: ["--vscode-editorWarning-foreground"],
  note: ["--vscode-editorInfo-foreground"],
};

const READ = `
const COLORS = ${JSON.stringify(COLORS)};
const read = () => {
  const style = getComputedStyle(document.documentElement), colors = {};
  for (const [name, variables] of Object.entries(COLORS)) {
    const color = variables.map((variable) => style.getPropertyValue(variable).trim()).find(Boolean);
    if (color) colors[name] = color;
  }
  const isLight = ["vscode-light", "vscode-high-contrast-light"].some((kind) => document.body.classList.contains(kind));
  return { type: "kindsl.theme", kind: isLight ? "light" : "dark", colors };
};`;

/** A script that sends the colours when the frame has loaded, and again whenever the theme changes. */
export function themeScript(origin: string): string {
  return `{${READ}
const frame = document.querySelector("iframe");
const tell = () => frame.contentWindow.postMessage(read(), ${JSON.stringify(origin)});
frame.addEventListener("load", tell);
for (const element of [document.documentElement, document.body]) {
  new MutationObserver(tell).observe(element, { attributes: true, attributeFilter: ["class", "style"] });
}
}`;
}

/** A script for the preview's page where that is the panel itself. */
export function ownThemeScript(): string {
  // The page writes its own colours into the root's style: to watch that would go round in circles.
  return `if (typeof acquireVsCodeApi === "function") {${READ}
const tell = () => kindsl.theme.take(read());
new MutationObserver(tell).observe(document.body, { attributes: true, attributeFilter: ["class", "data-vscode-theme-id"] });
tell();
}`;
}

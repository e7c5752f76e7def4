// The HTML around the preview: the page of the language server in a frame, or a sentence why there is none.

import { themeScript } from "./panelTheme";

/** What a panel shows, kept by the editor across a reload of the window. */
export interface PanelState {
  readonly uri: string;
  readonly isPinned: boolean;
}

export type PanelContent =
  | { readonly kind: "frame"; readonly url: string }
  | { readonly kind: "message"; readonly text: string; readonly actions: readonly string[] };

const STYLE = `
html, body { height: 100%; margin: 0; padding: 0; overflow: hidden; }
iframe { width: 100%; height: 100%; border: 0; display: block; }
p { margin: 2em 2em 1em; color: var(--vscode-descriptionForeground); font-family: var(--vscode-font-family); }
nav { margin: 0 2em; display: flex; flex-wrap: wrap; gap: 0.5em; }
button { padding: 4px 11px; border: 0; border-radius: 2px; font-family: var(--vscode-font-family); cursor: pointer;
  color: var(--vscode-button-foreground); background: var(--vscode-button-background); }
button:hover { background: var(--vscode-button-hoverBackground); }
`;

/** Shortcuts that are pressed in the frame, which VS Code does not see there. */
const SHORTCUTS = `
addEventListener("message", ({ source, data }) => {
  if (source !== document.querySelector("iframe").contentWindow || data?.type !== "kindsl.key") return;
  window.dispatchEvent(new KeyboardEvent("keydown", { ...data, bubbles: true, cancelable: true }));
});`;

/** The whole page. `nonce` must be fresh for each page. */
export function previewPage(content: PanelContent, state: PanelState, nonce: string): string {
  const policy = [
    "default-src 'none'",
    `style-src 'nonce-${nonce}'`,
    `script-src 'nonce-${nonce}'`,
    ...(content.kind === "frame" ? [`frame-src ${new URL(content.url).origin}`] : []),
  ];
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${escapeHtml(policy.join("; "))}">
<title>Kinematics-DSL preview</title>
<style nonce="${nonce}">${STYLE}</style>
</head>
<body>
${body(content)}
<script nonce="${nonce}">
const editor = acquireVsCodeApi();
editor.setState(${scriptLiteral(state)});
for (const button of document.querySelectorAll("button")) {
  button.addEventListener("click", () => editor.postMessage({ action: button.textContent }));
}
${theme(content)}
</script>
</body>
</html>
`;
}

function theme(content: PanelContent): string {
  return content.kind === "frame" ? themeScript(new URL(content.url).origin) + SHORTCUTS : "";
}

function body(content: PanelContent): string {
  if (content.kind === "message") return `<p>${escapeHtml(content.text)}</p>\n<nav>${content.actions.map(button).join("")}</nav>`;
  return `<iframe title="Robot" src="${escapeHtml(content.url)}" allow="fullscreen; clipboard-write"></iframe>`;
}

function button(title: string): string {
  return `<button>${escapeHtml(title)}</button>`;
}

function scriptLiteral(value: unknown): string {
  return JSON.stringify(value).replace(/</g, "\\u003c");
}

function escapeHtml(text: string): string {
  const entities: Record<string, string> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };
  return text.replace(/[&<>"']/g, (character) => entities[character] ?? character);
}

// An editor as VS Code sets it up for the language, with the server behind `askServer`.
//
// Python calls what hangs on `window.typist`; `askServer(method, params)` and
// `tellServer(method, params)` are Python's and take and give JSON.
const LANGUAGE = "kinematics-dsl";
const URI = "file:///typed/robot.kindsl";
const FRAMES = 3;

let editor;
let version = 1;
let underway = 0;
const untold = [];

/** Load VS Code's editor core and open an empty document. */
async function start({ configuration, triggerCharacters, options, initialText }) {
  await new Promise((resolve) => require(["vs/editor/editor.main"], resolve));
  monaco.languages.register({ id: LANGUAGE });
  monaco.languages.setLanguageConfiguration(LANGUAGE, languageConfiguration(configuration));
  monaco.languages.setMonarchTokensProvider(LANGUAGE, COMMENTS);
  monaco.languages.registerCompletionItemProvider(LANGUAGE, { triggerCharacters, provideCompletionItems });
  const model = monaco.editor.createModel(initialText, LANGUAGE, monaco.Uri.parse(URI));
  editor = monaco.editor.create(document.getElementById("editor"), { model, minimap: { enabled: false }, ...options });
  const textDocument = { uri: URI, languageId: LANGUAGE, version, text: initialText };
  await tellServer("textDocument/didOpen", JSON.stringify({ textDocument }));
  model.onDidChangeContent(({ changes }) => untold.push(...changes));
  editor.focus();
}

const COMMENTS = {
  tokenizer: {
    root: [
      [/\/\/.*$/, "comment"],
      [/\/\*/, "comment", "@block"],
      [/[^/]+|\//, ""],
    ],
    block: [
      [/\*\//, "comment", "@pop"],
      [/[^*]+|\*/, "comment"],
    ],
  },
};

/** The file language-configuration.json as the editor takes it. */
function languageConfiguration(file) {
  const pattern = (text) => (typeof text === "string" ? new RegExp(text) : text && new RegExp(text.pattern, text.flags));
  const rules = (each) =>
    Object.fromEntries(Object.entries(each ?? {}).map(([name, value]) => [name, pattern(value)]));
  const actions = { none: 0, indent: 1, indentOutdent: 2, outdent: 3 };
  const onEnterRules = (file.onEnterRules ?? []).map(({ action, ...texts }) => ({
    ...rules(texts),
    action: { ...action, indentAction: actions[action.indent] },
  }));
  return { ...file, wordPattern: pattern(file.wordPattern), indentationRules: rules(file.indentationRules), onEnterRules };
}

/** Tell the server what was typed since it was last told. */
function tell() {
  if (untold.length === 0) return;
  version += 1;
  const contentChanges = untold.splice(0).map(({ range, text }) => ({ range: toProtocol(range), text }));
  void tellServer("textDocument/didChange", JSON.stringify({ textDocument: { uri: URI, version }, contentChanges }));
}

async function provideCompletionItems(model, position, context) {
  underway += 1;
  tell();
  try {
    const question = {
      textDocument: { uri: URI },
      position: { line: position.lineNumber - 1, character: position.column - 1 },
      context: { triggerKind: context.triggerKind + 1, triggerCharacter: context.triggerCharacter },
    };
    const answer = await askServer("textDocument/completion", JSON.stringify(question));
    const { items, isIncomplete } = JSON.parse(answer);
    return { suggestions: items.map(suggestion), incomplete: isIncomplete };
  } finally {
    underway -= 1;
  }
}

function suggestion({ label, kind, detail, sortText, filterText, preselect, insertTextFormat, textEdit }) {
  const { newText, range, insert, replace } = textEdit;
  return {
    ...{ label, kind: kindOf(kind), detail, sortText, filterText, preselect },
    insertText: newText,
    insertTextRules: insertTextFormat === 2 ? monaco.languages.CompletionItemInsertTextRule.InsertAsSnippet : 0,
    range: range ? toEditor(range) : { insert: toEditor(insert), replace: toEditor(replace) },
  };
}

/** The protocol's kind of an item as the editor counts them. */
function kindOf(kind) {
  const { CompletionItemKind } = monaco.languages;
  const names = [
    ...["Text", "Method", "Function", "Constructor", "Field", "Variable", "Class", "Interface", "Module"],
    ...["Property", "Unit", "Value", "Enum", "Keyword", "Snippet", "Color", "File", "Reference", "Folder"],
    ...["EnumMember", "Constant", "Struct", "Event", "Operator", "TypeParameter"],
  ];
  return CompletionItemKind[names[kind - 1]];
}

function toProtocol({ startLineNumber, startColumn, endLineNumber, endColumn }) {
  const place = (line, column) => ({ line: line - 1, character: column - 1 });
  return { start: place(startLineNumber, startColumn), end: place(endLineNumber, endColumn) };
}

function toEditor({ start, end }) {
  return new monaco.Range(start.line + 1, start.character + 1, end.line + 1, end.character + 1);
}

/** Type a text, a key as soon as the list of the key before is there. */
async function type(text) {
  for (const key of text) {
    editor.trigger("keyboard", "type", { text: key });
    do {
      await sleep(0);
    } while (underway > 0);
  }
}

// Words go in at once, which nothing in the editor minds; each bracket and quote by itself.
const PLAIN_OR_BRACKET = /[\w .=,+*/-]+|[^]/gu;

/** Type a line and Enter too fast for any list. */
function hurry(line) {
  const model = editor.getModel();
  const behind = model.getValue().slice(model.getOffsetAt(editor.getPosition()));
  if (line === "}" && /^\s+\}/.test(behind)) {
    editor.trigger("typist", "cursorDown", {});
    editor.trigger("typist", "cursorEnd", {});
  } else {
    for (const keys of line.match(PLAIN_OR_BRACKET) ?? []) press(keys);
  }
  press("\n");
}

/** Type keys; brackets and Enter are clever only in a line whose tokens are known. */
function press(keys) {
  editor.getModel().tokenization.forceTokenization(editor.getPosition().lineNumber);
  editor.trigger("keyboard", "type", { text: keys });
}

/** Wait until nothing that a key began is going on: no timer of the editor, no question, no drawing. */
async function settle() {
  // A key begins its question in a timer that was set before ours, so it is seen to be under way.
  do {
    await sleep(0);
    await sleep(0);
  } while (underway > 0);
  // A list is drawn in the frame after its answer, its chosen item in the one after that.
  for (let frame = 0; frame < FRAMES; frame++) await new Promise(requestAnimationFrame);
  if (underway > 0) await settle();
}

const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** What a person sees: the text, the cursor (from 0), the labels of the open list, its chosen one. */
function seen() {
  const model = editor.getModel();
  const position = editor.getPosition();
  const widget = document.querySelector(".suggest-widget[monaco-visible-content-widget=true]");
  const label = (row) => row.querySelector(".label-name").innerText;
  const rows = [...(widget?.querySelectorAll(".monaco-list-row") ?? [])];
  const labels = rows.map(label);
  const chosen = rows.filter((row) => row.classList.contains("focused")).map(label)[0] ?? "";
  const offset = model.getOffsetAt(position);
  return { text: model.getValue(), offset, line: position.lineNumber - 1, labels, chosen };
}

/** Put a text into the document, the cursor at an offset, and leave any list and snippet. */
function put(text, offset) {
  editor.trigger("typist", "hideSuggestWidget", {});
  editor.trigger("typist", "leaveSnippet", {});
  const model = editor.getModel();
  model.pushEditOperations([], [{ range: model.getFullModelRange(), text }], () => null);
  editor.setPosition(model.getPositionAt(offset));
  editor.focus();
}

/** Whether placeholders are still to be visited. */
function isInSnippet() {
  return editor.getContribution("snippetController2").isInSnippet();
}

window.typist = { start, settle, type, hurry, seen, put, isInSnippet };

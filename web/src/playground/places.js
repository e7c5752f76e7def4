// Places in the shown text. They move with it, so what was listed for one version is found in the next.
import * as monaco from "monaco-editor/editor/editor.api.js";

const OPTIONS = { stickiness: monaco.editor.TrackedRangeStickiness.NeverGrowsWhenTypingAtEdges };

/**
 * A range of the protocol, from 0.
 * @typedef {object} Range
 * @property {{ readonly line: number, readonly character: number }} start
 * @property {{ readonly line: number, readonly character: number }} end
 */

/**
 * A range of the protocol as the editor counts.
 * @param {Range} range
 */
export const rangeOf = ({ start, end }) => new monaco.Range(start.line + 1, start.character + 1, end.line + 1, end.character + 1);

export class Places {
  #ranges;

  /** @param {monaco.editor.ICodeEditor} editor */
  constructor(editor) {
    this.editor = editor;
    this.#ranges = editor.createDecorationsCollection();
  }

  /**
   * Keep these ranges of the shown text, and none of those before.
   * @param {readonly monaco.IRange[]} ranges
   */
  keep(ranges) {
    this.#ranges.set(ranges.map((range) => ({ range, options: OPTIONS })));
  }

  /**
   * Put the cursor at the start of the range with this index; return whether the text that holds it is still shown.
   * @param {number} index
   */
  go(index) {
    const place = this.#ranges.getRange(index)?.getStartPosition();
    if (place === undefined) return false;
    this.editor.setPosition(place);
    this.editor.revealPositionInCenterIfOutsideViewport(place);
    this.editor.focus();
    return true;
  }
}

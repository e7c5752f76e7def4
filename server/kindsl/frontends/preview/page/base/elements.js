// Small elements of the page. Text is always set as text, never as markup.

const LONG = 12; // characters
const NAMESPACE = "http://www.w3.org/2000/svg";

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {string} [className]
 * @param {string} [text]
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, className, text) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  if (text !== undefined) element.textContent = text;
  return element;
}

/**
 * An element of a drawing.
 * @template {keyof SVGElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Readonly<Record<string, string | number>>} [attributes]
 * @returns {SVGElementTagNameMap[Tag]}
 */
export function makeSvg(tag, attributes = {}) {
  const element = document.createElementNS(NAMESPACE, tag);
  setAttributes(element, attributes);
  return element;
}

/**
 * @param {Element} element
 * @param {Readonly<Record<string, string | number>>} attributes
 */
export function setAttributes(element, attributes) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
}

/**
 * An element of `page.html`.
 * @template {HTMLElement} [Kind=HTMLElement]
 * @param {string} id
 * @returns {Kind}
 */
export function byId(id) {
  return partOf(document, `#${id}`);
}

/**
 * What an element of `page.html` has in it.
 * @template {HTMLElement} [Kind=HTMLElement]
 * @param {ParentNode} whole
 * @param {string} selector
 * @returns {Kind}
 */
export function partOf(whole, selector) {
  const found = whole.querySelector(selector);
  if (!found) throw new Error(`the page has no ${selector}`);
  return /** @type {Kind} */ (found);
}

/**
 * The panel's section that has an element in it.
 * @param {HTMLElement} element
 */
export function sectionOf(element) {
  return element.closest("section") ?? element;
}

/**
 * Give an element a name whose middle gives way where there is little room: names that begin alike differ at their ends.
 * @param {HTMLElement} element
 * @param {string} name
 * @param {string} [ending] Of the name; it is not shown.
 */
export function nameIn(element, name, ending = "") {
  const shown = name.slice(0, name.length - ending.length), end = shown.length < LONG ? 0 : Math.min(9, shown.length >> 1), at = shown.length - end;
  element.classList.add("cut");
  // Told whole: two parts would be read out as two words.
  element.replaceChildren(...[["start", shown.slice(0, at)], ["end", shown.slice(at)]].map(([part, text]) => (
    Object.assign(make("span", part, text), { ariaHidden: "true" }))));
  element.title = name;
}

/**
 * The last word of all names, as `_joint`; empty if they do not share it, and for fewer than three.
 * @param {readonly string[]} names
 */
export function sharedEnding(names) {
  const [ending = ""] = /[_-][^_-]+$/.exec(names[0] ?? "") ?? [];
  return names.length > 2 && names.every((name) => name.endsWith(ending) && name.length > ending.length) ? ending : "";
}

/**
 * Say at a field why its text is refused, or that it is taken.
 * @param {HTMLInputElement} field
 * @param {string} reason Empty if it is taken.
 */
export function judge(field, reason) {
  if (!reason && field.validity.valid) return;
  field.setCustomValidity(reason);
  field.title = reason;
  if (reason && document.activeElement === field) field.reportValidity();
}

/**
 * A number for people: so many decimals, no trailing zeros.
 * @param {number} value
 */
export const format = (value, digits = 4) => String(Number(value.toFixed(digits)));

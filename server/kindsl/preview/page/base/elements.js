// Small elements of the page. Text is always set as text, never as markup.

export function make(tag, className, text) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  if (text !== undefined) element.textContent = text;
  return element;
}

// A number for people: so many decimals, no trailing zeros.
export const format = (value, digits = 4) => String(Number(value.toFixed(digits)));

// Bring rows by name in line with what is wanted, in its order; rows that stay keep their focus.
export function keepRows(rows, parent, wanted, makeRow) {
  const names = new Set(wanted.map((item) => item.name));
  for (const [name, row] of rows) {
    if (names.has(name)) continue;
    row.element.remove();
    rows.delete(name);
  }
  wanted.forEach((item, position) => {
    if (!rows.has(item.name)) rows.set(item.name, makeRow(item));
    const { element } = rows.get(item.name);
    if (parent.children[position] !== element) parent.insertBefore(element, parent.children[position] || null);
  });
}

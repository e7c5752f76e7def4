// Texts of meshes as the viewer's loaders take them.

const UNIT = /<unit\b[^>]*\bmeter\s*=\s*["']([^"']+)["']/;

/**
 * A text that loaders read as robots mean it: COLLADA's axes as they are, no pictures, pieces that can be one mesh.
 * @param {string} format
 * @param {string} text
 */
export function meshText(format, text) {
  if (format !== "dae") return text;
  const plain = text.replace(/<library_images\b[\s\S]*?<\/library_images>/g, "").replace(/<up_axis>[^<]*<\/up_axis>/g, "<up_axis>Y_UP</up_axis>");
  return plain.replace(/semantic="(?:TEXCOORD|COLOR|TEXTANGENT|TEXBINORMAL)"/g, 'semantic="UNUSED"');
}

/**
 * How long a unit of a mesh is, metres, along each axis.
 * @param {string} format
 * @param {string} text
 * @returns {[number, number, number]}
 */
export function unitOf(format, text) {
  const unit = format === "dae" ? Number(UNIT.exec(text)?.[1] ?? 1) : 1, factor = Number.isFinite(unit) && unit > 0 ? unit : 1;
  return [factor, factor, factor];
}

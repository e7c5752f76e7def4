// The colours of marks, for light and for dark surroundings: each stands out by 3 to 1 or more, and kinds of joints
// differ in lightness and shape too, for people who do not tell their hues apart.

/** @import { Colors } from "../base/types.js" */

/** @type {Colors} */
export const LIGHT = {
  core: 0x71869f, "shaded-core": 0x596d86, bone: 0x71869f, drum: 0xb9590f, outline: 0x17202b, doubtful: 0xb07400,
  impossible: 0xbf2a1c, body: 0x647b96, base: 0x3f4f63, revolute: 0xb9590f, prismatic: 0x0f7566, axis: 0x2b333d, com: 0x1f2429,
  "robot-com": 0xb3203f, inertia: 0x6b4fae, "bad-inertia": 0xbf2a1c, torque: 0xa3347f, "negative-torque": 0x1f6f8f,
  ghost: 0x7d55b5, ground: 0x9aa5b1, highlight: 0x1456c4, guess: 0x866100, measure: 0x1f2429,
  x: 0xc92a2a, y: 0x1e7d3c, z: 0x2456c8,
};
/** @type {Colors} */
export const DARK = {
  core: 0x93abc6, "shaded-core": 0x7795b7, bone: 0x93abc6, drum: 0xf0995a, outline: 0x0b0e12, doubtful: 0xffc04d,
  impossible: 0xff7a6b, body: 0x93abc6, base: 0xb9c6d5, revolute: 0xf0995a, prismatic: 0x45c2ad, axis: 0xdbe3ec, com: 0xf2f5f8,
  "robot-com": 0xff7188, inertia: 0xb199f5, "bad-inertia": 0xff7a6b, torque: 0xe887cb, "negative-torque": 0x6cc5e6,
  ghost: 0xc0a2f5, ground: 0x56616d, highlight: 0x6fb0ff, guess: 0xe3c35a, measure: 0xf2f5f8,
  x: 0xff7b72, y: 0x5ccb7b, z: 0x7fabff,
};

/** @param {number} color */
export const cssColor = (color) => `#${color.toString(16).padStart(6, "0")}`;

/**
 * Relative luminance, 0 to 1, of red, green and blue from 0 to 255.
 * @param {readonly number[]} rgb
 */
export function luminance([r, g, b]) {
  const linear = (/** @type {number} */ value) => {
    const share = value / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  };
  return 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
}

// An exported page carries its state: frames one after the other, each after its length in four bytes.

export function framesIn(base64) {
  const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
  const view = new DataView(bytes.buffer), list = [];
  for (let at = 0; at < bytes.length; at += 4 + view.getUint32(at)) {
    list.push(bytes.slice(at + 4, at + 4 + view.getUint32(at)));
  }
  return list;
}

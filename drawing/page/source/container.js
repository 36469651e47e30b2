// Copyright the limpet authors. GPL-3.0-or-later.
// The data container: a JSON head, and arrays that it names, all little endian.

const kMagic = "LIMPAGE1";
const kTypes = {
  u8: Uint8Array,
  u16: Uint16Array,
  u32: Uint32Array,
  i32: Int32Array,
  f32: Float32Array,
  f64: Float64Array,
};

/// {head, arrays} of a container's bytes. Arrays are views of the bytes, nothing is copied.
export function parseContainer(bytes) {
  const magic = String.fromCharCode(...bytes.subarray(0, 8));
  if (magic !== kMagic) throw new Error("this is no data of limpet view");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(8, true);
  if (12 + length > bytes.length) throw new Error("the data is cut off");
  const head = JSON.parse(new TextDecoder().decode(bytes.subarray(12, 12 + length)));
  const arrays = {};
  for (const [name, { type, offset, length: count }] of Object.entries(head.arrays)) {
    const Type = kTypes[type];
    if (!Type) throw new Error(`array ${name} is of a type that is not known`);
    if (offset + count * Type.BYTES_PER_ELEMENT > bytes.length) throw new Error(`array ${name} is cut off`);
    arrays[name] = new Type(bytes.buffer, bytes.byteOffset + offset, count);
  }
  return { head, arrays };
}

export function bytesOfBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

export async function gunzip(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

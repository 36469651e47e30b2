// Copyright the limpet authors. GPL-3.0-or-later.
// Variable-length integers (LEB128, zigzag). Values may exceed 32 bits, so arithmetic, not shifts.

export class VarintReader {
  constructor(bytes, at = 0) {
    this.bytes = bytes;
    this.at = at;
  }

  unsigned() {
    const bytes = this.bytes;
    let byte = bytes[this.at++];
    if (byte < 128) return byte;
    let value = byte & 127;
    let scale = 128;
    do {
      byte = bytes[this.at++];
      value += (byte & 127) * scale;
      scale *= 128;
    } while (byte >= 128);
    if (byte === undefined) throw new RangeError("the data ends within a number");
    return value;
  }

  signed() {
    const zigzag = this.unsigned();
    return zigzag % 2 === 1 ? -(zigzag + 1) / 2 : zigzag / 2;
  }
}

export const unzigzag = (zigzag) => (zigzag % 2 === 1 ? -(zigzag + 1) / 2 : zigzag / 2);

// Copyright the limpet authors. GPL-3.0-or-later.
// An outline: the boundary cycles of a polygon, as the timeline stream writes them. Immutable once read.
import { unzigzag } from "./varint.js";

/// edges, partners, positions: of all cycles one after the other; bounds: {hole, start, end} of each cycle.
class Outline {
  constructor(edges, partners, positions, bounds) {
    this.edges = edges;
    this.partners = partners;
    this.positions = positions;
    this.bounds = bounds;
  }
  get cycles() {
    return this.bounds.map(({ hole, start, end }) => ({
      hole,
      start,
      edges: this.edges.subarray(start, end),
      partners: this.partners.subarray(start, end),
      positions: this.positions.subarray(3 * start, 3 * end),
    }));
  }
}

export const kNoOutline = new Outline(new Float64Array(0), new Float64Array(0), new Float64Array(0), []);

const kNothing = new Uint8Array(0);

// Where an outline is read to, before its size is known.
let capacity = 1024;
let edges = new Float64Array(capacity);
let partners = new Float64Array(capacity);
let positions = new Float64Array(3 * capacity);

function grow(size) {
  while (capacity < size) capacity *= 2;
  const larger = (old, length) => {
    const array = new Float64Array(length);
    array.set(old);
    return array;
  };
  edges = larger(edges, capacity);
  partners = larger(partners, capacity);
  positions = larger(positions, 3 * capacity);
}

/// Reads the outline that follows `last` in the stream. Calls written(edge, partner) for each vertex that was
/// not copied, and dropped(edge) for each of `last` that was not.
export function readOutline(reader, last, written, dropped) {
  const cycles = [];
  const copied = last === kNoOutline ? kNothing : new Uint8Array(last.edges.length);
  let lastIndex = null; // of edge identities, made when needed
  const indexInLast = (edge) => {
    if (last.edges.length < 24) return last.edges.indexOf(edge);
    if (!lastIndex) {
      lastIndex = new Map();
      last.edges.forEach((id, i) => lastIndex.set(id, i));
    }
    return lastIndex.get(edge) ?? -1;
  };
  let n = 0;
  let next = 0; // index just after the last copied one
  const cycleCount = reader.unsigned();
  for (let c = 0; c < cycleCount; ++c) {
    const hole = reader.unsigned() === 1;
    const start = n;
    const runs = reader.unsigned();
    for (let r = 0; r < runs; ++r) {
      const head = reader.unsigned();
      const length = Math.floor(head / 2);
      if (n + length > capacity) grow(n + length);
      if (head % 2 === 0) {
        const from = next + reader.signed();
        if (from < 0 || from + length > last.edges.length)
          throw new RangeError("an outline copies what is not there");
        edges.set(last.edges.subarray(from, from + length), n);
        partners.set(last.partners.subarray(from, from + length), n);
        positions.set(last.positions.subarray(3 * from, 3 * (from + length)), 3 * n);
        copied.fill(1, from, from + length);
        next = from + length;
        n += length;
        continue;
      }
      for (let i = 0; i < length; ++i, ++n) {
        const edge = (n > 0 ? edges[n - 1] : 0) + reader.signed();
        const partner = reader.unsigned();
        edges[n] = edge;
        partners[n] = partner === 0 ? 0 : edge + unzigzag(partner - 1);
        const before = indexInLast(edge);
        const base = before >= 0 ? last.positions : positions;
        const at = before >= 0 ? 3 * before : 3 * (n - 1);
        for (let axis = 0; axis < 3; ++axis) {
          positions[3 * n + axis] = (at >= 0 ? base[at + axis] : 0) + reader.signed();
        }
        written(edge, partners[n]);
      }
    }
    cycles.push({ hole, start, end: n });
  }
  for (let i = 0; i < copied.length; ++i) if (!copied[i]) dropped(last.edges[i]);
  return new Outline(edges.slice(0, n), partners.slice(0, n), positions.slice(0, 3 * n), cycles);
}

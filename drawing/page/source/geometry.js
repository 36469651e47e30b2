// Copyright the limpet authors. GPL-3.0-or-later.
// What is derived of outlines, once for each: triangles, area, lengths, where an edge is.
import { ShapeUtils, Vector2 } from "three";

/// Between the model's whole numbers, the world, and the scene, whose origin is the middle of all that is shown, so
/// that single precision suffices.
export class Frame {
  constructor(head) {
    this.unit = head.unit;
    this.origin = head.origin;
    const { low, high } = head.box;
    this.middle = low.map((x, i) => (x + high[i]) / 2 - head.origin[i]);  // minus origin
    this.size = high.map((x, i) => x - low[i]);
    this.radius = Math.hypot(...this.size) / 2 || head.resolution;
  }
  ofModel(positions, i = 0) {
    return [0, 1, 2].map((axis) => positions[i + axis] * this.unit - this.middle[axis]);
  }
  ofArray(array, i = 0) {
    return [0, 1, 2].map((axis) => array[i + axis] - this.middle[axis]);
  }
  ofWorld(world) {
    return world.map((x, axis) => x - this.origin[axis] - this.middle[axis]);
  }
  toWorld(scene) {
    return scene.map((x, axis) => x + this.middle[axis] + this.origin[axis]);
  }
}

const cache = new WeakMap();  // outline → what was derived

/// {triangles: scene positions, 9 for each; area; inner: a point well inside; indexOf: Map edge → index; next, previous:
/// index of the vertex after and before in the cycle}
export function derived(polygon, frame) {
  let found = cache.get(polygon.outline);
  if (!found) cache.set(polygon.outline, found = derive(polygon, frame));
  return found;
}

function derive({ outline, normal }, frame) {
  const { positions, edges, cycles } = outline;
  const n = edges.length;
  const scene = new Float64Array(3 * n);
  for (let i = 0; i < 3 * n; ++i) scene[i] = positions[i] * frame.unit - frame.middle[i % 3];
  const next = new Int32Array(n), previous = new Int32Array(n);
  for (const { start, edges: { length } } of cycles) {
    for (let i = 0; i < length; ++i) {
      next[start + i] = start + (i + 1) % length;
      previous[start + (i + 1) % length] = start + i;
    }
  }
  const indices = triangulate(scene, cycles, normal);
  const triangles = new Float32Array(3 * indices.length);
  let area = 0, largest = -1, inner = [0, 0, 0];
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [indices[t], indices[t + 1], indices[t + 2]].map((i) => scene.subarray(3 * i, 3 * i + 3));
    triangles.set(a, 3 * t);
    triangles.set(b, 3 * t + 3);
    triangles.set(c, 3 * t + 6);
    const size = triangleArea(a, b, c);
    area += size;
    if (size > largest) {
      largest = size;
      inner = [0, 1, 2].map((i) => (a[i] + b[i] + c[i]) / 3);
    }
  }
  let indexOf = null;
  return { scene, triangles, area, inner, next, previous, indexOf(edge) {
    if (n < 32) return edges.indexOf(edge);
    if (!indexOf) {
      indexOf = new Map();
      edges.forEach((id, i) => indexOf.set(id, i));
    }
    return indexOf.get(edge) ?? -1;
  } };
}

function triangleArea(a, b, c) {
  const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [vx, vy, vz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
}

/// Indices of vertices, three for each triangle, anticlockwise seen from where the normal points to.
function triangulate(scene, cycles, normal) {
  const count = scene.length / 3;
  if (count === 3) return [0, 1, 2];
  const [u, v] = planeAxes(normal);
  const flat = (i) => {
    const at = [0, 1, 2].map((axis) => scene[3 * i + axis] - scene[axis]);
    return new Vector2(at[0] * u[0] + at[1] * u[1] + at[2] * u[2], at[0] * v[0] + at[1] * v[1] + at[2] * v[2]);
  };
  const points = Array.from({ length: count }, (_, i) => flat(i));
  const parts = cycles.map(({ start, edges }) => points.slice(start, start + edges.length));
  const indices = [];
  for (const [a, b, c] of ShapeUtils.triangulateShape(parts[0].slice(), parts.slice(1))) {
    const [p, q, r] = [points[a], points[b], points[c]];
    const turn = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (turn >= 0) indices.push(a, b, c);
    else indices.push(a, c, b);
  }
  return indices;
}

/// Two unit vectors that make a right-handed frame with the normal.
export function planeAxes(normal) {
  const [x, y, z] = normal;
  const helper = Math.abs(z) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const u = unit([helper[1] * z - helper[2] * y, helper[2] * x - helper[0] * z, helper[0] * y - helper[1] * x]);
  return [u, [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]]];
}

const unit = (v) => {
  const length = Math.hypot(...v) || 1;
  return v.map((x) => x / length);
};

/// Ends of an edge in the scene, or null: [a, b].
export function edgeEnds(state, edge, frame) {
  const polygon = state.polygons.get(state.edges.get(edge)?.segment);
  if (!polygon) return null;
  const { scene, next, indexOf } = derived(polygon, frame);
  const i = indexOf(edge);
  if (i < 0) return null;
  const at = (k) => [...scene.subarray(3 * k, 3 * k + 3)];
  return [at(i), at(next[i])];
}

/// Scene positions of corners: where three or more polygons meet round a vertex, each sharing an edge with the next.
export function findCorners(state, frame) {
  const corners = [];
  const seen = new Set();
  for (const polygon of state.polygons.values()) {
    const { edges, partners } = polygon.outline;
    const own = derived(polygon, frame);
    for (let i = 0; i < edges.length; ++i) {
      if (partners[i] === 0 || partners[own.previous[i]] === 0 || seen.has(edges[i])) continue;
      const ring = walkRound(state, polygon, own, i, frame);
      ring?.forEach((edge) => seen.add(edge));
      if (ring && ring.length >= 3) corners.push(own.scene[3 * i], own.scene[3 * i + 1], own.scene[3 * i + 2]);
    }
  }
  return new Float32Array(corners);
}

/// Edges that start at the vertex, polygon by polygon round it; null where the ring is open.
function walkRound(state, polygon, own, i, frame) {
  const first = polygon.outline.edges[i];
  const ring = [first];
  for (let guard = 0; guard < 64; ++guard) {
    const edge = polygon.outline.partners[own.previous[i]];
    if (edge === 0) return null;
    if (edge === first) return ring;
    ring.push(edge);
    polygon = state.polygons.get(state.edges.get(edge)?.segment);
    if (!polygon) return null;
    own = derived(polygon, frame);
    i = own.indexOf(edge);
    if (i < 0) return null;
  }
  return null;
}

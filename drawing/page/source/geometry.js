// Copyright the limpet authors. GPL-3.0-or-later.
// What is derived of outlines, once for each: triangles, area, lengths, where an edge is.
import { ShapeUtils, Vector2 } from "three";

/// Between the model's whole numbers, the world, and the scene, whose origin is the middle of all that is
/// shown, so that single precision suffices.
export class Frame {
  constructor(head) {
    this.unit = head.unit;
    this.origin = head.origin;
    const { low, high } = head.box;
    this.middle = low.map((x, i) => (x + high[i]) / 2 - head.origin[i]); // minus origin
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

const cache = new WeakMap(); // outline → what was derived

/// Of a polygon's outline: scene (positions), triangles (indices of vertices), area, inner (a place well
/// inside), next and previous (index of the vertex after and before in the cycle), indexOf(edge).
export function derived(polygon, frame) {
  let found = cache.get(polygon.outline);
  if (!found) cache.set(polygon.outline, (found = new Derived(polygon, frame)));
  return found;
}

class Derived {
  constructor({ outline, normal }, frame) {
    const { positions, bounds } = outline;
    this.edges = outline.edges;
    this.index = null; // of edges, made when needed
    this.largest = 0; // where the largest triangle is
    const scene = (this.scene = new Float64Array(positions.length));
    const {
      unit,
      middle: [mx, my, mz],
    } = frame;
    for (let i = 0; i < scene.length; i += 3) {
      scene[i] = positions[i] * unit - mx;
      scene[i + 1] = positions[i + 1] * unit - my;
      scene[i + 2] = positions[i + 2] * unit - mz;
    }
    const order = orderOf(bounds);
    this.next = order.next;
    this.previous = order.previous;
    this.triangles = triangulate(scene, bounds, normal);
    this.area = 0;
    let largest = -1;
    for (let t = 0; t < this.triangles.length; t += 3) {
      const size = triangleArea(
        scene,
        3 * this.triangles[t],
        3 * this.triangles[t + 1],
        3 * this.triangles[t + 2],
      );
      this.area += size;
      if (size > largest) {
        largest = size;
        this.largest = t;
      }
    }
  }

  get inner() {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * this.triangles[this.largest + k]);
    return [0, 1, 2].map((i) => (this.scene[a + i] + this.scene[b + i] + this.scene[c + i]) / 3);
  }

  indexOf(edge) {
    if (this.edges.length < 32) return this.edges.indexOf(edge);
    if (!this.index) {
      this.index = new Map();
      this.edges.forEach((id, i) => this.index.set(id, i));
    }
    return this.index.get(edge) ?? -1;
  }
}

const orders = new Map(); // of outlines of one cycle, by its length: many are of the same

function orderOf(bounds) {
  const n = bounds.at(-1).end;
  if (bounds.length === 1 && orders.has(n)) return orders.get(n);
  const next = new Int32Array(n),
    previous = new Int32Array(n);
  for (const { start, end } of bounds) {
    for (let i = start; i < end; ++i) {
      const to = i + 1 < end ? i + 1 : start;
      next[i] = to;
      previous[to] = i;
    }
  }
  if (bounds.length === 1 && n < 256) orders.set(n, { next, previous });
  return { next, previous };
}

function triangleArea(p, a, b, c) {
  const ux = p[b] - p[a],
    uy = p[b + 1] - p[a + 1],
    uz = p[b + 2] - p[a + 2];
  const vx = p[c] - p[a],
    vy = p[c + 1] - p[a + 1],
    vz = p[c + 2] - p[a + 2];
  const x = uy * vz - uz * vy,
    y = uz * vx - ux * vz,
    z = ux * vy - uy * vx;
  return Math.sqrt(x * x + y * y + z * z) / 2;
}

const kTriangle = Uint32Array.of(0, 1, 2);

/// Indices of vertices, three for each triangle, anticlockwise seen from where the normal points to.
function triangulate(scene, bounds, normal) {
  const count = scene.length / 3;
  if (count === 3) return kTriangle;
  const [u, v] = planeAxes(normal);
  const flat = (i) => {
    const at = [0, 1, 2].map((axis) => scene[3 * i + axis] - scene[axis]);
    return new Vector2(
      at[0] * u[0] + at[1] * u[1] + at[2] * u[2],
      at[0] * v[0] + at[1] * v[1] + at[2] * v[2],
    );
  };
  const points = Array.from({ length: count }, (_, i) => flat(i));
  const parts = bounds.map(({ start, end }) => points.slice(start, end));
  const indices = [];
  for (const [a, b, c] of ShapeUtils.triangulateShape(parts[0].slice(), parts.slice(1))) {
    const [p, q, r] = [points[a], points[b], points[c]];
    const turn = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (turn >= 0) indices.push(a, b, c);
    else indices.push(a, c, b);
  }
  return Uint32Array.from(indices);
}

/// Two unit vectors that make a right-handed frame with the normal.
export function planeAxes(normal) {
  const [x, y, z] = normal;
  const helper = Math.abs(z) < 0.9 ? [0, 0, 1] : [1, 0, 0];
  const u = unit([
    helper[1] * z - helper[2] * y,
    helper[2] * x - helper[0] * z,
    helper[0] * y - helper[1] * x,
  ]);
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
  const own = derived(polygon, frame);
  const { scene, next } = own;
  const i = own.indexOf(edge);
  if (i < 0) return null;
  const at = (k) => [...scene.subarray(3 * k, 3 * k + 3)];
  return [at(i), at(next[i])];
}

/// Scene positions of corners: where three or more polygons meet round a vertex, each sharing an edge with
/// the next.
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
      if (ring && ring.length >= 3)
        corners.push(own.scene[3 * i], own.scene[3 * i + 1], own.scene[3 * i + 2]);
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

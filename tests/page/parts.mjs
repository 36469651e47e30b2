// Copyright the limpet authors. GPL-3.0-or-later.
// What containers made without the program have in common.
import { kEventKinds, kRefusals } from "./encode.mjs";

export const kBase = {
  program: "limpet 0.9",
  angle_deg: 10,
  noise: [0, 0, 0],
  tolerance: 0.01,
  finished: false,
  modes: [],
  refusals: kRefusals,
  event_kinds: kEventKinds,
};

export const kModes = ["none", "extend", "travel", "look again"];

export const kPointRobot = {
  name: "point",
  links: ["x", "y", "z", "body"].map((name, i) => ({
    name,
    parent: i - 1,
    kind: i < 3 ? "prismatic" : "fixed",
    axis: [i === 0 || i === 3 ? 1 : 0, i === 1 ? 1 : 0, i === 2 ? 1 : 0],
    low: null,
    high: null,
    mounting: [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0],
    capsules: [],
  })),
  control_point: { link: 3, position: [0, 0, 0] },
  sensors: [],
};
for (let x = -1; x <= 1; ++x)
  for (let y = -1; y <= 1; ++y)
    for (let z = -1; z <= 1; ++z) {
      const n = Math.hypot(x, y, z);
      if (n > 0)
        kPointRobot.sensors.push({ link: 3, position: [0, 0, 0], axis: [x / n, y / n, z / n], range: 0.2 });
    }

/// Random numbers that a seed repeats (mulberry32).
export function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

function statistics(polygons, unit) {
  let area = 0,
    open = 0;
  for (const { cycles, normal } of polygons)
    for (const { vertices } of cycles)
      vertices.forEach((v, i) => {
        const a = v.at,
          b = vertices[(i + 1) % vertices.length].at;
        const cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        area +=
          ((cross[0] * normal[0] + cross[1] * normal[1] + cross[2] * normal[2]) / 2 ** 25) * unit * unit;
        if (v.partner === 0) open += Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) * unit;
      });
  return { area, open };
}

/// Events and figures that follow from the difference of one state to the next.
export class Record {
  constructor() {
    this.events = [];
    this.area = [];
    this.open = [];
    this.last = { polygons: new Map(), edges: new Map() };
  }
  step(number, state, unit) {
    const polygons = new Map(state.polygons.map((p) => [p.id, p]));
    const edges = new Map(
      state.polygons.flatMap((p) => p.cycles.flatMap((c) => c.vertices.map((v) => [v.edge, v.partner]))),
    );
    for (const id of polygons.keys()) if (!this.last.polygons.has(id)) this.events.push([number, 0, id, 0]);
    for (const id of this.last.polygons.keys()) if (!polygons.has(id)) this.events.push([number, 2, id, 0]);
    for (const [e, p] of edges) {
      if (p > e && this.last.edges.get(e) !== p) this.events.push([number, 3, e, p]);
      const was = this.last.edges.get(e);
      if (p === 0 && was > e) this.events.push([number, 4, e, was]);
    }
    this.last = { polygons, edges };
    const { area, open } = statistics(state.polygons, unit);
    this.area.push(area);
    this.open.push(open);
  }
  arrays() {
    return {
      area: Float32Array.from(this.area),
      open_length: Float32Array.from(this.open),
      event_step: Uint32Array.from(this.events, (e) => e[0]),
      event_kind: Uint8Array.from(this.events, (e) => e[1]),
      event_a: Uint32Array.from(this.events, (e) => e[2]),
      event_b: Uint32Array.from(this.events, (e) => e[3]),
    };
  }
}

export function truthCube() {
  const at = [],
    triangles = [],
    lines = [];
  for (let i = 0; i < 8; ++i) at.push(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  for (const [a, b, c, d] of [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ]) {
    triangles.push(a, b, c, a, c, d);
  }
  for (let i = 0; i < 8; ++i) for (const bit of [1, 2, 4]) if (!(i & bit)) lines.push(i, i | bit);
  return {
    truth_position: Float32Array.from(at),
    truth_triangle: Uint32Array.from(triangles),
    truth_line: Uint32Array.from(lines),
  };
}

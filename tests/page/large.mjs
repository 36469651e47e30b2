// Copyright the limpet authors. GPL-3.0-or-later.
// Large models and long runs, to try the speed with.
import { TimelineEncoder, container } from "./encode.mjs";
import { Record, kBase, kModes, kPointRobot, random } from "./parts.mjs";

/// A model of a ball of about so many triangles: as many polygons, closed.
export function ball(triangles, { name = "ball.limpet" } = {}) {
  const unit = 1e-4,
    rows = Math.max(4, Math.round(Math.sqrt(triangles / 2))),
    columns = rows;
  const encoder = new TimelineEncoder();
  const at = (i, j) => {
    const a = (Math.PI * i) / rows,
      b = (2 * Math.PI * (j % columns)) / columns;
    return [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)].map((x) =>
      Math.round(x / unit),
    );
  };
  const polygons = [],
    twins = new Map();
  let edge = 0;
  const add = (corners) => {
    const vertices = corners.map((p) => ({ edge: ++edge, partner: 0, at: p }));
    vertices.forEach((v, i) => {
      const to = vertices[(i + 1) % vertices.length].at;
      const twin = twins.get(`${to}:${v.at}`);
      if (twin) [twin.partner, v.partner] = [v.edge, twin.edge];
      else twins.set(`${v.at}:${to}`, v);
    });
    const [a, b, c] = corners;
    const u = b.map((x, i) => x - a[i]),
      w = c.map((x, i) => x - a[i]);
    const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
    const length = Math.hypot(...n) || 1;
    const normal = n.map((x) => Math.round((x / length) * 2 ** 24));
    polygons.push({
      id: polygons.length + 1,
      count: 100,
      rms: 5,
      normal,
      cycles: [{ hole: false, vertices }],
      offset: Math.round((16 * (n[0] * a[0] + n[1] * a[1] + n[2] * a[2])) / length),
    });
  };
  for (let i = 0; i < rows; ++i)
    for (let j = 0; j < columns; ++j) {
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      if (i > 0) add([a, b, d]);
      if (i < rows - 1) add([b, c, i > 0 ? d : a]);
    }
  const refusals = new Map();
  for (const p of polygons)
    for (const v of p.cycles[0].vertices)
      if (v.partner === 0) refusals.set(v.edge, { code: v.edge % 17, other: 0 });
  encoder.step({ polygons, refusals });
  return container(
    {
      ...kBase,
      kind: "model",
      name,
      resolution: 0.02,
      unit,
      origin: [0, 0, 0],
      steps: 1,
      box: { low: [-1, -1, -1], high: [1, 1, 1] },
    },
    { timeline: encoder.bytes() },
  );
}

/// A run of many steps: patches on a grid, of which each step moves, lengthens or shortens one.
export function long(steps, { patches = 60, name = "long.run" } = {}) {
  const unit = 1e-3,
    next = random(7);
  const encoder = new TimelineEncoder({ intent: true });
  const record = new Record();
  const columns = Math.ceil(Math.sqrt(patches));
  const polygons = [],
    refusals = new Map();
  let edge = 0;
  const path = [],
    count = [],
    sensor = [],
    range = [],
    mode = [],
    clearance = [];
  const grow = (p) => {
    const n = 24 + Math.floor(next() * 24);
    const vertices = Array.from({ length: n }, (_, i) => {
      const radius = 300 + 150 * next(),
        a = (2 * Math.PI * i) / n;
      return {
        edge: ++edge,
        partner: 0,
        at: [p.x + Math.round(radius * Math.cos(a)), p.y + Math.round(radius * Math.sin(a)), 0],
      };
    });
    for (const v of vertices) refusals.set(v.edge, { code: [1, 4, 3, 8, 11][v.edge % 5], other: 0 });
    p.cycles = [{ hole: false, vertices }];
  };
  const all = Array.from({ length: patches }, (_, i) => ({
    id: i + 1,
    count: 3,
    rms: 10,
    normal: [0, 0, 2 ** 24],
    offset: 0,
    x: (i % columns) * 1000,
    y: Math.floor(i / columns) * 1000,
  }));
  for (let s = 1; s <= steps; ++s) {
    const p = all[Math.min(patches - 1, Math.floor(next() * patches * Math.min(1, (4 * s) / steps)))];
    if (!p.cycles) {
      grow(p);
      polygons.push(p);
      record.events.push([s, 0, p.id, 0]);
    } else {
      const at = Math.floor(next() * p.cycles[0].vertices.length);
      const changed = {
        ...p,
        count: p.count + 3,
        cycles: [
          {
            hole: false,
            vertices: p.cycles[0].vertices.map((v, i) => {
              if (i < at || i > at + 2) return v;
              refusals.delete(v.edge);
              const moved = {
                edge: ++edge,
                partner: 0,
                at: v.at.map((x, k) => (k < 2 ? x + Math.round(20 * next() - 10) : x)),
              };
              refusals.set(moved.edge, { code: [1, 4, 3, 8, 11][moved.edge % 5], other: 0 });
              return moved;
            }),
          },
        ],
      };
      polygons[polygons.indexOf(p)] = all[p.id - 1] = changed;
    }
    encoder.step({ polygons, refusals, intent: { targets: [[p.x, p.y, 100]], edge } });
    record.area.push(polygons.length * 0.4);
    record.open.push(polygons.length * 3 + Math.sin(s / 50));
    path.push(p.x * unit, p.y * unit, 0.2);
    count.push(6);
    for (let i = 0; i < 6; ++i) {
      sensor.push(i * 4);
      range.push(0.1);
    }
    mode.push(1 + (Math.floor(s / 97) % 3));
    clearance.push(0.1 + 0.02 * next());
  }
  const size = columns;
  return container(
    {
      ...kBase,
      kind: "run",
      name,
      resolution: 0.05,
      unit,
      origin: [0, 0, 0],
      steps,
      modes: kModes,
      box: { low: [-0.5, -0.5, -0.1], high: [size, size, 0.3] },
      robot: kPointRobot,
      run: {
        strategy: "frontier",
        ended: "interrupted",
        seed: 1,
        sets: steps,
        reasons_every: 1,
        intent: true,
        marks: {},
      },
    },
    {
      timeline: encoder.bytes(),
      ...record.arrays(),
      mode: Uint8Array.from(mode),
      clearance: Float32Array.from(clearance),
      path: Float32Array.from(path),
      joints: Float32Array.from(path),
      reading_count: Uint16Array.from(count),
      reading_sensor: Uint16Array.from(sensor),
      reading_range: Float32Array.from(range),
    },
  );
}

// Copyright the limpet authors. GPL-3.0-or-later.
// Containers made without the program: of a toy run, of invented large models and long runs, of the program's files.
import { existsSync } from "node:fs";
import { basename } from "node:path";
import { TimelineEncoder, container, kEventKinds, kRefusals } from "./encode.mjs";
import { readModel, readRun } from "./files.mjs";

const kBase = { program: "limpet 0.9", angle_deg: 10, noise: [0, 0, 0], tolerance: 0.01, finished: false,
  modes: [], refusals: kRefusals, event_kinds: kEventKinds };

export const kModes = ["none", "extend", "travel", "look again"];

const kPointRobot = {
  name: "point",
  links: ["x", "y", "z", "body"].map((name, i) => ({ name, parent: i - 1, kind: i < 3 ? "prismatic" : "fixed",
    axis: [i === 0 || i === 3 ? 1 : 0, i === 1 ? 1 : 0, i === 2 ? 1 : 0], low: null, high: null,
    mounting: [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0], capsules: [] })),
  control_point: { link: 3, position: [0, 0, 0] },
  sensors: [],
};
for (let x = -1; x <= 1; ++x) for (let y = -1; y <= 1; ++y) for (let z = -1; z <= 1; ++z) {
  const n = Math.hypot(x, y, z);
  if (n > 0) kPointRobot.sensors.push({ link: 3, position: [0, 0, 0], axis: [x / n, y / n, z / n], range: 0.2 });
}

/// An arm of three revolute joints with two sensors at its end.
export const kArm = {
  name: "arm",
  links: [[[0, 0, 1], [0, 0, 0]], [[0, 1, 0], [0, 0, 0.4]], [[0, 1, 0], [0, 0, 0.8]]].map(([axis, at], i) => ({
    name: `link${i}`, parent: i - 1, kind: "revolute", axis, low: -3, high: 3,
    mounting: [1, 0, 0, 0, 1, 0, 0, 0, 1, ...(i === 0 ? [-0.35, -0.35, 0] : at)],
    capsules: [{ a: [0, 0, 0], b: [0, 0, i === 0 ? 0.4 : 0.8 - 0.2 * (i - 1)], radius: 0.08 - 0.02 * i }] })),
  control_point: { link: 2, position: [0, 0, 0.7] },
  sensors: [[0, 0, 1], [0.6, 0, 0.8]].map((axis) => ({ link: 2, position: [0, 0, 0.6], axis, range: 0.4 })),
};

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
  let area = 0, open = 0;
  for (const { cycles, normal } of polygons) for (const { vertices } of cycles) vertices.forEach((v, i) => {
    const a = v.at, b = vertices[(i + 1) % vertices.length].at;
    const cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    area += (cross[0] * normal[0] + cross[1] * normal[1] + cross[2] * normal[2]) / 2 ** 25 * unit * unit;
    if (v.partner === 0) open += Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) * unit;
  });
  return { area, open };
}

/// Events and figures that follow from the difference of one state to the next.
class Record {
  constructor() {
    this.events = [];
    this.area = [];
    this.open = [];
    this.last = { polygons: new Map(), edges: new Map() };
  }
  step(number, state, unit) {
    const polygons = new Map(state.polygons.map((p) => [p.id, p]));
    const edges = new Map(state.polygons.flatMap((p) => p.cycles.flatMap((c) => c.vertices.map((v) =>
      [v.edge, v.partner]))));
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
    return { area: Float32Array.from(this.area), open_length: Float32Array.from(this.open),
      event_step: Uint32Array.from(this.events, (e) => e[0]), event_kind: Uint8Array.from(this.events, (e) => e[1]),
      event_a: Uint32Array.from(this.events, (e) => e[2]), event_b: Uint32Array.from(this.events, (e) => e[3]) };
  }
}

function truthCube() {
  const at = [], triangles = [], lines = [];
  for (let i = 0; i < 8; ++i) at.push(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  for (const [a, b, c, d] of [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]) {
    triangles.push(a, b, c, a, c, d);
  }
  for (let i = 0; i < 8; ++i) for (const bit of [1, 2, 4]) if (!(i & bit)) lines.push(i, i | bit);
  return { truth_position: Float32Array.from(at), truth_triangle: Uint32Array.from(triangles),
    truth_line: Uint32Array.from(lines) };
}

/// A cube whose faces grow polygon by polygon. Names may hold anything.
export function toy({ steps = 60, name = "toy.run", finished = true, robot = true } = {}) {
  const unit = 1 / 1024, lambda = 0.05, size = 1024;
  const encoder = new TimelineEncoder({ intent: true });
  const record = new Record();
  const sets = finished ? steps - 1 : steps;
  const faces = [0, 1, 2, 3, 4, 5].map((f) => {
    const axis = f >> 1, side = f & 1;
    const u = (axis + 1) % 3, v = (axis + 2) % 3;
    return { id: 10 + f, axis, u: side ? u : v, v: side ? v : u, at: side * size, sign: side ? 1 : -1 };
  });
  const path = [], joints = [], mode = [], clearance = [], time = [], count = [], sensor = [], range = [];
  for (let s = 1; s <= steps; ++s) {
    const polygons = [], points = [], refusals = new Map();
    faces.forEach((face, f) => {
      const share = Math.min(1, (s - f * steps / 8) / (steps / 4));
      const place = (a, b) => {
        const p = [0, 0, 0];
        p[face.axis] = face.at;
        p[face.u] = Math.round(a);
        p[face.v] = Math.round(b);
        return p;
      };
      if (share <= 0) return;
      if (share < 0.1) {
        points.push({ id: face.id, at: place(size / 2, size / 2), count: 3 });
        return;
      }
      const half = size / 2 * share;
      const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => place(size / 2 + a * half,
        size / 2 + b * half));
      const vertices = corners.map((at, i) => ({ edge: 100 + f * 10 + i, partner: 0, at }));
      const cycles = [{ hole: false, vertices }];
      if (share < 0.8) {
        const hole = half / 4;
        cycles.push({ hole: true, vertices: [[-1, -1], [-1, 1], [1, 1], [1, -1]].map(([a, b], i) => ({
          edge: 105 + f * 10 + i, partner: 0, at: place(size / 2 + a * hole, size / 2 + b * hole) })) });
      }
      const normal = [0, 0, 0];
      normal[face.axis] = face.sign * 2 ** 24;
      polygons.push({ id: face.id, count: 10 * s, rms: 20 + f, normal, cycles, initial: f === 0,
        offset: 16 * face.at * face.sign, full: share === 1 });
    });
    share(polygons);
    for (const p of polygons) for (const c of p.cycles) for (const v of c.vertices) {
      if (v.partner === 0 && v.edge % 7 !== 0) refusals.set(v.edge, { code: v.edge % 17, other: v.edge % 3 ? 10 : 0 });
    }
    const angle = s / steps * 12;
    const at = [0.5 + 0.9 * Math.cos(angle), 0.5 + 0.9 * Math.sin(angle), 1.1 * s / steps];
    const whole = (p) => p.map((x) => Math.round(x / unit));
    encoder.step({ polygons, points, refusals, intent: s > sets ? null : {
      targets: [[0.5, 0, 0.5], [0.5, 1, 0.4]].map(whole), aim: { target: whole([0.5, 0.5, 1]), place: whole([0.6, 0.5, 1.1]) },
      way: [at, [0.5, 1.3, 1], [0.5, 0.5, 1.2]].map(whole), edge: 100, segment: 10,
      slice: [[0, 0, 0.2], [0, 1, 0.2]].map(whole) } });
    record.step(s, { polygons }, unit);
    time.push(20 + (s * 37) % 11);
    mode.push(s >= sets ? 255 : s % 17 < 11 ? 1 : 2);
    clearance.push(s < 3 ? NaN : 0.2 + 0.1 * Math.sin(s / 3));
    if (s <= sets) {
      path.push(...at);
      joints.push(...at);
      count.push(s % 4 + 1);
      for (let i = 0; i < s % 4 + 1; ++i) {
        sensor.push((s + 5 * i) % 26);
        range.push(0.1 + 0.02 * i);
      }
    }
  }
  record.events.push([5, 6, 103, 1], [20, 7, 10, 11], [25, 1, 10, 99]);
  record.events.sort((a, b) => a[0] - b[0]);
  const head = { ...kBase, kind: "run", name, resolution: lambda, unit, origin: [0, 0, 0], steps, finished,
    box: { low: [-0.4, -0.4, 0], high: [1.4, 1.4, 1.1] }, modes: kModes, truth: { name: "cube" },
    run: { strategy: "frontier", ended: "complete", seed: 1, sets, reasons_every: 1, intent: true,
      marks: { unreachable_segments: [], unreachable_edges: [103], unclosable_edges: [] } } };
  if (robot === "arm") {
    head.robot = kArm;
    joints.forEach((_, i) => { joints[i] = [0.8, 0.3, 0.9][i % 3] + 0.3 * Math.sin(i / 9); });
    sensor.forEach((s, i) => { sensor[i] = s % 2; });
  } else if (robot) head.robot = kPointRobot;
  return container(head, { timeline: encoder.bytes(), ...record.arrays(), ...truthCube(),
    mode: Uint8Array.from(mode), clearance: Float32Array.from(clearance), time_us: Float32Array.from(time),
    path: Float32Array.from(path), joints: Float32Array.from(joints), reading_count: Uint16Array.from(count),
    reading_sensor: Uint16Array.from(sensor), reading_range: Float32Array.from(range) });
}

/// Makes partners of the edges of full faces that lie on each other.
function share(polygons) {
  const ends = new Map();
  for (const p of polygons) {
    if (!p.full) continue;
    const vertices = p.cycles[0].vertices;
    vertices.forEach((v, i) => {
      const to = vertices[(i + 1) % vertices.length].at;
      const twin = ends.get(`${to}:${v.at}`);
      if (twin) {
        twin.partner = v.edge;
        v.partner = twin.edge;
      } else ends.set(`${v.at}:${to}`, v);
    });
  }
}

/// A model of a ball of about so many triangles: as many polygons, closed.
export function ball(triangles, { name = "ball.limpet" } = {}) {
  const unit = 1e-4, rows = Math.max(4, Math.round(Math.sqrt(triangles / 2))), columns = rows;
  const encoder = new TimelineEncoder();
  const at = (i, j) => {
    const a = Math.PI * i / rows, b = 2 * Math.PI * (j % columns) / columns;
    return [Math.sin(a) * Math.cos(b), Math.sin(a) * Math.sin(b), Math.cos(a)].map((x) => Math.round(x / unit));
  };
  const polygons = [], twins = new Map();
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
    const u = b.map((x, i) => x - a[i]), w = c.map((x, i) => x - a[i]);
    const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
    const length = Math.hypot(...n) || 1;
    const normal = n.map((x) => Math.round(x / length * 2 ** 24));
    polygons.push({ id: polygons.length + 1, count: 100, rms: 5, normal, cycles: [{ hole: false, vertices }],
      offset: Math.round(16 * (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / length) });
  };
  for (let i = 0; i < rows; ++i) for (let j = 0; j < columns; ++j) {
    const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
    if (i > 0) add([a, b, d]);
    if (i < rows - 1) add([b, c, i > 0 ? d : a]);
  }
  const refusals = new Map();
  for (const p of polygons) for (const v of p.cycles[0].vertices) if (v.partner === 0) refusals.set(v.edge, { code: v.edge % 17, other: 0 });
  encoder.step({ polygons, refusals });
  return container({ ...kBase, kind: "model", name, resolution: 0.02, unit, origin: [0, 0, 0], steps: 1,
    box: { low: [-1, -1, -1], high: [1, 1, 1] } }, { timeline: encoder.bytes() });
}

/// A run of many steps: patches on a grid, of which each step moves, lengthens or shortens one.
export function long(steps, { patches = 60, name = "long.run" } = {}) {
  const unit = 1e-3, next = random(7);
  const encoder = new TimelineEncoder({ intent: true });
  const record = new Record();
  const columns = Math.ceil(Math.sqrt(patches));
  const polygons = [], refusals = new Map();
  let edge = 0;
  const path = [], count = [], sensor = [], range = [], mode = [], clearance = [];
  const grow = (p) => {
    const n = 24 + Math.floor(next() * 24);
    const vertices = Array.from({ length: n }, (_, i) => {
      const radius = 300 + 150 * next(), a = 2 * Math.PI * i / n;
      return { edge: ++edge, partner: 0, at: [p.x + Math.round(radius * Math.cos(a)), p.y + Math.round(radius * Math.sin(a)), 0] };
    });
    for (const v of vertices) refusals.set(v.edge, { code: [1, 4, 3, 8, 11][v.edge % 5], other: 0 });
    p.cycles = [{ hole: false, vertices }];
  };
  const all = Array.from({ length: patches }, (_, i) => ({ id: i + 1, count: 3, rms: 10, normal: [0, 0, 2 ** 24], offset: 0,
    x: (i % columns) * 1000, y: Math.floor(i / columns) * 1000 }));
  for (let s = 1; s <= steps; ++s) {
    const p = all[Math.min(patches - 1, Math.floor(next() * patches * Math.min(1, 4 * s / steps)))];
    if (!p.cycles) {
      grow(p);
      polygons.push(p);
      record.events.push([s, 0, p.id, 0]);
    } else {
      const at = Math.floor(next() * p.cycles[0].vertices.length);
      const changed = { ...p, count: p.count + 3, cycles: [{ hole: false, vertices: p.cycles[0].vertices.map((v, i) => {
        if (i < at || i > at + 2) return v;
        refusals.delete(v.edge);
        const moved = { edge: ++edge, partner: 0, at: v.at.map((x, k) => (k < 2 ? x + Math.round(20 * next() - 10) : x)) };
        refusals.set(moved.edge, { code: [1, 4, 3, 8, 11][moved.edge % 5], other: 0 });
        return moved;
      }) }] };
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
    mode.push(1 + Math.floor(s / 97) % 3);
    clearance.push(0.1 + 0.02 * next());
  }
  const size = columns;
  return container({ ...kBase, kind: "run", name, resolution: 0.05, unit, origin: [0, 0, 0], steps, modes: kModes,
    box: { low: [-0.5, -0.5, -0.1], high: [size, size, 0.3] }, robot: kPointRobot,
    run: { strategy: "frontier", ended: "interrupted", seed: 1, sets: steps, reasons_every: 1, intent: true, marks: {} } },
  { timeline: encoder.bytes(), ...record.arrays(), mode: Uint8Array.from(mode), clearance: Float32Array.from(clearance),
    path: Float32Array.from(path), joints: Float32Array.from(path), reading_count: Uint16Array.from(count),
    reading_sensor: Uint16Array.from(sensor), reading_range: Float32Array.from(range) });
}

/// A native model file, as a model; reasons of open edges are invented when asked for.
export function model(path) {
  const read = readModel(path);
  const encoder = new TimelineEncoder();
  const { state, box, unit } = whole([read]);
  encoder.step(state(read));
  return container({ ...kBase, kind: "model", name: basename(path), resolution: read.resolution, unit,
    origin: [0, 0, 0], box, steps: 1 }, { timeline: encoder.bytes() });
}

function whole(models, more = []) {
  const low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
  const add = (at) => at.forEach((x, i) => {
    low[i] = Math.min(low[i], x);
    high[i] = Math.max(high[i], x);
  });
  for (const m of models) for (const p of m.polygons) for (const c of p.cycles) for (const v of c.vertices) add(v.at);
  more.forEach(add);
  const unit = models[0].resolution / 4096;
  const round = (at) => at.map((x) => Math.round(x / unit));
  const state = (m) => ({
    points: m.points.map((p) => ({ ...p, at: round(p.at) })),
    polygons: m.polygons.map((p) => ({ id: p.id, count: p.count, rms: 16 * (p.id % 100), initial: p.initial,
      normal: p.normal.map((x) => Math.round(x * 2 ** 24)),
      offset: Math.round(16 / unit * p.normal.reduce((sum, n, i) => sum + n * p.cycles[0].vertices[0].at[i], 0)),
      cycles: p.cycles.map((c) => ({ hole: c.hole, vertices: c.vertices.map((v) => ({ ...v, at: round(v.at) })) })) })),
  });
  return { state, unit, box: { low, high } };
}

/// A recorded run, with models of its replays after every k-th set (`${folder}/${k}.limpet`). Reasons are invented.
export function run(path, folder, every, finalModel) {
  const read = readRun(path);
  const sets = read.sets.length;
  const models = new Map();
  for (let s = every; s <= sets; s += every) {
    if (existsSync(`${folder}/${s}.limpet`)) models.set(s, readModel(`${folder}/${s}.limpet`));
  }
  models.set(sets + 1, readModel(finalModel));
  const { state, box, unit } = whole([...models.values()], read.sets.map((s) => s.place));
  const encoder = new TimelineEncoder({ intent: true });
  const record = new Record();
  const modes = ["none", ...new Set(read.sets.map((s) => s.mode).filter(Boolean))];
  let now = { polygons: [], points: [] };
  for (let s = 1; s <= sets + 1; ++s) {
    if (models.has(s)) now = state(models.get(s));
    const refusals = new Map();
    const open = [];
    for (const p of now.polygons) for (const c of p.cycles) for (const v of c.vertices) if (v.partner === 0) {
      refusals.set(v.edge, { code: [1, 4, 1, 3, 8, 1, 4, 11][Math.floor(v.edge / 3) % 8], other: v.edge % 2 ? p.id : 0 });
      open.push(v);
    }
    const place = read.sets[Math.min(s, sets) - 1].place.map((x) => Math.round(x / unit));
    encoder.step({ ...now, refusals, intent: s > sets || open.length === 0 ? null : {
      targets: open.slice(0, 6).map((v) => v.at), edge: open[0].edge,
      aim: { target: open[0].at, place: place.map((x, i) => x + Math.round((open[0].at[i] - x) / 3)) } } });
    record.step(s, now, unit);
    const mode = modes.indexOf(read.sets[s - 1]?.mode), before = modes.indexOf(read.sets[s - 2]?.mode);
    if (mode > 0 && mode !== before) record.events.push([s, 5, mode, 0]);
  }
  const numbers = (f) => Float32Array.from(read.sets.flatMap(f));
  const modeOf = (s) => (s.mode ? modes.indexOf(s.mode) : 255);
  return container({ ...kBase, kind: "run", name: basename(path), resolution: read.resolution, unit, origin: [0, 0, 0],
    box, steps: sets + 1, finished: true, modes, truth: { name: "cube" },
    run: { strategy: read.strategy, ended: read.ended, seed: read.seed, sets, marks: read.marks, reasons_every: every,
      intent: true },
    robot: { name: read.robot, links: read.links, sensors: read.sensors, control_point: read.controlPoint },
  }, { timeline: encoder.bytes(), ...record.arrays(), ...truthCube(),
    mode: Uint8Array.from([...read.sets.map(modeOf), 255]), path: numbers((s) => s.place),
    joints: numbers((s) => s.joints), reading_count: Uint16Array.from(read.sets, (s) => s.readings.length),
    reading_sensor: Uint16Array.from(read.sets.flatMap((s) => s.readings.map((r) => r.sensor))),
    reading_range: numbers((s) => s.readings.map((r) => r.range)),
    clearance: Float32Array.from([...read.sets, read.sets.at(-1)], (s) => Math.min(...s.readings.map((r) => r.range))) });
}

// Copyright the limpet authors. GPL-3.0-or-later.
// A toy run, whose every number is known.
import { TimelineEncoder, container } from "./encode.mjs";
import { Record, kBase, kModes, kPointRobot, truthCube } from "./parts.mjs";

/// An arm of three revolute joints with two sensors at its end.
export const kArm = {
  name: "arm",
  links: [
    [
      [0, 0, 1],
      [0, 0, 0],
    ],
    [
      [0, 1, 0],
      [0, 0, 0.4],
    ],
    [
      [0, 1, 0],
      [0, 0, 0.8],
    ],
  ].map(([axis, at], i) => ({
    name: `link${i}`,
    parent: i - 1,
    kind: "revolute",
    axis,
    low: -3,
    high: 3,
    mounting: [1, 0, 0, 0, 1, 0, 0, 0, 1, ...(i === 0 ? [-0.35, -0.35, 0] : at)],
    capsules: [{ a: [0, 0, 0], b: [0, 0, i === 0 ? 0.4 : 0.8 - 0.2 * (i - 1)], radius: 0.08 - 0.02 * i }],
  })),
  control_point: { link: 2, position: [0, 0, 0.7] },
  sensors: [
    [0, 0, 1],
    [0.6, 0, 0.8],
  ].map((axis) => ({ link: 2, position: [0, 0, 0.6], axis, range: 0.4 })),
};

/// A cube whose faces grow polygon by polygon. Names may hold anything.
export function toy({ steps = 60, name = "toy.run", finished = true, robot = true } = {}) {
  const unit = 1 / 1024,
    lambda = 0.05,
    size = 1024;
  const encoder = new TimelineEncoder({ intent: true });
  const record = new Record();
  const sets = finished ? steps - 1 : steps;
  const faces = [0, 1, 2, 3, 4, 5].map((f) => {
    const axis = f >> 1,
      side = f & 1;
    const u = (axis + 1) % 3,
      v = (axis + 2) % 3;
    return { id: 10 + f, axis, u: side ? u : v, v: side ? v : u, at: side * size, sign: side ? 1 : -1 };
  });
  const path = [],
    joints = [],
    mode = [],
    clearance = [],
    time = [],
    count = [],
    sensor = [],
    range = [];
  for (let s = 1; s <= steps; ++s) {
    const polygons = [],
      points = [],
      refusals = new Map();
    faces.forEach((face, f) => {
      const share = Math.min(1, (s - (f * steps) / 8) / (steps / 4));
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
      const half = (size / 2) * share;
      const corners = [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ].map(([a, b]) => place(size / 2 + a * half, size / 2 + b * half));
      const vertices = corners.map((at, i) => ({ edge: 100 + f * 10 + i, partner: 0, at }));
      const cycles = [{ hole: false, vertices }];
      if (share < 0.8) {
        const hole = half / 4;
        cycles.push({
          hole: true,
          vertices: [
            [-1, -1],
            [-1, 1],
            [1, 1],
            [1, -1],
          ].map(([a, b], i) => ({
            edge: 105 + f * 10 + i,
            partner: 0,
            at: place(size / 2 + a * hole, size / 2 + b * hole),
          })),
        });
      }
      const normal = [0, 0, 0];
      normal[face.axis] = face.sign * 2 ** 24;
      polygons.push({
        id: face.id,
        count: 10 * s,
        rms: 20 + f,
        normal,
        cycles,
        initial: f === 0,
        offset: 16 * face.at * face.sign,
        full: share === 1,
      });
    });
    share(polygons);
    for (const p of polygons)
      for (const c of p.cycles)
        for (const v of c.vertices) {
          if (v.partner === 0 && v.edge % 7 !== 0)
            refusals.set(v.edge, { code: v.edge % 17, other: v.edge % 3 ? 10 : 0 });
        }
    const angle = (s / steps) * 12;
    const at = [0.5 + 0.9 * Math.cos(angle), 0.5 + 0.9 * Math.sin(angle), (1.1 * s) / steps];
    const whole = (p) => p.map((x) => Math.round(x / unit));
    encoder.step({
      polygons,
      points,
      refusals,
      intent:
        s > sets
          ? null
          : {
              targets: [
                [0.5, 0, 0.5],
                [0.5, 1, 0.4],
              ].map(whole),
              aim: { target: whole([0.5, 0.5, 1]), place: whole([0.6, 0.5, 1.1]) },
              way: [at, [0.5, 1.3, 1], [0.5, 0.5, 1.2]].map(whole),
              edge: 100,
              segment: 10,
              slice: [
                [0, 0, 0.2],
                [0, 1, 0.2],
              ].map(whole),
            },
    });
    record.step(s, { polygons }, unit);
    time.push(20 + ((s * 37) % 11));
    mode.push(s >= sets ? 255 : s % 17 < 11 ? 1 : 2);
    clearance.push(s < 3 ? NaN : 0.2 + 0.1 * Math.sin(s / 3));
    if (s <= sets) {
      path.push(...at);
      joints.push(...at);
      count.push((s % 4) + 1);
      for (let i = 0; i < (s % 4) + 1; ++i) {
        sensor.push((s + 5 * i) % 26);
        range.push(0.1 + 0.02 * i);
      }
    }
  }
  record.events.push([5, 6, 103, 1], [20, 7, 10, 11], [25, 1, 10, 99]);
  record.events.sort((a, b) => a[0] - b[0]);
  const head = {
    ...kBase,
    kind: "run",
    name,
    resolution: lambda,
    unit,
    origin: [0, 0, 0],
    steps,
    finished,
    box: { low: [-0.4, -0.4, 0], high: [1.4, 1.4, 1.1] },
    modes: kModes,
    truth: { name: "cube" },
    run: {
      strategy: "frontier",
      ended: "complete",
      seed: 1,
      sets,
      reasons_every: 1,
      intent: true,
      marks: { unreachable_segments: [], unreachable_edges: [103], unclosable_edges: [] },
    },
  };
  if (robot === "arm") {
    head.robot = kArm;
    joints.forEach((_, i) => {
      joints[i] = [0.8, 0.3, 0.9][i % 3] + 0.3 * Math.sin(i / 9);
    });
    sensor.forEach((s, i) => {
      sensor[i] = s % 2;
    });
  } else if (robot) head.robot = kPointRobot;
  return container(head, {
    timeline: encoder.bytes(),
    ...record.arrays(),
    ...truthCube(),
    mode: Uint8Array.from(mode),
    clearance: Float32Array.from(clearance),
    time_us: Float32Array.from(time),
    path: Float32Array.from(path),
    joints: Float32Array.from(joints),
    reading_count: Uint16Array.from(count),
    reading_sensor: Uint16Array.from(sensor),
    reading_range: Float32Array.from(range),
  });
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

// Copyright the limpet authors. GPL-3.0-or-later.
// Containers of the program's files, without the command view: reasons and aims are invented.
import { existsSync } from "node:fs";
import { basename } from "node:path";
import { TimelineEncoder, container } from "./encode.mjs";
import { readModel, readRun } from "./files.mjs";
import { Record, kBase, truthCube } from "./parts.mjs";

/// A native model file, as a model; reasons of open edges are invented when asked for.
export function model(path) {
  const read = readModel(path);
  const encoder = new TimelineEncoder();
  const { state, box, unit } = whole([read]);
  encoder.step(state(read));
  return container(
    {
      ...kBase,
      kind: "model",
      name: basename(path),
      resolution: read.resolution,
      unit,
      origin: [0, 0, 0],
      box,
      steps: 1,
    },
    { timeline: encoder.bytes() },
  );
}

function whole(models, more = []) {
  const low = [Infinity, Infinity, Infinity],
    high = low.map((x) => -x);
  const add = (at) =>
    at.forEach((x, i) => {
      low[i] = Math.min(low[i], x);
      high[i] = Math.max(high[i], x);
    });
  for (const m of models)
    for (const p of m.polygons) for (const c of p.cycles) for (const v of c.vertices) add(v.at);
  more.forEach(add);
  const unit = models[0].resolution / 4096;
  const round = (at) => at.map((x) => Math.round(x / unit));
  const state = (m) => ({
    points: m.points.map((p) => ({ ...p, at: round(p.at) })),
    polygons: m.polygons.map((p) => ({
      id: p.id,
      count: p.count,
      rms: 16 * (p.id % 100),
      initial: p.initial,
      normal: p.normal.map((x) => Math.round(x * 2 ** 24)),
      offset: Math.round(
        (16 / unit) * p.normal.reduce((sum, n, i) => sum + n * p.cycles[0].vertices[0].at[i], 0),
      ),
      cycles: p.cycles.map((c) => ({
        hole: c.hole,
        vertices: c.vertices.map((v) => ({ ...v, at: round(v.at) })),
      })),
    })),
  });
  return { state, unit, box: { low, high } };
}

/// A recorded run, with models of its replays after every k-th set (`${folder}/${k}.limpet`). Reasons are
/// invented.
export function run(path, folder, every, finalModel) {
  const read = readRun(path);
  const sets = read.sets.length;
  const models = new Map();
  for (let s = every; s <= sets; s += every) {
    if (existsSync(`${folder}/${s}.limpet`)) models.set(s, readModel(`${folder}/${s}.limpet`));
  }
  models.set(sets + 1, readModel(finalModel));
  const { state, box, unit } = whole(
    [...models.values()],
    read.sets.map((s) => s.place),
  );
  const encoder = new TimelineEncoder({ intent: true });
  const record = new Record();
  const modes = ["none", ...new Set(read.sets.map((s) => s.mode).filter(Boolean))];
  let now = { polygons: [], points: [] };
  for (let s = 1; s <= sets + 1; ++s) {
    if (models.has(s)) now = state(models.get(s));
    const refusals = new Map();
    const open = [];
    for (const p of now.polygons)
      for (const c of p.cycles)
        for (const v of c.vertices)
          if (v.partner === 0) {
            refusals.set(v.edge, {
              code: [1, 4, 1, 3, 8, 1, 4, 11][Math.floor(v.edge / 3) % 8],
              other: v.edge % 2 ? p.id : 0,
            });
            open.push(v);
          }
    const place = read.sets[Math.min(s, sets) - 1].place.map((x) => Math.round(x / unit));
    encoder.step({
      ...now,
      refusals,
      intent:
        s > sets || open.length === 0
          ? null
          : {
              targets: open.slice(0, 6).map((v) => v.at),
              edge: open[0].edge,
              aim: {
                target: open[0].at,
                place: place.map((x, i) => x + Math.round((open[0].at[i] - x) / 3)),
              },
            },
    });
    record.step(s, now, unit);
    const mode = modes.indexOf(read.sets[s - 1]?.mode),
      before = modes.indexOf(read.sets[s - 2]?.mode);
    if (mode > 0 && mode !== before) record.events.push([s, 5, mode, 0]);
  }
  const numbers = (f) => Float32Array.from(read.sets.flatMap(f));
  const modeOf = (s) => (s.mode ? modes.indexOf(s.mode) : 255);
  return container(
    {
      ...kBase,
      kind: "run",
      name: basename(path),
      resolution: read.resolution,
      unit,
      origin: [0, 0, 0],
      box,
      steps: sets + 1,
      finished: true,
      modes,
      truth: { name: "cube" },
      run: {
        strategy: read.strategy,
        ended: read.ended,
        seed: read.seed,
        sets,
        marks: read.marks,
        reasons_every: every,
        intent: true,
      },
      robot: { name: read.robot, links: read.links, sensors: read.sensors, control_point: read.controlPoint },
    },
    {
      timeline: encoder.bytes(),
      ...record.arrays(),
      ...truthCube(),
      mode: Uint8Array.from([...read.sets.map(modeOf), 255]),
      path: numbers((s) => s.place),
      joints: numbers((s) => s.joints),
      reading_count: Uint16Array.from(read.sets, (s) => s.readings.length),
      reading_sensor: Uint16Array.from(read.sets.flatMap((s) => s.readings.map((r) => r.sensor))),
      reading_range: numbers((s) => s.readings.map((r) => r.range)),
      clearance: Float32Array.from([...read.sets, read.sets.at(-1)], (s) =>
        Math.min(...s.readings.map((r) => r.range)),
      ),
    },
  );
}

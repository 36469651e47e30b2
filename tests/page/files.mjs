// Copyright the limpet authors. GPL-3.0-or-later.
// Readers of the program's text files, and what can be told of them: docs/native_format.md,
// docs/run_format.md.
import { readFileSync } from "node:fs";

/// {resolution, noise, tolerance, polygons: [{id, count, initial, normal, cycles: [{hole, vertices: [{edge,
/// partner, at}]}]}], points: [{id, at, count}]}, places in the world.
export function readModel(path) {
  const lines = readFileSync(path, "utf8")
    .split("\n")
    .filter((line) => !line.startsWith("#"));
  const model = { noise: [0, 0, 0], polygons: [], points: [], angle: 0, tolerance: 0 };
  let polygon = null,
    step = 1;
  for (let at = 0; at < lines.length; ++at) {
    const [word, ...rest] = lines[at].split(" ");
    const numbers = rest.map(Number);
    if (word === "resolution") model.resolution = numbers[0];
    else if (word === "angle") model.angle = numbers[0];
    else if (word === "noise") model.noise = [numbers[0], 0, 0];
    else if (word === "tolerance") model.tolerance = numbers[0];
    else if (word === "grid") step = numbers[0];
    else if (word === "point") {
      const [id, count, ...sums] = numbers;
      model.points.push({ id, count, at: [0, 1, 2].map((i) => (sums[i] / count) * step) });
      polygon = null;
    } else if (word === "polygon") {
      polygon = {
        id: numbers[0],
        count: numbers[1],
        rms: 0,
        initial: false,
        cycles: [],
        sums: numbers.slice(2, 11),
      };
      model.polygons.push(polygon);
    } else if (word === "chart") {
      polygon.chart = [0, 1, 2, 3].map((i) => numbers.slice(3 * i, 3 * i + 3));
    } else if (word === "height") {
      polygon.height = numbers;
      const [, u, v, n] = polygon.chart;
      const normal = [0, 1, 2].map((i) => n[i] - numbers[1] * u[i] - numbers[2] * v[i]);
      const length = Math.hypot(...normal);
      polygon.normal = normal.map((x) => x / length);
    } else if (word === "initial") polygon.initial = polygon.count === 0;
    else if (word === "cycle") {
      const vertices = [];
      const [o, u, v, n] = polygon.chart;
      const [h0, hx, hy] = polygon.height;
      for (let i = 0; i < numbers[0]; ++i) {
        const [x, y, edge, partner] = lines[++at].split(" ").map(Number);
        const h = h0 + hx * x + hy * y;
        vertices.push({
          edge,
          partner,
          at: [0, 1, 2].map((k) => o[k] + step * (x * u[k] + y * v[k] + h * n[k])),
        });
      }
      polygon.cycles.push({ hole: polygon.cycles.length > 0, vertices });
    } else if (word === "raw") at += numbers[0];
  }
  return model;
}

/// {head: [lines], sets: [{line, mode, joints, place, readings}], marks, links, sensors, …} of a recorded
/// run.
export function readRun(path) {
  const lines = readFileSync(path, "utf8").split("\n");
  const run = { head: [], sets: [], links: [], sensors: [], marks: {}, ended: "interrupted", seed: 1 };
  for (const line of lines) {
    const [word, ...f] = line.split(" ");
    if (word === "set") {
      run.sets.push(readSet(line, run));
      continue;
    }
    if (run.sets.length === 0) run.head.push(line);
    if (word === "resolution") run.resolution = real(f[0]);
    else if (word === "angle") run.angle = real(f[0]);
    else if (word === "noise") run.noise = f.map(real);
    else if (word === "tolerance") run.tolerance = real(f[0]);
    else if (word === "seed") run.seed = Number(f[0]);
    else if (word === "strategy") run.strategy = f[0];
    else if (word === "robot") run.robot = f[0];
    else if (word === "link") {
      const n = f.slice(3, 20).map(real);
      const m = n.slice(5);
      run.links.push({
        name: f[0],
        parent: f[1] === "-" ? -1 : Number(f[1]),
        kind: f[2],
        axis: n.slice(0, 3),
        low: Number.isFinite(n[3]) ? n[3] : null,
        high: Number.isFinite(n[4]) ? n[4] : null,
        mounting: [0, 1, 2, 4, 5, 6, 8, 9, 10, 3, 7, 11].map((i) => m[i]),
        capsules: [],
      });
    } else if (word === "capsule") {
      const n = f.map(real);
      run.links.at(-1).capsules.push({ a: n.slice(0, 3), b: n.slice(3, 6), radius: n[6] });
    } else if (word === "control_point")
      run.controlPoint = { link: Number(f[0]), position: f.slice(1, 4).map(real) };
    else if (word === "sensor") {
      const n = f.map(real);
      run.sensors.push({ link: n[0], position: n.slice(1, 4), axis: n.slice(4, 7), range: n[7] });
    } else if (word.startsWith("un")) run.marks[word] = f.slice(1).map(Number);
    else if (word === "end") run.ended = f[0];
  }
  return run;
}

function readSet(line, run) {
  const f = line.split(" ");
  const moving = run.links.filter((link) => link.kind !== "fixed").length;
  const joints = f.slice(2, 2 + moving).map(real);
  const place = f.slice(2 + moving, 5 + moving).map(real);
  const readings = [];
  for (let i = 6 + moving; i < f.length; i += 2) {
    const reading = { sensor: Number(f[i]), range: real(f[i + 1]) };
    if (f[i + 2] === "at") {
      reading.at = f.slice(i + 3, i + 6).map(real);
      i += 4;
    }
    readings.push(reading);
  }
  return { line, mode: f[1] === "-" ? null : f[1].replaceAll("_", " "), joints, place, readings };
}

/// The text of a run that ends after its first `sets` sets.
export function cutRun(run, sets) {
  return [
    ...run.head,
    ...run.sets.slice(0, sets).map((set) => set.line),
    "unreachable_segments 0",
    "unreachable_edges 0",
    "unclosable_edges 0",
    `end interrupted ${sets} -`,
    "",
  ].join("\n");
}

/// A real number of a run file: hexadecimal as in C, or decimal.
export function real(text) {
  const match = /^(-?)0x([0-9a-f]+)(?:\.([0-9a-f]*))?p([+-]?\d+)$/i.exec(text);
  if (!match) return text === "inf" ? Infinity : text === "-inf" ? -Infinity : Number(text);
  const [, sign, whole, fraction = "", exponent] = match;
  let value = parseInt(whole, 16);
  for (let i = 0; i < fraction.length; ++i) value += parseInt(fraction[i], 16) / 16 ** (i + 1);
  return (sign ? -1 : 1) * value * 2 ** Number(exponent);
}

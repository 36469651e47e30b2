// Copyright the limpet authors. GPL-3.0-or-later.
// The decoder against the encoder, on random timelines. SEED repeats one.
import test from "node:test";
import assert from "node:assert/strict";
import { TimelineEncoder, container } from "./encode.mjs";
import { random } from "./parts.mjs";
import { toy } from "./toy.mjs";
import { Timeline } from "../../drawing/page/source/timeline.js";
import { parseContainer } from "../../drawing/page/source/container.js";

const seed = Number(process.env.SEED ?? Math.floor(Math.random() * 1e9));

/// Random states, each made from the one before by small changes: outlines that lose, gain, move and rotate
/// vertices.
function* states(next, steps) {
  const below = (n) => Math.floor(next() * n);
  let edge = 1,
    segment = 1;
  const big = () => (next() < 0.05 ? below(2 ** 48) : below(5000)) - 2000;
  const at = () => [big(), big(), big()];
  const vertex = () => ({ edge: (edge += 1 + below(next() < 0.01 ? 2 ** 40 : 3)), partner: 0, at: at() });
  const cycle = (hole) => ({ hole, vertices: Array.from({ length: 3 + below(40) }, vertex) });
  const polygon = (id) => ({
    id,
    count: below(1e6),
    rms: below(1000),
    normal: at(),
    offset: big(),
    initial: next() < 0.1,
    cycles: [cycle(false), ...(next() < 0.3 ? [cycle(true)] : [])],
  });
  let now = { polygons: [], points: [], refusals: new Map(), intent: null };
  for (let s = 0; s < steps; ++s) {
    let { polygons, points } = structuredClone(now);
    polygons = polygons.filter(() => next() > 0.03);
    points = points.filter((p) => {
      if (next() < 0.1) return polygons.push(polygon(p.id)) < 0;
      return next() > 0.1;
    });
    if (next() < 0.5) points.push({ id: (segment += 1 + below(3)), at: at(), count: 1 + below(9) });
    if (next() < 0.2) polygons.push(polygon((segment += 1 + below(3))));
    for (const p of points) if (next() < 0.2) [p.at, p.count] = [at(), p.count + 1];
    for (const p of polygons) {
      if (next() < 0.7) continue;
      if (next() < 0.5) [p.count, p.rms] = [p.count + 1, below(100)];
      if (next() < 0.5) [p.normal, p.offset] = [at(), big()];
      if (next() < 0.2) p.cycles = [p.cycles[0], ...(next() < 0.5 ? [cycle(true)] : [])];
      const { vertices } = p.cycles[below(p.cycles.length)];
      const change = below(5);
      if (change === 0) vertices.splice(below(vertices.length), 0, vertex(), vertex());
      if (change === 1 && vertices.length > 5) vertices.splice(below(vertices.length - 2), 2);
      if (change === 2) vertices.unshift(...vertices.splice(below(vertices.length)));
      if (change === 3) vertices[below(vertices.length)].at = at();
      if (change === 4) vertices[below(vertices.length)].partner = next() < 0.3 ? 0 : 1 + below(edge);
    }
    const open = polygons.flatMap((p) => p.cycles.flatMap((c) => c.vertices.filter((v) => v.partner === 0)));
    const refusals = new Map(
      open.filter((v) => v.edge % 4).map((v) => [v.edge, { code: below(17), other: below(99) }]),
    );
    const places = () => Array.from({ length: below(5) }, at);
    const intent =
      next() < 0.3
        ? null
        : {
            targets: places(),
            aim: { target: at(), place: at() },
            way: places(),
            edge: 1 + below(99),
            segment: 1 + below(99),
            slice: places(),
          };
    now = { polygons, points, refusals, intent };
    yield now;
  }
}

/// A state as the test's own, plain data, to be compared.
const plain = (state) => ({
  polygons: [...state.polygons.values()]
    .sort((a, b) => a.id - b.id)
    .map((p) => ({
      id: p.id,
      count: p.count,
      rms: p.rms * 16,
      initial: p.initial,
      normal: p.normal.map((x) => x * 2 ** 24),
      offset: p.offset * 16,
      cycles: p.cycles.map((c) => ({
        hole: c.hole,
        vertices: Array.from(c.edges, (edge, i) => ({
          edge,
          partner: c.partners[i],
          at: [...c.positions.subarray(3 * i, 3 * i + 3)],
        })),
      })),
    })),
  points: [...state.points.values()]
    .sort((a, b) => a.id - b.id)
    .map((p) => ({ id: p.id, at: p.position, count: p.count })),
  refusals: [...state.refusals]
    .sort((a, b) => a[0] - b[0])
    .map(([edge, { code, other }]) => ({ edge, code, other })),
});
const expected = (s) => ({
  polygons: s.polygons.toSorted((a, b) => a.id - b.id),
  points: s.points.toSorted((a, b) => a.id - b.id),
  refusals: [...s.refusals]
    .sort((a, b) => a[0] - b[0])
    .map(([edge, { code, other }]) => ({ edge, code, other })),
});

test(`what was encoded is decoded, in any order of steps (SEED=${seed})`, async () => {
  const next = random(seed);
  for (let round = 0; round < 5; ++round) {
    const steps = 150;
    const encoder = new TimelineEncoder({ intent: true });
    const all = [...states(next, steps)];
    all.forEach((state) => encoder.step(state));
    const { head, arrays } = parseContainer(
      container({ steps, unit: 1, kind: "run", run: { intent: true } }, { timeline: encoder.bytes() }),
    );
    const timeline = new Timeline(head, arrays);
    if (round % 2) await timeline.index();
    for (let i = 0; i < 60; ++i) {
      const step = 1 + Math.floor(next() * steps);
      const state = timeline.seek(step);
      assert.equal(state.step, step);
      assert.deepEqual(plain(state), expected(all[step - 1]));
      const { intent } = all[step - 1];
      assert.deepEqual(state.intent && [...state.intent.way], intent && intent.way.flat());
      assert.deepEqual(state.intent?.aim, intent?.aim);
      const edges = new Map(
        all[step - 1].polygons.flatMap((p) =>
          p.cycles.flatMap((c) => c.vertices.map((v) => [v.edge, [p.id, v.partner]])),
        ),
      );
      assert.deepEqual(
        new Map([...state.edges].map(([e, { segment, partner }]) => [e, [segment, partner]])),
        edges,
      );
    }
  }
});

test("since when an edge is open or shared", () => {
  const { head, arrays } = parseContainer(toy());
  const timeline = new Timeline(head, arrays);
  const born = new Map(),
    since = new Map();
  let last = new Map();
  for (let s = 1; s <= head.steps; ++s) {
    const { edges } = timeline.seek(s);
    for (const [id, { partner }] of edges) {
      if (!last.has(id)) born.set(id, s);
      if (!last.has(id) || last.get(id) !== partner) since.set(id, s);
    }
    last = new Map([...edges].map(([id, { partner }]) => [id, partner]));
  }
  const { edges } = timeline.seek(head.steps);
  assert.equal(edges.size, 24);
  for (const [id, edge] of edges) {
    assert.equal(edge.born, born.get(id));
    assert.equal(edge.since, since.get(id));
    assert.equal(edges.get(edge.partner).partner, id);
  }
});

test("a damaged timeline is refused, not shown", () => {
  const { head, arrays } = parseContainer(toy());
  const cut = new Timeline(head, { timeline: arrays.timeline.subarray(0, arrays.timeline.length - 40) });
  assert.throws(() => cut.seek(head.steps), RangeError);
  assert.throws(() => parseContainer(new Uint8Array(64)), /no data/);
});

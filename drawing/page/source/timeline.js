// Copyright the limpet authors. GPL-3.0-or-later.
// The model at any step: a stream of changes is decoded forwards; snapshots make ways back short.
import { VarintReader } from "./varint.js";
import { kNoOutline, readOutline } from "./outline.js";
import { readIntent } from "./intent.js";

const kFigures = 1,
  kPlane = 2,
  kOutline = 4,
  kInitial = 8; // flags of a polygon
const kNotKnown = 17; // code of a refusal that holds no longer
const kMostSnapshots = 512;
const kMostEntries = 3e6; // of all snapshots' maps

class Polygon {
  constructor(id, count, rms, normal, offset, outline, initial, born, changed) {
    Object.assign(this, { id, count, rms, normal, offset, outline, initial, born, changed });
  }
  get cycles() {
    return this.outline.cycles;
  }
}

/// What seek() returns is alive: the next seek() changes its maps. The records in them never change.
///   polygons: id → {id, count, rms, initial, normal, offset, outline, cycles, born, changed}
///   points:   id → {id, count, position, born, changed}
///   edges:    id → {segment, partner, born, since}   since: the step at which it got this partner, or became
/// open
///   refusals: open edge → {code, other, since}
export class Timeline {
  constructor(head, arrays) {
    this.steps = head.steps;
    this.unit = head.unit;
    this.hasIntent = head.kind === "run" && head.run?.intent === true;
    this.bytes = arrays.timeline;
    this.spacing = 32; // steps from one snapshot to the next: a power of two
    while ((this.spacing * kMostSnapshots) / 2 < head.steps) this.spacing *= 2;
    this.snapshots = [];
    this.entries = 0;
    this.indexed = 0; // last step that was ever decoded
    this.version = 0;
    this.state = {
      step: 0,
      version: 0,
      polygons: new Map(),
      points: new Map(),
      edges: new Map(),
      refusals: new Map(),
      intent: null,
    };
    this.reader = new VarintReader(this.bytes);
    this.#keep();
  }

  /// The state after `step`, from 1 on.
  seek(step) {
    const to = Math.min(Math.max(Math.round(step) || 1, 1), this.steps);
    if (to === this.state.step) return this.state;
    const nearest = this.#snapshotBefore(to);
    if (to < this.state.step || nearest.step > this.state.step) this.#restore(nearest);
    while (this.state.step < to) this.#decodeStep();
    this.state.version = ++this.version;
    return this.state;
  }

  /// Decodes to the end in slices, so that the page stays responsive; reports the share that is done.
  async index(report = () => {}, sliceMs = 40) {
    let slice = performance.now();
    while (this.state.step < this.steps) {
      this.#decodeStep();
      if (this.state.step % 16 === 0 && performance.now() - slice > sliceMs) {
        report(this.state.step / this.steps);
        await new Promise((resolve) => setTimeout(resolve, 0));
        slice = performance.now();
      }
    }
    this.state.version = ++this.version;
  }

  #snapshotBefore(step) {
    let low = 0,
      high = this.snapshots.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.snapshots[middle].step <= step) low = middle;
      else high = middle - 1;
    }
    return this.snapshots[low];
  }

  #restore(snapshot) {
    const state = this.state;
    state.step = snapshot.step;
    state.polygons = new Map(snapshot.polygons);
    state.points = new Map(snapshot.points);
    state.edges = new Map(snapshot.edges);
    state.refusals = new Map(snapshot.refusals);
    state.intent = snapshot.intent;
    this.reader.at = snapshot.at;
  }

  #keep() {
    const { step, polygons, points, edges, refusals, intent } = this.state;
    this.snapshots.push({
      step,
      at: this.reader.at,
      polygons: new Map(polygons),
      points: new Map(points),
      edges: new Map(edges),
      refusals: new Map(refusals),
      intent,
    });
    this.entries += polygons.size + points.size + edges.size + refusals.size;
    if (this.snapshots.length <= kMostSnapshots && this.entries <= kMostEntries) return;
    this.spacing *= 2;
    this.snapshots = this.snapshots.filter((snapshot) => snapshot.step % this.spacing === 0);
    this.entries = this.snapshots.reduce(
      (sum, snapshot) =>
        sum + snapshot.polygons.size + snapshot.points.size + snapshot.edges.size + snapshot.refusals.size,
      0,
    );
  }

  #decodeStep() {
    const { reader, state } = this;
    const { polygons, points, edges, refusals } = state;
    const step = ++state.step;
    const gone = []; // pairs: edge, segment it was of
    const touched = new Set(); // edges that their polygon had before and wrote anew

    let id = 0;
    for (let n = reader.unsigned(); n > 0; --n) {
      id += reader.unsigned();
      points.delete(id);
      const polygon = polygons.get(id);
      if (!polygon) continue;
      polygons.delete(id);
      for (const edge of polygon.outline.edges) gone.push(edge, id);
    }

    id = 0;
    for (let n = reader.unsigned(); n > 0; --n) {
      id += reader.unsigned();
      const last = points.get(id);
      const position = [0, 1, 2].map((axis) => (last ? last.position[axis] : 0) + reader.signed());
      points.set(id, { id, position, count: reader.unsigned(), born: last?.born ?? step, changed: step });
    }

    id = 0;
    for (let n = reader.unsigned(); n > 0; --n) {
      id += reader.unsigned();
      const segment = id;
      const last = polygons.get(segment);
      const polygon = this.#readPolygon(
        segment,
        last,
        step,
        (edge, partner) => {
          if (last) touched.add(edge);
          const was = edges.get(edge);
          if (!was) edges.set(edge, { segment, partner, born: step, since: step });
          else if (was.segment !== segment || was.partner !== partner) {
            edges.set(edge, {
              segment,
              partner,
              born: was.born,
              since: was.partner === partner ? was.since : step,
            });
          }
          if (partner) refusals.delete(edge);
        },
        (edge) => gone.push(edge, segment),
      );
      points.delete(segment);
      polygons.set(segment, polygon);
    }
    for (let i = 0; i < gone.length; i += 2) {
      if (touched.has(gone[i]) || edges.get(gone[i])?.segment !== gone[i + 1]) continue;
      edges.delete(gone[i]);
      refusals.delete(gone[i]);
    }

    let edge = 0;
    for (let n = reader.unsigned(); n > 0; --n) {
      edge += reader.unsigned();
      const code = reader.unsigned();
      const other = reader.unsigned();
      const was = refusals.get(edge);
      if (code === kNotKnown) refusals.delete(edge);
      else refusals.set(edge, { code, other, since: was?.code === code ? was.since : step });
    }
    state.intent = this.hasIntent ? readIntent(reader) : null;

    if (reader.at > this.bytes.length) throw new RangeError(`the timeline ends within step ${step}`);
    if (step > this.indexed) {
      this.indexed = step;
      if (step % this.spacing === 0) this.#keep();
    }
  }

  #readPolygon(id, last, step, written, dropped) {
    const { reader } = this;
    const flags = reader.unsigned();
    let { count, rms, normal, offset, outline } = last ?? {
      count: 0,
      rms: 0,
      normal: [0, 0, 1],
      offset: 0,
      outline: kNoOutline,
    };
    if (flags & kFigures) {
      count = reader.unsigned();
      rms = (reader.unsigned() / 16) * this.unit;
    }
    if (flags & kPlane) {
      normal = [reader.signed() / 2 ** 24, reader.signed() / 2 ** 24, reader.signed() / 2 ** 24];
      offset = (reader.signed() / 16) * this.unit;
    }
    if (flags & kOutline) outline = readOutline(reader, outline, written, dropped);
    return new Polygon(
      id,
      count,
      rms,
      normal,
      offset,
      outline,
      (flags & kInitial) !== 0,
      last?.born ?? step,
      step,
    );
  }
}

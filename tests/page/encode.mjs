// Copyright the limpet authors. GPL-3.0-or-later.
// An encoder of the timeline stream, the counterpart of drawing/page/source/timeline.js: for tests, and for
// pages of invented models. The program has its own.

export class VarintWriter {
  constructor() {
    this.bytes = new Uint8Array(1 << 16);
    this.size = 0;
  }
  unsigned(value) {
    if (!(value >= 0)) throw new Error(`not unsigned: ${value}`);
    if (this.size + 10 > this.bytes.length) {
      const larger = new Uint8Array(2 * this.bytes.length);
      larger.set(this.bytes);
      this.bytes = larger;
    }
    while (value >= 128) {
      this.bytes[this.size++] = (value % 128) + 128;
      value = Math.floor(value / 128);
    }
    this.bytes[this.size++] = value;
  }
  signed(value) {
    this.unsigned(zigzag(value));
  }
}

const zigzag = (value) => (value < 0 ? -2 * value - 1 : 2 * value);

const same = (a, b) => a.edge === b.edge && a.partner === b.partner && a.at.every((v, i) => v === b.at[i]);

/// Encodes steps of whole states one after the other:
///   {polygons: [{id, count, rms, normal, offset, initial, cycles: [{hole, vertices: [{edge, partner,
/// at}]}]}],
///    points: [{id, at, count}], refusals: Map edge → {code, other}, intent}
/// with whole numbers throughout (rms and offset in u/16, normal times 2^24).
export class TimelineEncoder {
  constructor({ intent = false } = {}) {
    this.writer = new VarintWriter();
    this.intent = intent;
    this.polygons = new Map();
    this.points = new Map();
    this.refusals = new Map();
    this.steps = 0;
  }

  step(state) {
    const w = this.writer;
    ++this.steps;
    const polygons = new Map([...state.polygons].sort((a, b) => a.id - b.id).map((p) => [p.id, p]));
    const points = new Map([...(state.points ?? [])].sort((a, b) => a.id - b.id).map((p) => [p.id, p]));

    const gone = [...this.polygons.keys(), ...this.points.keys()].filter(
      (id) => !polygons.has(id) && !points.has(id),
    );
    this.#list(
      gone.sort((a, b) => a - b),
      (id) => id,
      () => {},
    );

    const changedPoints = [...points.values()].filter((p) => {
      const last = this.points.get(p.id);
      return !last || last.count !== p.count || last.at.some((v, i) => v !== p.at[i]);
    });
    this.#list(
      changedPoints,
      (p) => p.id,
      (p) => {
        const last = this.points.get(p.id)?.at ?? [0, 0, 0];
        p.at.forEach((v, i) => w.signed(v - last[i]));
        w.unsigned(p.count);
      },
    );

    const changed = [...polygons.values()]
      .map((p) => [p, this.#flags(p)])
      .filter(
        ([p, flags]) =>
          (flags & 7) !== 0 || (this.polygons.get(p.id).initial ?? false) !== (p.initial ?? false),
      );
    this.#list(
      changed,
      ([p]) => p.id,
      ([p, flags]) => this.#polygon(p, flags),
    );

    const refusals = state.refusals ?? new Map();
    const told = [];
    for (const [edge, { code, other }] of refusals) {
      const last = this.refusals.get(edge);
      if (!last || last.code !== code || last.other !== other) told.push([edge, code, other]);
    }
    for (const edge of this.refusals.keys()) if (!refusals.has(edge)) told.push([edge, 17, 0]);
    this.#list(
      told.sort((a, b) => a[0] - b[0]),
      (t) => t[0],
      ([, code, other]) => {
        w.unsigned(code);
        w.unsigned(other);
      },
    );
    if (this.intent) this.#intent(state.intent);

    this.polygons = polygons;
    this.points = points;
    this.refusals = new Map(refusals);
  }

  bytes() {
    return this.writer.bytes.slice(0, this.writer.size);
  }

  #list(items, idOf, write) {
    this.writer.unsigned(items.length);
    let last = 0;
    for (const item of items) {
      this.writer.unsigned(idOf(item) - last);
      last = idOf(item);
      write(item);
    }
  }

  #flags(p) {
    const last = this.polygons.get(p.id);
    if (last === p) return p.initial ? 8 : 0;
    const vertices = flat(p),
      old = last ? flat(last) : [];
    const outlineSame =
      last &&
      last.cycles.length === p.cycles.length &&
      vertices.length === old.length &&
      p.cycles.every(
        (c, i) => c.hole === last.cycles[i].hole && c.vertices.length === last.cycles[i].vertices.length,
      ) &&
      vertices.every((v, i) => same(v, old[i]));
    return (
      (!last || last.count !== p.count || last.rms !== p.rms ? 1 : 0) |
      (!last || last.offset !== p.offset || last.normal.some((v, i) => v !== p.normal[i]) ? 2 : 0) |
      (outlineSame ? 0 : 4) |
      (p.initial ? 8 : 0)
    );
  }

  #polygon(p, flags) {
    const w = this.writer;
    w.unsigned(flags);
    if (flags & 1) {
      w.unsigned(p.count);
      w.unsigned(p.rms);
    }
    if (flags & 2) {
      p.normal.forEach((v) => w.signed(v));
      w.signed(p.offset);
    }
    if (!(flags & 4)) return;
    const old = this.polygons.has(p.id) ? flat(this.polygons.get(p.id)) : [];
    const indexOf = new Map(old.map((v, i) => [v.edge, i]));
    let next = 0,
      previous = { edge: 0, at: [0, 0, 0] };
    w.unsigned(p.cycles.length);
    for (const { hole, vertices } of p.cycles) {
      w.unsigned(hole ? 1 : 0);
      const runs = [];
      for (let i = 0; i < vertices.length;) {
        const from = indexOf.get(vertices[i].edge);
        let n = 0;
        if (from !== undefined) {
          while (i + n < vertices.length && from + n < old.length && same(vertices[i + n], old[from + n]))
            ++n;
        }
        if (n > 0) runs.push({ from, vertices: vertices.slice(i, i + n) });
        else if (runs.length > 0 && runs.at(-1).from === undefined) runs.at(-1).vertices.push(vertices[i]);
        else runs.push({ vertices: [vertices[i]] });
        i += Math.max(n, 1);
      }
      w.unsigned(runs.length);
      for (const run of runs) {
        w.unsigned(2 * run.vertices.length + (run.from === undefined ? 1 : 0));
        if (run.from !== undefined) {
          w.signed(run.from - next);
          next = run.from + run.vertices.length;
          previous = run.vertices.at(-1);
          continue;
        }
        for (const v of run.vertices) {
          w.signed(v.edge - previous.edge);
          w.unsigned(v.partner === 0 ? 0 : zigzag(v.partner - v.edge) + 1);
          const base = indexOf.has(v.edge) ? old[indexOf.get(v.edge)].at : previous.at;
          v.at.forEach((value, i) => w.signed(value - base[i]));
          previous = v;
        }
      }
    }
  }

  #intent(intent) {
    const w = this.writer;
    const { targets, aim, way, edge, segment, slice } = intent ?? {};
    w.unsigned(
      (targets ? 1 : 0) |
        (aim ? 2 : 0) |
        (way ? 4 : 0) |
        (edge ? 8 : 0) |
        (segment ? 16 : 0) |
        (slice ? 32 : 0),
    );
    const places = (list) => {
      w.unsigned(list.length);
      list.forEach((at, i) => at.forEach((v, axis) => w.signed(v - (i > 0 ? list[i - 1][axis] : 0))));
    };
    if (targets) places(targets);
    if (aim) [...aim.target, ...aim.place].forEach((v) => w.signed(v));
    if (way) places(way);
    if (edge) w.unsigned(edge);
    if (segment) w.unsigned(segment);
    if (slice) places(slice);
  }
}

const flat = (polygon) => polygon.cycles.flatMap((cycle) => cycle.vertices);

const kNames = {
  Uint8Array: "u8",
  Uint16Array: "u16",
  Uint32Array: "u32",
  Int32Array: "i32",
  Float32Array: "f32",
  Float64Array: "f64",
};

/// The container of a head and typed arrays by name.
export function container(head, arrays) {
  const align = (n) => Math.ceil(n / 8) * 8;
  const described = (offsets) => ({
    ...head,
    arrays: Object.fromEntries(
      Object.entries(arrays).map(([name, array]) => [
        name,
        { type: kNames[array.constructor.name], offset: offsets[name] ?? 1e12, length: array.length },
      ]),
    ),
  });
  // The head's length depends on the offsets it holds: they are made with room for the longest, blanks fill
  // the rest.
  const room = new TextEncoder().encode(JSON.stringify(described({}))).length;
  const offsets = {};
  let at = align(12 + room);
  for (const [name, array] of Object.entries(arrays)) {
    offsets[name] = at;
    at = align(at + array.byteLength);
  }
  const bytes = new Uint8Array(at);
  bytes.set(new TextEncoder().encode("LIMPAGE1"));
  new DataView(bytes.buffer).setUint32(8, room, true);
  bytes.fill(32, 12, 12 + room);
  bytes.set(new TextEncoder().encode(JSON.stringify(described(offsets))), 12);
  for (const [name, array] of Object.entries(arrays)) {
    bytes.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), offsets[name]);
  }
  return bytes;
}

export const kRefusals = [
  ["none", "nothing but its order"],
  ["alone", "no other polygon near"],
  ["angle", "angle below the angular resolution"],
  ["line_far", "line of the planes too far"],
  ["nothing_opposite", "nothing open opposite"],
  ["ring_broken", "ring around the corner broken"],
  ["undecided", "neither convex nor concave"],
  ["short_section", "too short to make neighbours"],
  ["goes_on", "goes on beyond the line"],
  ["inside_shared", "would end inside a shared edge"],
  ["other_pairs", "other shared edges opposite"],
  ["bay", "bay too deep"],
  ["one_sided_end", "end shared on one side only"],
  ["corner_far", "corner too far"],
  ["corner_bay", "bay at the corner too deep"],
  ["corner_turns", "corner would turn an edge"],
  ["perimeter", "perimeter would not be valid"],
].map(([name, words]) => ({ name, words }));

export const kEventKinds = [
  "became_polygon",
  "merged",
  "deleted",
  "shared",
  "unshared",
  "mode",
  "mark",
  "corner_formed",
];

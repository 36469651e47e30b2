// Copyright the limpet authors. GPL-3.0-or-later.
// Events of a run, by kind, and the way from one to the next.

// Kinds as people look for them; each is one or more of head.event_kinds. Key: the next one; with shift the
// one before.
export const kEventRows = [
  { name: "polygon born", kinds: ["became_polygon"], key: "b", color: "#56a4dd" },
  { name: "merged, deleted", kinds: ["merged", "deleted"], key: "m", color: "#d55e00" },
  { name: "edge shared", kinds: ["shared"], key: "e", color: "#009e73" },
  { name: "edge unshared", kinds: ["unshared"], key: "u", color: "#cc79a7" },
  { name: "corner formed", kinds: ["corner_formed"], key: "c", color: "#7a68d8" },
  { name: "mark made", kinds: ["mark"], key: "k", color: "#e04040" },
  { name: "mode switched", kinds: ["mode"], key: "o", color: "#8a919c" },
];

const kMarks = ["unreachable segment", "unreachable edge", "unclosable edge"];

export class Events {
  constructor({ head, arrays }) {
    this.head = head;
    const { event_step: step, event_kind: kind, event_a: a, event_b: b } = arrays;
    this.step = step ?? new Uint32Array(0);
    this.kind = kind ?? new Uint8Array(0);
    this.a = a ?? this.step;
    this.b = b ?? this.step;
    this.rows = kEventRows.map((row) => {
      const codes = row.kinds.map((name) => head.event_kinds.indexOf(name));
      const steps = [];
      this.kind.forEach((code, i) => {
        if (codes.includes(code) && steps.at(-1) !== this.step[i]) steps.push(this.step[i]);
      });
      return { ...row, steps: Uint32Array.from(steps) };
    });
  }

  /// The nearest step after (direction 1) or before (−1) that has an event of the row; null if there is none.
  next(row, from, direction) {
    const { steps } = row;
    let low = 0,
      high = steps.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (steps[middle] < from + (direction > 0 ? 1 : 0)) low = middle + 1;
      else high = middle;
    }
    return (direction > 0 ? steps[low] : steps[low - 1]) ?? null;
  }

  /// Indices of a step's events: [first, last).
  range(step) {
    const first = (wanted) => {
      let low = 0,
        high = this.step.length;
      while (low < high) {
        const middle = (low + high) >> 1;
        if (this.step[middle] < wanted) low = middle + 1;
        else high = middle;
      }
      return low;
    };
    return [first(step), first(step + 1)];
  }

  /// Words and links: a list of strings and {polygon} or {edge}.
  describe(i) {
    const a = this.a[i],
      b = this.b[i];
    switch (this.head.event_kinds[this.kind[i]]) {
      case "became_polygon":
        return [{ polygon: a }, " became a polygon"];
      case "merged":
        return [{ polygon: b }, " merged into ", { polygon: a }];
      case "deleted":
        return [`segment ${a} deleted`];
      case "shared":
        return [{ edge: a }, " shared with ", { edge: b }];
      case "unshared":
        return [{ edge: a }, " no longer shared with ", { edge: b }];
      case "mode":
        return [`mode: ${this.head.modes[a] ?? a}`];
      case "mark":
        return [b === 0 ? { polygon: a } : { edge: a }, ` marked: ${kMarks[b] ?? b}`];
      case "corner_formed":
        return ["corner of ", { polygon: a }, " and ", { polygon: b }];
      default:
        return [`event ${this.kind[i]}: ${a}, ${b}`];
    }
  }

  /// When a segment became a polygon and when it was no more, as far as events tell.
  lifeOf(polygon) {
    const life = { born: null, gone: null };
    const kinds = this.head.event_kinds;
    for (let i = 0; i < this.step.length; ++i) {
      const kind = kinds[this.kind[i]];
      if (kind === "became_polygon" && this.a[i] === polygon) life.born ??= this.step[i];
      if (kind === "deleted" && this.a[i] === polygon) life.gone = this.step[i];
      if (kind === "merged" && this.b[i] === polygon) life.gone = this.step[i];
    }
    return life;
  }

  /// A step at which an edge was there, as far as events tell: the last that names it.
  stepWithEdge(edge) {
    const kinds = this.head.event_kinds;
    for (let i = this.step.length - 1; i >= 0; --i) {
      const kind = kinds[this.kind[i]];
      if (this.a[i] !== edge && this.b[i] !== edge) continue;
      if (kind === "shared") return this.step[i];
      if (kind === "unshared") return Math.max(1, this.step[i] - 1);
      if (kind === "mark" && this.b[i] > 0 && this.a[i] === edge) return this.step[i];
    }
    return null;
  }
}

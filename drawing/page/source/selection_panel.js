// Copyright the limpet authors. GPL-3.0-or-later.
// What is known of the selection, in words and numbers.
import { button, element, terms } from "./dom.js";
import { area, count, direction, length, number, place, plural } from "./format.js";
import { derived, edgeEnds } from "./geometry.js";
import { kUnknown, reasonColor } from "./palette.js";

const kMostRows = 200; // of a polygon's edges that are listed

export class SelectionPanel {
  constructor(app, events) {
    this.app = app;
    this.events = events;
    this.root = element("section", { id: "selection", "aria-live": "polite" });
    for (const event of ["selection", "theme"]) app.on(event, () => this.show());
    app.on(
      "step",
      app.calmly(() => this.show()),
    );
    this.show();
  }

  polygonLink(id) {
    return button(String(id), `polygon ${id}`, () => this.app.select({ polygon: id }, { focus: true }), {
      class: "link",
    });
  }
  edgeLink(id) {
    return button(String(id), `edge ${id}`, () => this.app.select({ edge: id }, { focus: true }), {
      class: "link",
    });
  }

  show() {
    const { app } = this;
    const selection = app.selection;
    if (!selection) {
      this.root.replaceChildren(
        element("h2", {}, "Selection"),
        element("p", { class: "quiet" }, "Click a polygon, an edge or a point; or search by identity."),
      );
      return;
    }
    const { state } = app;
    const kind = selection.edge !== undefined ? "edge" : selection.point !== undefined ? "point" : "polygon";
    const id = selection[kind];
    const head = (name, color) =>
      element(
        "h3",
        {},
        color && element("span", { class: "swatch", style: { background: color } }),
        element("span", {}, `${name} ${id}`),
        element("span", { class: "grow" }),
        button("show", "bring into view (r)", () => app.focusSelection(), {
          class: "small",
          disabled: !app.isThere(),
        }),
        button("×", "clear the selection (Esc)", () => app.select(null), { class: "small" }),
      );
    const title = element("h2", {}, "Selection");
    if (kind === "edge" && state.edges.has(id))
      this.root.replaceChildren(title, head("edge"), ...this.#edge(id));
    else if (kind === "polygon" && state.polygons.has(id)) {
      const polygon = state.polygons.get(id);
      const [r, g, b] = app.model.faces.color(polygon);
      this.root.replaceChildren(title, head("polygon", `rgb(${r}, ${g}, ${b})`), ...this.#polygon(polygon));
    } else if (kind !== "edge" && state.points.has(id)) {
      this.root.replaceChildren(title, head("point segment"), ...this.#point(state.points.get(id)));
    } else this.root.replaceChildren(title, head(kind), ...this.#missing(kind, id));
  }

  #missing(kind, id) {
    const { app } = this;
    const parts = [
      element(
        "p",
        { class: "problem" },
        app.isRun ? `There is no ${kind} ${id} at step ${count(app.step)}.` : `There is no ${kind} ${id}.`,
      ),
    ];
    if (!app.isRun) return parts;
    const go = (step, words) =>
      button(
        words,
        words,
        () => {
          app.seek(step);
          app.focusSelection();
        },
        { class: "small" },
      );
    if (kind === "edge") {
      const step = this.events.stepWithEdge(id);
      if (step) parts.push(go(step, `go to step ${count(step)}, when it was`));
    } else {
      const { born, gone } = this.events.lifeOf(id);
      if (born) parts.push(go(born, `go to step ${count(born)}, where it became a polygon`));
      if (gone && gone > 1) parts.push(go(gone - 1, `go to step ${count(gone - 1)}, its last`));
    }
    return parts;
  }

  #point({ position, count: points, born, changed }) {
    const { app } = this;
    return [
      element("p", { class: "quiet" }, "Readings that are no polygon yet."),
      terms([
        ["points", count(points)],
        ["place", place(app.frame.toWorld(app.frame.ofModel(position)))],
        ["since step", app.isRun ? count(born) : null],
        ["changed in step", app.isRun ? count(changed) : null],
      ]),
    ];
  }

  #polygon(polygon) {
    const { app } = this;
    const {
      state,
      frame,
      head: { resolution },
    } = app;
    const { outline, cycles, normal } = polygon;
    const own = derived(polygon, frame);
    const neighbours = new Map(); // id → shared edges
    let open = 0,
      openLength = 0;
    const rows = [];
    outline.edges.forEach((edge, i) => {
      const [a, b] = [3 * i, 3 * own.next[i]];
      const size = Math.hypot(...[0, 1, 2].map((k) => own.scene[b + k] - own.scene[a + k]));
      const partner = outline.partners[i];
      if (partner === 0) {
        ++open;
        openLength += size;
      } else {
        const other = state.edges.get(partner)?.segment;
        if (other !== undefined) neighbours.set(other, (neighbours.get(other) ?? 0) + 1);
      }
      if (rows.length < 3 * kMostRows) {
        rows.push(
          this.edgeLink(edge),
          this.#status(edge, partner),
          element("span", { class: "number" }, number(size)),
        );
      }
    });
    const links = [...neighbours.keys()]
      .sort((a, b) => a - b)
      .slice(0, 60)
      .flatMap((id) => [this.polygonLink(id), " "]);
    const offset = polygon.offset + normal.reduce((sum, n, i) => sum + n * frame.origin[i], 0);
    const surface = this.#surface(polygon.id);
    return [
      polygon.initial &&
        element("p", { class: "quiet" }, "Known beforehand; its points are readings that confirm it."),
      terms([
        ["points", count(polygon.count)],
        ["residual, rms", length(polygon.rms, resolution)],
        ["area", area(own.area, resolution)],
        ["normal", direction(normal)],
        ["plane, offset", number(offset, 5)],
        [
          "edges",
          `${count(outline.edges.length)}: ${count(outline.edges.length - open)} shared, ${count(open)} open`,
        ],
        ["open length", length(openLength, resolution)],
        ["holes", count(cycles.filter((cycle) => cycle.hole).length)],
        ["neighbours", neighbours.size ? links : "none"],
        ["a polygon since step", app.isRun ? count(polygon.born) : null],
        ["changed in step", app.isRun ? count(polygon.changed) : null],
      ]),
      element("h4", {}, "Its surface, by shared edges"),
      terms([
        ["polygons", count(surface.polygons)],
        ["area", area(surface.area, resolution)],
        [
          "open",
          surface.open === 0
            ? "nothing: closed"
            : `${plural(surface.open, "edge")}, ${length(surface.openLength, resolution)}`,
        ],
      ]),
      element("h4", {}, outline.edges.length > kMostRows ? `Edges (the first ${kMostRows})` : "Edges"),
      element("div", { class: "list" }, ...rows),
    ].filter(Boolean);
  }

  #status(edge, partner) {
    const { state, head, theme } = this.app;
    if (partner !== 0) {
      const other = state.edges.get(partner)?.segment;
      return element("span", {}, other === undefined ? "shared" : `shared with ${other}`);
    }
    const code = state.refusals.get(edge)?.code ?? kUnknown;
    return element(
      "span",
      { style: { color: reasonColor(code, theme) } },
      head.refusals[code]?.words ?? "open",
    );
  }

  /// What is connected with a polygon by shared edges.
  #surface(id) {
    const { state, frame } = this.app;
    const seen = new Set([id]);
    const figures = { polygons: 0, area: 0, open: 0, openLength: 0 };
    for (const at of seen) {
      const polygon = state.polygons.get(at);
      if (!polygon) continue;
      const { area, next, scene } = derived(polygon, frame);
      ++figures.polygons;
      figures.area += area;
      polygon.outline.partners.forEach((partner, i) => {
        if (partner !== 0) {
          const other = state.edges.get(partner)?.segment;
          if (other !== undefined) seen.add(other);
          return;
        }
        ++figures.open;
        figures.openLength += Math.hypot(...[0, 1, 2].map((k) => scene[3 * next[i] + k] - scene[3 * i + k]));
      });
    }
    return figures;
  }

  #edge(id) {
    const { app } = this;
    const { state, frame, theme, head } = app;
    const { segment, partner, born, since } = state.edges.get(id);
    const [a, b] = edgeEnds(state, id, frame);
    const size = Math.hypot(...a.map((x, i) => b[i] - x));
    const parts = [];
    if (partner === 0) {
      const refusal = state.refusals.get(id);
      const code = refusal?.code ?? kUnknown;
      const known = head.refusals[code];
      const color = reasonColor(code, theme);
      parts.push(
        element(
          "div",
          { class: "why", style: { borderColor: color } },
          element(
            "div",
            {},
            element("b", {}, known ? `Open: ${known.words}` : "Open: reason not known at this step"),
          ),
          known
            ? element(
                "div",
                { class: "quiet" },
                known.name,
                refusal.other ? " · not shared with " : "",
                refusal.other ? this.polygonLink(refusal.other) : "",
              )
            : "",
          app.isRun
            ? element(
                "div",
                { class: "quiet" },
                `open since step ${count(since)}` +
                  (refusal ? `, for this reason since step ${count(refusal.since)}` : ""),
              )
            : "",
        ),
      );
    }
    const marks = head.run?.marks ?? {};
    const marked = [
      ["unreachable_edges", "unreachable"],
      ["unclosable_edges", "unclosable"],
    ]
      .filter(([name]) => marks[name]?.includes(id))
      .map(([, words]) => words);
    const other = state.edges.get(partner);
    parts.push(
      terms([
        ["of polygon", this.polygonLink(segment)],
        [
          "shared with",
          partner
            ? [this.edgeLink(partner), ...(other ? [" of polygon ", this.polygonLink(other.segment)] : [])]
            : "nothing: open",
        ],
        ["shared since step", partner && app.isRun ? count(since) : null],
        ["angle between planes", other ? this.#angle(segment, other.segment, a, b) : null],
        ["length", length(size, head.resolution)],
        ["from", place(frame.toWorld(a))],
        ["to", place(frame.toWorld(b))],
        ["first seen in step", app.isRun ? count(born) : null],
        ["given up as", marked.length ? marked.join(", ") : null],
      ]),
    );
    return parts;
  }

  #angle(first, second, a, b) {
    const p = this.app.state.polygons.get(first),
      q = this.app.state.polygons.get(second);
    if (!p || !q) return null;
    const dot = p.normal.reduce((sum, x, i) => sum + x * q.normal[i], 0);
    const [x, y, z] = p.normal,
      [u, v, w] = q.normal;
    const turn = [y * w - z * v, z * u - x * w, x * v - y * u].reduce(
      (sum, c, i) => sum + c * (b[i] - a[i]),
      0,
    );
    const degrees = (Math.acos(Math.max(-1, Math.min(1, dot))) * 180) / Math.PI;
    return `${number(degrees, 3)}°, ${turn >= 0 ? "convex" : "concave"}`;
  }
}

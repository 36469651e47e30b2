// Copyright the limpet authors. GPL-3.0-or-later.
// The model in the scene: faces, shared edges, open edges by reason, corners, point segments.
import { Group, Plane, Vector3 } from "three";
import { Faces } from "./faces.js";
import { kMostFat, LineBatch } from "./lines.js";
import { PointBatch } from "./points.js";
import { derived, findCorners } from "./geometry.js";
import { kUnknown, reasonColor, reasonDash, themeColors } from "./palette.js";

export class ModelView {
  constructor(frame, viewer) {
    this.frame = frame;
    this.viewer = viewer;
    this.group = new Group();
    this.faces = new Faces(frame);
    this.shared = new LineBatch({ width: 1.8 });
    this.open = new Map(); // code → LineBatch
    this.corners = new PointBatch({ size: 7 });
    this.points = new PointBatch({ size: 7, ring: 0.5 });
    this.group.add(this.faces.mesh, this.shared.object, this.corners.object, this.points.object);
    viewer.scene.add(this.group);
    this.hidden = new Set(); // names of the legend's rows that are switched off
    this.stressed = null; // the row that is stressed, the others dim
    this.clipping = null;
    this.level = 0; // of quality, see quality.js
    this.figures = null; // counts and lengths, for the legend
    viewer.before.push((level) => {
      if (level !== this.level) {
        this.level = level;
        this.#apply(false);
      }
    });
  }

  setTheme(theme) {
    this.theme = theme;
    const colors = themeColors(theme);
    this.faces.setTheme(theme);
    this.shared.setColor(colors.shared);
    this.corners.setColor(colors.corner);
    this.points.setColor(colors.point);
    for (const [code, batch] of this.open) batch.setColor(reasonColor(code, theme));
    if (this.state) this.faces.show(this.state);
  }

  /// Shows a state of the timeline.
  show(state) {
    this.state = state;
    this.faces.show(state);
    this.#showEdges(state);
    const corners = findCorners(state, this.frame);
    this.corners.size = corners.length > 3 * 1500 ? 3.5 : 7; // many would hide what they are corners of
    this.corners.set(corners);
    const places = new Float32Array(3 * state.points.size);
    this.pointIds = [];
    for (const point of state.points.values()) {
      places.set(this.frame.ofModel(point.position), 3 * this.pointIds.length);
      this.pointIds.push(point.id);
    }
    this.points.set(places);
    let area = 0;
    let known = 0; // beforehand
    for (const polygon of state.polygons.values()) {
      area += derived(polygon, this.frame).area;
      known += polygon.initial ? 1 : 0;
    }
    Object.assign(this.figures, {
      polygons: state.polygons.size,
      known,
      area,
      corners: this.corners.count,
      points: state.points.size,
    });
    this.#apply();
  }

  #showEdges(state) {
    let total = 0;
    for (const { outline } of state.polygons.values()) total += outline.edges.length;
    if (!this.ends || this.ends.length < 6 * total) {
      this.ends = new Float32Array(6 * Math.ceil(1.3 * total + 16));
      this.codes = new Uint8Array(this.ends.length / 6);
      this.ids = new Float64Array(this.ends.length / 6);
    }
    const classes = new Map(); // code → {count, length}; −1: shared
    let n = 0;
    for (const polygon of state.polygons.values()) {
      const { edges, partners } = polygon.outline;
      const { scene, next } = derived(polygon, this.frame);
      for (let i = 0; i < edges.length; ++i) {
        const partner = partners[i];
        if (partner !== 0 && partner < edges[i] && state.edges.has(partner)) continue;
        const code = partner !== 0 ? 255 : (state.refusals.get(edges[i])?.code ?? kUnknown);
        const a = 3 * i,
          b = 3 * next[i];
        for (let axis = 0; axis < 3; ++axis) {
          this.ends[6 * n + axis] = scene[a + axis];
          this.ends[6 * n + 3 + axis] = scene[b + axis];
        }
        const length = Math.hypot(
          scene[b] - scene[a],
          scene[b + 1] - scene[a + 1],
          scene[b + 2] - scene[a + 2],
        );
        let figures = classes.get(code);
        if (!figures) classes.set(code, (figures = { count: 0, length: 0 }));
        ++figures.count;
        figures.length += length;
        this.codes[n] = code;
        this.ids[n] = edges[i];
        ++n;
      }
    }
    this.edgeCount = n;
    const gathered = new Map(
      [...classes].map(([code, { count }]) => [code, { ends: new Float32Array(6 * count), at: 0 }]),
    );
    for (let i = 0; i < n; ++i) {
      const into = gathered.get(this.codes[i]);
      into.ends.set(this.ends.subarray(6 * i, 6 * i + 6), into.at);
      into.at += 6;
    }
    this.shared.set(gathered.get(255)?.ends ?? new Float32Array(0));
    for (const code of gathered.keys()) {
      if (code === 255 || this.open.has(code)) continue;
      const batch = new LineBatch({ width: 3.2, dash: reasonDash(code), order: 3 });
      batch.setColor(reasonColor(code, this.theme));
      batch.setClipping(this.clipping);
      this.open.set(code, batch);
      this.group.add(batch.object);
    }
    for (const [code, batch] of this.open) batch.set(gathered.get(code)?.ends ?? new Float32Array(0));
    const none = { count: 0, length: 0 };
    const open = new Map([...classes].filter(([code]) => code !== 255));
    const sum = (key) => [...open.values()].reduce((total, figures) => total + figures[key], 0);
    this.figures = {
      shared: classes.get(255) ?? none,
      open,
      openCount: sum("count"),
      openLength: sum("length"),
    };
  }

  setHidden(name, hidden) {
    if (hidden) this.hidden.add(name);
    else this.hidden.delete(name);
    this.#apply();
  }
  setStressed(name) {
    this.stressed = name;
    this.#apply();
  }
  isShown(name) {
    return !this.hidden.has(name);
  }
  isOpenShown(code) {
    return this.isShown("open") && this.isShown(`reason ${code}`);
  }

  #apply(draw = true) {
    const few = (batch, level) => this.level < level || batch.count < kMostFat;
    const dims = (...names) => (this.stressed && !names.includes(this.stressed) ? 0.12 : 1);
    this.faces.mesh.visible = this.isShown("polygons");
    this.faces.setBacks(this.isShown("backs"));
    this.shared.object.visible = this.isShown("shared") && this.shared.count > 0 && few(this.shared, 3);
    this.shared.setOpacity(dims("shared"));
    for (const [code, batch] of this.open) {
      batch.object.visible = this.isOpenShown(code) && batch.count > 0 && few(batch, 3);
      batch.setOpacity(dims("open", `reason ${code}`));
    }
    this.corners.object.visible = this.isShown("corners") && this.corners.count > 0 && few(this.corners, 2);
    this.corners.setOpacity(dims("corners"));
    this.points.object.visible = this.isShown("points") && this.points.count > 0 && few(this.points, 2);
    this.points.setOpacity(dims("points"));
    if (draw) this.viewer.invalidate();
  }

  /// A section: what lies on the plane's negative side is not drawn. null: none.
  setSection(section) {
    this.section = section && new Plane(new Vector3(...section.normal), section.constant);
    this.clipping = section ? [this.section] : null;
    this.faces.material.clippingPlanes = this.clipping;
    for (const batch of [this.shared, this.corners, this.points, ...this.open.values()])
      batch.setClipping(this.clipping);
    this.viewer.invalidate();
  }
  isCut(place) {
    return this.section ? this.section.distanceToPoint(place) < 0 : false;
  }
}

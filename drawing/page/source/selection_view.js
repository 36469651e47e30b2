// Copyright the limpet authors. GPL-3.0-or-later.
// What is selected, stressed in the scene; and the line along which a section cuts the faces.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, MeshBasicMaterial } from "three";
import { LineBatch } from "./lines.js";
import { PointBatch } from "./points.js";
import { derived, edgeEnds } from "./geometry.js";
import { themeColors } from "./palette.js";

const kNothing = new Float32Array(0);

export class SelectionView {
  constructor(app) {
    this.app = app;
    this.veil = new Mesh(
      new BufferGeometry(),
      new MeshBasicMaterial({
        transparent: true,
        opacity: 0.28,
        side: DoubleSide,
        depthWrite: false,
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
      }),
    );
    this.veil.renderOrder = 1;
    this.veil.frustumCulled = false;
    // A seam about the edges, below them: what they are stays to be seen.
    this.near = new LineBatch({ width: 9, under: true, order: 1 });
    this.far = new LineBatch({ width: 3, through: true, order: 5 }); // also where something is in front of it
    this.ends = new PointBatch({ size: 9, order: 6 });
    this.cut = new LineBatch({ width: 2.4, order: 4 });
    app.viewer.scene.add(this.veil, this.near.object, this.far.object, this.ends.object, this.cut.object);
  }

  setTheme(theme) {
    const { select, cut } = themeColors(theme);
    this.veil.material.color = new Color(select);
    for (const part of [this.near, this.far, this.ends]) part.setColor(select);
    this.far.setOpacity(0.3);
    this.cut.setColor(cut);
  }

  show() {
    const { state, frame, selection } = this.app;
    let lines = kNothing,
      triangles = null,
      ends = kNothing;
    const polygon = state.polygons.get(selection?.polygon);
    if (polygon) {
      const { scene, next, triangles: indices } = derived(polygon, frame);
      lines = new Float32Array(6 * next.length);
      next.forEach((to, i) => {
        lines.set(scene.subarray(3 * i, 3 * i + 3), 6 * i);
        lines.set(scene.subarray(3 * to, 3 * to + 3), 6 * i + 3);
      });
      triangles = new Float32Array(3 * indices.length);
      indices.forEach((k, i) => triangles.set(scene.subarray(3 * k, 3 * k + 3), 3 * i));
    } else if (selection?.edge !== undefined && state.edges.has(selection.edge)) {
      lines = Float32Array.from(edgeEnds(state, selection.edge, frame).flat());
      ends = lines;
    } else if (selection) {
      const point = state.points.get(selection.point ?? selection.polygon);
      if (point) ends = Float32Array.from(frame.ofModel(point.position));
    }
    this.near.set(lines);
    this.far.set(lines);
    this.ends.set(ends);
    this.veil.visible = triangles !== null;
    if (triangles) {
      this.veil.geometry.dispose();
      this.veil.geometry = new BufferGeometry();
      this.veil.geometry.setAttribute("position", new BufferAttribute(triangles, 3));
    }
    this.showCut();
  }

  setSection(planes) {
    this.veil.material.clippingPlanes = planes;
    this.veil.material.needsUpdate = true;
    for (const part of [this.near, this.far, this.ends]) part.setClipping(planes);
    this.showCut();
  }

  showCut() {
    const { model } = this.app;
    if (!model.section || !model.isShown("polygons")) {
      this.cut.set(kNothing);
      return;
    }
    const { normal, constant } = model.section;
    const {
      attributes: {
        position: { array: p },
      },
      index: { array: index },
    } = model.faces.mesh.geometry;
    const lines = [];
    const side = (k) => normal.x * p[k] + normal.y * p[k + 1] + normal.z * p[k + 2] + constant;
    for (let t = 0; t < model.faces.count; ++t) {
      const at = [3 * index[3 * t], 3 * index[3 * t + 1], 3 * index[3 * t + 2]];
      const s = at.map(side);
      if (s[0] > 0 === s[1] > 0 && s[1] > 0 === s[2] > 0) continue;
      for (let i = 0; i < 3; ++i) {
        const j = (i + 1) % 3;
        if (s[i] > 0 === s[j] > 0) continue;
        const share = s[i] / (s[i] - s[j]);
        for (let axis = 0; axis < 3; ++axis)
          lines.push(p[at[i] + axis] + share * (p[at[j] + axis] - p[at[i] + axis]));
      }
    }
    this.cut.set(Float32Array.from(lines));
  }
}

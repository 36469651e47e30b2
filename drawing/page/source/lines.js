// Copyright the limpet authors. GPL-3.0-or-later.
// Batches of line segments of one colour: fat and dashed where the count allows, thin above.
import { BufferAttribute, BufferGeometry, Color, Group, InstancedInterleavedBuffer, InterleavedBufferAttribute,
  LineBasicMaterial, LineSegments } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import { kDashes } from "./palette.js";

export const kMostFat = 24000;  // segments of one batch

export class LineBatch {
  /// width in pixels; dash: index of kDashes; thinOnly: never fat; through: also drawn over what is in front; under:
  /// leaves no depth, so that what is drawn later at the same place covers it.
  constructor({ width = 2, dash = 0, thinOnly = false, through = false, under = false, order = 2 } = {}) {
    this.object = new Group();
    this.width = width;
    this.thinOnly = thinOnly;
    this.order = order;
    this.capacity = 0;
    this.count = 0;
    this.opacity = 1;
    this.dash = kDashes[dash];
    const dashed = this.dash[1] > 0;
    this.fat = new LineMaterial({ linewidth: width, dashed, dashSize: this.dash[0], gapSize: this.dash[1],
      depthTest: !through, depthWrite: !through && !under });
    this.thin = new LineBasicMaterial({ depthTest: !through, depthWrite: !through });
    this.drawn = null;
  }

  setColor(color) {
    this.fat.color = new Color(color);
    this.thin.color = new Color(color);
  }
  setOpacity(opacity) {
    this.opacity = opacity;
    for (const material of [this.fat, this.thin]) {
      material.transparent = opacity < 1;
      material.opacity = opacity;
    }
  }
  setClipping(planes) {
    this.fat.clippingPlanes = planes;
    this.thin.clippingPlanes = planes;
  }
  /// Dashes are in pixels: how many there are to a unit of length.
  setPixels(perLength) {
    this.fat.dashScale = perLength;
  }

  /// Segments, 6 numbers each; `count` of them.
  set(positions, count = positions.length / 6) {
    this.count = count;
    const fat = !this.thinOnly && count <= kMostFat;
    if (!this.drawn || count > this.capacity || fat !== this.isFat) this.#reserve(count, fat);
    this.object.visible = count > 0;
    this.buffer.array.set(positions.subarray(0, 6 * count));
    this.buffer.clearUpdateRanges();
    this.buffer.addUpdateRange(0, 6 * count);
    this.buffer.needsUpdate = true;
    if (fat && this.dash[1] > 0) {
      const lengths = this.lengths.array;
      for (let i = 0; i < count; ++i) {
        const k = 6 * i;
        lengths[2 * i + 1] = Math.hypot(positions[k + 3] - positions[k], positions[k + 4] - positions[k + 1],
          positions[k + 5] - positions[k + 2]);
      }
      this.lengths.needsUpdate = true;
    }
    this.limit(count);
  }

  /// Draws the first `count` segments only.
  limit(count) {
    if (!this.drawn) return;
    const n = Math.min(count, this.count);
    this.object.visible = n > 0;
    if (this.isFat) this.drawn.geometry.instanceCount = n;
    else this.drawn.geometry.setDrawRange(0, 2 * n);
  }

  #reserve(count, fat) {
    this.isFat = fat;
    this.capacity = Math.max(16, Math.ceil(1.4 * count));
    if (this.drawn) {
      this.object.remove(this.drawn);
      this.drawn.geometry.dispose();
    }
    if (fat) {
      const geometry = new LineSegmentsGeometry();
      this.buffer = new InstancedInterleavedBuffer(new Float32Array(6 * this.capacity), 6, 1);
      geometry.setAttribute("instanceStart", new InterleavedBufferAttribute(this.buffer, 3, 0));
      geometry.setAttribute("instanceEnd", new InterleavedBufferAttribute(this.buffer, 3, 3));
      this.lengths = new InstancedInterleavedBuffer(new Float32Array(2 * this.capacity), 2, 1);
      geometry.setAttribute("instanceDistanceStart", new InterleavedBufferAttribute(this.lengths, 1, 0));
      geometry.setAttribute("instanceDistanceEnd", new InterleavedBufferAttribute(this.lengths, 1, 1));
      this.drawn = new LineSegments2(geometry, this.fat);
    } else {
      const geometry = new BufferGeometry();
      this.buffer = new BufferAttribute(new Float32Array(6 * this.capacity), 3);
      geometry.setAttribute("position", this.buffer);
      this.drawn = new LineSegments(geometry, this.thin);
    }
    this.drawn.frustumCulled = false;
    this.drawn.renderOrder = this.order;
    this.object.add(this.drawn);
  }
}

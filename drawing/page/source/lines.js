// Copyright the limpet authors. GPL-3.0-or-later.
// Batches of line segments of one colour: fat and dashed where the count allows, thin above.
import { BufferAttribute, BufferGeometry, Color, Group, LineBasicMaterial, LineSegments, Mesh } from "three";
import { fatLineMaterial } from "./fat_line.js";
import { kDashes } from "./palette.js";

export const kMostFat = 24000; // segments of one batch

export class LineBatch {
  /// width in pixels; dash: index of kDashes; thinOnly: never fat; through: also drawn over what is in front;
  /// under: leaves no depth, so that what is drawn later at the same place covers it.
  constructor({ width = 2, dash = 0, thinOnly = false, through = false, under = false, order = 2 } = {}) {
    this.object = new Group();
    this.thinOnly = thinOnly;
    this.order = order;
    this.capacity = 0;
    this.count = 0;
    this.fat = fatLineMaterial(width, kDashes[dash], !through, !through && !under);
    this.thin = new LineBasicMaterial({ depthTest: !through, depthWrite: !through });
    this.drawn = null;
  }

  setColor(color) {
    this.thin.color = new Color(color);
    const { r, g, b } = this.thin.color.clone().convertLinearToSRGB();
    this.fat.uniforms.tint.value = { x: r, y: g, z: b };
  }
  setOpacity(opacity) {
    for (const material of [this.fat, this.thin]) material.transparent = opacity < 1;
    this.thin.opacity = this.fat.uniforms.opacity.value = opacity;
  }
  setClipping(planes) {
    this.fat.clippingPlanes = planes;
    this.thin.clippingPlanes = planes;
  }

  /// Segments, 6 numbers each; `count` of them.
  set(positions, count = positions.length / 6) {
    this.count = count;
    const fat = !this.thinOnly && count <= kMostFat;
    if (!this.drawn || count > this.capacity || fat !== this.isFat) this.#reserve(count, fat);
    const { position, other } = this.drawn.geometry.attributes;
    if (!fat) position.array.set(positions.subarray(0, 6 * count));
    else {
      const here = position.array,
        there = other.array;
      for (let i = 0, k = 0; i < 6 * count; i += 6, k += 12) {
        for (let axis = 0; axis < 3; ++axis) {
          const a = positions[i + axis],
            b = positions[i + 3 + axis];
          here[k + axis] = here[k + 3 + axis] = there[k + 6 + axis] = there[k + 9 + axis] = a;
          here[k + 6 + axis] = here[k + 9 + axis] = there[k + axis] = there[k + 3 + axis] = b;
        }
      }
    }
    for (const attribute of fat ? [position, other] : [position]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, (fat ? 12 : 6) * count);
      attribute.needsUpdate = true;
    }
    this.limit(count);
  }

  /// Draws the first `count` segments only.
  limit(count) {
    if (!this.drawn) return;
    const n = Math.min(count, this.count);
    this.object.visible = n > 0;
    this.drawn.geometry.setDrawRange(0, (this.isFat ? 6 : 2) * n);
  }

  #reserve(count, fat) {
    this.isFat = fat;
    this.capacity = Math.max(16, Math.ceil(1.4 * count));
    if (this.drawn) {
      this.object.remove(this.drawn);
      this.drawn.geometry.dispose();
    }
    const geometry = new BufferGeometry();
    const vertices = (fat ? 4 : 2) * this.capacity;
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * vertices), 3));
    if (fat) {
      geometry.setAttribute("other", new BufferAttribute(new Float32Array(3 * vertices), 3));
      const side = new Int8Array(4 * vertices),
        index = new Uint32Array(6 * this.capacity);
      for (let i = 0; i < this.capacity; ++i) {
        side.set([-1, 0, 0, 0, 1, 0, 0, 0, -1, 1, 0, 0, 1, 1, 0, 0], 16 * i);
        index.set(
          [0, 1, 2, 2, 1, 3].map((k) => 4 * i + k),
          6 * i,
        );
      }
      geometry.setAttribute("side", new BufferAttribute(side, 4));
      geometry.setIndex(new BufferAttribute(index, 1));
      this.drawn = new Mesh(geometry, this.fat);
      this.drawn.onBeforeRender = (renderer) => renderer.getSize(this.fat.uniforms.resolution.value);
    } else this.drawn = new LineSegments(geometry, this.thin);
    this.drawn.frustumCulled = false;
    this.drawn.renderOrder = this.order;
    this.object.add(this.drawn);
  }
}

// Copyright the limpet authors. GPL-3.0-or-later.
// All faces in one mesh: positions, normals and colours in few buffers, and whose triangle is whose.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, ShaderMaterial, Color } from "three";
import { derived } from "./geometry.js";
import { faceColor, kFaceColors, knownColor, themeColors } from "./palette.js";

const kVertexShader = `
  #include <clipping_planes_pars_vertex>
  varying vec3 vFace;
  varying vec3 vDirection;
  void main() {
    vFace = color;
    vDirection = normalMatrix * normal;
    vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
    #include <clipping_planes_vertex>
    gl_Position = projectionMatrix * mvPosition;
  }`;
// Flat, with a little light from beside the camera; the backs are grey.
const kFragmentShader = `
  #include <clipping_planes_pars_fragment>
  uniform vec3 back;
  uniform float opacity;
  varying vec3 vFace;
  varying vec3 vDirection;
  void main() {
    #include <clipping_planes_fragment>
    float light = 0.74 + 0.26 * abs(dot(normalize(vDirection), vec3(0.28, 0.42, 0.863)));
    gl_FragColor = vec4((gl_FrontFacing ? vFace : back) * light, opacity);
  }`;

export function faceMaterial(back) {
  const { r, g, b } = new Color(back).convertLinearToSRGB();
  return new ShaderMaterial({ vertexShader: kVertexShader, fragmentShader: kFragmentShader, side: DoubleSide,
    vertexColors: true, clipping: true, uniforms: { back: { value: { x: r, y: g, z: b } }, opacity: { value: 1 } },
    polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 });
}

export class Faces {
  constructor(frame) {
    this.frame = frame;
    this.capacity = 0;
    this.count = 0;       // of triangles
    this.owners = [];     // polygon ids, in the order of their triangles
    this.starts = [];     // first triangle of each owner
    this.material = faceMaterial("#888888");
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.chosen = new Map();  // polygon → index of its colour
    this.#reserve(256);
  }

  setTheme(theme) {
    this.theme = theme;
    this.palette = Array.from({ length: kFaceColors }, (_, i) => faceColor(i, theme).map((x) => Math.round(255 * x)));
    this.known = knownColor(theme).map((x) => Math.round(255 * x));
    const { r, g, b } = new Color(themeColors(theme).back).convertLinearToSRGB();
    this.material.uniforms.back.value = { x: r, y: g, z: b };
    this.shown = null;
  }

  #reserve(triangles) {
    if (triangles <= this.capacity) return;
    this.capacity = Math.max(triangles, Math.ceil(this.capacity * 1.5));
    this.mesh.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(9 * this.capacity), 3));
    geometry.setAttribute("normal", new BufferAttribute(new Int8Array(9 * this.capacity), 3, true));
    geometry.setAttribute("color", new BufferAttribute(new Uint8Array(9 * this.capacity), 3, true));
    this.mesh.geometry = geometry;
  }

  /// Rewrites the buffers from the first polygon that is not as it was shown before.
  show(state) {
    let at = 0, same = true;
    const before = this.shown ?? [];
    const now = [...state.polygons.values()];
    this.#choose(state);
    let total = 0;
    for (const polygon of now) total += derived(polygon, this.frame).triangles.length / 9;
    if (total > this.capacity) {
      this.#reserve(total);
      same = false;
    }
    const { position, normal, color } = this.mesh.geometry.attributes;
    this.owners = [];
    this.starts = [];
    let firstChanged = -1;
    now.forEach((polygon, i) => {
      const { triangles } = derived(polygon, this.frame);
      const count = triangles.length / 9;
      this.owners.push(polygon.id);
      this.starts.push(at);
      const was = before[i];
      same = same && was && was.id === polygon.id && was.outline === polygon.outline && was.normal === polygon.normal &&
        was.initial === polygon.initial;
      if (!same) {
        if (firstChanged < 0) firstChanged = at;
        position.array.set(triangles, 9 * at);
        const n = polygon.normal.map((x) => Math.max(-127, Math.min(127, Math.round(127 * x))));
        const c = this.color(polygon);
        for (let k = 9 * at; k < 9 * (at + count); ++k) {
          normal.array[k] = n[k % 3];
          color.array[k] = c[k % 3];
        }
      }
      at += count;
    });
    if (firstChanged >= 0) {
      for (const attribute of [position, normal, color]) {
        attribute.clearUpdateRanges();
        attribute.addUpdateRange(9 * firstChanged, 9 * (at - firstChanged));
        attribute.needsUpdate = true;
      }
    }
    this.shown = now;
    this.count = at;
    this.mesh.geometry.setDrawRange(0, 3 * at);
  }

  color({ id, initial }) {
    return initial ? this.known : this.palette[this.chosen.get(id)];
  }

  /// A colour for each new polygon: none of its neighbours', and one that few others have. It keeps it.
  #choose(state) {
    const used = new Uint32Array(kFaceColors);
    const fresh = [];
    for (const polygon of state.polygons.values()) {
      if (this.chosen.has(polygon.id)) ++used[this.chosen.get(polygon.id)];
      else fresh.push(polygon);
    }
    for (const polygon of fresh) {
      const weight = Float64Array.from(used);
      for (const partner of polygon.outline.partners) {
        const other = partner === 0 ? undefined : this.chosen.get(state.edges.get(partner)?.segment);
        if (other !== undefined) weight[other] += 1e9;
      }
      let best = 0;
      for (let i = 1; i < kFaceColors; ++i) if (weight[i] < weight[best]) best = i;
      this.chosen.set(polygon.id, best);
      ++used[best];
    }
  }

  /// The polygon that a triangle is of.
  owner(triangle) {
    let low = 0, high = this.starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.starts[middle] <= triangle) low = middle;
      else high = middle - 1;
    }
    return this.owners[low];
  }
}

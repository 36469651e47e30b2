// Copyright the limpet authors. GPL-3.0-or-later.
// All faces in one mesh: positions, normals and colours in few buffers, and whose triangle is whose.
import { BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Mesh, ShaderMaterial, Color } from "three";
import { derived } from "./geometry.js";
import { faceColor, kFaceColors, knownColor, themeColors } from "./palette.js";

const kVertexShader = `
  #include <clipping_planes_pars_vertex>
  varying vec3 vFace;
  varying vec3 vDirection;
  void main() {
    vFace = color.rgb;
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
  return new ShaderMaterial({
    vertexShader: kVertexShader,
    fragmentShader: kFragmentShader,
    side: DoubleSide,
    vertexColors: true,
    clipping: true,
    uniforms: { back: { value: { x: r, y: g, z: b } }, opacity: { value: 1 } },
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 2,
  });
}

export class Faces {
  constructor(frame) {
    this.frame = frame;
    this.vertexCapacity = this.indexCapacity = 0;
    this.count = 0; // of triangles
    this.owners = []; // polygon ids, in the order of their triangles
    this.starts = []; // first triangle of each owner
    this.material = faceMaterial("#888888");
    this.mesh = new Mesh(new BufferGeometry(), this.material);
    this.mesh.frustumCulled = false;
    this.chosen = new Map(); // polygon → index of its colour
    this.#reserve(256, 256);
  }

  setTheme(theme) {
    this.theme = theme;
    this.palette = Array.from({ length: kFaceColors }, (_, i) =>
      faceColor(i, theme).map((x) => Math.round(255 * x)),
    );
    this.known = knownColor(theme).map((x) => Math.round(255 * x));
    const { r, g, b } = new Color(themeColors(theme).back).convertLinearToSRGB();
    this.material.uniforms.back.value = { x: r, y: g, z: b };
    this.shown = null;
  }

  /// Are backs shown, grey, or looked through?
  setBacks(shown) {
    this.material.side = shown ? DoubleSide : FrontSide;
  }
  get hasBacks() {
    return this.material.side === DoubleSide;
  }

  #reserve(vertices, indices) {
    this.vertexCapacity = Math.max(vertices, Math.ceil(this.vertexCapacity * 1.5));
    this.indexCapacity = Math.max(indices, Math.ceil(this.indexCapacity * 1.5));
    this.mesh.geometry.dispose();
    const geometry = new BufferGeometry();
    const n = this.vertexCapacity;
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * n), 3));
    // Four bytes each, which graphics hardware reads at once; the fourth means nothing.
    geometry.setAttribute("normal", new BufferAttribute(new Int8Array(4 * n), 4, true));
    geometry.setAttribute("color", new BufferAttribute(new Uint8Array(4 * n), 4, true));
    geometry.setIndex(new BufferAttribute(new Uint32Array(this.indexCapacity), 1));
    this.mesh.geometry = geometry;
    this.shown = null;
  }

  /// Rewrites the buffers from the first polygon that is not as it was shown before.
  show(state) {
    const now = [...state.polygons.values()];
    this.#choose(state);
    let vertices = 0,
      indices = 0;
    for (const polygon of now) {
      vertices += polygon.outline.edges.length;
      indices += derived(polygon, this.frame).triangles.length;
    }
    if (vertices > this.vertexCapacity || indices > this.indexCapacity) this.#reserve(vertices, indices);
    const before = this.shown ?? [];
    const {
      attributes: { position, normal, color },
      index,
    } = this.mesh.geometry;
    this.owners = [];
    this.starts = [];
    let vertex = 0,
      at = 0,
      firstVertex = -1,
      firstIndex = 0;
    now.forEach((polygon, i) => {
      const { scene, triangles } = derived(polygon, this.frame);
      this.owners.push(polygon.id);
      this.starts.push(at / 3);
      const was = before[i];
      const same =
        firstVertex < 0 &&
        was &&
        was.id === polygon.id &&
        was.outline === polygon.outline &&
        was.normal === polygon.normal &&
        was.initial === polygon.initial;
      if (!same) {
        if (firstVertex < 0) [firstVertex, firstIndex] = [vertex, at];
        position.array.set(scene, 3 * vertex);
        for (let k = 0; k < triangles.length; ++k) index.array[at + k] = vertex + triangles[k];
        const [nx, ny, nz] = polygon.normal;
        const [r, g, b] = this.color(polygon);
        for (let k = 4 * vertex; k < 4 * vertex + (4 * scene.length) / 3; k += 4) {
          normal.array[k] = 127 * nx;
          normal.array[k + 1] = 127 * ny;
          normal.array[k + 2] = 127 * nz;
          color.array[k] = r;
          color.array[k + 1] = g;
          color.array[k + 2] = b;
          color.array[k + 3] = 255;
        }
      }
      vertex += scene.length / 3;
      at += triangles.length;
    });
    if (firstVertex >= 0) {
      for (const [attribute, size, first, last] of [
        [position, 3, firstVertex, vertex],
        [normal, 4, firstVertex, vertex],
        [color, 4, firstVertex, vertex],
        [index, 1, firstIndex, at],
      ]) {
        attribute.clearUpdateRanges();
        attribute.addUpdateRange(size * first, size * (last - first));
        attribute.needsUpdate = true;
      }
    }
    this.shown = now;
    this.count = at / 3;
    this.mesh.geometry.setDrawRange(0, at);
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
    let low = 0,
      high = this.starts.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.starts[middle] <= triangle) low = middle;
      else high = middle - 1;
    }
    return this.owners[low];
  }
}

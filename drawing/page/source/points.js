// Copyright the limpet authors. GPL-3.0-or-later.
// Round points of a size in pixels.
import { BufferAttribute, BufferGeometry, Color, Points, ShaderMaterial } from "three";

const kVertexShader = `
  #include <clipping_planes_pars_vertex>
  uniform float size;
  void main() {
    vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
    #include <clipping_planes_vertex>
    gl_Position = projectionMatrix * mvPosition;
    gl_Position.z -= 2e-5 * gl_Position.w;
    gl_PointSize = size;
  }`;
const kFragmentShader = `
  #include <clipping_planes_pars_fragment>
  uniform vec3 tint;
  uniform float opacity;
  uniform float ring;
  uniform float cross_;
  void main() {
    #include <clipping_planes_fragment>
    float r = length(gl_PointCoord - 0.5);
    if (r > 0.5 || r < ring) discard;
    vec2 d = abs(gl_PointCoord - 0.5);
    if (cross_ > 0.0 && abs(d.x - d.y) > cross_) discard;
    gl_FragColor = vec4(tint, opacity);
  }`;

export class PointBatch {
  /// size: diameter in pixels; ring: share of it that is left empty inside; cross: half the width of its
  /// strokes, a share of the size
  constructor({ size = 6, ring = 0, cross = 0, through = false, order = 3 } = {}) {
    this.size = size;
    this.material = new ShaderMaterial({
      vertexShader: kVertexShader,
      fragmentShader: kFragmentShader,
      clipping: true,
      depthTest: !through,
      depthWrite: !through,
      uniforms: {
        size: { value: size },
        tint: { value: { x: 0, y: 0, z: 0 } },
        opacity: { value: 1 },
        ring: { value: ring / 2 },
        cross_: { value: cross },
      },
    });
    this.object = new Points(new BufferGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = order;
    this.object.onBeforeRender = (renderer) => {
      this.material.uniforms.size.value = this.size * renderer.getPixelRatio();
    };
    this.capacity = 0;
    this.count = 0;
    this.object.visible = false;
  }
  setColor(color) {
    const { r, g, b } = new Color(color).convertLinearToSRGB();
    this.material.uniforms.tint.value = { x: r, y: g, z: b };
  }
  setOpacity(opacity) {
    this.material.transparent = opacity < 1;
    this.material.uniforms.opacity.value = opacity;
  }
  setClipping(planes) {
    this.material.clippingPlanes = planes;
  }
  set(positions, count = positions.length / 3) {
    if (count > this.capacity) {
      this.capacity = Math.max(16, Math.ceil(1.4 * count));
      this.object.geometry.dispose();
      this.object.geometry = new BufferGeometry();
      this.object.geometry.setAttribute(
        "position",
        new BufferAttribute(new Float32Array(3 * this.capacity), 3),
      );
    }
    this.count = count;
    this.object.visible = count > 0;
    if (count === 0) return;
    const { position } = this.object.geometry.attributes;
    position.array.set(positions.subarray(0, 3 * count));
    position.needsUpdate = true;
    this.object.geometry.setDrawRange(0, count);
  }
}

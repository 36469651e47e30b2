// Copyright the limpet authors. GPL-3.0-or-later.
// The truth: beside the model, over it as lines, or not at all.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  Mesh,
  ShaderMaterial,
  Vector3,
} from "three";
import { LineBatch } from "./lines.js";
import { themeColors } from "./palette.js";

const kVertexShader = `varying vec3 place; void main() {
  vec4 p = modelViewMatrix * vec4(position, 1.0); place = p.xyz;
  gl_Position = projectionMatrix * p; }`;
const kFragmentShader = `uniform vec3 tint; varying vec3 place; void main() {
  vec3 n = normalize(cross(dFdx(place), dFdy(place)));
  gl_FragColor = vec4(tint * (0.62 + 0.38 * abs(dot(n, vec3(0.28, 0.42, 0.863)))), 1.0); }`;

export class TruthView {
  constructor({ arrays }, frame, viewer) {
    this.viewer = viewer;
    this.frame = frame;
    this.group = new Group();
    viewer.scene.add(this.group);
    const places = Float32Array.from(arrays.truth_position, (x, i) => x - frame.middle[i % 3]);
    this.low = [0, 1, 2].map((axis) =>
      places.reduce((m, x, i) => (i % 3 === axis ? Math.min(m, x) : m), Infinity),
    );
    this.high = [0, 1, 2].map((axis) =>
      places.reduce((m, x, i) => (i % 3 === axis ? Math.max(m, x) : m), -Infinity),
    );
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(places, 3));
    geometry.setIndex(new BufferAttribute(new Uint32Array(arrays.truth_triangle), 1));
    this.material = new ShaderMaterial({
      vertexShader: kVertexShader,
      fragmentShader: kFragmentShader,
      side: DoubleSide,
      uniforms: { tint: { value: { x: 0, y: 0, z: 0 } } },
      polygonOffset: true,
      polygonOffsetFactor: 2,
      polygonOffsetUnits: 2,
    });
    this.mesh = new Mesh(geometry, this.material);
    const lines = arrays.truth_line ?? [];
    const ends = new Float32Array(3 * lines.length);
    lines.forEach((vertex, i) => ends.set(places.subarray(3 * vertex, 3 * vertex + 3), 3 * i));
    this.lines = new LineBatch({ width: 1.4, dash: 3 });
    this.solid = new LineBatch({ width: 1.4 });
    this.lines.set(ends);
    this.solid.set(ends);
    this.group.add(this.mesh, this.lines.object, this.solid.object);
    this.set("none");
  }

  setTheme(theme) {
    const color = themeColors(theme).truth;
    const { r, g, b } = new Color(color)
      .lerp(new Color(theme === "dark" ? "#15181c" : "#ffffff"), 0.45)
      .convertLinearToSRGB();
    this.material.uniforms.tint.value = { x: r, y: g, z: b };
    this.lines.setColor(color);
    this.solid.setColor(color);
  }

  /// "none", "over" or "beside": to the right of what is seen, as it is seen then.
  set(how) {
    this.how = how;
    const { extent, camera } = this.viewer;
    const right = new Vector3(1, 0, 0).transformDirection(camera.matrixWorld).setZ(0).normalize();
    const along = (size) => Math.abs(right.x) * size[0] + Math.abs(right.y) * size[1];
    const size = this.high.map((x, i) => x - this.low[i]);
    const middle = this.high.map((x, i) => (x + this.low[i]) / 2);
    const apart = (along(this.frame.size) + along(size)) / 2 + 0.15 * this.frame.radius;
    const shift =
      how === "beside"
        ? right.multiplyScalar(apart).sub(new Vector3(middle[0], middle[1], 0))
        : new Vector3();
    this.group.position.copy(shift);
    this.group.visible = how !== "none";
    this.mesh.visible = this.solid.object.visible = how === "beside";
    this.lines.object.visible = how === "over" && this.lines.count > 0;
    const own = { middle: middle.map((x, i) => x + shift.getComponent(i)), size };
    extent.boxes = [{ middle: [0, 0, 0], size: this.frame.size }, ...(how === "beside" ? [own] : [])];
    extent.middle.set(...(how === "beside" ? own.middle.map((x) => x / 2) : [0, 0, 0]));
    extent.radius =
      this.frame.radius + extent.middle.length() + (how === "beside" ? Math.hypot(...size) / 4 : 0);
    this.viewer.invalidate();
  }
}

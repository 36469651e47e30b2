// Copyright the limpet authors. GPL-3.0-or-later.
// The material of fat lines: quads that are turned to the camera and as wide everywhere on the screen. Unlike
// three's own they are not instanced: where a processor draws, each instance costs as much as a call.
import { DoubleSide, ShaderMaterial, Vector2 } from "three";

// position: this end; other: the other one; side.x: left or right (−1, 1), side.y: which end this is (0, 1)
const kVertexShader = `
  #include <clipping_planes_pars_vertex>
  attribute vec3 other;
  attribute vec4 side;
  uniform vec2 resolution;
  uniform float width;
  varying float along;
  // What lies behind a perspective camera cannot be projected: the end is moved to the near plane.
  vec4 trimmed(vec4 end, vec4 rest) {
    if (projectionMatrix[2][3] == 0.0) return end;
    float near = -projectionMatrix[3][2] / (projectionMatrix[2][2] - 1.0) * 1.0001;
    if (end.z <= near || rest.z >= near) return end;
    return mix(rest, end, (near - rest.z) / (end.z - rest.z));
  }
  void main() {
    vec4 a = modelViewMatrix * vec4(position, 1.0);
    vec4 b = modelViewMatrix * vec4(other, 1.0);
    vec4 mvPosition = trimmed(a, b);
    vec4 here = projectionMatrix * mvPosition;
    vec4 there = projectionMatrix * trimmed(b, a);
    vec2 way = (there.xy / there.w - here.xy / here.w) * resolution * 0.5;
    float size = length(way);
    vec2 forward = size > 1e-4 ? way / size : vec2(1.0, 0.0);
    along = side.y * size;
    if (side.y > 0.5) forward = -forward;
    vec2 outward = side.y > 0.5 ? forward : -forward;
    vec2 shift = (vec2(-forward.y, forward.x) * side.x + outward * 0.7) * width * 0.5;
    here.xy += shift * 2.0 / resolution * here.w;
    gl_Position = here;
    #include <clipping_planes_vertex>
  }`;
const kFragmentShader = `
  #include <clipping_planes_pars_fragment>
  uniform vec3 tint;
  uniform float opacity;
  uniform vec2 dash;
  varying float along;
  void main() {
    #include <clipping_planes_fragment>
    if (dash.y > 0.0 && mod(along, dash.x + dash.y) > dash.x) discard;
    gl_FragColor = vec4(tint, opacity);
  }`;

export function fatLineMaterial(width, [drawn, gap], depthTest, depthWrite) {
  return new ShaderMaterial({
    vertexShader: kVertexShader,
    fragmentShader: kFragmentShader,
    clipping: true,
    depthTest,
    depthWrite,
    side: DoubleSide,
    uniforms: {
      resolution: { value: new Vector2(1, 1) },
      width: { value: width },
      tint: { value: { x: 0, y: 0, z: 0 } },
      opacity: { value: 1 },
      dash: { value: new Vector2(drawn, gap) },
    },
  });
}

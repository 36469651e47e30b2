// Copyright the limpet authors. GPL-3.0-or-later.
// Everything of a run that is not the model: robot, rays of the current set, path so far, what the robot is
// up to.
import {
  CapsuleGeometry,
  Color,
  Group,
  Matrix4,
  Mesh,
  Quaternion,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
} from "three";
import { LineBatch } from "./lines.js";
import { PointBatch } from "./points.js";
import { derived, edgeEnds } from "./geometry.js";
import { jointCount, linkPoses, sensorPoses } from "./kinematics.js";
import { themeColors } from "./palette.js";

const kMostPath = 12000;
const kTrail = 40; // the last sets of the path, that stand out

// Lit from the camera, like the faces; three's own lit materials would weigh more than they are worth here.
const kVertexShader = `varying vec3 n; void main() { n = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;
const kFragmentShader = `uniform vec3 tint; varying vec3 n; void main() {
  gl_FragColor = vec4(tint * (0.55 + 0.45 * abs(normalize(n).z)), 1.0); }`;

export class RunView {
  constructor(data, frame, viewer) {
    this.head = data.head;
    this.arrays = data.arrays;
    this.frame = frame;
    this.viewer = viewer;
    this.robot = data.head.robot ?? null;
    this.sets = data.head.run.sets;
    this.joints = this.robot ? jointCount(this.robot) : 0; // of a configuration
    this.group = new Group();
    viewer.scene.add(this.group);
    this.material = new ShaderMaterial({
      vertexShader: kVertexShader,
      fragmentShader: kFragmentShader,
      uniforms: { tint: { value: { x: 0, y: 0, z: 0 } } },
    });
    this.parts = {
      path: [(this.path = new LineBatch({ thinOnly: true }))],
      trail: [(this.trail = new LineBatch({ width: 2.6, order: 3 }))],
      rays: [
        (this.rays = new LineBatch({ width: 2, order: 4 })),
        (this.hits = new PointBatch({ size: 7, order: 5 })),
        (this.misses = new LineBatch({ thinOnly: true, order: 4 })),
        (this.raysBehind = new LineBatch({ width: 2, through: true, order: 4 })),
      ],
      switches: [
        (this.quiet = new PointBatch({ size: 4, order: 4 })),
        (this.seeing = new PointBatch({ size: 9, order: 5 })),
        (this.fields = new LineBatch({ width: 3.5, order: 5 })),
        (this.fieldsBehind = new LineBatch({ width: 3.5, through: true, order: 5 })),
      ],
      targets: [(this.targets = new PointBatch({ size: 9, ring: 0.55, through: true, order: 6 }))],
      aim: [
        (this.aim = new LineBatch({ width: 1.6, dash: 2, through: true, order: 6 })),
        (this.goal = new PointBatch({ size: 13, ring: 0.6, through: true, order: 6 })),
        (this.place = new PointBatch({ size: 6, through: true, order: 6 })),
      ],
      way: [(this.way = new LineBatch({ width: 2, dash: 1, through: true, order: 6 }))],
      current: [(this.current = new LineBatch({ width: 11, under: true, order: 0.5 }))],
      marks: [(this.marks = new PointBatch({ size: 13, cross: 0.11, through: true, order: 6 }))],
      slice: [(this.slice = new LineBatch({ width: 2, order: 5 }))],
    };
    this.body = new Group();
    this.bones = new LineBatch({ width: 3, order: 4 });
    this.control = new PointBatch({ size: 7, through: true, order: 7 });
    this.halo = new PointBatch({ size: 19, ring: 0.76, through: true, order: 7 }); // it shows through
    this.group.add(this.body, this.bones.object, this.control.object, this.halo.object);
    Object.values(this.parts)
      .flat()
      .forEach((part) => this.group.add(part.object));
    this.hidden = new Set();
    if (this.arrays.path) this.#makePath();
    if (this.robot) this.#makeBody();
    this.#makeReadings();
  }

  #makePath() {
    const { path } = this.arrays;
    this.places = new Float32Array(path.length);
    for (let i = 0; i < path.length; ++i) this.places[i] = path[i] - this.frame.middle[i % 3];
    const segments = new Float32Array(Math.max(0, 2 * (path.length - 3)));
    for (let i = 0; i + 3 < path.length; i += 3) segments.set(this.places.subarray(i, i + 6), 2 * i);
    this.pathSegments = segments;
    // Of very long runs every k-th place suffices; the last ones are exact all the same.
    this.stride = Math.ceil(this.sets / kMostPath);
    const coarse = new Float32Array(6 * Math.floor((this.sets - 1) / this.stride));
    for (let i = 0; i < coarse.length / 6; ++i) {
      for (const [end, set] of [
        [0, i * this.stride],
        [3, (i + 1) * this.stride],
      ]) {
        coarse.set(this.places.subarray(3 * set, 3 * set + 3), 6 * i + end);
      }
    }
    this.path.set(coarse);
  }

  #makeBody() {
    this.links = this.robot.links.map((link) => {
      const group = new Group();
      group.matrixAutoUpdate = false;
      for (const { a, b, radius } of link.capsules) {
        const from = new Vector3(...a),
          to = new Vector3(...b);
        const length = from.distanceTo(to);
        const shape =
          length > 0 ? new CapsuleGeometry(radius, length, 6, 16) : new SphereGeometry(radius, 20, 12);
        const mesh = new Mesh(shape, this.material);
        mesh.position.copy(from).add(to).multiplyScalar(0.5);
        const direction = to.sub(from).normalize();
        if (length > 0)
          mesh.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), direction));
        group.add(mesh);
      }
      this.body.add(group);
      return group;
    });
    // A point robot has no body; a ball of a fifth of the resolution stands for it.
    if (this.robot.links.every((link) => link.capsules.length === 0)) {
      this.links[this.robot.control_point.link].add(
        new Mesh(new SphereGeometry(0.2 * this.head.resolution, 20, 12), this.material),
      );
    }
  }

  #makeReadings() {
    const { reading_count: counts, off_axis_reading: off } = this.arrays;
    this.firstReading = new Uint32Array((counts?.length ?? 0) + 1);
    for (let s = 0; s < (counts?.length ?? 0); ++s)
      this.firstReading[s + 1] = this.firstReading[s] + counts[s];
    const { seeing_count: seen } = this.arrays;
    this.firstSeeing = new Uint32Array((seen?.length ?? 0) + 1);
    for (let s = 0; s < (seen?.length ?? 0); ++s) this.firstSeeing[s + 1] = this.firstSeeing[s] + seen[s];
    this.offAxis = new Map();
    off?.forEach((reading, i) => this.offAxis.set(reading, i));
  }

  /// Readings of the set that a step shows: [{sensor, range}].
  readings(step) {
    const set = this.set(step);
    const readings = [];
    const { reading_sensor: sensor, reading_range: range } = this.arrays;
    if (!sensor) return readings;
    for (let i = this.firstReading[set]; i < this.firstReading[set + 1]; ++i) {
      readings.push({ sensor: sensor[i], range: range[i], index: i });
    }
    return readings;
  }

  /// Numbers of the switches that see something in the set that a step shows.
  switchesSeeing(step) {
    const set = this.set(step);
    return [...(this.arrays.seeing_switch?.subarray(this.firstSeeing[set], this.firstSeeing[set + 1]) ?? [])];
  }

  /// Counted from 0. What finishing did has no set of its own: the last one is shown.
  set(step) {
    return Math.min(step, this.sets) - 1;
  }

  setTheme(theme) {
    const colors = themeColors(theme);
    const { r, g, b } = new Color(colors.robot).convertLinearToSRGB();
    this.material.uniforms.tint.value = { x: r, y: g, z: b };
    const of = {
      path: "path",
      trail: "trail",
      rays: "ray",
      switches: "current",
      targets: "target",
      aim: "aim",
      way: "way",
      current: "current",
      slice: "slice",
      marks: "mark",
    };
    for (const [name, color] of Object.entries(of))
      this.parts[name].forEach((part) => part.setColor(colors[color]));
    this.misses.setColor(colors.miss);
    this.quiet.setColor(colors.miss);
    this.bones.setColor(colors.robot);
    this.control.setColor(colors.robot);
    this.halo.setColor(colors.robot);
    this.raysBehind.setOpacity(0.4);
    this.fieldsBehind.setOpacity(0.4);
  }

  show(state) {
    const set = this.set(state.step);
    if (set < 0) return;
    if (this.places) {
      this.path.limit(Math.floor(set / this.stride));
      const from = Math.max(0, Math.min(set - kTrail, Math.floor(set / this.stride) * this.stride));
      this.trail.set(this.pathSegments.subarray(6 * from, 6 * set));
    }
    if (this.robot && this.arrays.joints) this.#showRobot(state.step, set);
    else if (this.places) this.#showControl(this.places.subarray(3 * set, 3 * set + 3));
    this.#showIntent(state);
    this.#showMarks(state);
    this.#apply();
  }

  #showRobot(step, set) {
    const n = this.joints;
    const shift = this.frame.ofWorld([0, 0, 0]);
    const poses = linkPoses(this.robot, this.arrays.joints.subarray(n * set, n * (set + 1)), shift);
    this.links.forEach((link, i) => {
      link.matrix.copy(poses[i]);
      link.matrixWorldNeedsUpdate = true;
    });
    const bones = [];
    const origin = (pose) => new Vector3().setFromMatrixPosition(pose).toArray();
    // Links without a body are drawn as lines, but for gantries: prismatic joints from the world are only
    // numbers.
    this.robot.links.forEach((link, i) => {
      if (link.parent < 0 || link.kind === "prismatic" || this.robot.links[link.parent].capsules.length > 0)
        return;
      if (poses[i].equals(poses[link.parent])) return;
      bones.push(...origin(poses[link.parent]), ...origin(poses[i]));
    });
    this.bones.set(Float32Array.from(bones));
    const control = new Vector3(...this.robot.control_point.position).applyMatrix4(
      poses[this.robot.control_point.link] ?? new Matrix4(),
    );
    this.#showControl(Float32Array.from(control.toArray()));

    const sensors = sensorPoses(this.robot.sensors, poses);
    const rays = [],
      hits = [],
      misses = [];
    const met = new Set();
    for (const { sensor, range, index } of this.readings(step)) {
      if (!sensors[sensor]) continue;
      const { position, axis } = sensors[sensor];
      const place = this.offAxis.has(index)
        ? this.frame.ofArray(this.arrays.off_axis_place, 3 * this.offAxis.get(index))
        : position.clone().addScaledVector(axis, range).toArray();
      rays.push(...position.toArray(), ...place);
      hits.push(...place);
      met.add(sensor);
    }
    sensors.forEach(({ position, axis, range }, i) => {
      if (met.has(i)) return;
      const length = Number.isFinite(range) ? range : 2 * this.head.resolution;
      misses.push(
        ...position.toArray(),
        ...position
          .clone()
          .addScaledVector(axis, 0.5 * length)
          .toArray(),
      );
    });
    this.rays.set(Float32Array.from(rays));
    this.raysBehind.set(Float32Array.from(rays));
    this.hits.set(Float32Array.from(hits));
    this.misses.set(Float32Array.from(misses));
    this.controlPlace = control.toArray();
    this.#showSwitches(step, poses);
  }

  /// Those that see something stand out, with the diameters of their fields.
  #showSwitches(step, poses) {
    const seeing = new Set(this.switchesSeeing(step));
    const quiet = [],
      places = [],
      fields = [];
    sensorPoses(this.robot.switches ?? [], poses).forEach(({ position, axis, range }, i) => {
      const place = position.toArray();
      (seeing.has(i) ? places : quiet).push(...place);
      if (seeing.has(i)) fields.push(...place, ...position.clone().addScaledVector(axis, range).toArray());
    });
    this.quiet.set(Float32Array.from(quiet));
    this.seeing.set(Float32Array.from(places));
    this.fields.set(Float32Array.from(fields));
    this.fieldsBehind.set(Float32Array.from(fields));
  }

  #showControl(place) {
    this.control.set(place);
    this.halo.set(place);
  }

  #showIntent(state) {
    const intent = state.intent ?? {};
    const places = (list) => {
      const scene = new Float32Array(list?.length ?? 0);
      for (let i = 0; i < scene.length; ++i) scene[i] = list[i] * this.frame.unit - this.frame.middle[i % 3];
      return scene;
    };
    this.targets.set(places(intent.targets));
    const { aim } = intent;
    const here =
      this.controlPlace ??
      (this.places ? [...this.places.subarray(3 * this.set(state.step)).slice(0, 3)] : null);
    if (aim) {
      const target = this.frame.ofModel(aim.target),
        place = this.frame.ofModel(aim.place);
      this.aim.set(
        Float32Array.from(here ? [...here, ...place, ...place, ...target] : [...place, ...target]),
      );
      this.goal.set(Float32Array.from(target));
      this.place.set(Float32Array.from(place));
    } else for (const part of this.parts.aim) part.set(new Float32Array(0));
    const stops = places(intent.way);
    const way = new Float32Array(Math.max(0, 2 * (stops.length - 3)));
    for (let i = 0; i + 3 < stops.length; i += 3) way.set(stops.subarray(i, i + 6), 2 * i);
    this.way.set(way);
    const ends = intent.edge ? edgeEnds(state, intent.edge, this.frame) : null;
    this.current.set(Float32Array.from(ends ? ends.flat() : []));
    this.slice.set(places(intent.slice));
  }

  /// Crosses on what was given up so far, and is still there and open.
  #showMarks(state) {
    const { event_step: steps, event_kind: kinds, event_a: ids, event_b: what } = this.arrays;
    const code = this.head.event_kinds.indexOf("mark");
    this.markEvents ??= Array.from(kinds ?? [], (kind, i) => i).filter((i) => kinds[i] === code);
    const edges = new Set(),
      segments = new Set();
    for (const i of this.markEvents)
      if (steps[i] <= state.step) (what[i] === 0 ? segments : edges).add(ids[i]);
    if (state.step === this.head.steps) {
      const {
        unreachable_segments: s = [],
        unreachable_edges: u = [],
        unclosable_edges: c = [],
      } = this.head.run.marks ?? {};
      s.forEach((id) => segments.add(id));
      [...u, ...c].forEach((id) => edges.add(id));
    }
    const places = [];
    for (const edge of edges) {
      const ends = state.edges.get(edge)?.partner === 0 ? edgeEnds(state, edge, this.frame) : null;
      if (ends) places.push(...ends[0].map((x, i) => (x + ends[1][i]) / 2));
    }
    for (const id of segments) {
      const polygon = state.polygons.get(id),
        point = state.points.get(id);
      if (polygon) places.push(...derived(polygon, this.frame).inner);
      else if (point) places.push(...this.frame.ofModel(point.position));
    }
    this.marks.set(Float32Array.from(places));
  }

  setHidden(name, hidden) {
    if (hidden) this.hidden.add(name);
    else this.hidden.delete(name);
    this.#apply();
  }

  #apply() {
    const shown = (name) => !this.hidden.has(name);
    this.body.visible = shown("robot");
    for (const part of [this.control, this.halo]) part.object.visible = shown("robot") && part.count > 0;
    this.bones.object.visible = shown("robot") && this.bones.count > 0;
    for (const [name, parts] of Object.entries(this.parts)) {
      const on = shown(name === "trail" ? "path" : name);
      for (const part of parts) part.object.visible = on && part.count > 0;
    }
    this.viewer.invalidate();
  }
}

// Copyright the limpet authors. GPL-3.0-or-later.
// What is under the pointer: an edge within some pixels before a face; nothing that is hidden.
import { Vector3 } from "three";

const kReach = 6; // pixels

export class Picker {
  constructor(viewer, model) {
    this.viewer = viewer;
    this.model = model;
  }

  /// {edge, place} or {polygon, place} or {point, place} or null; x, y in pixels of the canvas.
  pick(x, y) {
    this.viewer.prepare();
    return this.#point(x, y) ?? this.#edge(x, y) ?? this.#face(this.#ray(x, y));
  }

  #ray(x, y) {
    const { camera, width, height } = this.viewer;
    const ndc = [(2 * x) / width - 1, 1 - (2 * y) / height];
    const near = new Vector3(...ndc, -1).unproject(camera);
    const direction = new Vector3(...ndc, 1).unproject(camera).sub(near).normalize();
    return { origin: near, direction };
  }

  /// The first face that the ray meets, at most so far away.
  #face({ origin, direction }, most = Infinity) {
    const { faces } = this.model;
    if (!this.model.isShown("polygons")) return null;
    const p = faces.mesh.geometry.attributes.position.array;
    const index = faces.mesh.geometry.index.array;
    const { x: ox, y: oy, z: oz } = origin,
      { x: dx, y: dy, z: dz } = direction;
    let nearest = most,
      triangle = -1;
    const place = new Vector3();
    for (let t = 0; t < faces.count; ++t) {
      const i = 3 * index[3 * t],
        j = 3 * index[3 * t + 1],
        k = 3 * index[3 * t + 2];
      const ax = p[i],
        ay = p[i + 1],
        az = p[i + 2];
      const ux = p[j] - ax,
        uy = p[j + 1] - ay,
        uz = p[j + 2] - az;
      const vx = p[k] - ax,
        vy = p[k + 1] - ay,
        vz = p[k + 2] - az;
      const hx = dy * vz - dz * vy,
        hy = dz * vx - dx * vz,
        hz = dx * vy - dy * vx;
      const det = ux * hx + uy * hy + uz * hz;
      if (det === 0 || (det < 0 && !faces.hasBacks)) continue; // seen from behind
      const sx = ox - ax,
        sy = oy - ay,
        sz = oz - az;
      const b = (sx * hx + sy * hy + sz * hz) / det;
      if (b < 0 || b > 1) continue;
      const qx = sy * uz - sz * uy,
        qy = sz * ux - sx * uz,
        qz = sx * uy - sy * ux;
      const c = (dx * qx + dy * qy + dz * qz) / det;
      if (c < 0 || b + c > 1) continue;
      const distance = (vx * qx + vy * qy + vz * qz) / det;
      if (distance <= 0 || distance >= nearest) continue;
      if (this.model.isCut(place.copy(origin).addScaledVector(direction, distance))) continue;
      nearest = distance;
      triangle = t;
    }
    if (triangle < 0) return null;
    return {
      polygon: faces.owner(triangle),
      place: origin.clone().addScaledVector(direction, nearest),
      nearest,
    };
  }

  /// Is a place hidden by a face? One that it lies on does not count.
  #isHidden(place) {
    const [x, y] = this.viewer.project(place.toArray());
    const ray = this.#ray(x, y);
    const distance = place.distanceTo(ray.origin);
    const margin = 3 * this.viewer.lengthPerPixel() + 1e-4 * this.viewer.extent.radius;
    return this.#face(ray, distance - margin) !== null;
  }

  #edge(x, y) {
    const { ends, ids, codes, edgeCount } = this.model;
    const { camera, width, height } = this.viewer;
    const m = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).elements;
    const shown = Array.from({ length: 256 }, (_, code) =>
      code === 255 ? this.model.isShown("shared") : this.model.isOpenShown(code),
    );
    const found = [];
    const clip = (k) =>
      [0, 1, 3].map((r) => m[r] * ends[k] + m[4 + r] * ends[k + 1] + m[8 + r] * ends[k + 2] + m[12 + r]);
    for (let i = 0; i < edgeCount; ++i) {
      if (!shown[codes[i]]) continue;
      const a = clip(6 * i),
        b = clip(6 * i + 3);
      if (a[2] <= 0 || b[2] <= 0) continue;
      const ax = ((a[0] / a[2] + 1) / 2) * width - x,
        ay = ((1 - a[1] / a[2]) / 2) * height - y;
      const bx = ((b[0] / b[2] + 1) / 2) * width - x,
        by = ((1 - b[1] / b[2]) / 2) * height - y;
      const ex = bx - ax,
        ey = by - ay;
      const square = ex * ex + ey * ey;
      const s = square > 0 ? Math.max(0, Math.min(1, -(ax * ex + ay * ey) / square)) : 0;
      const distance = Math.hypot(ax + s * ex, ay + s * ey);
      if (distance > kReach) continue;
      // s is along the edge on the screen; along the edge itself perspective shifts it
      const t = (s * a[2]) / (s * a[2] + (1 - s) * b[2]);
      found.push({ i, distance, t });
    }
    found.sort((p, q) => p.distance - q.distance);
    for (const { i, t } of found.slice(0, 24)) {
      const a = new Vector3().fromArray(ends, 6 * i),
        b = new Vector3().fromArray(ends, 6 * i + 3);
      const place = a.lerp(b, t);
      if (this.model.isCut(place) || this.#isHidden(place)) continue;
      return { edge: this.#sideOf(ids[i], place), place };
    }
    return null;
  }

  /// A shared edge is two: the one of the polygon that faces the camera is meant.
  #sideOf(edge, place) {
    const { state } = this.model;
    const own = state.edges.get(edge);
    if (!own?.partner) return edge;
    const view = this.viewer.isOrthographic
      ? this.viewer.camera.getWorldDirection(new Vector3()).negate()
      : this.viewer.camera.position.clone().sub(place);
    const facing = (id) => {
      const polygon = state.polygons.get(state.edges.get(id)?.segment);
      return polygon ? view.dot(new Vector3(...polygon.normal)) : -Infinity;
    };
    return facing(own.partner) > facing(edge) && facing(edge) < 0 ? own.partner : edge;
  }

  #point(x, y) {
    const { points, pointIds } = this.model;
    if (!this.model.isShown("points") || !points.count) return null;
    const { array } = points.object.geometry.attributes.position;
    let nearest = kReach,
      found = -1;
    for (let i = 0; i < points.count; ++i) {
      const [px, py, depth] = this.viewer.project([array[3 * i], array[3 * i + 1], array[3 * i + 2]]);
      const distance = Math.hypot(px - x, py - y);
      if (Math.abs(depth) < 1 && distance < nearest) [nearest, found] = [distance, i];
    }
    if (found < 0) return null;
    const place = new Vector3().fromArray(array, 3 * found);
    return this.model.isCut(place) || this.#isHidden(place) ? null : { point: pointIds[found], place };
  }
}

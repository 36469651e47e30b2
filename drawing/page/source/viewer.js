// Copyright the limpet authors. GPL-3.0-or-later.
// The canvas: scene, cameras, named views; drawn on demand, never in an idle loop.
import { Color, OrthographicCamera, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Quality } from "./quality.js";

// Directions from the middle towards the camera; z is up.
export const kViews = {
  iso: [1, -1.3, 0.9],
  front: [0, -1, 0],
  back: [0, 1, 0],
  left: [-1, 0, 0],
  right: [1, 0, 0],
  top: [0, 0, 1],
  bottom: [0, 0, -1],
};
const kFieldOfView = 30;
const kRoom = 1.08; // about all that is shown
const kToolbar = 44; // pixels

export class Viewer {
  constructor(canvas, frame) {
    this.canvas = canvas;
    this.frame = frame;
    this.scene = new Scene();
    this.quality = new Quality();
    this.renderer = new WebGLRenderer({ canvas, antialias: this.quality.antialias });
    this.renderer.localClippingEnabled = true;
    this.perspective = new PerspectiveCamera(kFieldOfView, 1, 0.1, 10);
    this.orthographic = new OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
    for (const camera of [this.perspective, this.orthographic]) camera.up.set(0, 0, 1);
    this.camera = this.perspective;
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.invalidate());
    this.view = "iso"; // the named view that is seen, or null
    this.controls.addEventListener("start", () => {
      this.gesture = this.camera.position.clone();
    });
    this.controls.addEventListener("end", () => {
      if (this.view && this.gesture && this.gesture.distanceTo(this.camera.position) > 1e-9)
        this.#setName(null);
    });
    // What is shown: a ball about it, and the boxes it fills.
    this.extent = {
      middle: new Vector3(),
      radius: frame.radius,
      boxes: [{ middle: [0, 0, 0], size: frame.size }],
    };
    this.before = []; // called before each drawing, with the level of quality
    this.viewListeners = [];
    this.frames = 0;
    this.pending = false;
    this.width = this.height = 1;
    canvas.addEventListener("webglcontextrestored", () => this.invalidate());
    this.resize();
    this.setView("iso");
  }

  invalidate() {
    this.asked = true;
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame((now) => this.#frame(now));
  }

  async #frame(now) {
    if (!this.quality.software) {
      this.pending = false;
      this.render();
      return;
    }
    clearTimeout(this.resting);
    // The next frame waits until this one is drawn: else they queue up, and the picture lags behind the hand.
    const how = this.quality.forFrame(now);
    this.asked = false;
    const begin = performance.now();
    this.render(how);
    await this.#drawn();
    this.quality.took(performance.now() - begin, how);
    this.pending = false;
    this.resting = setTimeout(() => this.#rest(), this.quality.rest);
    if (this.asked) this.invalidate();
  }

  /// Draws once more, finely, when nothing has moved for a while.
  async #rest() {
    const how = this.quality.whenResting(this.pixelRatio, this.drawn);
    if (!how || this.pending) return;
    this.pending = true;
    this.asked = false;
    const begin = performance.now();
    this.render(how);
    await this.#drawn();
    this.quality.took(performance.now() - begin, how);
    this.pending = false;
    if (this.asked) this.invalidate();
    else if (how.scale === 1) this.resting = setTimeout(() => this.#rest(), this.quality.rest);
  }

  /// Until the graphics process has drawn all that it was told to.
  async #drawn() {
    const gl = this.renderer.getContext();
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!fence) return;
    gl.flush();
    for (let tries = 0; tries < 2000; ++tries) {
      await new Promise((resolve) => setTimeout(resolve, 2));
      if (gl.isContextLost() || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED) break;
    }
    gl.deleteSync(fence);
  }

  render(how = { level: 0, scale: 1 }) {
    const ratio = this.pixelRatio * how.scale;
    if (ratio !== this.renderer.getPixelRatio()) this.renderer.setPixelRatio(ratio);
    this.#setDepths();
    for (const call of this.before) call(how.level);
    this.renderer.render(this.scene, this.camera);
    ++this.frames;
    this.drawn = how;
  }

  setGround(color) {
    this.renderer.setClearColor(new Color(color), 1);
    this.invalidate();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    this.width = Math.max(1, clientWidth);
    this.height = Math.max(1, clientHeight);
    this.pixelRatio = Math.min(window.devicePixelRatio || 1, 2);
    this.renderer.setPixelRatio(this.pixelRatio);
    this.renderer.setSize(this.width, this.height, false);
    this.perspective.aspect = this.width / this.height;
    this.perspective.updateProjectionMatrix();
    // The toolbar covers the upper rim: what is in the middle is shown a little lower.
    for (const camera of [this.perspective, this.orthographic]) {
      camera.setViewOffset(this.width, this.height, 0, -kToolbar / 2, this.width, this.height);
    }
    this.#setOrthographicSize();
    // Now, not with the next frame: a canvas that was sized is blank until then.
    if (this.frames > 0) this.render();
  }

  #setOrthographicSize(height) {
    if (height) this.orthographicHeight = height;
    const h = (this.orthographicHeight ?? 1) / 2,
      w = (h * this.width) / this.height;
    Object.assign(this.orthographic, { left: -w, right: w, top: h, bottom: -h });
    this.orthographic.updateProjectionMatrix();
  }

  /// Near and far as close as the content allows: lines on faces need the depth.
  #setDepths() {
    const { middle, radius } = this.extent;
    const forward = this.camera.getWorldDirection(new Vector3());
    const depth = middle.clone().sub(this.camera.position).dot(forward);
    const reach = radius * 1.3;
    if (this.camera.isPerspectiveCamera) {
      this.camera.far = Math.max(depth + reach, reach * 1e-2);
      this.camera.near = Math.max(depth - reach, this.camera.far * 1e-3);
    } else {
      this.camera.near = depth - reach;
      this.camera.far = depth + reach;
    }
    this.camera.updateProjectionMatrix();
  }

  /// Length in the scene that a pixel spans where the camera turns about.
  lengthPerPixel() {
    if (this.camera.isOrthographicCamera) return this.orthographicHeight / this.camera.zoom / this.height;
    const distance = this.camera.position.distanceTo(this.controls.target);
    return (2 * distance * Math.tan((kFieldOfView * Math.PI) / 360)) / this.height;
  }

  get isOrthographic() {
    return this.camera.isOrthographicCamera === true;
  }

  setOrthographic(on) {
    if (on === this.isOrthographic) return;
    const seen = this.lengthPerPixel() * this.height;
    const from = this.camera;
    this.camera = on ? this.orthographic : this.perspective;
    const direction = from.position.clone().sub(this.controls.target).normalize();
    const distance = seen / 2 / Math.tan((kFieldOfView * Math.PI) / 360);
    this.camera.position.copy(this.controls.target).addScaledVector(direction, distance);
    this.camera.zoom = 1;
    if (on) this.#setOrthographicSize(seen);
    this.controls.object = this.camera;
    this.controls.update();
    this.invalidate();
  }

  /// Looks from a direction at a place, so that a ball of that radius is in view.
  lookFrom(direction, target, radius) {
    const seen = 2.25 * radius * Math.max(1, this.height / this.width);
    const distance = seen / 2 / Math.tan((kFieldOfView * Math.PI) / 360);
    const d = new Vector3(...direction).normalize();
    // Straight down, the sideways direction is undefined: a hair towards the front makes it x to the right.
    if (Math.abs(d.z) > 0.9999) d.set(0, -1e-4, Math.sign(d.z)).normalize();
    this.controls.target.set(...target);
    this.camera.position.copy(this.controls.target).addScaledVector(d, distance);
    this.camera.zoom = 1;
    this.#setOrthographicSize(seen);
    this.controls.update();
    this.invalidate();
  }

  setView(name) {
    if (!kViews[name]) return;
    this.#lookAtAll(kViews[name]);
    this.#setName(name);
  }

  /// From a direction, as near as the box of all that is shown allows.
  #lookAtAll(direction) {
    const { middle, boxes, radius } = this.extent;
    this.lookFrom(direction, middle.toArray(), radius);
    this.camera.updateMatrixWorld();
    const slope = Math.tan((kFieldOfView * Math.PI) / 360),
      aspect = this.width / this.height;
    const room = (kRoom * this.height) / Math.max(this.height - kToolbar, this.height / 2);
    const origin = middle.clone().applyMatrix4(this.camera.matrixWorldInverse);
    let distance = 0,
      height = 0;
    for (let i = 0; i < 8 * boxes.length; ++i) {
      const box = boxes[i >> 3];
      const corner = new Vector3(
        ...box.size.map((x, axis) => box.middle[axis] + ((i >> axis) & 1 ? x : -x) / 2),
      )
        .applyMatrix4(this.camera.matrixWorldInverse)
        .sub(origin);
      const half = Math.max((kRoom * Math.abs(corner.x)) / aspect, Math.abs(corner.y) * room);
      distance = Math.max(distance, half / slope + corner.z);
      height = Math.max(height, 2 * half);
    }
    const d = this.camera.position.clone().sub(this.controls.target).normalize();
    this.camera.position.copy(this.controls.target).addScaledVector(d, Math.max(distance, 1e-6 * radius));
    this.#setOrthographicSize(height || radius);
    this.controls.update();
    this.invalidate();
  }

  /// Keeps the direction, shows all.
  fit() {
    const direction = this.camera.position.clone().sub(this.controls.target);
    this.#lookAtAll(direction.toArray());
  }

  /// Brings a place into view: from the side its normal points to, if it faces away.
  focus(place, normal, radius) {
    const direction = this.camera.position.clone().sub(this.controls.target).normalize();
    const n = new Vector3(...normal);
    let turned = false;
    if (direction.dot(n) < 0.25) {
      turned = true;
      direction.copy(n).multiplyScalar(1.2);
      const side = Math.abs(n.z) > 0.9 ? new Vector3(0.4, -0.6, 0) : new Vector3(-n.y * 0.5, n.x * 0.5, 0.5);
      direction.add(side).normalize();
    }
    const seen = Math.max(radius, 0.3 * this.extent.radius);
    this.lookFrom(direction.toArray(), place, Math.min(seen, this.extent.radius));
    if (turned) this.#setName(null);
  }

  #setName(name) {
    this.view = name;
    for (const call of this.viewListeners) call(name);
  }

  turn(azimuth, elevation) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const distance = offset.length();
    const a = Math.atan2(offset.y, offset.x) + azimuth;
    const e = Math.min(1.5706, Math.max(-1.5706, Math.asin(offset.z / distance) + elevation));
    offset.set(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)).multiplyScalar(distance);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.#setName(null);
    this.invalidate();
  }

  zoom(factor) {
    if (this.isOrthographic) {
      this.camera.zoom *= factor;
      this.camera.updateProjectionMatrix();
    } else {
      const offset = this.camera.position.clone().sub(this.controls.target).divideScalar(factor);
      this.camera.position.copy(this.controls.target).add(offset);
    }
    this.controls.update();
    this.invalidate();
  }

  /// Makes the camera's matrices what they would be if it were drawn now.
  prepare() {
    this.camera.updateMatrixWorld();
    this.#setDepths();
  }

  /// Pixels in the canvas, from its upper left corner, after prepare(), of a place in the scene; and its
  /// depth (−1 to 1).
  project(place) {
    const v = new Vector3(...place).project(this.camera);
    return [((v.x + 1) / 2) * this.width, ((1 - v.y) / 2) * this.height, v.z];
  }
}

// Copyright the limpet authors. GPL-3.0-or-later.
// The page's state: which step, what is selected, which theme; who wants to know is told.
import { Frame, derived, edgeEnds } from "./geometry.js";
import { ModelView } from "./model_view.js";
import { Picker } from "./picking.js";
import { RunView } from "./run_view.js";
import { SelectionView } from "./selection_view.js";
import { Timeline } from "./timeline.js";
import { TruthView } from "./truth_view.js";
import { Viewer } from "./viewer.js";
import { themeColors } from "./palette.js";

export class App {
  constructor({ head, arrays }, canvas) {
    this.head = head;
    this.arrays = arrays;
    this.isRun = head.kind === "run";
    this.frame = new Frame(head);
    this.timeline = new Timeline(head, arrays);
    this.viewer = new Viewer(canvas, this.frame);
    this.model = new ModelView(this.frame, this.viewer);
    this.run = this.isRun ? new RunView(this, this.frame, this.viewer) : null;
    this.truth = arrays.truth_position ? new TruthView(this, this.frame, this.viewer) : null;
    this.marker = new SelectionView(this);
    this.picker = new Picker(this.viewer, this.model);
    this.listeners = new Map();
    this.step = 0;
    this.selection = null;
    this.playing = false;
    const asked = window.matchMedia("(prefers-color-scheme: dark)");
    asked.addEventListener("change", () => this.setTheme(asked.matches ? "dark" : "light"));
    this.setTheme(asked.matches ? "dark" : "light");
  }

  on(event, call) {
    if (!this.listeners.has(event)) this.listeners.set(event, []);
    this.listeners.get(event).push(call);
  }
  emit(event) {
    for (const call of this.listeners.get(event) ?? []) call();
  }

  /// A function that, while time plays, is called no more than some times a second: for text that nobody could read.
  calmly(call) {
    let last = -Infinity;
    return () => {
      const now = performance.now();
      if (this.playing && now - last < 150) return;
      last = now;
      call();
    };
  }

  get state() {
    return this.timeline.state;
  }

  seek(step) {
    const to = Math.min(Math.max(Math.round(step) || 1, 1), this.head.steps);
    if (to === this.step) return;
    this.timeline.seek(to);
    this.step = to;
    this.model.show(this.state);
    this.run?.show(this.state);
    this.marker.show();
    this.emit("step");
    this.viewer.invalidate();
  }

  /// {polygon}, {edge}, {point} or null. focus: is it brought into view?
  select(selection, { focus = false } = {}) {
    this.selection = selection;
    this.marker.show();
    if (focus) this.focusSelection();
    this.emit("selection");
    this.viewer.invalidate();
  }

  /// Is what is selected there at this step?
  isThere(selection = this.selection) {
    if (!selection) return false;
    if (selection.edge !== undefined) return this.state.edges.has(selection.edge);
    if (selection.point !== undefined) return this.state.points.has(selection.point);
    return this.state.polygons.has(selection.polygon) || this.state.points.has(selection.polygon);
  }

  focusSelection() {
    if (!this.isThere()) return;
    const { edge, polygon, point } = this.selection;
    if (edge !== undefined) {
      const [a, b] = edgeEnds(this.state, edge, this.frame);
      const { normal } = this.state.polygons.get(this.state.edges.get(edge).segment);
      const middle = a.map((x, i) => (x + b[i]) / 2);
      this.viewer.focus(middle, normal, 2.5 * Math.hypot(...a.map((x, i) => b[i] - x)));
      return;
    }
    const found = this.state.polygons.get(polygon);
    if (!found) {
      const { position } = this.state.points.get(point ?? polygon);
      this.viewer.focus(this.frame.ofModel(position), [0, 0, 1], 4 * this.head.resolution);
      return;
    }
    const { scene } = derived(found, this.frame);
    const low = [Infinity, Infinity, Infinity],
      high = low.map((x) => -x);
    scene.forEach((x, i) => {
      low[i % 3] = Math.min(low[i % 3], x);
      high[i % 3] = Math.max(high[i % 3], x);
    });
    this.viewer.focus(
      low.map((x, i) => (x + high[i]) / 2),
      found.normal,
      Math.hypot(...low.map((x, i) => high[i] - x)) * 0.8,
    );
  }

  setTheme(theme) {
    this.theme = theme;
    document.documentElement.dataset.theme = theme;
    for (const part of [this.model, this.run, this.truth, this.marker]) part?.setTheme(theme);
    this.viewer.setGround(themeColors(theme).ground);
    this.emit("theme");
  }

  say(words) {
    const message = document.getElementById("message");
    message.textContent = words;
    message.hidden = false;
    clearTimeout(this.messageTimer);
    this.messageTimer = setTimeout(() => {
      message.hidden = true;
    }, 4000);
  }
}

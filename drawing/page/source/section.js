// Copyright the limpet authors. GPL-3.0-or-later.
// A section plane: axis, position, which side is kept.
import { button, element } from "./dom.js";
import { length } from "./format.js";

export class SectionControl {
  constructor(app, root) {
    this.app = app;
    this.root = root;
    this.on = false;
    this.axis = 0;
    this.share = 0.5; // of the model's extent along the axis
    this.flipped = false;
    this.axes = ["x", "y", "z"].map((name, axis) =>
      button(name, `section across ${name}`, () => this.set({ axis })),
    );
    this.slider = element("input", {
      type: "range",
      min: 0,
      max: 1000,
      value: 500,
      "aria-label": "position of the section",
      oninput: () => this.set({ share: this.slider.valueAsNumber / 1000 }),
    });
    this.output = element("output");
    this.flip = button("flip", "keep the other side", () => this.set({ flipped: !this.flipped }));
    root.append(
      element("span", {}, "section"),
      element("span", { class: "group" }, ...this.axes),
      this.slider,
      this.output,
      this.flip,
      button("×", "no section (x)", () => this.set({ on: false }), { class: "small" }),
    );
    this.listeners = [];
  }

  set(change) {
    Object.assign(this, change);
    this.share = Math.min(1, Math.max(0, this.share));
    const { app } = this;
    this.root.hidden = !this.on;
    this.axes.forEach((made, axis) =>
      made.setAttribute("aria-pressed", axis === this.axis ? "true" : "false"),
    );
    this.flip.setAttribute("aria-pressed", this.flipped ? "true" : "false");
    this.slider.value = Math.round(this.share * 1000);
    const size = app.frame.size[this.axis];
    const at = (this.share - 0.5) * size * 1.002;
    const world = app.frame.toWorld([0, 1, 2].map((axis) => (axis === this.axis ? at : 0)))[this.axis];
    this.output.textContent = length(world, app.head.resolution);
    // Cut away is the side that the view iso looks at: in front, to the right, above; flipped, the other one.
    const sign = (this.axis === 1) === this.flipped ? -1 : 1;
    const normal = [0, 0, 0];
    normal[this.axis] = sign;
    app.model.setSection(this.on ? { normal, constant: -sign * at } : null);
    app.marker.setSection(app.model.clipping);
    for (const call of this.listeners) call();
  }
}

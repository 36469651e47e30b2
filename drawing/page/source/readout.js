// Copyright the limpet authors. GPL-3.0-or-later.
// At a glance, over the scene: which file, which step, what is known, what is open, what the robot does.
import { element } from "./dom.js";
import { count, length, number, plural } from "./format.js";
import { modeColor } from "./palette.js";

export class Readout {
  constructor(app, root) {
    this.app = app;
    this.name = element("div", { class: "name" }, app.head.name);
    this.now = element("div", { class: "now", hidden: !app.isRun });
    this.figures = element("div", { class: "figures" });
    this.robot = element("div", { class: "figures", hidden: !app.isRun });
    root.append(this.name, this.now, this.figures, this.robot);
    app.on("step", () => this.show());
  }

  show() {
    const { app } = this;
    const {
      head,
      arrays,
      model: { figures },
      step,
    } = app;
    const strong = (text) => element("b", {}, text);
    const { resolution } = head;
    this.figures.replaceChildren(
      strong(plural(figures.polygons, "polygon")),
      ` ${number(figures.area)} in area · `,
      strong(count(figures.shared.count)),
      " shared · ",
      ...(figures.openCount > 0
        ? [strong(plural(figures.openCount, "open edge")), ` ${length(figures.openLength, resolution)}`]
        : [figures.polygons > 0 ? strong("closed") : "nothing open"]),
    );
    if (!app.isRun) return;
    const finish = head.finished && step === head.steps;
    const mode = arrays.mode?.[step - 1];
    const words = finish
      ? "finished"
      : mode === undefined
        ? null
        : mode === 255
          ? "run ended"
          : head.modes[mode];
    this.now.replaceChildren(
      `step ${count(step)} of ${count(head.steps)}`,
      words === null
        ? ""
        : element("span", { class: "chip", style: { borderColor: modeColor(finish ? 255 : mode) } }, words),
    );
    const clearance = arrays.clearance?.[step - 1];
    const met = app.run.rays.count;
    this.robot.replaceChildren(
      strong(plural(met, "reading")),
      " in this set",
      ...(arrays.clearance
        ? [" · clearance ", strong(Number.isFinite(clearance) ? length(clearance, resolution) : "none near")]
        : []),
    );
  }
}

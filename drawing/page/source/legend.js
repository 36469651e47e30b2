// Copyright the limpet authors. GPL-3.0-or-later.
// The legend: only what occurs, with counts and lengths; its rows switch things off and, pointed at, stress
// them.
import { button, element } from "./dom.js";
import { count, number } from "./format.js";
import { kDashes, kUnknown, reasonColor, reasonDash, themeColors } from "./palette.js";

export class Legend {
  constructor(app) {
    this.app = app;
    this.pinned = null;
    this.rows = [];
    this.grid = element("div", { class: "legend" });
    this.root = element("section", { id: "legend" }, element("h2", {}, "Legend"), this.grid);
    this.#make();
    for (const event of ["step", "theme"]) app.on(event, () => this.show());
  }

  #make() {
    const { app } = this;
    const { model, run, head } = app;
    const { resolution } = head;
    const figures = () => model.figures;
    const inLambda = (x) => `${number(x / resolution, 3)} λ`;
    const row = (...args) => this.#row(model, ...args);
    this.#heading("Model");
    row(
      "polygons",
      "polygons",
      "face",
      () => figures().polygons,
      () => `${number(figures().area / resolution ** 2, 3)} λ²`,
    );
    row("known", "known beforehand", "known", () => figures().known, null, { fixed: true });
    row("backs", "backs of polygons", "back", () => null, null, { show: () => figures().polygons, stress: false });
    row(
      "shared",
      "shared edges",
      { color: "shared", width: 2 },
      () => figures().shared.count,
      () => inLambda(figures().shared.length),
    );
    row("corners", "corners", { dot: "corner" }, () => figures().corners);
    row("points", "point segments", { ring: "point" }, () => figures().points);
    row(
      "open",
      "open edges, by reason:",
      null,
      () => figures().openCount,
      () => inLambda(figures().openLength),
    );
    for (let code = 0; code <= kUnknown; ++code) {
      const { words, name } = head.refusals[code] ?? { words: "reason not known", name: "" };
      row(
        `reason ${code}`,
        words,
        { reason: code },
        () => figures().open.get(code)?.count ?? 0,
        () => inLambda(figures().open.get(code)?.length ?? 0),
        { title: name },
      );
    }
    if (run) {
      const parts = run.parts;
      const some = (name) => (parts[name].some((part) => part.count > 0) ? 1 : 0);
      const line = (name, label, swatch, amount, show = () => some(name)) =>
        this.#row(run, name, label, swatch, amount, null, { show, stress: false });
      this.#heading("Robot");
      line(
        "robot",
        "robot",
        { dot: "robot" },
        () => null,
        () => 1,
      );
      line("rays", "rays of this set, met", { color: "ray", width: 2 }, () => run.rays.count);
      line("switches", "switches that see something", { color: "current", width: 3.5 }, () => run.seeing.count);
      line(
        "path",
        "path so far (last 40 bold)",
        { color: "trail", width: 2.6 },
        () => null,
        () => (run.places && app.step > 1 ? 1 : 0),
      );
      line("marks", "given up", { cross: "mark" }, () => run.marks.count);
      line("targets", "targets", { ring: "target" }, () => run.targets.count);
      line("aim", "aim, and how to feel it", { color: "aim", width: 1.6, dash: 2 }, () => null);
      line("way", "way", { color: "way", width: 2, dash: 1 }, () => null);
      line("current", "current edge", { color: "current", width: 6 }, () => null);
      line("slice", "current slice", { color: "slice", width: 2 }, () => null);
    }
    if (app.truth) this.#truth();
  }

  #heading(words) {
    this.grid.append(element("div", { class: "heading" }, words));
  }

  #row(owner, name, label, swatch, amount, measure, { fixed = false, stress = true, title, show } = {}) {
    const drawn = element("canvas", {
      width: 52,
      height: 28,
      style: { width: "26px", height: "14px" },
      "aria-hidden": "true",
    });
    const box = element("input", {
      type: "checkbox",
      "aria-label": `show ${label}`,
      onchange: () => {
        owner.setHidden(name, !box.checked);
        if (name === "polygons") this.app.marker.showCut();
        line.classList.toggle("off", !box.checked);
      },
    });
    box.checked = true;
    const press = button(
      label,
      title ?? label,
      () => {
        if (!stress) return box.click();
        this.pinned = this.pinned === name ? null : name;
        this.#stress(this.pinned);
      },
      { class: "label" },
    );
    if (stress && name !== "polygons" && !fixed) {
      press.addEventListener("pointerenter", () => this.#stress(name));
      press.addEventListener("pointerleave", () => this.#stress(this.pinned));
    }
    const total = element("span", { class: "count" });
    const size = element("span", { class: "measure" });
    const line = element(
      "div",
      { class: "row", "data-row": name },
      element("label", {}, fixed ? "" : box),
      drawn,
      press,
      total,
      size,
    );
    this.grid.append(line);
    this.rows.push({ name, box, line, drawn, swatch, amount, measure, total, size, press, show, stress });
  }

  #stress(name) {
    const stressed = name === "polygons" || name === "known" ? null : name;
    this.app.model.setStressed(stressed);
    for (const { name: own, press, stress } of this.rows) {
      if (stress) press.setAttribute("aria-pressed", own === this.pinned ? "true" : "false");
    }
  }
  /// Switches what a row stands for on or off.
  toggle(name) {
    this.rows.find((row) => row.name === name).box.click();
  }
  clearStress() {
    this.pinned = null;
    this.#stress(null);
  }

  #truth() {
    const { app } = this;
    const choices = ["none", "over", "beside"];
    const buttons = choices.map((how) =>
      button(how, `truth: ${how}`, () => this.setTruth(how), { "data-truth": how }),
    );
    this.setTruth = (how) => {
      app.truth.set(how);
      buttons.forEach((made, i) => made.setAttribute("aria-pressed", choices[i] === how ? "true" : "false"));
      if (how === "beside" || this.wasBeside) app.viewer.fit();
      this.wasBeside = how === "beside";
    };
    this.cycleTruth = () => this.setTruth(choices[(choices.indexOf(app.truth.how) + 1) % 3]);
    buttons[0].setAttribute("aria-pressed", "true");
    this.grid.append(
      element("div", { class: "heading" }, "Truth", element("span", { class: "group" }, ...buttons)),
    );
  }

  show() {
    for (const row of this.rows) {
      const amount = row.amount();
      const shown = row.show ? row.show() > 0 : amount > 0;
      row.line.hidden = !shown;
      if (!shown) continue;
      row.total.textContent = amount === null ? "" : count(amount);
      row.size.textContent = row.measure ? row.measure() : "";
      if (row.theme !== this.app.theme) this.#drawSwatch(row);
    }
  }

  #drawSwatch(row) {
    row.theme = this.app.theme;
    const { theme } = this.app;
    const colors = themeColors(theme);
    const context = row.drawn.getContext("2d");
    const { swatch } = row;
    context.resetTransform();
    context.clearRect(0, 0, 52, 28);
    context.scale(2, 2);
    if (!swatch) return;
    if (swatch === "face" || swatch === "known" || swatch === "back") {
      const fill =
        swatch === "back"
          ? [colors.back]
          : swatch === "known"
          ? theme === "dark"
            ? ["#4d5766"]
            : ["#ccd4e0"]
          : theme === "dark"
            ? ["#3f5468", "#6b5a3d", "#3d5a49"]
            : ["#a9c4dc", "#e3cfae", "#a8d2b6"];
      fill.forEach((color, i) => {
        context.fillStyle = color;
        context.fillRect(2 + (i * 22) / fill.length, 2, 22 / fill.length, 10);
      });
      return;
    }
    if (swatch.cross) {
      context.strokeStyle = colors[swatch.cross];
      context.lineWidth = 2.2;
      context.beginPath();
      for (const side of [-1, 1]) {
        context.moveTo(13 - 4 * side, 3);
        context.lineTo(13 + 4 * side, 11);
      }
      context.stroke();
      return;
    }
    if (swatch.dot || swatch.ring) {
      context.strokeStyle = context.fillStyle = colors[swatch.dot ?? swatch.ring];
      context.lineWidth = 2;
      context.beginPath();
      context.arc(13, 7, swatch.dot ? 4 : 3.5, 0, 7);
      if (swatch.dot) context.fill();
      else context.stroke();
      return;
    }
    const reason = swatch.reason;
    context.strokeStyle = reason === undefined ? colors[swatch.color] : reasonColor(reason, theme);
    context.lineWidth = swatch.width ?? 3.2;
    const dash = kDashes[reason === undefined ? (swatch.dash ?? 0) : reasonDash(reason)];
    context.setLineDash(dash[1] > 0 ? dash : []);
    context.beginPath();
    context.moveTo(1, 7);
    context.lineTo(25, 7);
    context.stroke();
  }
}

// Copyright the limpet authors. GPL-3.0-or-later.
// Rows over the axis of steps: the modes as a band, a row of marks for each kind of event, charts. Drawn once
// for a size and a theme; while time goes on only the cursor moves.
import { button, element } from "./dom.js";
import { area, count, duration, length } from "./format.js";
import { modeColor } from "./palette.js";

const kBand = 16,
  kEvent = 14; // heights

export class Tracks {
  constructor(app, events, bar) {
    this.app = app;
    this.events = events;
    this.steps = app.head.steps;
    this.chartHeight = window.innerHeight < 850 ? 26 : 40;
    this.rows = this.#makeRows();
    this.labels = element("div", { class: "labels" });
    this.values = element("div", { class: "values" });
    this.canvas = element("canvas", { "aria-hidden": "true" });
    this.tip = element("div", { id: "tip", hidden: true });
    this.slider = element(
      "div",
      {
        id: "slider",
        role: "slider",
        tabindex: 0,
        "aria-label": "step",
        "aria-valuemin": 1,
        "aria-valuemax": this.steps,
      },
      this.canvas,
      this.tip,
    );
    this.root = element("div", { id: "tracks" }, this.labels, this.slider, this.values);
    for (const row of this.rows) {
      const style = { height: `${row.height}px` };
      const jumps = row.event
        ? [
            button("‹", `previous: ${row.label} (shift ${row.event.key})`, () => bar.jump(row.event, -1)),
            button("›", `next: ${row.label} (${row.event.key})`, () => bar.jump(row.event, 1)),
          ]
        : [];
      const title = row.label;
      row.extent = row.kind === "chart" ? element("span", { class: "extent" }) : null;
      this.labels.append(
        element(
          "div",
          { class: row.class, style, title },
          ...jumps,
          element("span", {}, row.label),
          row.extent,
        ),
      );
      row.value = element("div", { class: row.class, style });
      this.values.append(row.value);
    }
    this.#listen();
    this.still = document.createElement("canvas");
    app.on("theme", () => this.resize());
    new ResizeObserver(() => this.resize()).observe(this.slider);
  }

  #makeRows() {
    const { arrays, head } = this.app;
    const { resolution } = head;
    const rows = [{ kind: "band", class: "band", height: kBand, label: arrays.mode ? "mode" : "step" }];
    for (const event of this.events.rows) {
      if (event.steps.length)
        rows.push({ kind: "event", class: "event", height: kEvent, label: event.name, event });
    }
    const inLambda = (x) => length(x, resolution);
    const charts = [
      ["area", ["area"], (x) => area(x, resolution)],
      ["open length", ["open_length"], inLambda],
      ["clearance", ["clearance", "true_clearance"], inLambda],
      ["time a step", ["time_us"], duration],
    ];
    for (const [label, names, format] of charts) {
      const series = names.map((name) => arrays[name]).filter(Boolean);
      if (series.length)
        rows.push({ kind: "chart", class: "chart", height: this.chartHeight, label, series, format });
    }
    return rows;
  }

  #listen() {
    const stepAt = (event) => {
      const { left, width } = this.slider.getBoundingClientRect();
      return this.#step((event.clientX - left) / width);
    };
    let dragging = false;
    this.slider.addEventListener("pointerdown", (event) => {
      dragging = true;
      this.slider.setPointerCapture(event.pointerId);
      this.onScrub?.();
      this.app.seek(stepAt(event));
    });
    this.slider.addEventListener("pointermove", (event) => {
      if (dragging) this.app.seek(stepAt(event));
      this.#showTip(stepAt(event));
    });
    this.slider.addEventListener("pointerup", () => {
      dragging = false;
    });
    this.slider.addEventListener("pointercancel", () => {
      dragging = false;
    });
    this.slider.addEventListener("pointerleave", () => {
      this.tip.hidden = true;
    });
  }

  #showTip(step) {
    const { arrays, head } = this.app;
    const mode = arrays.mode?.[step - 1];
    this.tip.textContent =
      `step ${count(step)}` + (mode === undefined || mode === 255 ? "" : ` · ${head.modes[mode]}`);
    this.tip.hidden = false;
    this.tip.style.left = `${Math.min(Math.max(this.#x(step), 50), this.width - 50)}px`;
  }

  /// The step at a share of the width, and back.
  #step(share) {
    return Math.min(this.steps, Math.max(1, 1 + Math.floor(share * this.steps)));
  }
  #x(step) {
    return ((step - 0.5) / this.steps) * this.width;
  }

  resize() {
    const shown = this.rows.filter((row) => !this.root.classList.contains(`no-${row.class}s`));
    this.height = shown.reduce((sum, row) => sum + row.height, 0);
    this.slider.style.height = `${this.height}px`;
    this.width = this.slider.clientWidth;
    if (this.width === 0) return;
    const ratio = window.devicePixelRatio || 1;
    for (const canvas of [this.canvas, this.still]) {
      canvas.width = Math.round(this.width * ratio);
      canvas.height = Math.round(this.height * ratio);
    }
    const context = this.still.getContext("2d");
    context.scale(ratio, ratio);
    const style = getComputedStyle(document.documentElement);
    this.colors = Object.fromEntries(
      ["text", "quiet", "line", "raised", "accent", "surface"].map((name) => [
        name,
        style.getPropertyValue(`--${name}`).trim(),
      ]),
    );
    let top = 0;
    for (const row of shown) {
      this[{ band: "drawBand", event: "drawEvents", chart: "drawChart" }[row.kind]](context, row, top);
      top += row.height;
    }
    this.show();
  }

  drawBand(context, row, top) {
    const {
      arrays: { mode },
      head,
    } = this.app;
    context.fillStyle = this.colors.raised;
    context.fillRect(0, top + 1, this.width, row.height - 3);
    if (!mode) return;
    context.font = "600 10.5px system-ui, sans-serif";
    context.textBaseline = "middle";
    for (let from = 0; from < this.steps;) {
      let to = from + 1;
      while (to < this.steps && mode[to] === mode[from]) ++to;
      const x = (from / this.steps) * this.width,
        width = ((to - from) / this.steps) * this.width;
      if (mode[from] !== 255) {
        context.fillStyle = modeColor(mode[from]);
        context.fillRect(x, top + 1, Math.max(width - (width > 3 ? 0.5 : 0), 0.5), row.height - 3);
        const words = head.modes[mode[from]] ?? "";
        if (width > 30 && context.measureText(words).width < width - 8) {
          context.fillStyle = "#10141a";
          context.fillText(words, x + 4, top + row.height / 2);
        }
      }
      from = to;
    }
  }

  drawEvents(context, row, top) {
    context.fillStyle = this.colors.line;
    context.fillRect(0, top + row.height - 1, this.width, 0.5);
    context.fillStyle = row.event.color;
    let last = -1;
    for (const step of row.event.steps) {
      const x = Math.round(this.#x(step) * 2) / 2;
      if (x === last) continue; // many steps to a pixel: one mark is enough
      last = x;
      context.fillRect(x - 0.75, top + 3, 1.5, row.height - 6);
    }
  }

  drawChart(context, row, top) {
    const height = row.height - 5;
    let most = 0;
    for (const values of row.series)
      for (const value of values) if (value > most && value < Infinity) most = value;
    row.extent.textContent = `0 … ${row.format(most).replace(/ \(.*/, "")}`;
    context.fillStyle = this.colors.line;
    context.fillRect(0, top + row.height - 1, this.width, 0.5);
    if (most === 0) return;
    row.series.forEach((values, i) => {
      context.strokeStyle = i === 0 ? this.colors.accent : this.colors.quiet;
      context.lineWidth = 1.3;
      context.setLineDash(i === 0 ? [] : [3, 3]);
      context.beginPath();
      const y = (value) => top + 2 + height * (1 - value / most);
      // At most two points to a pixel, the least and the most: nothing that stands out is lost.
      const columns = Math.min(values.length, Math.ceil(this.width));
      let pen = false;
      for (let column = 0; column < columns; ++column) {
        const from = Math.floor((column * values.length) / columns);
        const to = Math.max(from + 1, Math.floor(((column + 1) * values.length) / columns));
        let low = Infinity,
          high = -Infinity;
        for (let k = from; k < to; ++k) {
          if (!Number.isFinite(values[k])) continue;
          low = Math.min(low, values[k]);
          high = Math.max(high, values[k]);
        }
        if (high < low) {
          pen = false;
          continue;
        }
        const x = this.#x((from + to + 1) / 2);
        if (pen) context.lineTo(x, y(low));
        else context.moveTo(x, y(low));
        if (high > low) context.lineTo(x, y(high));
        pen = true;
      }
      context.stroke();
      context.setLineDash([]);
    });
  }

  show() {
    if (!this.width || !this.app.step) return;
    const context = this.canvas.getContext("2d");
    const ratio = window.devicePixelRatio || 1;
    context.resetTransform();
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.drawImage(this.still, 0, 0);
    context.scale(ratio, ratio);
    const x = this.#x(this.app.step);
    context.fillStyle = this.colors.text;
    context.fillRect(x - 0.75, 0, 1.5, this.height);
    context.beginPath();
    context.moveTo(x - 5, 0);
    context.lineTo(x + 5, 0);
    context.lineTo(x, 7);
    context.fill();
    this.slider.setAttribute("aria-valuenow", this.app.step);
    this.slider.setAttribute("aria-valuetext", `step ${this.app.step} of ${this.steps}`);
    for (const row of this.rows) {
      if (row.kind !== "chart") continue;
      const value = row.series[0][this.app.step - 1];
      row.value.textContent = Number.isFinite(value) ? row.format(value) : "–";
      row.value.title = row.value.textContent;
    }
  }
}

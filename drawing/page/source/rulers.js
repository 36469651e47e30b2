// Copyright the limpet authors. GPL-3.0-or-later.
// How long things are and where the axes point.
import { Vector3 } from "three";
import { element } from "./dom.js";
import { length } from "./format.js";
import { themeColors } from "./palette.js";

/// The round length (1, 2 or 5 times a power of ten) that spans at most so many pixels.
export function roundLength(perPixel, pixels) {
  const most = perPixel * pixels;
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].find((x) => x * power <= most) * power;
}

export class Rulers {
  constructor(app, scale, triad) {
    this.app = app;
    this.rule = element("div", { class: "rule" });
    this.label = element("div");
    scale.append(this.label, this.rule);
    this.context = triad.getContext("2d");
    app.viewer.before.push(() => this.show());
  }

  show() {
    const { viewer, head, theme } = this.app;
    const perPixel = viewer.lengthPerPixel();
    this.length = roundLength(perPixel, 140);
    this.pixels = this.length / perPixel;
    this.words = length(this.length, head.resolution);
    this.rule.style.width = `${this.pixels}px`;
    this.label.textContent = this.words;
    drawTriad(this.context, viewer.camera, theme);
  }
}

export function drawTriad(context, camera, theme) {
  context.clearRect(0, 0, 64, 64);
  const axes = ["x", "y", "z"]
    .map((name, i) => {
      const v = new Vector3().setComponent(i, 1).transformDirection(camera.matrixWorldInverse);
      return { name, v, color: ["#d04a3a", "#3f9a4a", "#3f78d8"][i] };
    })
    .sort((a, b) => a.v.z - b.v.z);
  context.font = "600 11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 2;
  for (const { name, v, color } of axes) {
    context.strokeStyle = context.fillStyle = color;
    context.beginPath();
    context.moveTo(32, 32);
    context.lineTo(32 + 20 * v.x, 32 - 20 * v.y);
    context.stroke();
    context.fillStyle = themeColors(theme).shared;
    context.fillText(name, 32 + 27 * v.x, 32 - 27 * v.y);
  }
}

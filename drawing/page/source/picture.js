// Copyright the limpet authors. GPL-3.0-or-later.
// A picture of what is seen, to be kept: the scene with its scale, and which step it is.
import { drawTriad } from "./rulers.js";
import { themeColors } from "./palette.js";

/// A PNG, as a Blob.
export function takePicture(app, rulers) {
  const { viewer, theme } = app;
  // In the same task as it is copied: the drawing buffer is not kept.
  viewer.render({ level: 0, scale: 2 / viewer.pixelRatio });
  const source = viewer.canvas;
  const canvas = document.createElement("canvas");
  canvas.width = source.width;
  canvas.height = source.height;
  const context = canvas.getContext("2d");
  context.drawImage(source, 0, 0);
  const ratio = viewer.renderer.getPixelRatio();
  context.scale(ratio, ratio);
  const colors = themeColors(theme);
  const height = source.height / ratio,
    width = source.width / ratio;
  context.fillStyle = context.strokeStyle = colors.shared;
  context.font = "13px system-ui, sans-serif";
  context.textBaseline = "top";
  context.fillText(title(app), 10, 10, width - 20);
  context.textAlign = "center";
  context.textBaseline = "bottom";
  const { pixels, words } = rulers;
  context.fillText(words, 86 + pixels / 2, height - 20);
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(86, height - 18);
  context.lineTo(86, height - 12);
  context.lineTo(86 + pixels, height - 12);
  context.lineTo(86 + pixels, height - 18);
  context.stroke();
  const triad = document.createElement("canvas");
  triad.width = triad.height = 64;
  drawTriad(triad.getContext("2d"), viewer.camera, theme);
  context.drawImage(triad, 8, height - 72);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}

function title({ head, isRun, step }) {
  return isRun ? `${head.name}, step ${step} of ${head.steps}` : head.name;
}

export async function savePicture(app, rulers) {
  const blob = await takePicture(app, rulers);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  const name = app.head.name.replace(/[^\w.-]+/g, "_");
  link.download = app.isRun ? `${name}-${app.step}.png` : `${name}.png`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

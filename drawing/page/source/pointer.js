// Copyright the limpet authors. GPL-3.0-or-later.
// The mouse on the scene: a click selects, a drag does not.

export function installPointer(app) {
  const { canvas } = app.viewer;
  let down = null;
  canvas.addEventListener("pointerdown", (event) => {
    down = event.button === 0 ? [event.clientX, event.clientY] : null;
  });
  const pick = (event) => {
    const { left, top } = canvas.getBoundingClientRect();
    return app.picker.pick(event.clientX - left, event.clientY - top);
  };
  canvas.addEventListener("pointerup", (event) => {
    if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > 4) return;
    down = null;
    app.select(selectionOf(pick(event)));
  });
  canvas.addEventListener("dblclick", () => app.focusSelection());
}

export function selectionOf(picked) {
  if (!picked) return null;
  const { edge, polygon, point } = picked;
  return edge !== undefined ? { edge } : point !== undefined ? { point } : { polygon };
}

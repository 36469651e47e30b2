// Copyright the limpet authors. GPL-3.0-or-later.
// Deep links: what the page shows, in the address; #step=412&edge=1234&view=top.

/// {step, edge, polygon, view} of a hash, as far as they are there and sound.
export function parseHash(hash) {
  const fields = new URLSearchParams(hash.replace(/^#/, ""));
  const found = {};
  for (const name of ["step", "edge", "polygon"]) {
    const text = fields.get(name);
    if (text !== null && /^\d{1,16}$/.test(text)) found[name] = Number(text);
  }
  const view = fields.get("view");
  if (view !== null) found.view = view;
  return found;
}

export function formatHash({ step, edge, polygon, view }) {
  const fields = Object.entries({ step, edge, polygon, view }).filter(
    ([, value]) => value !== undefined && value !== null,
  );
  return fields.length ? `#${fields.map(([name, value]) => `${name}=${value}`).join("&")}` : "";
}

export class DeepLinks {
  constructor(app) {
    this.app = app;
    this.asked = parseHash(location.hash);
    for (const event of ["step", "selection"]) app.on(event, () => this.#changed());
    app.viewer.viewListeners.push(() => this.#changed());
    window.addEventListener("hashchange", () => {
      if (location.hash !== this.written) this.follow(parseHash(location.hash));
    });
  }

  /// Shows what a link asks for.
  follow({ step, edge, polygon, view }) {
    const { app } = this;
    if (step !== undefined && app.isRun) app.seek(step);
    if (view !== undefined) app.viewer.setView(view);
    if (edge !== undefined) app.select({ edge }, { focus: view === undefined });
    else if (polygon !== undefined) app.select({ polygon }, { focus: view === undefined });
    else app.select(null);
  }

  // Browsers allow few changes of the address a second: while playing, it follows late.
  #changed() {
    if (this.timer) return;
    this.timer = setTimeout(() => {
      this.timer = null;
      const { app } = this;
      const { edge, polygon, point } = app.selection ?? {};
      this.written = formatHash({
        step: app.isRun ? app.step : undefined,
        edge,
        polygon: polygon ?? point,
        view: app.viewer.view && app.viewer.view !== "iso" ? app.viewer.view : undefined,
      });
      if (this.written === location.hash) return;
      history.replaceState(null, "", this.written || location.pathname + location.search);
    }, 400);
  }
}

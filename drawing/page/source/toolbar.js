// Copyright the limpet authors. GPL-3.0-or-later.
// Buttons over the scene: named views, projection, section, picture, theme, panel, help.
import { button, element } from "./dom.js";
import { kViews } from "./viewer.js";

export class Toolbar {
  constructor(ui, root) {
    const { app } = ui;
    const { viewer } = app;
    const names = Object.keys(kViews);
    this.views = names.map((name, i) =>
      button(name, `view: ${name} (${i + 1})`, () => viewer.setView(name), { "data-view": name }),
    );
    this.projection = button(
      "perspective",
      "perspective or orthographic (p)",
      () => this.toggleProjection(),
      { id: "projection" },
    );
    this.section = button("section", "section plane (x)", () => ui.section.set({ on: !ui.section.on }), {
      id: "sectiontoggle",
    });
    this.panel = button("panel", "show the panel (h)", () => this.togglePanel(), {
      id: "paneltoggle",
      "aria-pressed": "true",
    });
    this.theme = button(
      "",
      "light or dark (t)",
      () => app.setTheme(app.theme === "dark" ? "light" : "dark"),
      { id: "themetoggle" },
    );
    const group = (...buttons) => element("span", { class: "group" }, ...buttons);
    root.append(
      group(...this.views),
      group(
        button("fit", "fit all (f)", () => viewer.fit()),
        this.projection,
      ),
      group(this.section),
      element("span", { class: "space" }),
      group(
        button("PNG", "save a picture of what is seen (i)", () => ui.savePicture(), { id: "png" }),
        this.theme,
        this.panel,
        button("?", "keys and mouse (?)", () => ui.help.showModal(), { id: "helptoggle" }),
      ),
    );
    this.app = app;
    viewer.viewListeners.push(() => this.#showView());
    app.on("theme", () => this.#showTheme());
    ui.section.listeners.push(() =>
      this.section.setAttribute("aria-pressed", ui.section.on ? "true" : "false"),
    );
    this.#showView();
    this.#showTheme();
  }

  toggleProjection() {
    const { viewer } = this.app;
    viewer.setOrthographic(!viewer.isOrthographic);
    this.projection.textContent = viewer.isOrthographic ? "orthographic" : "perspective";
  }
  togglePanel() {
    const hidden = document.getElementById("app").classList.toggle("no-panel");
    this.panel.setAttribute("aria-pressed", hidden ? "false" : "true");
  }
  #showView() {
    for (const made of this.views) {
      made.setAttribute("aria-pressed", made.dataset.view === this.app.viewer.view ? "true" : "false");
    }
  }
  #showTheme() {
    this.theme.textContent = this.app.theme === "dark" ? "light" : "dark";
  }
}

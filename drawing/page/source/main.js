// Copyright the limpet authors. GPL-3.0-or-later.
// Starts the page: unpacks the data, makes the parts, opens where the address says.
import { App } from "./app.js";
import { byId } from "./dom.js";
import { derived } from "./geometry.js";
import { Events } from "./events.js";
import { Legend } from "./legend.js";
import { DeepLinks } from "./links.js";
import { Player } from "./player.js";
import { Readout } from "./readout.js";
import { Rulers } from "./rulers.js";
import { SectionControl } from "./section.js";
import { SelectionPanel } from "./selection_panel.js";
import { StepPanel, aboutPanel } from "./step_panel.js";
import { TimeBar } from "./timebar.js";
import { Toolbar } from "./toolbar.js";
import { bytesOfBase64, gunzip, parseContainer } from "./container.js";
import { installKeys } from "./keys.js";
import { installPointer } from "./pointer.js";
import { savePicture } from "./picture.js";
import { searchPanel } from "./search.js";
import { testInterface } from "./interface.js";

async function start() {
  const progress = byId("progress");
  const data = parseContainer(await gunzip(bytesOfBase64(byId("data").textContent.trim())));
  byId("data").textContent = ""; // some megabytes that nobody needs any more
  byId("program").textContent = "";
  byId("app").hidden = false;
  byId("time").hidden = data.head.kind !== "run";

  const app = new App(data, byId("view"));
  const links = new DeepLinks(app);
  if (app.isRun && links.asked.step === undefined) {
    await app.timeline.index((share) => {
      progress.textContent = `Reading the run … ${Math.round(100 * share)} %`;
    });
  }
  const events = new Events(data);
  const player = new Player(app);
  const ui = { app, events, player, help: byId("help") };
  ui.section = new SectionControl(app, byId("sectionbar"));
  ui.rulers = new Rulers(app, byId("scale"), byId("triad"));
  ui.savePicture = () => savePicture(app, ui.rulers);
  ui.toolbar = new Toolbar(ui, byId("toolbar"));
  ui.readout = new Readout(app, byId("readout"));
  const selection = new SelectionPanel(app, events);
  ui.legend = new Legend(app);
  const steps = app.isRun ? new StepPanel(app, events, selection) : null;
  byId("panel").append(
    searchPanel(app),
    selection.root,
    ui.legend.root,
    ...(steps ? [steps.root] : []),
    aboutPanel(app),
  );
  ui.search = byId("search");
  if (app.isRun) {
    ui.bar = new TimeBar(app, player, events, byId("time"));
    ui.bar.tracks.onScrub = () => player.pause();
  }
  ui.selectNext = (kind, by) => selectNext(app, kind, by);
  installKeys(ui);
  installPointer(app);
  new ResizeObserver(() => app.viewer.resize()).observe(byId("stage"));
  app.viewer.resize();
  app.viewer.setView("iso");

  app.seek(links.asked.step ?? app.head.steps);
  if (facesInwards(app)) ui.legend.toggle("backs");
  links.follow(links.asked);
  byId("start").hidden = true;
  app.viewer.render();
  return { app, ui };
}

/// Was most of it seen from inside, as a room is? Then its backs would hide all there is.
function facesInwards(app) {
  let inwards = 0;
  for (const polygon of app.state.polygons.values()) {
    const { area, inner } = derived(polygon, app.frame);
    const outwards = inner.reduce((sum, x, axis) => sum + x * polygon.normal[axis], 0);
    inwards += outwards < 0 ? area : -area;
  }
  return inwards > 0;
}

/// Goes through polygons, or open edges, in the order of their identities.
function selectNext(app, kind, by) {
  const { state } = app;
  const ids =
    kind === "polygon"
      ? [...state.polygons.keys()]
      : [...state.edges].filter(([, { partner }]) => partner === 0).map(([id]) => id);
  if (ids.length === 0) {
    app.say(kind === "polygon" ? "there is no polygon" : "no edge is open");
    return;
  }
  ids.sort((a, b) => a - b);
  const at = ids.indexOf(app.selection?.[kind]);
  const next = at < 0 ? (by > 0 ? 0 : ids.length - 1) : (at + by + ids.length) % ids.length;
  app.select({ [kind]: ids[next] }, { focus: true });
}

window.limpet = testInterface(start(), (error) => {
  byId("app").hidden = true;
  byId("start").hidden = false;
  byId("progress").textContent = `The page cannot be shown: ${error.message}`;
});

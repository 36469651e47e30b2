// Copyright the limpet authors. GPL-3.0-or-later.
// The time bar: transport, mode band, event marks and charts, which share one axis of steps.
import { button, element } from "./dom.js";
import { count } from "./format.js";
import { kSpeeds } from "./player.js";
import { Tracks } from "./tracks.js";

export class TimeBar {
  constructor(app, player, events, root) {
    this.app = app;
    this.player = player;
    this.events = events;
    root.hidden = false;
    const { steps } = app.head;
    this.playButton = button("▶", "play or pause (space)", () => player.toggle(), { id: "play" });
    this.speed = element(
      "select",
      {
        "aria-label": "speed",
        title: "speed ([ and ])",
        onchange: () => player.setSpeed(Number(this.speed.value)),
      },
      ...kSpeeds.map((speed) => element("option", { value: speed }, `${speed} steps/s`)),
    );
    this.field = element("input", {
      type: "number",
      min: 1,
      max: steps,
      step: 1,
      "aria-label": "step",
      id: "stepfield",
      onchange: () => this.#go(this.field.valueAsNumber),
    });
    this.kind = element("select", { "aria-label": "kind of event", id: "eventkind" });
    for (const row of events.rows) {
      if (row.steps.length > 0)
        this.kind.append(element("option", { value: row.name }, `${row.name} (${count(row.steps.length)})`));
    }
    const chosen = () => events.rows.find((row) => row.name === this.kind.value);
    this.tracks = new Tracks(app, events, this);
    const toggle = (name, label, key) => {
      const made = button(label, `show ${label} (${key})`, () => this.toggle(name), { id: `toggle-${name}` });
      return made;
    };
    this.toggles = { events: toggle("events", "events", "v"), charts: toggle("charts", "charts", "g") };
    root.append(
      element(
        "div",
        { id: "transport" },
        element(
          "span",
          { class: "group" },
          button("|◂", "first step (Home)", () => this.#go(1)),
          button("◂", "step back (←)", () => this.#go(app.step - 1)),
          this.playButton,
          button("▸", "step on (→)", () => this.#go(app.step + 1)),
          button("▸|", "last step (End)", () => this.#go(steps)),
        ),
        this.speed,
        element("label", {}, "step", this.field, `of ${count(steps)}`),
        element("span", { class: "space" }),
        ...(this.kind.options.length
          ? [
              element("label", {}, "jump to", this.kind),
              element(
                "span",
                { class: "group" },
                button("‹ previous", "previous event of this kind", () => this.jump(chosen(), -1), {
                  id: "eventprevious",
                }),
                button("next ›", "next event of this kind", () => this.jump(chosen(), 1), {
                  id: "eventnext",
                }),
              ),
            ]
          : []),
        element("span", { class: "group" }, ...Object.values(this.toggles)),
      ),
      this.tracks.root,
    );
    player.listeners.push(() => this.#showPlayer());
    app.on("step", () => this.show());
    this.#showPlayer();
    const low = window.innerHeight < 600;
    this.toggle("events", !low);
    this.toggle("charts", !low);
  }

  toggle(name, on = this.tracks.root.classList.contains(`no-${name}`)) {
    this.tracks.root.classList.toggle(`no-${name}`, !on);
    this.toggles[name].setAttribute("aria-pressed", on ? "true" : "false");
    this.tracks.resize();
  }

  #go(step) {
    this.player.pause();
    this.app.seek(step);
  }

  jump(row, direction) {
    const step = this.events.next(row, this.app.step, direction);
    this.player.pause();
    if (step === null) this.app.say(`no ${direction > 0 ? "later" : "earlier"} event: ${row.name}`);
    else this.app.seek(step);
  }

  show() {
    if (document.activeElement !== this.field || this.player.playing) this.field.value = this.app.step;
    this.tracks.show();
  }

  #showPlayer() {
    this.playButton.textContent = this.player.playing ? "❚❚" : "▶";
    this.speed.value = this.player.speed;
  }
}

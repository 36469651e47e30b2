// Copyright the limpet authors. GPL-3.0-or-later.
// What a step was: readings, motion, mode, times, and what changed.
import { button, element, terms } from "./dom.js";
import { area, count, duration, length, number, place, plural } from "./format.js";

const kMostEvents = 12;

export class StepPanel {
  constructor(app, events, selection) {
    this.app = app;
    this.events = events;
    this.selection = selection;
    this.root = element("section", { id: "step" });
    app.on(
      "step",
      app.calmly(() => this.show()),
    );
  }

  show() {
    const { app } = this;
    const { head, arrays, step, run } = app;
    const { resolution } = head;
    const at = (name) => arrays[name]?.[step - 1];
    const finish = head.finished && step === head.steps;
    const set = run.set(step);
    const readings = run.readings(step);
    const ranges = readings.map(({ range }) => range);
    const sensors = head.robot?.sensors.length;
    const switches = head.robot?.switches?.length;
    const intent = app.state.intent ?? {};
    const path = arrays.path;
    const here = path && [0, 1, 2].map((i) => path[3 * set + i] + app.frame.origin[i]);
    const moved =
      path && set > 0 ? Math.hypot(...[0, 1, 2].map((i) => path[3 * set + i] - path[3 * set - 3 + i])) : NaN;
    const joints =
      arrays.joints && run.joints > 0
        ? [...arrays.joints.subarray(run.joints * set, run.joints * (set + 1))]
            .map((q) => number(q))
            .join(", ")
        : null;
    const mode = at("mode");
    const distance = (name) => (arrays[name] ? length(at(name), resolution) : null);
    this.root.replaceChildren(
      element("h2", {}, `Step ${count(step)} of ${count(head.steps)}`),
      finish
        ? element(
            "p",
            { class: "quiet" },
            "What finishing did after the last set; the robot is where it was then. " +
              `The run ended: ${head.run.ended}.`,
          )
        : "",
      terms([
        [
          "readings",
          sensors ? `${count(readings.length)} of ${count(sensors)} sensors` : count(readings.length),
        ],
        [
          "see something",
          switches ? `${count(run.switchesSeeing(step).length)} of ${count(switches)} switches` : null,
        ],
        [
          "ranges",
          ranges.length ? `${number(Math.min(...ranges), 3)} to ${number(Math.max(...ranges), 3)}` : null,
        ],
        ["control point", here ? place(here) : null],
        ["moved", Number.isFinite(moved) ? length(moved, resolution) : null],
        ["joints", joints],
        ["motion after it", mode === undefined ? null : mode === 255 ? "none" : head.modes[mode]],
        ["aims at", intent.aim ? place(app.frame.toWorld(app.frame.ofModel(intent.aim.target))) : null],
        ["targets", intent.targets ? count(intent.targets.length / 3) : null],
        ["current edge", intent.edge ? this.selection.edgeLink(intent.edge) : null],
        ["current segment", intent.segment ? this.selection.polygonLink(intent.segment) : null],
        ["clearance to model", distance("clearance")],
        ["clearance to truth", distance("true_clearance")],
        ["model's update", arrays.time_us ? duration(at("time_us")) : null],
        ["area", arrays.area ? area(at("area"), resolution) : null],
        ["open length", distance("open_length")],
      ]),
      ...this.#events(),
    );
  }

  #events() {
    const [first, last] = this.events.range(this.app.step);
    if (first === last) return [];
    const rows = [];
    for (let i = first; i < Math.min(last, first + kMostEvents); ++i) {
      rows.push(
        element(
          "p",
          {},
          ...this.events
            .describe(i)
            .map((part) =>
              typeof part === "string"
                ? part
                : part.edge !== undefined
                  ? element("span", {}, "edge ", this.selection.edgeLink(part.edge))
                  : element("span", {}, "polygon ", this.selection.polygonLink(part.polygon)),
            ),
        ),
      );
    }
    if (last - first > kMostEvents)
      rows.push(element("p", { class: "quiet" }, `and ${count(last - first - kMostEvents)} more`));
    return [element("h4", {}, `${plural(last - first, "event")} in this step`), ...rows];
  }
}

/// What is known of a model or a run as a whole.
export function aboutPanel(app) {
  const { head } = app;
  return element(
    "section",
    { id: "about" },
    element("h2", {}, head.kind === "run" ? "Run" : "Model"),
    terms([
      ["file", head.name],
      ["program", head.program],
      ["resolution λ", number(head.resolution)],
      ["angle μ", head.angle_deg === undefined ? null : `${number(head.angle_deg)}°`],
      ["noise", head.noise?.some((x) => x > 0) ? head.noise.map((x) => number(x)).join(", ") : "0"],
      ["tolerance", head.tolerance === undefined ? null : length(head.tolerance, head.resolution)],
      ["strategy", head.run?.strategy],
      ["ended", head.run?.ended],
      ["sets", head.run ? count(head.run.sets) : null],
      ["seed", head.run?.seed === undefined ? null : String(head.run.seed)],
      ["robot", head.robot?.name],
      ["truth", head.truth?.name],
      [
        "given up",
        head.run?.marks
          ? Object.entries(head.run.marks)
              .filter(([, ids]) => ids.length)
              .map(([name, ids]) => `${ids.length} ${name.replace("_", " ")}`)
              .join(", ") || "nothing"
          : null,
      ],
      ["reasons asked", head.run?.reasons_every > 1 ? `every ${head.run.reasons_every} steps` : null],
      ["lengths", "in the file's unit"],
    ]),
    element(
      "p",
      {},
      button("keys and mouse (?)", "keys and mouse (?)", () => document.getElementById("help").showModal(), {
        class: "small",
      }),
    ),
  );
}

// Copyright the limpet authors. GPL-3.0-or-later.
// Keys for everything, and the overlay that lists them.
import { button, element } from "./dom.js";
import { kViews } from "./viewer.js";

/// Groups of [keys to show, words, keys as events have them, what they do]. Shift and letters: capitals.
function bindings(ui) {
  const { app, player, bar, section, legend } = ui;
  const { viewer } = app;
  const run = app.isRun;
  const turn = Math.PI / 24;
  const go = (step) => {
    player.pause();
    app.seek(step);
  };
  const far = Math.max(10, Math.round(app.head.steps / 100));
  const groups = [];
  if (run) {
    groups.push([
      "Time",
      [
        ["space", "play, pause", [" "], () => player.toggle()],
        [
          "← →",
          "a step back, on",
          ["ArrowLeft", "ArrowRight"],
          (key) => go(app.step + (key === "ArrowLeft" ? -1 : 1)),
        ],
        [
          "shift ← →",
          `${far} steps back, on`,
          ["Shift+ArrowLeft", "Shift+ArrowRight", "PageUp", "PageDown"],
          (key) => go(app.step + (key.endsWith("Left") || key === "PageUp" ? -far : far)),
        ],
        ["Home End", "first, last step", ["Home", "End"], (key) => go(key === "Home" ? 1 : app.head.steps)],
        ["[ ]", "slower, faster", ["[", "]"], (key) => player.faster(key === "[" ? -1 : 1)],
        ["v g", "show events, charts", ["v", "g"], (key) => bar.toggle(key === "v" ? "events" : "charts")],
      ],
    ]);
    groups.push([
      "Next event (with shift: previous)",
      ui.events.rows
        .filter((row) => row.steps.length)
        .map((row) => [
          row.key,
          row.name,
          [row.key, row.key.toUpperCase()],
          (key) => bar.jump(row, key === row.key ? 1 : -1),
        ]),
    ]);
  }
  groups.push([
    "View",
    [
      [
        "1 … 7",
        Object.keys(kViews).join(", "),
        ["1", "2", "3", "4", "5", "6", "7"],
        (key) => viewer.setView(Object.keys(kViews)[Number(key) - 1]),
      ],
      ["f", "fit all", ["f"], () => viewer.fit()],
      [
        "w a s d",
        "turn",
        ["w", "a", "s", "d"],
        (key) => viewer.turn({ a: -turn, d: turn }[key] ?? 0, { w: turn, s: -turn }[key] ?? 0),
      ],
      ["+ −", "nearer, farther", ["+", "=", "-"], (key) => viewer.zoom(key === "-" ? 1 / 1.2 : 1.2)],
      ["p", "perspective or orthographic", ["p"], () => ui.toolbar.toggleProjection()],
      ["t", "light or dark", ["t"], () => app.setTheme(app.theme === "dark" ? "light" : "dark")],
      ...(app.truth ? [["y", "truth: none, over, beside", ["y"], () => legend.cycleTruth()]] : []),
      ["q", "backs of polygons: grey, or none", ["q"], () => legend.toggle("backs")],
      ["h", "show the panel", ["h"], () => ui.toolbar.togglePanel()],
      ["i", "save a picture (PNG)", ["i"], () => ui.savePicture()],
    ],
  ]);
  groups.push([
    "Section",
    [
      ["x", "on, off", ["x"], () => section.set({ on: !section.on })],
      ["X", "next axis", ["X"], () => section.set({ on: true, axis: (section.axis + 1) % 3 })],
      [
        ", .",
        "move",
        [",", "."],
        (key) => section.set({ on: true, share: section.share + (key === "," ? -0.02 : 0.02) }),
      ],
      ["z", "flip", ["z"], () => section.set({ on: true, flipped: !section.flipped })],
    ],
  ]);
  groups.push([
    "Selection",
    [
      ["/", "search by identity", ["/"], () => ui.search.focus()],
      ["n N", "next, previous polygon", ["n", "N"], (key) => ui.selectNext("polygon", key === "n" ? 1 : -1)],
      ["l L", "next, previous open edge", ["l", "L"], (key) => ui.selectNext("edge", key === "l" ? 1 : -1)],
      ["r", "bring it into view", ["r"], () => app.focusSelection()],
      [
        "Esc",
        "clear",
        ["Escape"],
        () => {
          legend.clearStress();
          app.select(null);
        },
      ],
      ["?", "these keys", ["?"], () => ui.help.showModal()],
    ],
  ]);
  return groups;
}

const kMouse = [
  ["drag", "turn"],
  ["wheel", "nearer, farther, towards the pointer"],
  ["right drag, shift drag", "shift"],
  ["click", "select a polygon, an edge, a point"],
  ["double click", "and bring it into view"],
  ["legend: point, click", "stress a kind of edges"],
];

export function installKeys(ui) {
  const groups = bindings(ui);
  const actions = new Map();
  for (const [, list] of groups)
    for (const [, , keys, act] of list) for (const key of keys) actions.set(key, act);
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || ui.help.open) return;
    const target = event.target;
    if (target.matches("input[type=search], input[type=number], select, input[type=range]")) {
      if (event.key === "Escape") target.blur();
      return;
    }
    // A focused button is pressed by space and enter, as everywhere.
    if (event.key === " " && target.matches("button, input")) return;
    const key = event.shiftKey && event.key.startsWith("Arrow") ? `Shift+${event.key}` : event.key;
    const act = actions.get(key);
    if (!act) return;
    event.preventDefault();
    act(key);
  });
  const caps = (keys) => keys.split(" ").flatMap((key, i) => [i > 0 ? " " : "", element("kbd", {}, key)]);
  const part = (title, rows, show = caps) =>
    element(
      "div",
      {},
      element("h3", {}, title),
      element(
        "dl",
        {},
        ...rows.flatMap(([keys, words]) => [element("dt", {}, ...show(keys)), element("dd", {}, words)]),
      ),
    );
  ui.help.replaceChildren(
    element(
      "h2",
      {},
      "Keys and mouse",
      button("close", "close (Esc)", () => ui.help.close()),
    ),
    element(
      "div",
      { class: "keys" },
      ...groups.map(([title, list]) => part(title, list)),
      part("Mouse", kMouse, (words) => [words]),
    ),
  );
}

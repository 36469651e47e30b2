// Copyright the limpet authors. GPL-3.0-or-later.
// Colours, for a light and a dark ground. Faces are muted so that edges read on them.

export const kUnknown = 17; // code of an open edge whose reason is not known

// Of open edges by reason, in the order of model::Refusal: on light, on dark, and the dash pattern. Hues are
// those of the drawing (open_edge_color.cpp), darker or lighter where the ground asks for it; neighbours in
// hue differ in dash.
const kReasons = [
  ["#0093c4", "#3cc8ff", 3], // none
  ["#dd4510", "#ff7d3e", 0], // alone
  ["#a87c00", "#ffd23c", 2], // angle
  ["#865622", "#d2a468", 3], // line_far
  ["#c4103a", "#ff6480", 1], // nothing_opposite
  ["#8424d8", "#bd88ff", 1], // ring_broken
  ["#008585", "#2cd0cc", 1], // undecided
  ["#008a46", "#38d484", 2], // short_section
  ["#1b4cf0", "#7098ff", 0], // goes_on
  ["#d800a8", "#ff6ade", 1], // inside_shared
  ["#78003c", "#e07aa8", 3], // other_pairs
  ["#55820a", "#a8e034", 1], // bay
  ["#d64c6c", "#ffa0b4", 2], // one_sided_end
  ["#5a3ca0", "#a694f0", 3], // corner_far
  ["#006438", "#5cc090", 3], // corner_bay
  ["#9a56d4", "#d8b0f6", 2], // corner_turns
  ["#f00000", "#ff4a4a", 2], // perimeter
  ["#666c76", "#a2a9b4", 0], // not known
];

// Dash patterns in pixels: drawn, left out. No gap: solid.
export const kDashes = [
  [1, 0],
  [11, 4],
  [5, 3],
  [2, 2.5],
];

const kThemes = {
  light: {
    ground: "#f3f4f6",
    shared: "#14181d",
    corner: "#14181d",
    point: "#7a4b00",
    back: "#9a9da3",
    path: "#6a7484",
    trail: "#0b5cad",
    ray: "#0a8f6a",
    miss: "#b3bac4",
    robot: "#3b4654",
    target: "#b000c8",
    aim: "#b000c8",
    way: "#0b5cad",
    current: "#e0a400",
    mark: "#c00000",
    slice: "#008a8a",
    truth: "#5c6470",
    select: "#ff00aa",
    cut: "#14181d",
    grid: "#d4d8de",
  },
  dark: {
    ground: "#15181c",
    shared: "#f2f4f7",
    corner: "#ffffff",
    point: "#ffc46b",
    back: "#54585f",
    path: "#8590a2",
    trail: "#6cb6ff",
    ray: "#4fe0b0",
    miss: "#4a525e",
    robot: "#c6ced9",
    target: "#f08cff",
    aim: "#f08cff",
    way: "#6cb6ff",
    current: "#ffd24a",
    mark: "#ff5a5a",
    slice: "#40d8d8",
    truth: "#98a2b0",
    select: "#ff4fc4",
    cut: "#ffffff",
    grid: "#2b3037",
  },
};

export const themeColors = (theme) => kThemes[theme];
export const reasonColor = (code, theme) => kReasons[code][theme === "dark" ? 1 : 0];
export const reasonDash = (code) => kReasons[code][2];

// Hue (of a turn) and lightness (0 to 1) of faces, in an order in which those that follow each other are far
// apart.
const kFaces = [
  [0.58, 0.5],
  [0.1, 0.7],
  [0.36, 0.3],
  [0.86, 0.6],
  [0.16, 1],
  [0.48, 0.9],
  [0.72, 0.9],
  [0.02, 0.2],
  [0.27, 0.8],
  [0.64, 0],
  [0.93, 1],
  [0.42, 0.5],
];
export const kFaceColors = kFaces.length;

export function faceColor(index, theme) {
  const [turn, tone] = kFaces[index];
  return theme === "dark" ? hsl(turn, 0.32, 0.27 + 0.1 * tone) : hsl(turn, 0.45, 0.74 + 0.1 * tone);
}
export const knownColor = (theme) => (theme === "dark" ? [0.3, 0.34, 0.4] : [0.8, 0.83, 0.88]);

// Bright enough on both grounds, and apart for all kinds of sight (after Okabe and Ito).
const kModeColors = ["#8a919c", "#56a4dd", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#b8a800", "#7a68d8"];
export const modeColor = (mode) => (mode === 255 || mode === undefined ? "#8a919c" : kModeColors[mode % 8]);

function hsl(hue, saturation, lightness) {
  const a = saturation * Math.min(lightness, 1 - lightness);
  const channel = (n) => {
    const k = (n + 12 * hue) % 12;
    return lightness - a * Math.max(-1, Math.min(k - 3, 9 - k, 1));
  };
  return [channel(0), channel(8), channel(4)];
}

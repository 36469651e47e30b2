// Copyright the limpet authors. GPL-3.0-or-later.
// Search by identity: "polygon 12", "edge 345", "step 7", or a number alone.
import { element } from "./dom.js";

/// {polygon}, {edge}, {step} or null of what was typed; a number alone is looked for among edges, polygons,
/// points.
export function parseQuery(text, state) {
  const match = /^\s*(polygon|segment|point|p|edge|e|step|s)?\s*[#: ]?\s*(\d{1,16})\s*$/i.exec(text);
  if (!match) return null;
  const id = Number(match[2]);
  const word = match[1]?.toLowerCase();
  if (word?.startsWith("e")) return { edge: id };
  if (word === "step" || word === "s") return { step: id };
  if (word === "segment" || word === "point" || word?.startsWith("p")) return { polygon: id };
  if (state.polygons.has(id)) return { polygon: id };
  return state.edges.has(id) || !state.points.has(id) ? { edge: id } : { polygon: id };
}

export function searchPanel(app) {
  const input = element("input", {
    type: "search",
    id: "search",
    placeholder: "polygon 12, edge 345, step 7 …",
    "aria-label": "search by identity (/)",
    autocomplete: "off",
    spellcheck: "false",
  });
  const problem = element("p", { class: "problem", hidden: true });
  const form = element(
    "form",
    {
      class: "search",
      onsubmit: (event) => {
        event.preventDefault();
        const found = parseQuery(input.value, app.state);
        problem.hidden = true;
        if (!found) {
          problem.textContent = "Write polygon, edge or step, and a number.";
          problem.hidden = false;
        } else if (found.step !== undefined) app.seek(found.step);
        else app.select(found, { focus: true });
      },
    },
    input,
    element("button", { type: "submit" }, "Find"),
  );
  return element("section", { id: "find" }, form, problem);
}

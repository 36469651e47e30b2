// Copyright the limpet authors. GPL-3.0-or-later.
// Elements of the page. Text goes in as text, never as markup: names come from files.

export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name === "class") made.className = value;
    else if (name === "style") Object.assign(made.style, value);
    else made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined && child !== false));
  return made;
}

export const byId = (id) => document.getElementById(id);

export function button(label, title, onclick, attributes = {}) {
  return element("button", { type: "button", title, "aria-label": title, onclick, ...attributes }, label);
}

/// A list of terms and what they are; pairs whose value is null are left out.
export function terms(pairs) {
  const list = element("dl");
  for (const [term, value] of pairs) {
    if (value === null || value === undefined) continue;
    list.append(element("dt", {}, term), element("dd", {}, ...(Array.isArray(value) ? value : [value])));
  }
  return list;
}

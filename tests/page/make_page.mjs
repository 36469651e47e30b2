// Copyright the limpet authors. GPL-3.0-or-later.
// Pastes template, style, program and data to a page, as the program does.
import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { fileURLToPath } from "node:url";

const kFolder = fileURLToPath(new URL("../../drawing/page/", import.meta.url));

let bundled = null;
export function bundle() {
  bundled ??= execFileSync(
    "esbuild",
    [
      `${kFolder}source/main.js`,
      "--bundle",
      "--minify",
      "--format=iife",
      "--target=es2020",
      "--legal-comments=none",
    ],
    { maxBuffer: 1 << 26 },
  );
  return bundled;
}

const escape = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

export function makePage(data, title) {
  const parts = {
    title: escape(title),
    style: readFileSync(`${kFolder}style.css`, "utf8"),
    program: gzipSync(bundle(), { level: 9 }).toString("base64"),
    data: gzipSync(data, { level: 9 }).toString("base64"),
  };
  return readFileSync(`${kFolder}page.html`, "utf8").replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]);
}

// node make_page.mjs toy|ball:N|model FILE|run FILE FOLDER EVERY MODEL -o PAGE
if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const invented = {
    ...(await import("./toy.mjs")),
    ...(await import("./large.mjs")),
    ...(await import("./recorded.mjs")),
  };
  const [kind, ...rest] = process.argv.slice(2);
  const at = rest.indexOf("-o");
  const to = at >= 0 ? rest.splice(at, 2)[1] : "page.html";
  const data =
    kind === "toy"
      ? invented.toy({ robot: rest[0] ?? true })
      : kind.startsWith("ball")
        ? invented.ball(Number(kind.split(":")[1] ?? 1000))
        : kind.startsWith("long")
          ? invented.long(Number(kind.split(":")[1] ?? 1000))
          : kind === "model"
            ? invented.model(rest[0])
            : invented.run(rest[0], rest[1], Number(rest[2]), rest[3]);
  writeFileSync(to, makePage(data, rest[0] ?? kind));
  console.log(`${to}: data ${data.length} bytes, ${gzipSync(data).length} in gzip`);
}

// Copyright the limpet authors. GPL-3.0-or-later.
// The browser that tests look at pages with, and the program's pages.
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const folder = mkdtempSync(join(tmpdir(), "limpet-page-"));
const kProfile = join(folder, "profile");

const kArguments = [
  "--headless",
  "--no-sandbox",
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

let context = null;
async function browser() {
  context ??= await chromium.launchPersistentContext(kProfile, {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: kArguments,
    acceptDownloads: true,
  });
  return context;
}
export async function closeBrowser() {
  await context?.close();
  rmSync(folder, { recursive: true, force: true });
}

/// Opens a page and waits until it is ready. What it said and asked for is in its `log` and `requests`.
export async function open(file, { hash = "", theme = "light", width = 1366, height = 768 } = {}) {
  const page = await (await browser()).newPage();
  page.log = [];
  page.requests = [];
  page.on("console", (message) => page.log.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => page.log.push(`error: ${error.stack}`));
  page.on("dialog", (dialog) => {
    page.log.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on("request", (request) => page.requests.push(request.url()));
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ colorScheme: theme });
  await page.goto(pathToFileURL(file).href + hash);
  await page.waitForFunction(() => window.limpet !== undefined);
  await page.evaluate(() => window.limpet.ready.then(() => true));
  return page;
}

export function write(name, content) {
  const path = join(folder, name);
  writeFileSync(path, content);
  return path;
}

export const program = process.env.LIMPET ?? null;
export function run(...words) {
  return execFileSync(program, words, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
}
/// Follows; exit code 1 says that the run is not complete.
export function follow(...words) {
  const { status, stderr } = spawnSync(program, ["follow", ...words], { cwd: folder, encoding: "utf8" });
  if (status > 1) throw new Error(stderr);
}
export const replay = (file, to) => follow("--replay", file, "-o", to, "--quiet");
export const canView = program !== null && spawnSync(program, ["view", "--help"]).status === 0;

// Copyright the limpet authors. GPL-3.0-or-later.
// The program's pages against the program's replays. LIMPET: the program. Or LIMPET_RUN and LIMPET_PAGE: a
// recorded run and its page, that are there already.
import test, { after } from "node:test";
import assert from "node:assert/strict";
import { canView, closeBrowser, folder, follow, open, program, replay, run, write } from "./browser.mjs";
import { cutRun, readModel, readRun } from "./files.mjs";
import { random } from "./parts.mjs";
import { readFileSync } from "node:fs";
import { join } from "node:path";

const seed = Number(process.env.SEED ?? Math.floor(Math.random() * 1e9));
const given = process.env.LIMPET_RUN && process.env.LIMPET_PAGE;
const skip =
  program === null ? "LIMPET is not set" : !given && !canView ? "the program has no command view" : false;
after(closeBrowser);

/// Cycles with their least edge first, polygons by identity: in whatever order they were written.
const sorted = (polygons) =>
  polygons
    .map(({ id, cycles }) => ({
      id,
      cycles: cycles.map(({ vertices }) => {
        let least = 0;
        vertices.forEach((v, i) => {
          if (v.edge < vertices[least].edge) least = i;
        });
        return [...vertices.slice(least), ...vertices.slice(0, least)];
      }),
    }))
    .sort((a, b) => a.id - b.id);

function assertSame(shown, model, unit, words) {
  const one = sorted(shown),
    other = sorted(model);
  assert.deepEqual(
    one.map(({ id }) => id),
    other.map(({ id }) => id),
    `${words}: polygons`,
  );
  one.forEach(({ id, cycles }, i) => {
    const what = (list) => list.map((vertices) => vertices.map(({ edge, partner }) => [edge, partner]));
    assert.deepEqual(what(cycles), what(other[i].cycles), `${words}, polygon ${id}: edges and partners`);
    cycles.forEach((vertices, c) =>
      vertices.forEach(({ edge, at }, k) =>
        at.forEach((x, axis) => {
          const far = Math.abs(x - other[i].cycles[c][k].at[axis]);
          assert.ok(far <= unit, `${words}, edge ${edge}: ${far} from where it is, the unit is ${unit}`);
        }),
      ),
    );
  });
}

const shownState = (page) =>
  page.evaluate(() => {
    const { unit, origin } = limpet.head;
    return [...limpet.state().polygons.values()].map(({ id, cycles }) => ({
      id,
      cycles: cycles.map((c) => ({
        vertices: Array.from(c.edges, (edge, i) => ({
          edge,
          partner: c.partners[i],
          at: [0, 1, 2].map((axis) => origin[axis] + unit * c.positions[3 * i + axis]),
        })),
      })),
    }));
  });

test(
  `at ten random steps the page shows what a replay models (SEED=${seed})`,
  { skip, timeout: 540000 },
  async () => {
    let file = process.env.LIMPET_RUN,
      page_ = process.env.LIMPET_PAGE;
    if (!given) {
      file = join(folder, "cube.run");
      page_ = join(folder, "cube.html");
      run("follow", "cube", "--record", file, "-o", join(folder, "cube.limpet"), "--quiet");
      run("view", file, "-o", page_, "--quiet");
    }
    const record = readRun(file);
    const page = await open(page_);
    const { sets, unit, steps, finished } = await page.evaluate(() => ({
      sets: limpet.head.run.sets,
      unit: limpet.head.unit,
      steps: limpet.head.steps,
      finished: limpet.head.finished,
    }));
    assert.equal(sets, record.sets.length);
    assert.equal(steps, finished ? sets + 1 : sets);
    const next = random(seed);
    for (let i = 0; i < 10; ++i) {
      const step = i === 0 ? sets : 1 + Math.floor(next() * sets);
      const cut = write("cut.run", cutRun(record, step)),
        model = join(folder, "cut.limpet");
      replay(cut, model);
      await page.evaluate((s) => {
        limpet.seek(s);
      }, step);
      assertSame(await shownState(page), readModel(model).polygons, unit, `step ${step}`);
    }
    if (finished) {
      const whole = join(folder, "whole.limpet");
      replay(file, whole);
      await page.evaluate((s) => {
        limpet.seek(s);
      }, steps);
      assertSame(await shownState(page), readModel(whole).polygons, unit, "the last step");
    }
    await page.locator("#transport select").first().selectOption("1000");
    await page.keyboard.press("Home");
    await page.keyboard.press(" ");
    await page.waitForFunction((s) => limpet.stats().step === s, steps, { timeout: 120000 });
    assert.deepEqual(page.log, []);
    assert.deepEqual(
      page.requests.filter((url) => !/^(file|data|blob):/.test(url)),
      [],
    );
    await page.close();
  },
);

test(
  "a model's page shows the model",
  { skip: skip || (!canView && "the program has no command view") },
  async () => {
    const scan = join(folder, "scan.ply"),
      model = join(folder, "scan.limpet"),
      file = join(folder, "scan.html");
    run("scan", "step_hole", "-o", scan, "--noise", "0.002", "--points", "20000", "--quiet");
    run("model", scan, "-o", model, "--quiet");
    run("view", model, "-o", file, "--quiet");
    const page = await open(file);
    const unit = await page.evaluate(() => limpet.head.unit);
    assertSame(await shownState(page), readModel(model).polygons, unit, "the model");
    assert.equal(await page.locator("#time").isVisible(), false);
    assert.deepEqual(page.log, []);
    await page.close();
  },
);

test(
  "of a robot with switches the page tells those that see something",
  { skip: skip || (!canView && "the program has no command view") },
  async () => {
    const file = join(folder, "switches.run"),
      page_ = join(folder, "switches.html");
    const how = ["--robot", "arm", "--link-sensors", "switches", "--max-sets", "80"];
    follow("cube", ...how, "--record", file, "-o", join(folder, "s.limpet"), "--quiet");
    run("view", file, "-o", page_, "--quiet");
    const text = readFileSync(file, "utf8");
    const all = Number(text.match(/\nswitches (\d+)\n/)[1]);
    const seeing = [...text.matchAll(/\nset .* seeing (\d+)/g)].map((match) => Number(match[1]));
    assert.equal(seeing.length, 80);
    assert.ok(seeing.some((n) => n > 0) && seeing.some((n) => n === 0));
    const page = await open(page_);
    for (const step of [1, 20, 40, 60, 80, 1 + seeing.findIndex((n) => n > 0)]) {
      await page.evaluate((s) => limpet.seek(s), step);
      await page.waitForFunction(
        (words) => document.body.innerText.includes(words),
        `${seeing[step - 1]} of ${all} switches`,
        { timeout: 20000 },
      );
    }
    assert.deepEqual(page.log, []);
    await page.close();
  },
);

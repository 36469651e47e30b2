// Copyright the limpet authors. GPL-3.0-or-later.
// The page in a browser: a toy run, whose every number is known.
import test, { after } from "node:test";
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync, existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { closeBrowser, open, write } from "./browser.mjs";
import { ball } from "./large.mjs";
import { toy } from "./toy.mjs";
import { makePage } from "./make_page.mjs";

const kToy = write("toy.html", makePage(toy(), "toy.run"));
const kBall = write("ball.html", makePage(ball(500), "ball.limpet"));
after(closeBrowser);

const silent = (page) => {
  assert.deepEqual(page.log, []);
  assert.deepEqual(
    page.requests.filter((url) => !/^(file|data|blob):/.test(url)),
    [],
  );
};
const text = (page, selector) => page.locator(selector).innerText();
const stats = (page) => page.evaluate(() => limpet.stats());
const selection = (page) => page.evaluate(() => limpet.selection());

test("opens at the last step, plays to the end, says nothing", async () => {
  const page = await open(kToy);
  assert.equal((await stats(page)).step, 60);
  assert.match(await text(page, "#readout"), /step 60 of 60/);
  assert.match(await text(page, "#readout"), /6 polygons.*12 shared.*closed/);
  assert.equal((await stats(page)).corners, 8);
  await page.locator("#transport select").first().selectOption("50");
  await page.keyboard.press("Home");
  assert.equal((await stats(page)).step, 1);
  await page.locator("#play").click();
  await page.waitForFunction(() => limpet.stats().step === 60 && !limpet.isPlaying());
  silent(page);
  await page.close();
});

test("a model has no time bar", async () => {
  const page = await open(kBall);
  assert.equal(await page.locator("#time").isVisible(), false);
  const { triangles, polygons } = await stats(page);
  assert.equal(triangles, polygons);
  await page.keyboard.press("l");
  assert.match(await text(page, "#message"), /no edge is open/);
  await page.keyboard.press("ArrowLeft");
  silent(page);
  await page.close();
});

test("a click selects what is drawn there, and the panel tells of it", async () => {
  const page = await open(kToy);
  for (const view of ["iso", "front", "top", "left"])
    for (const projection of [0, 1]) {
      await page.evaluate((name) => limpet.setView(name), view);
      if (projection) await page.keyboard.press("p");
      const facing = await page.evaluate(() =>
        [...limpet.state().polygons.values()]
          .filter(({ id, normal }) => {
            const inner = limpet.placeOf({ polygon: id });
            return limpet.camera().reduce((sum, x, i) => sum + (x - inner[i]) * normal[i], 0) > 0.3;
          })
          .map(({ id }) => ({ id, at: limpet.project(limpet.placeOf({ polygon: id })) })),
      );
      assert.ok(facing.length >= 1);
      for (const { id, at } of facing) {
        await page.mouse.click(...at);
        assert.deepEqual(await selection(page), { polygon: id }, `${view} ${projection} ${at}`);
        const panel = await text(page, "#selection");
        assert.match(panel, new RegExp(`polygon ${id}`));
        assert.match(panel, /points\n600/);
        assert.match(panel, /area\n1 \(400 λ²\)/);
        assert.match(panel, /edges\n4: 4 shared, 0 open/);
        assert.match(panel, /polygons\n6/);
        assert.match(panel, /nothing: closed/);
      }
      const ids = facing.map(({ id }) => id);
      const edges = await page.evaluate(
        (polygons) =>
          [...limpet.state().edges]
            .filter(
              ([id, e]) =>
                id < e.partner &&
                polygons.includes(e.segment) &&
                polygons.includes(limpet.state().edges.get(e.partner).segment),
            )
            .map(([id, { partner }]) => ({ id, partner, at: limpet.project(limpet.placeOf({ edge: id })) })),
        ids,
      );
      for (const { id, partner, at } of edges) {
        await page.mouse.click(at[0] + 2, at[1] + 2);
        const { edge } = await selection(page);
        assert.ok(edge === id || edge === partner, `${edge} is neither ${id} nor ${partner}`);
        const panel = await text(page, "#selection");
        assert.match(panel, new RegExp(`shared with\n${edge === id ? partner : id} of polygon`));
        assert.match(panel, /length\n1 \(20 λ\)/);
        assert.match(panel, /90°, convex/);
      }
      if (projection) await page.keyboard.press("p");
    }
  await page.mouse.click(20, 400);
  assert.equal(await selection(page), null);
  silent(page);
  await page.close();
});

test("an open edge says why, and since when", async () => {
  const page = await open(kToy, { hash: "#step=24&edge=100" });
  const { since, code } = await page.evaluate(() => ({
    since: limpet.state().edges.get(100).since,
    code: limpet.state().refusals.get(100).code,
  }));
  const words = await page.evaluate((c) => limpet.head.refusals[c].words, code);
  const panel = await text(page, "#selection");
  assert.ok(panel.includes(`Open: ${words}`), panel);
  assert.ok(panel.includes(`open since step ${since}`), panel);
  await page.evaluate(() => {
    const { edges, refusals } = limpet.seek(10) ?? limpet.state();
    limpet.select({ edge: [...edges].find(([id, e]) => e.partner === 0 && !refusals.has(id))[0] });
  });
  assert.match(await text(page, "#selection"), /reason not known/);
  silent(page);
  await page.close();
});

test("deep links open, follow, and are kept", async () => {
  const page = await open(kToy, { hash: "#step=41&edge=110&view=top" });
  assert.equal((await stats(page)).step, 41);
  assert.deepEqual(await selection(page), { edge: 110 });
  assert.equal((await stats(page)).view, "top");
  await page.evaluate(() => {
    location.hash = "#step=50&polygon=12";
  });
  await page.waitForFunction(() => limpet.stats().step === 50);
  assert.deepEqual(await selection(page), { polygon: 12 });
  const [x, y] = await page.evaluate(() => limpet.project(limpet.placeOf({ polygon: 12 })));
  assert.ok(x > 0 && y > 0 && x < 1000 && y < 560, "it is in view");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Escape");
  await page.keyboard.press("4");
  await page.waitForFunction(() => location.hash === "#step=49&view=left");
  silent(page);
  await page.close();
  const lost = await open(kToy, { hash: "#step=1&edge=999999&view=nowhere" });
  assert.match(await text(lost, "#selection"), /There is no edge 999999 at step 1/);
  silent(lost);
  await lost.close();
});

test("search by identity", async () => {
  const page = await open(kToy);
  const find = async (words) => {
    await page.keyboard.press("/");
    await page.keyboard.type(words);
    await page.keyboard.press("Enter");
    await page.locator("#search").fill("");
    await page.keyboard.press("Escape");
    return selection(page);
  };
  assert.deepEqual(await find("polygon 14"), { polygon: 14 });
  assert.deepEqual(await find("e 121"), { edge: 121 });
  assert.deepEqual(await find("12"), { polygon: 12 });
  assert.deepEqual(await find("130"), { edge: 130 });
  await find("step 33");
  assert.equal((await stats(page)).step, 33);
  await find("polygon 15");
  assert.match(await text(page, "#selection"), /There is no polygon 15 at step 33/);
  await page.locator("#selection button", { hasText: "where it became a polygon" }).click();
  assert.ok((await stats(page)).step > 33);
  assert.match(await text(page, "#selection"), /area/);
  await find("nonsense");
  assert.match(await text(page, "#find"), /Write polygon, edge or step/);
  silent(page);
  await page.close();
});

test("keys, events, theme, help", async () => {
  const page = await open(kToy);
  const step = async (key) => {
    await page.keyboard.press(key);
    return (await stats(page)).step;
  };
  assert.equal(await step("ArrowLeft"), 59);
  assert.equal(await step("Shift+ArrowLeft"), 49);
  assert.equal(await step("Home"), 1);
  const born = await step("b");
  assert.equal(born, 2);
  const second = await step("b");
  assert.ok(second > born);
  assert.equal(await step("B"), born);
  assert.equal(await step("k"), 5);
  await page.locator("#eventkind").selectOption("edge shared");
  await page.locator("#eventnext").click();
  const shared = (await stats(page)).step;
  assert.match(await text(page, "#step"), /shared with edge/);
  await page.locator("#eventprevious").click();
  assert.match(await text(page, "#message"), /no earlier event/);
  assert.equal((await stats(page)).step, shared);
  await page.keyboard.press("n");
  assert.deepEqual(await selection(page), { polygon: 10 });
  await page.keyboard.press("l");
  assert.ok((await selection(page)).edge > 0);
  await page.keyboard.press("?");
  assert.ok(await page.locator("#help").isVisible());
  await page.keyboard.press("Escape");
  assert.ok(!(await page.locator("#help").isVisible()));
  assert.equal((await stats(page)).theme, "light");
  await page.keyboard.press("t");
  assert.equal((await stats(page)).theme, "dark");
  const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(ground, "rgb(21, 24, 28)");
  await page.keyboard.press("p");
  assert.ok((await stats(page)).orthographic);
  const box = await page.locator("#slider").boundingBox();
  await page.mouse.click(box.x + box.width * 0.5, box.y + 5);
  assert.ok(Math.abs((await stats(page)).step - 30) <= 1);
  silent(page);
  await page.close();
});

test("the legend counts what there is, switches it off, and it cannot be picked then", async () => {
  const page = await open(kToy, { hash: "#step=30" });
  const counted = Number(await text(page, "[data-row=open] .count"));
  const open_ = await page.evaluate(
    () => [...limpet.state().edges.values()].filter((e) => e.partner === 0).length,
  );
  assert.equal(counted, open_);
  const at = await page.evaluate(() => limpet.project(limpet.placeOf({ polygon: 12 })));
  assert.deepEqual(await page.evaluate((p) => limpet.pick(...p), at), { polygon: 12 });
  await page.locator("[data-row=polygons] input").click();
  assert.notDeepEqual(await page.evaluate((p) => limpet.pick(...p), at), { polygon: 12 });
  silent(page);
  await page.close();
});

test("a section cuts away what is before it", async () => {
  const page = await open(kToy);
  await page.evaluate(() => limpet.setView("right"));
  const at = await page.evaluate(() => limpet.project([1, 0.5, 0.5]));
  const before = await page.evaluate((p) => limpet.pick(...p), at);
  await page.keyboard.press("x");
  let after_ = await page.evaluate((p) => limpet.pick(...p), at);
  if (after_?.polygon === before.polygon) {
    await page.keyboard.press("z");
    after_ = await page.evaluate((p) => limpet.pick(...p), at);
  }
  assert.equal(before.polygon, 11);
  assert.equal(after_.polygon, 10);
  assert.match(await text(page, "#sectionbar"), /0\.5 \(10 λ\)/);
  await page.keyboard.press(".");
  assert.doesNotMatch(await text(page, "#sectionbar"), /0\.5 \(10 λ\)/);
  silent(page);
  await page.close();
});

/// Colours of a PNG in the page: how many different ones, and how far two pictures differ.
const compare = (page, one, other) =>
  page.evaluate(
    async ([a, b]) => {
      const pixels = async (base64) => {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
        const canvas = new OffscreenCanvas(image.width, image.height);
        const context = canvas.getContext("2d");
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, image.width, image.height);
      };
      const first = await pixels(a);
      const colors = new Set(new Uint32Array(first.data.buffer)).size;
      if (!b) return { colors, width: first.width, height: first.height };
      const second = await pixels(b);
      if (first.width !== second.width || first.height !== second.height) return { colors, differ: 1 };
      let differ = 0;
      for (let i = 0; i < first.data.length; i += 4) {
        if ([0, 1, 2].some((k) => Math.abs(first.data[i + k] - second.data[i + k]) > 48)) ++differ;
      }
      return { colors, differ: (differ * 4) / first.data.length };
    },
    [one, other],
  );

test("a picture is saved, and not blank", async () => {
  const page = await open(kToy, { hash: "#step=30" });
  const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#png").click()]);
  assert.equal(download.suggestedFilename(), "toy.run-30.png");
  const { colors, width } = await compare(page, readFileSync(await download.path()).toString("base64"));
  assert.ok(colors > 50, `${colors} colours`);
  assert.ok(width > 900);
  silent(page);
  await page.close();
});

test("names do nothing but stand there", async () => {
  const name = "</script><img src=x onerror=alert(1)><!--.run";
  const file = write("names.html", makePage(toy({ name }), name));
  const page = await open(file);
  assert.equal(await page.title(), name);
  assert.equal(await text(page, "#readout .name"), name);
  assert.equal(await page.locator("img").count(), 0);
  silent(page);
  await page.close();
});

test("too old a browser and damaged data are told in words", async () => {
  const file = write("damaged.html", makePage(new Uint8Array(64), "damaged"));
  await assert.rejects(open(file), /no data of limpet view/);
});

test("pictures are as they were", async () => {
  const references = fileURLToPath(new URL("references/", import.meta.url));
  const failed = [];
  for (const [name, theme, hash] of [
    ["toy-30-light", "light", "#step=30"],
    ["toy-30-dark", "dark", "#step=30"],
    ["toy-60-light", "light", "#step=60&view=iso"],
    ["toy-45-selected", "light", "#step=45&polygon=11&view=iso"],
  ]) {
    const page = await open(kToy, { hash, theme, width: 800, height: 500 });
    await page.addStyleTag({ content: "#overlay, #time { display: none !important; }" });
    await page.keyboard.press("h");
    // Until two pictures are the same: the page rests, and draws finely, some time after the last change.
    let picture = null;
    for (let tries = 0, last = null; tries < 12 && (picture === null || picture !== last); ++tries) {
      await page.waitForTimeout(300);
      await page.evaluate(() => {
        limpet.setView("iso");
        limpet.render({ level: 0, scale: 2 });
      });
      last = picture;
      picture = (await page.locator("#view").screenshot()).toString("base64");
    }
    const path = `${references}${name}.png`;
    if (process.env.UPDATE || !existsSync(path)) {
      mkdirSync(references, { recursive: true });
      writeFileSync(path, Buffer.from(picture, "base64"));
      if (!process.env.UPDATE) failed.push(`${name}: there was no reference; written`);
    } else {
      const { differ } = await compare(page, picture, readFileSync(path).toString("base64"));
      if (differ > 0.01) {
        const aside = path.replace(/\.png$/, ".new.png");
        writeFileSync(aside, Buffer.from(picture, "base64"));
        failed.push(`${name}: ${(100 * differ).toFixed(2)} % of the pixels differ, see ${aside}`);
      }
    }
    silent(page);
    await page.close();
  }
  assert.deepEqual(failed, []);
});

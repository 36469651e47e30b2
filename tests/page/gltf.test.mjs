// Copyright the limpet authors. GPL-3.0-or-later.
// Binary glTF files of the program, judged by the Khronos validator. LIMPET: the program.
import test from "node:test";
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import validator from "gltf-validator";

const program = process.env.LIMPET;
const folder = mkdtempSync(join(tmpdir(), "limpet-gltf-"));
test.after(() => rmSync(folder, { recursive: true, force: true }));

const inFolder = (name) => join(folder, name);
const limpet = (...words) => execFileSync(program, [...words, "--quiet"], { stdio: "pipe" });

async function judged(name) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(inFolder(name))));
  const { numErrors, numWarnings, numInfos, messages } = report.issues;
  assert.equal(numErrors + numWarnings + numInfos, 0, JSON.stringify(messages));
  return report.info;
}

const options = { skip: program ? false : "LIMPET is not set" };

test("a model that is closed", options, async () => {
  limpet("scan", "step_hole", "-o", inFolder("s.ply"), "--points", "20000");
  limpet("model", inFolder("s.ply"), "-o", inFolder("s.glb"));
  const info = await judged("s.glb");
  assert.ok(info.totalTriangleCount >= 20, `${info.totalTriangleCount} triangles`);
});

test("a model with open edges and holes", options, async () => {
  limpet("scan", "plate3", "-o", inFolder("p.ply"), "--points", "20000");
  limpet("model", inFolder("p.ply"), "-o", inFolder("p.limpet"), "-o", inFolder("p.glb"));
  assert.ok((await judged("p.glb")).drawCallCount >= 2);
  limpet("view", inFolder("p.limpet"), "-o", inFolder("v.glb"));
  assert.deepEqual(readFileSync(inFolder("v.glb")), readFileSync(inFolder("p.glb")));
});

test("a model of nothing", options, async () => {
  limpet("scan", "cube", "-o", inFolder("c.ply"), "--points", "5");
  limpet("model", inFolder("c.ply"), "-o", inFolder("c.glb"), "--resolution", "0.01", "--noise", "0");
  await judged("c.glb");
});

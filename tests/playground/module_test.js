// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The module alone, in node: frames as the manuals print them, five drives through a start, a cut cable and a fault,
// and the size that it may have.
"use strict";
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");
const test = require("node:test");
const { loadModule } = require("../../docs/playground/page/module.js");

const bytes = fs.readFileSync(process.argv[2]);
const golden = JSON.parse(fs.readFileSync(path.join(__dirname, "frames.json"), "utf8"));
const load = () => loadModule(bytes.toString("base64"));
const toSeconds = 1000000;

function opened(engine, name) {
  assert.ok(engine.open(engine.drives().indexOf(name)), name);
  return engine;
}

/// How the newest order ended.
const newest = (engine) => engine.state().orders.at(-1);

test("it imports nothing, and is small", () => {
  assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(bytes)), []);
  const size = execFileSync("gzip", ["-9", "-c"], { input: bytes }).length;
  console.log(`module: ${bytes.length} bytes, ${size} with gzip`);
  assert.ok(size <= 80000, `${size} bytes with gzip`);
});

test("frames that manuals print get their CRC and their fields", async () => {
  const engine = await load();
  for (const each of golden) {
    opened(engine, each.drive);
    const bare = each.bytes.slice(0, -6);
    const offered = engine.decode(bare);
    assert.equal(offered.kind, "crc missing", bare);
    assert.equal(offered.offer, each.bytes);
    const whole = engine.decode(each.bytes);
    assert.equal(whole.kind, "good", each.bytes);
    const fields = whole.frames[0].readings[0].fields.map((field) => `${field.name}=${field.value}`);
    assert.ok(fields.some((field) => field.startsWith(each.says)), `${each.says} in ${fields}`);
    const wrong = engine.decode(bare + " 00 00");
    assert.deepEqual([wrong.kind, wrong.offer], ["crc wrong", each.bytes]);
  }
});

test("what is no bytes is told with its place", async () => {
  const engine = await load();
  assert.equal(engine.decode("01 0G").flaw, "character 4: a byte has two digits");
  assert.equal(engine.decode("01 x1").flaw, "character 4: not a hexadecimal digit");
  assert.match(engine.decode("00".repeat(257)).flaw, /^257 bytes/);
  assert.equal(engine.send("zz"), false);
  assert.equal(engine.open(5), false);
});

for (const name of ["atv12", "atv28", "atv310", "atv310_2026", "atv320"]) {
  test(`${name}: nothing moves by surprise`, async () => {
    const engine = opened(await load(), name);
    assert.equal(engine.state().drive.state, "");
    engine.mains(true);
    engine.run(toSeconds);
    assert.equal(engine.state().drive.state, "switch on disabled");
    assert.ok(engine.state().client.linked);

    engine.start(300);
    engine.run(6 * toSeconds);
    assert.equal(newest(engine).outcome.split(",")[0], "done");
    assert.equal(engine.state().drive.frequency, 30000);
    assert.equal(engine.state().client.frequency, 300);

    engine.cable(1);
    engine.run(12 * toSeconds);
    const cut = engine.state();
    assert.ok(["fault", "switch on disabled"].includes(cut.drive.state), cut.drive.state);
    assert.equal(cut.drive.frequency, 0);
    assert.equal(cut.client.linked, false);

    engine.cable(0);
    engine.run(30 * toSeconds);
    assert.equal(engine.state().drive.frequency, 0, "it moved after the cable was mended");
    assert.ok(engine.state().client.linked);
    engine.reset();
    engine.run(2 * toSeconds);
    assert.equal(newest(engine).outcome.split(",")[0], "done");
    assert.equal(engine.state().drive.frequency, 0, "it moved after the reset");

    engine.start(-200);
    engine.run(6 * toSeconds);
    assert.equal(engine.state().drive.frequency, -20000);
    engine.fault(true);
    engine.run(2 * toSeconds);
    assert.equal(engine.state().drive.state, "fault");
    assert.equal(engine.state().drive.frequency, 0);
    engine.start(200);
    engine.run(2 * toSeconds);
    assert.match(newest(engine).outcome, /^the drive is in fault/);

    engine.fault(false);
    engine.reset();
    engine.run(2 * toSeconds);
    engine.supervised(false);
    engine.start(200);
    engine.run(2 * toSeconds);
    assert.match(newest(engine).outcome, /^the drive does not watch its link/);
    assert.equal(engine.state().drive.frequency, 0);
  });
}

test("the state machine has what the drive has", async () => {
  const engine = opened(await load(), "atv320");
  const machine = engine.machine();
  assert.equal(machine.states.length, 8);
  const of = (number) => machine.transitions.filter((each) => each.number === number);
  assert.deepEqual(of("4").map((each) => [each.from, each.to, each.cause]), [["switched on", "operation enabled", "enable operation"]]);
  assert.equal(of("7")[0].cause, "disable voltage or quick stop");
  assert.equal(of("13")[0].to, "fault reaction active");
});

test("typed bytes reach the drive as they are, and a wrong CRC gets no answer", async () => {
  const engine = opened(await load(), "atv320");
  engine.mains(true);
  engine.run(toSeconds);
  let next = engine.state().frames;
  assert.ok(engine.send("01 03 0C 81 00 01 D7 72"));
  engine.run(toSeconds);
  let seen = engine.frames(next);
  const asked = seen.findIndex((each) => each.from === "you");
  assert.equal(seen[asked].hex, "01 03 0C 81 00 01 D7 72");
  assert.equal(seen[asked + 1].from, "drive");
  assert.match(seen[asked + 1].summary, /^ETA 0x/);
  next = engine.state().frames;
  assert.ok(engine.send("01 03 0C 81 00 01 D7 73"));
  engine.run(toSeconds);
  seen = engine.frames(next);
  const damaged = seen.findIndex((each) => each.verdict === "damaged");
  assert.ok(damaged >= 0);
  assert.notEqual(seen[damaged + 1].from, "drive");
});

/// A small generator, so that each run presses the same.
function presses(seed) {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state >>> 16) % below;
  };
}

function press(engine, next) {
  const acts = [
    () => engine.mains(next(4) !== 0), () => engine.cable(next(4)), () => engine.fault(next(2) !== 0),
    () => engine.local(next(2) !== 0), () => engine.stopKey(), () => engine.supervised(next(2) !== 0),
    () => engine.start(next(9000) - 4500), () => engine.start(next(600) - 300), () => engine.change(next(600) - 300),
    () => engine.stop(next(5)), () => engine.reset(), () => engine.send("01 03 0C 81 00 01 D7 72"), () => engine.send("FF 00"),
  ];
  acts[next(acts.length)]();
}

test("whatever is pressed, each state has its transition, and a stop over a whole line ends with a motor that stands", async () => {
  const engine = await load();
  for (const name of engine.drives()) {
    opened(engine, name);
    const next = presses(7);
    const ways = new Set(engine.machine().transitions.map((each) => `${each.number} to ${each.to}`));
    for (let i = 0; i < 150; ++i) {
      press(engine, next);
      engine.run(next(900) * 1000);
      const { drive } = engine.state();
      assert.ok(!drive.on || ways.has(`${drive.last} to ${drive.state}`), `${name}: ${drive.last} to ${drive.state}`);
    }
    engine.cable(0);
    engine.mains(true);
    engine.run(40 * toSeconds);
    engine.stop(0);
    engine.run(40 * toSeconds);
    assert.equal(engine.state().drive.frequency, 0, `${name}: ${JSON.stringify(engine.state())}`);
    assert.ok(!["operation enabled", "quick stop active"].includes(engine.state().drive.state), name);
  }
});

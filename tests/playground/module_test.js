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

/// Stops in one of the ways that the page offers for this drive, by its name there.
const stopBy = (engine, name) => engine.stop(engine.describe().stops.find((each) => each.name === name).id);

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
  assert.equal(engine.decode("01 é 03").flaw, "character 4: not a hexadecimal digit");
  assert.equal(engine.decode("０１").flaw, "character 1: not a hexadecimal digit");
  assert.deepEqual([engine.decode("0x01, 0X03").flaw, engine.decode("0x01, 0X03").size], ["", 2]);
  for (const typed of ["01 06 21 36 01 2C zz 99", "01 10 21 35 00 02 04 00 0F 01 2C x", "[12:34:56.123] TX 01 06 21 36 01 2C", "01 03 0C 81 00 01 D7 72 0"]) {
    const { size, flaw, offer, frames } = engine.decode(typed);
    assert.match(flaw, /^character \d+: /, typed);
    assert.deepEqual([size, offer, frames, engine.send(typed)], [0, "", [], false], typed);
  }
  for (const typed of ["0000: 01 03 0C 81 00 01", "00000000: 0103 0c81", "00000000  01 03 0C", "00000010 01 03 0C", "0000   01 03", "01 03\n0010: 0C 81"]) {
    assert.match(engine.decode(typed).flaw, /offset/, typed);
    assert.equal(engine.send(typed), false, typed);
  }
  for (const typed of ["01:03:0C:81", "0103 0C81 0001 D772", "01030C81 0001D772", "01030C810001D772", "0103"]) assert.equal(engine.decode(typed).flaw, "", typed);
  const long = "01 03 0C 81 00 01" + " ".repeat(2000);
  assert.match(engine.decode(long).flaw, /^2017 characters: 2000 are read at most/);
  assert.equal(engine.send(long), false);
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

    engine.start(30);
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

    engine.start(-20);
    engine.run(6 * toSeconds);
    assert.equal(engine.state().drive.frequency, -20000);
    engine.fault(true);
    engine.run(2 * toSeconds);
    assert.equal(engine.state().drive.state, "fault");
    assert.equal(engine.state().drive.frequency, 0);
    engine.start(20);
    engine.run(2 * toSeconds);
    assert.match(newest(engine).outcome, /^the drive is in fault/);

    engine.fault(false);
    engine.reset();
    engine.run(2 * toSeconds);
    engine.supervised(false);
    engine.start(20);
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
  const damaged = seen.findIndex((each) => each.damaged);
  assert.ok(damaged >= 0);
  assert.notEqual(seen[damaged + 1].from, "drive");
});

/// An engine with a drive that is on and watched.
async function powered(name = "atv320") {
  const engine = opened(await load(), name);
  engine.mains(true);
  engine.run(toSeconds);
  return engine;
}

/// The same with a motor that an order runs at 30 Hz.
async function running(name = "atv320") {
  const engine = await powered(name);
  engine.start(30);
  engine.run(6 * toSeconds);
  assert.equal(engine.state().drive.frequency, 30000);
  return engine;
}

// Numbers that wrap, at 16, at 32 or at 64 bits, to others that a drive would take; numbers between its steps; and none.
const [tooHigh, tooLow, between] = ["value above the register's maximum", "value below the register's minimum", "value between two steps of the register"];
const noNumber = "type a number first: digits and a point, no comma";
const refusals = {
  "6583.6": tooHigh, "-6523.6": tooLow, "99999": tooHigh, "429496759.6": tooHigh, "18446744073709.6": tooHigh, "99999999999999999999999": tooHigh,
  "-99999999999999999999999": tooLow, "0.04": between, "49.99999999": between, "49.9999991": between, "30.0000000000000000001": between,
  "": noNumber, "  ": noNumber, "2,5": noNumber, "0x10": noNumber, "1e3": noNumber, "1e309": noNumber, "--5": noNumber, "-": noNumber, "5.": noNumber,
  ".5": noNumber, "1.2.3": noNumber, "5 0": noNumber, "NaN": noNumber, "Infinity": noNumber, "٣": noNumber, [`3${"0".repeat(30)}`]: noNumber, [`0.${"0".repeat(3000)}1`]: noNumber,
};

test("a reference is taken as it is typed, or refused with its reason", async () => {
  for (const name of ["atv12", "atv28", "atv320"]) {
    const engine = await powered(name);
    for (const [typed, reason] of Object.entries(refusals)) {
      for (const act of ["start", "change"]) {
        const before = engine.state().frames;
        engine[act](typed);
        engine.run(2 * toSeconds);
        assert.equal(newest(engine).outcome, "not given: " + reason, `${name}: ${act} ${typed}`);
        assert.ok(!engine.frames(before).some((each) => each.summary.startsWith("write")), `${name}: ${act} ${typed}`);
      }
    }
    assert.equal(engine.state().drive.state, "switch on disabled");
    engine.start(" -12.300000000 ");
    engine.run(4 * toSeconds);
    assert.match(newest(engine).what, /^start at -12.300000000 Hz$/);
    assert.equal(engine.state().drive.frequency, -12300);
    engine.change("-0");
    engine.run(6 * toSeconds);
    assert.deepEqual([newest(engine).what, engine.state().drive.frequency], ["change to -0 Hz", -100]);
  }
});

test("the list of orders shows what was typed, whatever it is", async () => {
  const engine = await powered();
  const shown = { "2,5 é": "start at 2,5 é Hz", "\"\\\u0001": "start at \"\\\u0001 Hz", "": "start at no Hz", ["7".repeat(40)]: `start at ${"7".repeat(24)}… Hz` };
  for (const [typed, what] of Object.entries(shown)) {
    engine.start(typed);
    assert.equal(newest(engine).what, what);
  }
});

const endings = ["open", "not done", "done otherwise", "done"];
const ended = (engine) => endings[newest(engine).ending];

test("a motor that runs at the drive's limit is an order that was done", async () => {
  const engine = await powered();
  engine.start(60);
  engine.run(8 * toSeconds);
  assert.deepEqual([ended(engine), engine.state().drive.frequency], ["done otherwise", 50000]);
  assert.match(newest(engine).outcome, /^done, at the drive's limit: the reference is outside the drive's limits/);
  engine.change(-70);
  engine.run(12 * toSeconds);
  assert.deepEqual([ended(engine), engine.state().drive.frequency], ["done otherwise", -50000]);
  engine.change(40);
  engine.run(12 * toSeconds);
  assert.deepEqual([ended(engine), engine.state().drive.frequency], ["done", 40000]);
});

test("another stop than the one ordered is told apart, and said before", async () => {
  for (const [name, coasts, how] of [["atv12", true, "done otherwise"], ["atv28", false, "done"], ["atv320", true, "done otherwise"]]) {
    const engine = await powered(name); // nobody has checked it
    assert.equal(engine.describe().coasts, coasts, name);
    stopBy(engine, "on the ramp");
    engine.run(12 * toSeconds);
    assert.equal(ended(engine), how, `${name}: ${newest(engine).outcome}`);
    assert.equal(/another stop than the one ordered/.test(newest(engine).outcome), coasts, name);
    const checked = await running(name);
    stopBy(checked, "on the ramp");
    checked.run(12 * toSeconds);
    assert.equal(ended(checked), "done", `${name}: ${newest(checked).outcome}`);
  }
});

test("an order that is under way stays in the list until its end is told", async () => {
  const engine = await powered();
  engine.start(30);
  const { number } = newest(engine);
  for (let i = 0; i < 40; ++i) engine.start(20);
  const found = () => engine.state().orders.find((each) => each.number === number);
  assert.equal(endings[found().ending], "open");
  assert.equal(engine.state().orders.length, 12);
  engine.run(6 * toSeconds);
  assert.equal(endings[found().ending], "done");
  assert.match(found().outcome, /^done/);
});

test("bytes that wait for a free line are not replaced", async () => {
  const engine = await powered();
  const seen = engine.state().frames;
  assert.equal(engine.send("01 03 0C 81 00 01 D7 72"), true);
  assert.equal(engine.send("01 06 21 35 00 06 13 CA"), false);
  engine.run(toSeconds);
  const own = engine.frames(seen).filter((each) => each.from === "you").map((each) => each.hex);
  assert.deepEqual(own, ["01 03 0C 81 00 01 D7 72"]);
  assert.equal(engine.send("01 03 0C 81 00 01 D7 72"), true);
});

test("a client that has asked nothing yet has no error", async () => {
  const engine = opened(await load(), "atv320");
  const { client } = engine.state();
  assert.deepEqual([client.rounds, client.linked, client.error], [0, false, ""]);
});

test("a time-out that is switched off while the motor runs is shown as it is, and given back by a loss of mains", async () => {
  for (const name of ["atv12", "atv28", "atv320"]) {
    const engine = await running(name);
    engine.supervised(false);
    engine.cable(1);
    engine.run(60 * toSeconds);
    assert.deepEqual([engine.state().drive.frequency, engine.state().drive.supervised, engine.state().client.order], [30000, false, "given up"], name);
    engine.cable(0);
    engine.run(60 * toSeconds);
    assert.ok(engine.state().client.linked, name);
    assert.deepEqual([engine.state().drive.frequency, engine.state().client.order], [30000, "given up"], "no order stands behind it");
    stopBy(engine, "on the ramp");
    engine.run(8 * toSeconds);
    assert.deepEqual([engine.state().drive.frequency, engine.state().client.order], [0, "none"], name);
    engine.mains(false);
    engine.run(toSeconds);
    engine.supervised(false);
    engine.mains(true);
    engine.run(toSeconds);
    assert.equal(engine.state().drive.supervised, true, "as delivered");
    engine.start(30);
    engine.run(6 * toSeconds);
    engine.cable(1);
    engine.run(12 * toSeconds);
    assert.deepEqual([engine.state().drive.state, engine.state().drive.lineFault], ["fault", true], name);
  }
});

test("who writes its time-out, the drive's own is what counts", async () => {
  const engine = await powered();
  assert.ok(engine.send(engine.decode("01 06 1B 62 00 00").offer));
  engine.run(toSeconds);
  const sll = engine.frames(0).some((each) => each.summary.startsWith("write SLL"));
  assert.equal(sll, true, "7010 is SLL");
  assert.equal(engine.state().drive.supervised, false);
  engine.supervised(true);
  assert.equal(engine.state().drive.supervised, true);
});

test("local control ends with the mains; the cause of a fault does not", async () => {
  const engine = await powered();
  engine.local(true);
  assert.equal(engine.state().drive.local, true);
  engine.mains(false);
  assert.equal(engine.state().drive.local, false);
  engine.local(true);
  engine.fault(true);
  engine.mains(true);
  engine.run(toSeconds);
  assert.deepEqual([engine.state().drive.local, engine.state().drive.cause, engine.state().drive.state], [false, true, "fault"]);
  assert.match(engine.state().drive.fault, /^OCF/);
  engine.reset();
  engine.run(2 * toSeconds);
  assert.equal(engine.state().drive.state, "fault");
  engine.mains(false);
  engine.fault(false);
  engine.mains(true);
  engine.run(toSeconds);
  assert.deepEqual([engine.state().drive.cause, engine.state().drive.state], [false, "switch on disabled"]);
});

test("a motor without power coasts", async () => {
  for (const lose of [(engine) => stopBy(engine, "freewheel"), (engine) => engine.fault(true), (engine) => engine.mains(false)]) {
    const engine = await running();
    assert.deepEqual([engine.state().drive.power, engine.state().drive.shaft], [true, 30000]);
    lose(engine);
    engine.run(toSeconds);
    const { drive } = engine.state();
    assert.deepEqual([drive.power, drive.frequency], [false, 0]);
    assert.ok(drive.shaft > 20000 && drive.shaft < 30000, String(drive.shaft));
    engine.run(8 * toSeconds);
    assert.equal(engine.state().drive.shaft, 0);
  }
  for (const how of ["on the ramp", "quick stop"]) {
    const braked = await running();
    stopBy(braked, how);
    braked.run(0.2 * toSeconds);
    const { drive } = braked.state();
    assert.ok(drive.power && drive.frequency > 0 && drive.frequency < 30000, `${how}: ${drive.frequency}`);
    assert.equal(drive.shaft, drive.frequency, how);
  }
});

test("a start at once after power-up is an order like any other", async () => {
  const engine = opened(await load(), "atv320");
  for (const rest of [0.5, 6]) {
    engine.mains(true);
    engine.run(rest * toSeconds);
    engine.start(30);
    engine.run(8 * toSeconds);
    assert.deepEqual([engine.state().client.order, engine.state().drive.frequency], ["ordered", 30000]);
    engine.cable(1);
    engine.run(30 * toSeconds);
    assert.equal(engine.state().client.order, "given up");
    engine.cable(0);
    engine.run(10 * toSeconds);
    engine.mains(false);
    engine.run(10 * toSeconds);
  }
});

test("what the client has to do with a motor that turns", async () => {
  const engine = await powered();
  engine.start(30);
  const seen = new Set();
  for (let i = 0; i < 3000; ++i) {
    engine.run(1000);
    seen.add(engine.state().client.order);
  }
  assert.deepEqual([...seen], ["starting", "ordered"]);
  stopBy(engine, "freewheel");
  engine.run(8 * toSeconds);
  assert.equal(engine.state().client.order, "none");
  for (const frame of ["01 06 21 36 01 2C", "01 06 21 35 00 06", "01 06 21 35 00 07", "01 06 21 35 00 0F"]) {
    engine.send(engine.decode(frame).offer);
    engine.run(toSeconds);
  }
  assert.ok(engine.state().drive.frequency > 0);
  assert.equal(engine.state().client.order, "none", "somebody else ordered it");
});

test("a halt keeps the power, and is no order to run", async () => {
  const engine = await running("atv12");
  assert.equal(engine.state().drive.halted, false);
  stopBy(engine, "halt");
  engine.run(6 * toSeconds);
  const { drive, client } = engine.state();
  assert.deepEqual([drive.state, drive.power, drive.shaft, drive.halted, client.order], ["operation enabled", true, 0, true, "stopping"]);
});

test("a silence of more than the clock holds stays a silence", async () => {
  const engine = await powered("atv12");
  engine.cable(1);
  engine.run(4400 * toSeconds);
  assert.ok(engine.state().drive.silence > 3000 * toSeconds, String(engine.state().drive.silence));
});

test("power off and on again: no order stays open", async () => {
  const engine = opened(await load(), "atv320");
  engine.mains(true);
  engine.mains(false);
  engine.mains(true);
  engine.run(2 * toSeconds);
  assert.deepEqual(engine.state().orders.map((each) => each.outcome), ["a later one took its place", "done"]);
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
    () => engine.start((next(9000) - 4500) / 10), () => engine.start((next(600) - 300) / 10), () => engine.change((next(600) - 300) / 10),
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
    stopBy(engine, "on the ramp");
    engine.run(40 * toSeconds);
    assert.equal(engine.state().drive.frequency, 0, `${name}: ${JSON.stringify(engine.state())}`);
    assert.ok(!["operation enabled", "quick stop active"].includes(engine.state().drive.state), name);
  }
});

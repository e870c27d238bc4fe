// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The module alone, in node, with its simulated units at the other end and a clock of the test's own: it listens first, a drive is
// polled only with consent, and whatever is called in whatever order, only reads leave.
"use strict";
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const test = require("node:test");
const { loadLine, formatNames } = require("../../docs/line/page/module.js");
const { usualSettings } = require("../../docs/line/page/worker.js");
const { whyNoRead } = require("./bridge.js");

const bytes = fs.readFileSync(process.argv[2]);
const character = 1000 * 11 / 19200;

/// The module and its units on one wire, in steps of a millisecond.
class Bench {
  static async make() {
    const bench = new Bench();
    bench.engine = await loadLine(bytes.toString("base64"));
    bench.now = 5000;
    bench.sent = [];
    bench.events = [];
    bench.onWire = [];
    bench.engine.open(19200, "8E1", bench.now);
    bench.engine.simulated.open(19200, "8E1", bench.now);
    return bench;
  }

  run(milliseconds) {
    for (const end = this.now + milliseconds; this.now < end;) {
      this.now += 1;
      this.send(this.engine.pass(this.now));
      const said = this.engine.simulated.pass(this.now);
      if (said.length > 0) this.put(said, (all) => this.engine.receive(all, this.now));
      const due = this.onWire.filter(({ at }) => at <= this.now);
      this.onWire = this.onWire.filter(({ at }) => at > this.now);
      for (const { all, take } of due) take(all);
      this.events.push(...this.engine.events());
    }
  }

  send(frame) {
    if (frame.length === 0) return;
    this.sent.push({ frame: Buffer.from(frame), at: this.now });
    this.engine.sent(this.now);
    this.put(frame, (all) => this.engine.simulated.receive(all, this.now));
  }

  put(all, take) { this.onWire.push({ at: this.now + all.length * character, all, take }); }
  take(name) { const found = this.events.filter(({ event }) => event === name); this.events = []; return found; }
}

async function ready() {
  const bench = await Bench.make();
  bench.run(1200);
  assert.equal(bench.take("phase").at(-1).phase, "quiet");
  return bench;
}

const values = (bench) => Object.fromEntries(bench.take("values").flatMap(({ values }) => values).map(({ name, text }) => [name, text]));

test("it imports nothing, and is small", () => {
  assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(bytes)), []);
  const size = execFileSync("gzip", ["-9", "-c"], { input: bytes }).length;
  console.log(`module: ${bytes.length} bytes, ${size} with gzip`);
  assert.ok(size <= 128000, `${size} bytes with gzip`);
});

test("nothing leaves before a second of silence", async () => {
  const bench = await Bench.make();
  for (let at = 0; at < 90; ++at) {
    bench.engine.scan(1, 3);
    bench.engine.watch(1, "ETA", 1);
    bench.run(10);
  }
  assert.equal(bench.sent.length, 0);
  assert.ok(bench.take("end").every(({ how }) => how === "not begun"));
  bench.run(200);
  bench.engine.scan(1, 1);
  bench.run(100);
  assert.ok(bench.sent.length > 0);
});

test("where others talk nothing leaves; a stray byte is none of them", async () => {
  const request = Uint8Array.from([9, 3, 0, 0, 0, 1, 0x85, 0x42]), noise = Uint8Array.from([1, 2, 3, 4, 5, 6, 7]);
  for (const [heard, phase] of [[request, "others"], [noise, "noise"], [Uint8Array.from([0]), "quiet"]]) {
    const bench = await Bench.make();
    bench.run(300);
    bench.engine.receive(heard, bench.now);
    bench.run(900);
    assert.equal(bench.take("phase").at(-1).phase, phase);
    bench.engine.scan(1, 1);
    bench.run(100);
    assert.equal(bench.sent.length > 0, phase === "quiet", phase);
  }
  const bench = await ready();
  bench.engine.watch(2, "input:0:f32", 50);
  bench.run(500);
  const before = bench.sent.length;
  bench.engine.receive(request, bench.now);
  bench.run(2000);
  assert.equal(bench.sent.length, before);
  assert.match(bench.take("end").at(-1).how, /another client/);
});

test("it finds who is there, and reads by name", async () => {
  const bench = await ready();
  bench.engine.setTimeout(200);
  bench.engine.scan(1, 4);
  bench.run(2000);
  const units = bench.take("unit");
  assert.deepEqual(units.map(({ unit, drive, mayBeDrive }) => [unit, drive, mayBeDrive]), [[1, "atv320", true], [2, "", false]]);
  assert.equal(bench.engine.watch(2, "voltage\tinput:0:f32\t\tV\t\t\ngone\tinput:2000:f32\t\tV\t\t", 0), "");
  bench.run(400);
  assert.match(bench.events.find(({ event }) => event === "failure").name, /illegal data address/);
  assert.match(values(bench).voltage, /^2(29|3[0-2])(\.\d+)? V$/);
  assert.match(bench.engine.watch(2, "input:0:f31", 0), /'input:0:f31' names nothing here.*f32/);
  assert.match(bench.engine.watch(2, "coil:70000", 0), /names nothing/);
  assert.equal(bench.engine.registers(1).find(({ name }) => name === "RFR").unit, "Hz");
  assert.deepEqual(bench.engine.registers(2), []);
});

test("a drive is asked who it is, and then nothing without consent", async () => {
  const bench = await ready();
  bench.engine.identify(1);
  bench.run(500);
  const before = bench.sent.length;
  for (let i = 0; i < 5; ++i) {
    bench.engine.watch(1, "ETA", 10);
    bench.run(200);
    bench.engine.backUp(1, "now");
    bench.run(200);
  }
  assert.equal(bench.sent.length, before);
  assert.equal(bench.take("consent").length, 10);
  bench.engine.consent(1);
  bench.engine.watch(1, "ETA\nRFR\n3204", 100);
  bench.run(1000);
  assert.deepEqual(Object.keys(values(bench)).sort(), ["ETA", "LCR", "RFR"]);
  bench.engine.stop();
  const stopped = bench.sent.length;
  bench.run(3000);
  assert.equal(bench.sent.length, stopped);
});

test("a drive that nobody asked about before is found out before it is polled, and an identification cut short counts for none", async () => {
  const bench = await ready();
  bench.engine.watch(1, "3201", 10);
  bench.run(1000);
  assert.equal(bench.take("consent").length, 1);
  for (const cut of [1, 3, 8, 14, 21, 30]) {
    bench.engine.identify(1);
    bench.run(cut);
    bench.engine.stop();
    bench.engine.watch(1, "3201", 10);
    bench.run(4000); // what was cut short may still be answered
    assert.equal(bench.take("consent").length, 1, `${cut} ms`);
    bench.engine.scan(1, 1);
    bench.run(cut);
    bench.engine.watch(1, "3201", 10);
    bench.run(4000); // what was cut short may still be answered
    assert.equal(bench.take("consent").length, 1, `scan, ${cut} ms`);
  }
  bench.engine.consent(1);
  bench.engine.set(19200, "8E1", bench.now);
  bench.engine.watch(1, "3201", 10);
  bench.run(1000);
  assert.equal(bench.take("consent").length, 1, "at another setting others may answer");
});

test("a response of damaged bytes is shown with them; an echo is told and taken out", async () => {
  const bench = await ready();
  bench.engine.identify(2);
  bench.run(600);
  bench.take("unit");
  const send = bench.send;
  bench.send = function (frame) {
    if (frame.length === 0) return;
    this.sent.push({ frame: Buffer.from(frame), at: this.now });
    this.engine.sent(this.now);
    this.put(Uint8Array.from([2, 4, 4, 1, 2, 3, 4, 9, 9]), (all) => this.engine.receive(all, this.now));
  };
  bench.engine.watch(2, "input:0:f32", 0);
  bench.run(500);
  const [failure] = bench.take("failure");
  assert.match(failure.name, /CRC/);
  assert.equal(failure.bytes, "02 04 04 01 02 03 04 09 09");
  bench.send = function (frame) {
    if (frame.length > 0) this.put(Uint8Array.from(frame), (all) => this.engine.receive(all, this.now));
    send.call(this, frame);
  };
  bench.engine.watch(2, "input:0:f32", 0);
  bench.run(500);
  assert.match(bench.take("failure")[0].name, /itself came back/);
  bench.engine.watch(2, "input:0:f32", 0);
  bench.run(3000);
  assert.deepEqual(Object.keys(values(bench)), ["input:0"]);
});

test("a pause of the page is told, and a slow page listens anew", async () => {
  const bench = await Bench.make();
  bench.run(500);
  bench.now += 5000;
  bench.run(500);
  assert.equal(bench.take("slowed").length, 1);
  bench.engine.scan(1, 1);
  bench.run(300);
  assert.equal(bench.sent.length, 0, "nobody listened in that time");
  bench.run(400);
  bench.engine.watch(2, "input:0:f32", 100);
  bench.run(1000);
  bench.take("values");
  bench.now += 60000;
  bench.run(300);
  assert.equal(bench.events.find(({ event }) => event === "slowed").milliseconds, 60001);
  assert.ok(bench.take("values").length >= 2, "it goes on");
});

test("the settings of the drive are read whole", async () => {
  const bench = await ready();
  bench.engine.identify(1);
  bench.run(500);
  bench.engine.consent(1);
  bench.engine.backUp(1, "2026-01-01T00:00:00+0000");
  bench.run(60000);
  const { parameters, rows, format, drive } = JSON.parse(bench.engine.file());
  assert.deepEqual([format, drive, Number(rows)], ["rtuwire backup 1", "atv320", parameters.length]);
  assert.equal(parameters.find(({ register }) => register === "TFR").unit, "Hz");
  assert.ok(bench.sent.every(({ frame }) => whyNoRead(frame) === ""));
});

test("whatever is called in whatever order, only reads leave", async () => {
  let seed = 1;
  const draw = (most) => { seed = (seed * 1103515245 + 12345) % 2147483648; return Math.floor(seed / 2147483648 * most); };
  const words = ["ETA", "CMD", "8501", "coil:0", "coil:0-2000", "holding:65535", "input:65535:f32", "x\tholding:0:u16\t0.1\tV\ta=1\t5", "*", "", "\t\t\t\t\t",
    "01 06 21 35 00 0F", "discrete:9-3", "holding:0-499"];
  const unit = () => [0, 1, 2, 3, 247, 248, 255, 256, 4294967295][draw(9)];
  const bench = await ready();
  const { engine } = bench;
  const acts = [
    () => engine.scan(unit(), unit()), () => engine.identify(unit()), () => engine.watch(unit(), words[draw(words.length)], [0, 1, 50, 4294967295][draw(4)]),
    () => engine.consent(unit()), () => engine.backUp(unit(), "x"), () => engine.stop(), () => draw(20) || engine.listen(), () => engine.setTimeout(draw(400)),
    () => draw(20) || engine.set(usualSettings[draw(24)][0], formatNames[draw(6)], bench.now),
    () => draw(12) || engine.receive(Uint8Array.from({ length: draw(300) }, () => draw(256)), bench.now), () => engine.receiveError(bench.now), () => engine.sent(bench.now),
    () => draw(50) || engine.open(19200, "8E1", bench.now), () => engine.decode(words[draw(words.length)], unit()), () => engine.explain(draw(100)), () => engine.capture(),
  ];
  for (let done = 0; done < 10000; ++done) {
    acts[draw(acts.length)]();
    bench.run(draw(12));
    if (draw(30) === 0) bench.run(1500);
  }
  assert.ok(bench.sent.length > 300, `${bench.sent.length}`);
  for (const { frame } of bench.sent) assert.equal(whyNoRead(frame), "", frame.toString("hex"));
  console.log(`10000 random calls: ${bench.sent.length} frames left, each a read`);
});

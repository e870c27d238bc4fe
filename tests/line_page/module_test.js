// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The module alone, in node, with its simulated units at the other end and a clock of the test's own: it listens first, a drive is
// polled only with consent, and whatever is called in whatever order, only reads leave.
"use strict";
const assert = require("node:assert/strict");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const test = require("node:test");
const { loadLine, formatNames } = require("../../docs/line/page/module.js");
const { LineClock, usualSettings } = require("../../docs/line/page/worker.js");
const { Unit, frameOf, whyNoRead } = require("./bridge.js");
const { TomlReader, placeWord, readRegisterFile } = require("../../docs/line/page/register_file.js");

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

  /// A unit of the tests in place of the simulated ones: `answers` as of `Unit`.
  meet(answers, words) {
    const unit = new Unit(words);
    this.send = (frame) => {
      if (frame.length === 0) return;
      const request = Buffer.from(frame);
      this.sent.push({ frame: request, at: this.now });
      this.engine.sent(this.now);
      for (const [later, all] of answers(unit.response(request), request)) this.onWire.push({ at: this.now + later, all, take: (bytes) => this.engine.receive(bytes, this.now) });
    };
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

test("an answer that comes later than any time-out is no value of another register", async () => {
  for (const late of [1300, 2500, 3700, 5500]) {
    const bench = await ready();
    bench.meet((response, request) => [[request[1] === 4 ? late : 5, response]]);
    bench.engine.watch(2, "input:0\ninput:10\ninput:20\ninput:30:u32", 100);
    bench.run(40000);
    for (const [name, value] of Object.entries(values(bench))) assert.equal(value, name === "input:30" ? String(30 * 65536 + 31) : name.slice(6), `${name} after ${late} ms`);
    assert.ok(bench.sent.length > 8);
  }
});

test("an answer that was asked for before a stop is none to what is asked behind it, and what came frees the unit at once", async () => {
  const bench = await ready();
  bench.meet((response) => [[5, response]]);
  bench.engine.watch(2, "input:0", 0);
  bench.run(100);
  bench.meet((response) => [[900, response]]);
  bench.engine.watch(2, "input:0", 0);
  bench.run(20);
  bench.engine.stop();
  bench.take("values");
  bench.engine.watch(2, "input:10", 0);
  bench.run(8000);
  assert.deepEqual(values(bench), { "input:10": "10" });
  bench.engine.watch(2, "input:0", 0);
  bench.run(20);
  bench.engine.stop();
  bench.run(1500);
  bench.take("values");
  bench.engine.watch(2, "input:10", 0);
  bench.run(1200);
  assert.deepEqual(values(bench), { "input:10": "10" });
});

test("what came in place of an answer is told with its bytes, in a scan, too", async () => {
  const bench = await ready();
  bench.meet((response) => [[5, frameOf(9, ...response.subarray(1, -2))]]);
  bench.engine.setTimeout(300);
  bench.engine.scan(2, 3);
  bench.run(3000);
  const told = bench.take("failure");
  assert.deepEqual(told.map(({ unit, bytes }) => [unit, bytes]), [2, 3].map((unit) => [unit, frameOf(9, 0x83, 2).toString("hex").toUpperCase().replace(/..(?=.)/g, "$& ")]));
});

test("whatever is asked of a drive without consent ends, and something else can be asked", async () => {
  const bench = await ready();
  bench.engine.identify(1);
  bench.run(500);
  for (const act of [() => bench.engine.watch(1, "ETA", 100), () => bench.engine.backUp(1, "now")]) {
    bench.events = [];
    act();
    bench.run(50);
    assert.deepEqual(bench.events.map(({ event, how }) => how ?? event), ["begin", "consent", "done"]);
  }
});

test("a sleep of any length ends what was asked, and it goes on", async () => {
  for (const minutes of [1, 20, 34, 36, 40, 60, 71, 72, 90, 200]) {
    const bench = await ready();
    let deaf = false;
    bench.meet((response) => (deaf ? [] : [[5, response]]));
    bench.engine.watch(2, "input:0", 1000);
    bench.run(3000);
    deaf = true;
    bench.run(1100);
    deaf = false;
    bench.now += minutes * 60000;
    bench.take("values");
    bench.run(10000);
    assert.ok(bench.take("values").length >= 3, `${minutes} minutes`);
  }
});

test("a capture that is full is told once", async () => {
  const bench = await ready();
  bench.meet((response) => [[1, response]]);
  bench.engine.watch(2, "input:0-59:u16", 1);
  bench.run(200);
  const noise = Buffer.from(Array.from({ length: 60000 }, (_, at) => at * 7 & 255));
  for (let i = 0; i < 900 && bench.engine.capture().length < 16000000; ++i) {
    bench.engine.receive(noise, bench.now);
    bench.run(5);
  }
  bench.run(2000);
  const size = bench.engine.capture().length;
  assert.ok(size >= 16000000 && size < 17000000, `${size} bytes`);
  assert.equal(bench.take("full").length, 1);
});

test("a clock goes on while the computer sleeps", () => {
  let own = 100, calendar = 1e12;
  const clock = new LineClock(() => own, () => calendar);
  const pass = (by, ahead = by) => { own += by; calendar += ahead; return clock.now(); };
  assert.equal(pass(50), 150);
  assert.equal(pass(50, 3600050), 3600200, "an hour of sleep");
  assert.equal(pass(50, -86400000), 3600250, "the calendar is set back");
  assert.equal(pass(50), 3600300);
  assert.equal(pass(50, 450), 3600350, "a correction is no sleep");
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

test("each kind of value is what its bits mean, and no request is longer than the file says", async () => {
  const bench = await ready();
  const words = [0x8000, 0, 0, 1, 0x4009, 0x21FB, 0x5444, 0x2D18, 0x9999, 0x9999, 0x6962, 0x7300, 0x00FA];
  bench.meet((response) => [[5, response]], words);
  bench.engine.watch(2, ["a\tinput:0:u64\t0.1\tWh\t\t", "b\tinput:0:i64\t\t\t\t", "c\tinput:4:f64\t\t\t\t", "input:8:bcd32", "input:8:bcd16", "input:12:bcd16", "input:10:text3", "input:10:text4:badc",
    "d\tinput:0:f32\t0.1\tV\t\t", "e\tinput:0:u64\t\t\t\t-9223372036854775807", "input:0:u64:dcba"].join("\n"), 0, 6);
  bench.run(2000);
  const found = bench.take("values").flatMap((each) => each.values);
  const of = (name) => found.filter((each) => each.name === name).map(({ text, number, wide, step }) => wide ? [wide, step] : [text, number]);
  assert.deepEqual(of("a"), [["u64:0x8000000000000001", "0.1"]]);
  assert.deepEqual(of("b"), [["i64:0x8000000000000001", "1"]]);
  assert.deepEqual(of("c"), [["f64:0x400921FB54442D18", "1"]]);
  assert.deepEqual(of("input:8"), [["99999999", 99999999], ["9999", 9999]]);
  assert.deepEqual(of("input:12"), [["0x00FA, which is no BCD", undefined]]);
  assert.deepEqual(of("input:10"), [["ibs", undefined], ["bi", undefined]]);
  assert.deepEqual(of("d"), [["f32:0x0000000080000000", "0.1"]]);
  assert.match(of("e")[0][0], /no value: 0x8000000000000001/);
  assert.deepEqual(of("input:0"), [["u64:0x0100000000000080", "1"]]);
  for (const { frame } of bench.sent.filter(({ frame }) => frame[1] === 4)) assert.ok(frame.readUInt16BE(4) <= 6);
});

test("register files are read as Python reads them", () => {
  const folder = path.join(__dirname, "../../tools/devices");
  const files = fs.readdirSync(folder).filter((name) => name.endsWith(".toml")).map((name) => path.join(folder, name));
  const strange = `${os.tmpdir()}/line_page_${process.pid}.toml`;
  fs.writeFileSync(strange, "# c\r\n[device] # d\nmax_registers = 0b101\n[[register]]\nname = 'a_1' # 'x'\naddress = 1_0_0\nscale = 2.50\nunit = \"k\\u0057h\"\nchoices = { \"on\" = +1, off = 0x0 }\n" +
    "invalid = [\n 0o17, # e\n -1,]\nmin = -1.5e2\nmoves = true\n\n[[ register ]]\nname=\"b\"\naddress=0xFF_FF\n");
  files.push(strange);
  const script = "import json,sys,tomllib;print(json.dumps([tomllib.load(open(each,'rb')) for each in sys.argv[1:]]))";
  const theirs = JSON.parse(execFileSync("/usr/bin/python3", ["-c", script, ...files], { encoding: "utf8" }));
  files.forEach((file, at) => {
    const ours = JSON.parse(JSON.stringify(new TomlReader(fs.readFileSync(file, "utf8")).document(), (_, value) => (typeof value === "bigint" ? Number(value) : value)));
    assert.deepEqual(ours, theirs[at], file);
    const { points, leftOut, most } = readRegisterFile(file, fs.readFileSync(file, "utf8"));
    assert.deepEqual(leftOut, []);
    assert.equal(points.length, theirs[at].register.length);
    assert.equal(most, theirs[at].device?.max_registers ?? 0);
  });
  fs.rmSync(strange);
});

test("a place is taken as it is typed to the tool", () => {
  for (const [typed, place] of [["list:40001", "holding:0"], ["list:30101:float32", "input:100:f32"], ["list:400001", "holding:0"], ["list:10001", "discrete:0"], ["list:1", "coil:0"],
    ["i:7:uint64:CDAB", "input:7:u64:cdab"], ["40:INT16", "40:i16"], ["RFR", "RFR"], ["list:40000", "list:40000"], ["list:x", "list:x"], ["coil:0-7", "coil:0-7"]]) {
    assert.equal(placeWord(typed), place);
  }
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

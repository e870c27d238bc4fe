// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The page on lines that are not as they should be: a port that is taken, a tab that is loaded again, units that answer late, damaged,
// in part or in another's name, an adapter that loses bytes and refuses settings; and with register files that somebody wrote.
//
//   node strange_line_test.js PAGE
"use strict";
const assert = require("node:assert/strict");
const fs = require("node:fs");
const { Adapter, Unit, frameOf, makeBridge } = require("./bridge.js");
const pages = require("./pages.js");
const { areReads, choose, connect, download, failed, hasValue, isPhase, isTold, launch, stepwise, text, told, wait } = pages;

const open = (browser, bridge, options) => pages.open(process.argv[2], browser, bridge, { names: ["line"], ...options });
const hasText = (page, id, words) => page.waitForFunction(([id, words]) => document.getElementById(id).textContent.includes(words), [id, words]);
const isIdle = (page) => page.waitForFunction(() => !document.getElementById("read").disabled);
const areWell = (page) => assert.deepEqual(page.problems.filter((each) => !/WebSocket/.test(each)), []);

async function read(page, unit, points, button = "read") {
  await page.fill("#unit", String(unit));
  await page.fill("#points", points);
  await page.click("#" + button);
}

/// The second tab is told that the port is taken, and the first goes on.
async function openTwice(browser, bridge, line) {
  const first = await open(browser, bridge);
  await connect(first, "line");
  await read(first, 2, "input:7", "watch");
  await hasValue(first, "input:7 (unit 2)");
  const second = await open(browser, bridge);
  await choose(second, "line");
  await second.click("#connect");
  await hasText(second, "line-note", "The port does not open");
  assert.match(await told(second), /Does another program use it\?/);
  assert.equal(await second.isDisabled("#scan"), true);
  const before = line.sent.length;
  await wait(2500);
  assert.ok(line.sent.length > before, "the first goes on");
  await first.context().close();
  await wait(300);
  await second.click("#connect");
  await isPhase(second, "ready");
  areWell(second);
  await second.context().close();
}

/// A page that is loaded again in the middle of a scan asks nothing more, and listens first when it is connected again.
async function loadAgain(browser, bridge, line) {
  const page = await open(browser, bridge);
  await connect(page, "line");
  line.device.answers = () => [];
  await page.fill("#last", "100");
  await page.click("#scan");
  await page.waitForFunction(() => document.getElementById("progress").value > 0.02);
  await page.reload();
  await page.waitForSelector("html[data-ready=yes]");
  const before = line.sent.length;
  await wait(1000);
  assert.equal(line.sent.length, before);
  line.device.answers = (response) => [[5, response]];
  await connect(page, "line");
  assert.ok(line.sent.filter((each) => each.at < line.opened.at(-1).at + 950).length === before);
  areWell(page);
  await page.context().close();
}

/// Whatever comes in place of a response is shown with its bytes and what they tell; no value is made of it.
async function answerStrangely(browser, bridge, line) {
  const page = await open(browser, bridge), unit = line.device;
  await connect(page, "line");
  await read(page, 2, "input:7");
  await hasValue(page, "input:7 (unit 2)");
  await isIdle(page);
  for (const [answers, words] of [
    [(response) => [[5, Buffer.from([9, ...response.subarray(1)])]], "crc"],
    [(response) => [[5, frameOf(9, ...response.subarray(1, -2))]], "begin with address 9"],
    [(response) => [[5, response.subarray(0, 4)]], "bytes: 02 04 02 00\n"],
    [() => [[5, Buffer.from([0x80, 0xF0, 0xE0, 0xFC, 0x00, 0xF8, 0x1C])]], "80 f0 e0 fc 00 f8 1c"],
    [() => [], "no response in time"],
  ]) {
    unit.answers = answers;
    await page.click("#read");
    await page.waitForFunction((wanted) => document.getElementById("failures").innerText.toLowerCase().includes(wanted), words);
    await isIdle(page);
  }
  assert.match(await page.innerText("#values"), /input:7 \(unit 2\)\s+7\s*$/);
  // A byte with a wrong parity is none of a frame.
  unit.answers = (response) => { setTimeout(() => line.damage(), 1); return [[5, response.subarray(2)]]; };
  await page.click("#read");
  await isIdle(page);
  unit.answers = (response) => [[5, response]];
  const before = await text(page, "values-note");
  await page.click("#read");
  await page.waitForFunction((then) => /^\d+ values kept/.test(document.getElementById("values-note").textContent) && document.getElementById("values-note").textContent !== then, before);
  areReads(line);
  areWell(page);
  await page.context().close();
}

/// Later than any time-out: what is late is no value of another register.
async function answerLate(browser, bridge, line) {
  const page = await open(browser, bridge), unit = line.device;
  await connect(page, "line");
  await page.click("#identify");
  await isTold(page, "Unit 1 answers");
  await isIdle(page);
  unit.answers = (response, request) => [[request[1] === 4 ? 2500 : 5, response]];
  await read(page, 1, "input:0, input:10, input:20", "watch");
  await hasText(page, "values-note", "may still answer");
  await failed(page, "input:20");
  await page.click("#stop-watch");
  for (const row of await page.$$eval("#values tbody tr", (all) => all.map(({ innerText }) => innerText))) {
    const [, register, value] = row.match(/input:(\d+) \(unit 1\)\s+(\d+)/);
    assert.equal(value, register, "a late response was taken for another's");
  }
  unit.answers = (response) => [[5, response]];
  while (unit.owes > 0) await wait(50); // the next page would hear it, and take it for others
  areWell(page);
  await page.context().close();
}

/// On a line that loses one byte of a hundred each value that is shown is right, and it goes on.
async function loseBytes(browser, bridge, line) {
  const page = await open(browser, bridge);
  line.lumps = 4;
  line.delay = 16;
  await connect(page, "line");
  await read(page, 3, "input:1, input:30, input:60:u32");
  await hasValue(page, "input:60 (unit 3)");
  await isIdle(page);
  await page.selectOption("#period", "200");
  line.loses = 100;
  await page.click("#watch");
  await page.waitForFunction(() => /(\d+) values kept/.exec(document.getElementById("values-note").innerText)?.[1] > 20);
  line.loses = 0;
  await page.click("#stop-watch");
  await isIdle(page);
  assert.match(await page.innerText("#failures"), /bytes:|no response/);
  const lines = fs.readFileSync(await download(page, "csv"), "utf8").trim().split("\r\n").slice(1).map((each) => each.split(","));
  const right = { "input:1": "1", "input:30": "30", "input:60": String(60 * 65536 + 61) };
  for (const [, unit, name, number] of lines) assert.deepEqual([unit, number], ["3", right[name]], name);
  console.log(`of a line that loses bytes: ${lines.length} values, each right`);
  line.lumps = line.delay = 0;
  areReads(line);
  areWell(page);
  await page.context().close();
}

/// The search goes past settings that an adapter refuses, ends where somebody disconnects, and finds by an adapter that hears itself.
async function search(browser, bridge, line) {
  const page = await open(browser, bridge);
  line.setting = "38400,8,none,2";
  line.refuses = ["9600,8,even,1", "115200,8,none,2"];
  await connect(page, "line");
  await page.click("#find");
  await isTold(page, "Found: 38400 8N2");
  assert.match(await told(page), /does not open at 9600 8E1/);
  await page.click("#find");
  await hasText(page, "line-note", "Tries 9600 8N2");
  await page.click("#disconnect");
  await isPhase(page, "not connected");
  await wait(1500);
  assert.equal(line.isTaken, false, "the port is closed");
  line.refuses = [];
  line.echoes = true;
  await page.selectOption("#baud", "19200");
  await connect(page, "line");
  await page.click("#find");
  await page.waitForFunction(() => document.getElementById("line-note").textContent.startsWith("Found: "));
  assert.match(await text(page, "line-note"), /^Found: 38400 8N2/);
  line.echoes = false;
  line.setting = "";
  areReads(line);
  areWell(page);
  await page.context().close();
}

async function openFile(page, name, content) {
  await page.setInputFiles("#file", { name, mimeType: "text/plain", buffer: Buffer.from(content) });
  await hasText(page, "file-note", name);
  return text(page, "file-note");
}

/// A person's own register file: each kind of value, what is left out by name, what is wrong by its line; and as CSV no formula.
async function readOwnFile(browser, bridge, line) {
  const page = await open(browser, bridge), unit = line.device;
  unit.words = [0xFFFF, 0xFFFF, 0xFFFF, 0xFFFE, // 0: u64, i64
    0x3FF8, 0, 0, 0, // 4: 1.5
    0x1234, 0x5678, 0x12A4, 0, // 8: BCD
    0x3D31, 0x2B32, 0x2000, 0, // 12: "=1+2 "
    0xCCCD, 0x41BC, 0x8002, 0xFFF6]; // 16: 23.6 with the low word first, no value, -10
  const register = (name, address, rest = "") => `[[register]]\nname = "${name}"\nspace = 'input'\naddress = ${address}\n${rest}\n`;
  const file = "# mine\n[device]\nmax_registers = 4\n" + register("all", "0x0", 'type = "u64"\nscale = 0.01\nunit = "kWh"') + register("back", 0, 'type = "int64"') +
    register("half", 4, 'type = "f64"\nunit = "Ω"') + register("packed", 8, 'type = "bcd32"') + register("no_packed", 10, 'type = "bcd16"') + register("label", 12, 'type = "text5"') +
    register("warm", 16, 'type = "f32"\norder = "cdab"\nscale = 0.1\nunit = "°C"') + register("none", 18, "type = \"i16\"\ninvalid = [ # none\n  0x8002,\n]") +
    register("mode", 19, 'type = "i16"\nchoices = { off = -10, on = 1 }') + register("flag", 20, 'bits = "3"') + register("moved", 21, "offset = -40.5") +
    register("wide", 24, 'type = "u64"\norder = "ghefcdab"');
  assert.match(await openFile(page, "mine.toml", file), /mine\.toml: 9 names\. This page does not read, and left out: flag \(bits\), moved \(offset\), wide \(order ghefcdab\)\./);
  await connect(page, "line");
  await read(page, 5, "*");
  await hasValue(page, "mode (unit 5)");
  await isIdle(page);
  const shown = Object.fromEntries(await page.$$eval("#values tbody tr", (all) => all.map(({ cells }) => [cells[1].textContent, cells[2].textContent])));
  assert.deepEqual(shown, { "all (unit 5)": "184467440737095516.14 kWh", "back (unit 5)": "-2", "half (unit 5)": "1.5 Ω", "packed (unit 5)": "12345678", "no_packed (unit 5)": "0x12A4, which is no BCD",
    "label (unit 5)": "=1+2", "warm (unit 5)": "2.36 °C", "none (unit 5)": "no value: 0x8002", "mode (unit 5)": "off" });
  for (const { bytes } of line.sent.filter(({ bytes }) => bytes[0] === 5 && bytes[1] === 4)) assert.ok(bytes.readUInt16BE(4) <= 4, "more registers than the file says");
  const csv = fs.readFileSync(await download(page, "csv"), "utf8");
  assert.match(csv, /,5,all,184467440737095516\.14,/);
  assert.match(csv, /,label,,'=1\+2,/);
  for (const [content, words] of [["[[register]]\nname = \"a\"\naddress = 1\nadress = 2\n", /not taken: line 1: a: 'adress' is no key/], ["[[register]]\nname = \"a\naddress = 1", /line 2: a value is a text/],
    ["", /has no registers/], [register("a", 1) + register("A", 2), /line 6: the name 'A' stands there twice/], ["<!doctype html>", /line 1: neither/]]) {
    assert.match(await openFile(page, "flawed.toml", content), words);
  }
  assert.equal(await page.inputValue("#device"), "mine.toml", "the one before stays");
  unit.words = [];
  areWell(page);
  await page.context().close();
}

async function main() {
  const line = new Adapter(new Unit(), "");
  const bridge = await makeBridge({ line });
  const browser = await launch();
  const step = stepwise(), only = process.env.ONLY;
  try {
    for (const [name, act] of Object.entries({ openTwice, loadAgain, answerStrangely, answerLate, loseBytes, search, readOwnFile })) {
      if (!only || only.split(",").includes(name)) await step(name, () => act(browser, bridge.place, line));
    }
    areReads(line);
  } finally {
    await browser.close();
    bridge.close();
    pages.clean();
  }
  process.exit(0);
}

main().catch((problem) => {
  console.error(problem);
  process.exit(1);
});

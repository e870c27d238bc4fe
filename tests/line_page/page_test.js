// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The page in Chromium, from a file, with a `navigator.serial` of the tests' own, behind which pseudo-terminals are: a simulated
// drive and a meter, and a server of libmodbus. Everything that a page sends is read by the test, without any of our code.
//
//   node page_test.js PAGE PICTURES RTUWIRE LIBMODBUS_SERVER [night]
"use strict";
const assert = require("node:assert/strict");
const { spawn, execFileSync } = require("node:child_process");
const fs = require("node:fs");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { Adapter, makeBridge, whyNoRead } = require("./bridge.js");
const pages = require("./pages.js");
const { areReads, choose, connect, download, failed, folder, hasValue, isPhase, isTold, launch, patience, stepwise, text, told, wait } = pages;

const [page_file, shots, tool, libmodbus_server, night] = process.argv.slice(2);
const open = (browser, bridge, options) => pages.open(page_file, browser, bridge, options);
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const children = [];
const drives = ["atv12", "atv28", "atv310", "atv310_2026", "atv320"];

/// A program that goes on; resolves with the first match in what it says.
function begin(program, args, pattern) {
  const child = spawn(program, args, { stdio: ["ignore", "pipe", "pipe"] });
  children.push(child);
  return new Promise((resolve, reject) => {
    let said = "";
    const take = (text) => { said += text; const found = said.match(pattern); if (found) resolve(found); };
    child.stdout.on("data", take);
    child.stderr.on("data", take);
    child.on("exit", () => reject(new Error(`${program} ended: ${said}`)));
  });
}

/// Listens first: of a second in which nobody talks nothing is sent.
async function listenFirst(page, units) {
  await connect(page, "units");
  const { at, setting } = units.opened.at(-1);
  assert.equal(setting, "19200,8,even,1");
  assert.equal(units.sent.filter((each) => each.at < at + 950).length, 0);
  assert.equal(units.sent.length, 0, "and nothing by itself afterwards");
}

async function scanAll(page, units) {
  await page.fill("#last", "4");
  await page.click("#scan");
  await isTold(page, "Scanned: 2 units are known");
  const rows = await page.innerText("#units tbody");
  assert.match(rows, /Schneider Electric ATV320U07M2B; its table is atv320/);
  assert.match(rows, /2\s+does not say who it is/);
  areReads(units);
}

async function readMeter(page) {
  await page.fill("#unit", "2");
  await page.selectOption("#device", "sdm630");
  await page.fill("#points", "voltage_l1, frequency");
  await page.click("#read");
  await hasValue(page, "voltage_l1 (unit 2)");
  assert.match(await page.innerText("#values"), /voltage_l1 \(unit 2\)\s+\d+(\.\d+)? V/);
  await page.fill("#points", "nonsense");
  await page.click("#read");
  await page.waitForFunction(() => document.getElementById("points-flaw").textContent.includes("'nonsense' names nothing here"));
}

/// Nothing polls a drive before somebody has read what that does.
async function askForConsent(page, units) {
  await page.fill("#unit", "1");
  await page.selectOption("#device", "");
  await page.fill("#points", "ETA, RFR, LFT");
  const before = units.sent.length;
  await page.click("#watch");
  await page.waitForSelector("#consent:not([hidden])");
  assert.match(await text(page, "consent-text"), /Unit 1 is a drive.*feeds its time-out.*SLL = 0 it goes on turning/);
  assert.equal(units.sent.length, before, "not one read");
  await page.click("#agree");
  await hasValue(page, "RFR (unit 1)");
}

async function watchDrive(page, units, seconds) {
  const from = Date.now();
  await wait(seconds * 1000);
  const rounds = units.sent.filter((each) => each.at > from && each.bytes[1] === 3).length / 2; // ETA and RFR are neighbours
  assert.ok(rounds > seconds * 0.6 && rounds < seconds * 1.4, `${rounds} rounds in ${seconds} s`);
  assert.match(await page.innerText("#values"), /ETA \(unit 1\)\s+0x[0-9A-F]{4} \(/);
  // Whoever closes the tab is asked whether he means it.
  const dialog = page.waitForEvent("dialog");
  page.close({ runBeforeUnload: true });
  const asked = await dialog;
  assert.equal(asked.type(), "beforeunload");
  await asked.dismiss();
  await page.click("#stop-watch");
  await isTold(page, "Unit 1 is not asked any more: after TTO");
  await page.waitForFunction(() => !document.getElementById("read").disabled);
}

/// The tool's own backup of the same drive says the same, but for what changes by itself; and the tool reads the page's.
async function compareBackup(page, own) {
  const place = await download(page, "backup");
  const [ours, tools] = [place, own].map((each) => JSON.parse(fs.readFileSync(each, "utf8")));
  assert.deepEqual(Object.keys(ours), Object.keys(tools));
  for (const each of ["format", "made by", "unit", "drive", "vendor", "product", "revision", "rating", "rows"]) assert.equal(ours[each], tools[each], each);
  const shape = ({ parameters }) => parameters.map(({ raw, value, error, ...rest }) => JSON.stringify(rest));
  assert.deepEqual(shape(ours), shape(tools));
  const differing = ours.parameters.filter((each, at) => JSON.stringify(each) !== JSON.stringify(tools.parameters[at])).map((each) => each.register);
  console.log(`backup: ${ours.parameters.length} rows; measured meanwhile: ${differing}`);
  assert.ok(differing.length < 20);
  execFileSync(tool, ["compare", place, own], { stdio: "pipe" });
}

function openCapture(place, frames) {
  const said = execFileSync("tshark", ["-r", place, "-o", "mbrtu.udp.port:1502", "-o", "mbrtu.crc_verification:TRUE", "-T", "fields", "-e", "frame.protocols", "-e", "modbus.func_code"], { encoding: "utf8" });
  const lines = said.trim().split("\n");
  assert.ok(lines.length >= frames, `${lines.length} frames`);
  assert.ok(lines.every((each) => /mbrtu/.test(each)), lines.find((each) => !/mbrtu/.test(each)));
}

async function pullAndPlug(page, units) {
  await page.fill("#unit", "2");
  await page.selectOption("#device", "sdm630");
  await page.fill("#points", "frequency");
  await page.click("#watch");
  await hasValue(page, "frequency (unit 2)");
  units.pull();
  await isPhase(page, "the adapter is gone");
  assert.match(await told(page), /The adapter is gone: The device has been lost/);
  const before = units.sent.length;
  units.plug();
  await page.evaluate(() => navigator.serial.plug("units"));
  await isPhase(page, "ready");
  assert.match(await told(page), /The adapter is back\. It listens first/);
  assert.equal(units.sent.length, before, "nothing is read until somebody asks");
  await page.click("#read");
  await hasValue(page, "frequency (unit 2)");
}

async function hearEcho(page, units) {
  units.echoes = true;
  await page.click("#read");
  await failed(page, "the request itself came back");
  assert.match(await page.innerText("#failures"), /The adapter hears itself/);
  await page.waitForFunction(() => !document.getElementById("read").disabled);
  const before = await page.innerText("#values-note");
  await page.click("#read");
  await page.waitForFunction((then) => document.getElementById("values-note").innerText !== then, before);
  units.echoes = false;
}

/// Another client begins: this one ends what it does, and only listens from there on.
async function meetAnother(page, units) {
  await page.waitForFunction(() => !document.getElementById("watch").disabled);
  await page.click("#watch");
  await hasValue(page, "frequency (unit 2)");
  const foreign = [0x09, 0x03, 0x00, 0x00, 0x00, 0x01, 0x85, 0x42];
  assert.equal(whyNoRead(Buffer.from(foreign)), "");
  await wait(300);
  units.inject(foreign);
  await isPhase(page, "others talk");
  const before = units.sent.length;
  assert.ok(await page.isDisabled("#scan"));
  await wait(1500);
  assert.equal(units.sent.length, before);
  await page.click("#listen");
  const timer = setInterval(() => units.inject(foreign), 200);
  await isPhase(page, "listening");
  await isPhase(page, "others talk");
  clearInterval(timer);
  await page.click("#listen");
  await isPhase(page, "ready");
  assert.equal(units.sent.length, before);
}

/// Of a silent line at another rate the lowest addresses are asked; of one on which others talk nothing is.
async function findSetting(page, units) {
  await page.click("#disconnect");
  await isPhase(page, "not connected");
  units.setting = "9600,8,even,1";
  await connect(page, "units");
  await page.click("#read");
  await failed(page, "no response in time");
  await page.waitForFunction(() => !document.getElementById("find").disabled);
  await page.click("#find");
  await isTold(page, "Found: 9600 8E1.");
  assert.equal(await page.inputValue("#baud"), "9600");

  await page.click("#disconnect");
  await isPhase(page, "not connected");
  units.setting = "9600,8,none,2";
  await page.selectOption("#baud", "19200");
  const before = units.sent.length;
  const request = [0x09, 0x03, 0x00, 0x00, 0x00, 0x01, 0x85, 0x42];
  const timer = setInterval(() => units.inject(request), 150);
  await connect(page, "units", "only listening");
  await page.click("#find");
  await isTold(page, "Found: 9600 8N2 (8N2 does for 8N1 as well).");
  clearInterval(timer);
  assert.equal(units.sent.length, before, "nothing is sent on a line where others talk");
  await page.click("#disconnect");
  await isPhase(page, "not connected");
  units.setting = "";
  await page.selectOption("#baud", "19200");
  await page.selectOption("#format", "8E1");
}

async function readForeign(browser, bridge, foreign) {
  const page = await open(browser, bridge, { names: ["foreign"] });
  await connect(page, "foreign");
  await page.fill("#unit", "1");
  await page.selectOption("#device", "");
  await page.fill("#points", "100-103, 300");
  await page.click("#read");
  await hasValue(page, "103 (unit 1)");
  assert.match(await page.innerText("#values"), /100 \(unit 1\)\s+100\s/);
  await failed(page, "illegal data address");
  areReads(foreign);
  assert.deepEqual(page.problems, []);
  await page.context().close();
}

/// Watches registers of the meter, unit 2, of which the last is its frequency.
async function watchMeter(page, points) {
  await page.fill("#unit", "2");
  await page.selectOption("#device", "sdm630");
  await page.fill("#points", points);
  await page.selectOption("#period", "200");
  await page.click("#watch");
  await hasValue(page, "frequency (unit 2)");
}

/// A computer that sleeps, or a browser that stops the page's process, asks nothing; the page says so afterwards.
async function holdUp(browser, page, units) {
  await connect(page, "units");
  await watchMeter(page, "frequency");
  const control = await browser.newBrowserCDPSession();
  const { processInfo } = await control.send("SystemInfo.getProcessInfo");
  const renderers = processInfo.filter(({ type }) => type === "renderer").map(({ id }) => id);
  assert.ok(renderers.length > 0);
  for (const each of renderers) process.kill(each, "SIGSTOP");
  await wait(300);
  const before = units.sent.length;
  await wait(2500);
  assert.equal(units.sent.length, before);
  for (const each of renderers) process.kill(each, "SIGCONT");
  await isTold(page, "The browser held this page up for");
  await page.click("#stop-watch");
}

/// In a hidden tab the worker goes on as before.
async function hide(browser, page, units, seconds) {
  await page.waitForFunction(() => !document.getElementById("watch").disabled);
  await page.click("#watch");
  const other = await page.context().newPage();
  await other.bringToFront();
  const control = await page.context().newCDPSession(page);
  await control.send("Emulation.setCPUThrottlingRate", { rate: 4 });
  await control.send("Page.setWebLifecycleState", { state: "frozen" });
  await wait(1000);
  const from = Date.now();
  await wait(seconds * 1000);
  const rounds = units.sent.filter((each) => each.at > from).length;
  console.log(`hidden and frozen: ${rounds} rounds in ${seconds} s, of ${seconds * 5}`);
  assert.ok(rounds > seconds * 2, `${rounds} rounds in ${seconds} s`);
  await control.send("Page.setWebLifecycleState", { state: "active" });
  await control.send("Emulation.setCPUThrottlingRate", { rate: 1 });
  await other.close();
  await page.bringToFront();
  await page.click("#stop-watch");
}

/// Each drive is known as what it is, the one without function 43 by its registers.
async function tellDrivesApart(browser, bridge) {
  const page = await open(browser, bridge, { names: ["drives"] });
  await connect(page, "drives");
  await page.fill("#first", "11");
  await page.fill("#last", "15");
  await page.click("#scan");
  await isTold(page, "Scanned: 5 units are known");
  const rows = await page.$$eval("#units tbody tr", (all) => all.map((row) => [row.dataset.unit, row.cells[1].textContent]));
  const found = rows.map(([unit, who]) => `${unit} ${who.match(/its table is (\w+)/)?.[1]}`);
  assert.deepEqual(found, drives.map((each, at) => `${11 + at} ${each}`));
  assert.deepEqual(page.problems, []);
  await page.context().close();
}

async function refuse(browser, bridge) {
  const page = await open(browser, bridge);
  await page.evaluate(() => { navigator.serial.choice = { name: "" }; });
  await page.click("#connect");
  await isTold(page, "No adapter was chosen. Nothing was opened.");
  await page.evaluate(() => { navigator.serial.choice = { name: "units" }; navigator.serial.getPorts = async () => { throw new DOMException("no", "SecurityError"); }; });
  await page.click("#connect");
  await isTold(page, "does not allow serial ports here");
  assert.deepEqual(page.problems, []);
  await page.context().close();
}

/// A worker without ports of its own: the page carries the bytes.
async function relay(browser, bridge, units) {
  const page = await open(browser, bridge, { inWorker: false, names: ["foreign", "units"] });
  await connect(page, "units");
  await page.fill("#last", "2");
  await page.click("#scan");
  await isTold(page, "Scanned: 2 units are known");
  units.pull();
  await isPhase(page, "the adapter is gone");
  units.plug();
  await page.evaluate(() => navigator.serial.plug("units"));
  await isPhase(page, "ready");
  assert.deepEqual(page.problems.filter((each) => !/WebSocket/.test(each)), []);
  await page.context().close();
}

/// Whatever is clicked and typed, in whatever order.
async function clickAnywhere(browser, bridge, units, count) {
  const page = await open(browser, bridge), before = units.sent.length;
  await connect(page, "units");
  page.on("dialog", (dialog) => dialog.accept());
  let seed = 20240229;
  const draw = (most) => { seed = (seed * 1103515245 + 12345) % 2147483648; return Math.floor(seed / 2147483648 * most); };
  const typed = ["*", "ETA", "8501", "CMD, LFR", "input:0:f32", "coil:0-7", "voltage_l1", "0", "1", "2", "247", "999", "-1", "01 06 21 35 00 0F", "holding:8501-8502", "x"];
  for (let done = 0; done < count;) {
    const burst = Array.from({ length: 4 }, () => [draw(1e6), draw(typed.length)]);
    done += await page.evaluate(({ burst, typed }) => {
      let clicks = 0;
      for (const [which, what] of burst) {
        const all = [...document.querySelectorAll("button:not([id=csv]):not([id=capture]), select:not([id=kind]), input:not([type=file]), textarea")].filter((each) => !each.disabled && each.offsetParent);
        const one = all[which % all.length];
        ++clicks;
        // What ends what it does is drawn less often: else nothing would begin.
        if (["disconnect", "listen", "find", "stop", "stop-watch"].includes(one.id) && which % 16 !== 0) continue;
        if (one.tagName === "BUTTON" || one.type === "checkbox") one.click();
        else if (one.tagName === "SELECT") one.selectedIndex = which % one.options.length;
        else one.value = one.classList.contains("short") ? ["1", "2", "2", "3", "247", "x"][what % 6] : typed[what];
        one.dispatchEvent(new Event("input", { bubbles: true }));
        one.dispatchEvent(new Event("change", { bubbles: true }));
      }
      return clicks;
    }, { burst, typed });
    await wait(60);
    if (done % 20 !== 0) continue;
    // What is drawn asks for little that there is.
    await page.evaluate(() => {
      document.getElementById("unit").value = "2";
      document.getElementById("points").value = "input:0-3, input:6:f32";
      document.getElementById("watch").click();
    });
  }
  areReads(units);
  const left = units.sent.length - before;
  assert.ok(left > 0);
  console.log(`${count} random clicks: ${left} frames left, each a read`);
  assert.deepEqual(page.problems.filter((each) => !/WebSocket/.test(each)), []);
  await page.context().close();
}

/// Reads of 36 registers one after the other, beside another client for Web Serial on the same line: in turns of two seconds, so that
/// whatever else the machine does slows both. Of each turn what passed the adapter counts.
async function beFast(browser, bridge, units) {
  const turns = 8, seconds = 2;
  const page = await open(browser, bridge);
  const library = fs.readFileSync(path.join(path.dirname(require.resolve("axe-core")), "../modbus-webserial/dist/index.js"), "utf8");
  await page.addScriptTag({ type: "module", content: `${library}\nwindow.ModbusRTU = ModbusRTU;` });
  await page.waitForFunction(() => window.ModbusRTU);
  await page.selectOption("#baud", "115200");
  await page.evaluate(() => { document.getElementById("period").options[0].value = "1"; });
  await page.selectOption("#period", "1");
  await page.fill("#unit", "2");
  await page.fill("#points", "input:0-35");
  const count = async () => {
    const begun = units.sent.length;
    await wait(200); // until it is under way
    const from = units.sent.length, at = performance.now();
    assert.ok(from > begun);
    await wait(seconds * 1000);
    return (units.sent.length - from) / (performance.now() - at) * 1000;
  };
  const ours = [], theirs = [];
  for (let turn = 0; turn < turns; ++turn) {
    await connect(page, "units");
    await page.click("#watch");
    await hasValue(page, "input:35 (unit 2)");
    ours.push(await count());
    await page.click("#disconnect");
    await isPhase(page, "not connected");
    await page.evaluate(async () => {
      window.theirs = await window.ModbusRTU.openWebSerial({ baudRate: 115200 });
      window.theirs.setID(2);
      window.goesOn = true;
      window.ended = (async () => { while (window.goesOn) await window.theirs.readInputRegisters(0, 36); })();
    });
    theirs.push(await count());
    await page.evaluate(async () => { window.goesOn = false; await window.ended; await window.theirs.close(); });
  }
  const middle = (all) => [...all].sort((left, right) => left - right)[turns / 2];
  const ratio = middle(ours.map((each, turn) => each / theirs[turn]));
  const texts = [ours, theirs].map((all) => all.map((each) => each.toFixed(0)).join(" "));
  console.log(`requests a second, turn by turn: ${texts[0]}; modbus-webserial: ${texts[1]}; ratio ${ratio.toFixed(2)}`);
  assert.ok(ratio > 0.9, `${ratio} of modbus-webserial`);
  await page.context().close();
}

async function checkAxe(page, name) {
  await page.addScriptTag({ content: axe });
  const found = await page.evaluate(async () => {
    const { violations, passes } = await axe.run(document);
    return { passes: passes.length, violations: violations.map((each) => `${each.id}: ${each.nodes.map((node) => node.target.join(" ")).join(", ")}`) };
  });
  assert.deepEqual(found.violations, [], name);
  console.log(`axe, ${name}: ${found.passes} rules passed, 0 violations`);
}

/// Everything that a person may see at once, in light and dark, on a wide screen and on a phone.
async function look(browser, bridge) {
  for (const colorScheme of ["light", "dark"]) {
    for (const width of [1280, 390]) {
      const page = await open(browser, bridge, { viewport: { width, height: 900 }, colorScheme, names: [] });
      await page.selectOption("#kind", "simulated");
      await page.click("#connect");
      await isPhase(page, "ready");
      await page.fill("#last", "3");
      await page.click("#scan");
      await isTold(page, "Scanned: 2 units are known");
      await page.fill("#points", "ETA, RFR");
      await page.click("#read");
      await page.waitForSelector("#consent:not([hidden])");
      await page.fill("#unit", "2");
      await page.setInputFiles("#file", { name: "a-meter-with-a-long-name.toml", mimeType: "text/plain",
        buffer: Buffer.from("[[register]]\nname = \"energy\"\nspace = \"input\"\naddress = 72\ntype = \"f32\"\nunit = \"kWh\"\n[[register]]\nname = \"flag\"\naddress = 1\nbits = \"3\"\n") });
      await page.waitForFunction(() => document.getElementById("file-note").textContent.includes("left out: flag (bits)"));
      await page.fill("#points", "energy, input:0:f32, input:500");
      await page.selectOption("#period", "200");
      await page.click("#watch");
      await hasValue(page, "energy (unit 2)");
      await failed(page, "illegal data address");
      await page.fill("#bytes", "02 04 04 43 66 33 33 DF A1");
      await page.click("#frames button");
      await wait(1500);
      await page.click("#stop-watch");
      const isWide = await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);
      assert.equal(isWide, false, `the page is wider than ${width} px`);
      await page.evaluate(() => scrollTo(0, 0));
      await page.screenshot({ path: path.join(shots, `line-${colorScheme}-${width}.png`), fullPage: true });
      await checkAxe(page, `${colorScheme}, ${width} px`);
      assert.deepEqual(page.problems, []);
      await page.context().close();
    }
  }
}

/// As it stands in the file: the page's own rules forbid every request, and the simulated units answer.
async function openAlone(browser) {
  const page = await (await browser.newContext({ viewport: { width: 390, height: 844 }, colorScheme: "dark", hasTouch: true })).newPage();
  page.setDefaultTimeout(patience);
  page.problems = [];
  page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
  page.on("pageerror", (problem) => page.problems.push(String(problem)));
  await page.goto(pathToFileURL(path.resolve(page_file)).href);
  await page.waitForSelector("html[data-ready=yes]");
  await page.selectOption("#kind", "simulated");
  await page.click("#connect");
  await isPhase(page, "ready");
  await page.fill("#last", "3");
  await page.click("#scan");
  await isTold(page, "Scanned: 2 units are known");
  await watchMeter(page, "voltage_l1, power_l1, frequency");
  await wait(1500);
  const isWide = await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);
  assert.equal(isWide, false, "the page is wider than a phone");
  await page.screenshot({ path: path.join(shots, "line-phone.png"), fullPage: true });
  const refused = await page.evaluate(() => fetch("http://127.0.0.1:9/").then(() => "sent", (problem) => String(problem)));
  assert.match(refused, /TypeError/);
  assert.match(page.problems.join("\n"), /Content Security Policy/);
  page.problems.length = 0;
  await page.click("#stop-watch");
  assert.deepEqual(page.problems, []);
  await page.context().close();
}

async function main() {
  fs.mkdirSync(shots, { recursive: true });
  const [, units_device] = await begin(tool, ["simulate", "atv320:1", path.join(__dirname, "../../tools/devices/sdm630.toml:2")], /(\/dev\/pts\/\d+)/);
  const backup = path.join(folder, "tool.json");
  execFileSync(tool, ["-p", units_device, "-b", "19200", "-f", "8E1", "-u", "1", "--no-listen", "backup", "-o", backup], { stdio: "pipe" });
  const ends = ["near", "far"].map((each) => path.join(folder, each));
  await begin("socat", ["-d", "-d", ...ends.map((each) => `pty,raw,echo=0,link=${each}`)], /starting data transfer/);
  await begin(libmodbus_server, [ends[1]], /ready/);
  const [, drives_device] = await begin(tool, ["simulate", ...drives.map((each, at) => `${each}:${11 + at}`)], /(\/dev\/pts\/\d+)/);
  const units = new Adapter(units_device, ""), foreign = new Adapter(ends[0], ""), five = new Adapter(drives_device, "");
  units.lumps = 4;
  const bridge = await makeBridge({ units, foreign, drives: five });
  const browser = await launch();
  const step = stepwise();
  try {
    const page = await open(browser, bridge.place, { viewport: { width: 1280, height: 900 }, colorScheme: "light" });
    await step("listens first", () => listenFirst(page, units));
    await step("scan", () => scanAll(page, units));
    await step("meter", () => readMeter(page));
    await step("consent", () => askForConsent(page, units));
    await step("watch", () => watchDrive(page, units, night ? 60 : 5));
    await page.screenshot({ path: path.join(shots, "line.png"), fullPage: true });
    await step("axe", () => checkAxe(page, "watching a drive"));
    const capture = await download(page, "capture");
    await download(page, "csv");
    assert.match(fs.readFileSync(path.join(folder, "values.csv"), "utf8"), /^time,unit,name,number,value,measure\r\n.*\r\n/);
    openCapture(capture, units.sent.length);
    await step("backup", () => compareBackup(page, backup));
    await step("pulled", () => pullAndPlug(page, units));
    await step("echo", () => hearEcho(page, units));
    await step("others", () => meetAnother(page, units));
    await step("setting", () => findSetting(page, units));
    await step("libmodbus", () => readForeign(browser, bridge.place, foreign));
    await step("held up", () => holdUp(browser, page, units));
    await step("hidden", () => hide(browser, page, units, night ? 420 : 4));
    areReads(units);
    assert.deepEqual(page.problems.filter((each) => !/WebSocket/.test(each)), []);
    await page.context().close();
    await step("five drives", () => tellDrivesApart(browser, bridge.place));
    await step("refused", () => refuse(browser, bridge.place));
    await step("relayed", () => relay(browser, bridge.place, units));
    await step("alone", () => openAlone(browser));
    await step("looks", () => look(browser, bridge.place));
    if (night) await step("speed", () => beFast(browser, bridge.place, units));
    await step("clicks", () => clickAnywhere(browser, bridge.place, units, night ? 10000 : 500));
  } finally {
    await browser.close();
    bridge.close();
    for (const each of [units, foreign, five]) each.close();
    for (const each of children) each.kill();
    pages.clean();
  }
  console.log("the page listens, scans, identifies, reads, watches and saves; what it sent were reads");
  process.exit(0);
}

main().catch((problem) => {
  console.error(problem);
  for (const each of children) each.kill();
  process.exit(1);
});

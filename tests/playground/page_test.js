// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The page in Chromium, from a file: a start, a cut cable and a fault are clicked, and what the page shows is compared.
// The page is paused: time passes by its button only, so that the machine's speed does not matter. The axe rules are
// run in light and in dark. Pictures go to the second argument's directory.
"use strict";
const assert = require("node:assert/strict");
const fs = require("node:fs");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { chromium } = require("playwright-core");

const { namedStates, readState, writeState } = require("../../docs/playground/page/states.js");

const [page_file, shots] = process.argv.slice(2);
const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage"];
const patience = 120000; // of a busy machine, in ms
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

async function open(browser, options, state = "") {
  const page = await (await browser.newContext(options)).newPage();
  page.setDefaultTimeout(patience);
  page.problems = [];
  page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
  page.on("pageerror", (problem) => page.problems.push(String(problem)));
  page.on("request", (request) => request.url().startsWith("file:") || request.url().startsWith("data:") || page.problems.push(`asks for ${request.url()}`));
  await page.goto(pathToFileURL(path.resolve(page_file)).href + state);
  await page.waitForSelector("html[data-ready=yes]");
  return page;
}

const text = (page, id) => page.textContent("#" + id);
const wait = async (page, seconds) => { for (let i = 0; i < seconds; ++i) await page.click("#second"); };
async function shot(page, name) {
  await page.evaluate(() => scrollTo(0, 0));
  await page.screenshot({ path: path.join(shots, name + ".png"), fullPage: true });
}
const newestOrder = (page) => page.textContent("#orders li:first-child");
const stands = async (page) => { assert.equal(await text(page, "p-freq"), "0.0 Hz"); assert.equal(await text(page, "p-motor"), "stands"); };

async function checkAxe(page, name) {
  await page.addScriptTag({ content: axe });
  const found = await page.evaluate(async () => {
    const { violations, passes } = await axe.run(document);
    return { passes: passes.length, violations: violations.map((each) => `${each.id}: ${each.nodes.map((node) => node.target.join(" ")).join(", ")}`) };
  });
  assert.deepEqual(found.violations, [], name);
  assert.ok(found.passes > 20, name);
  console.log(`axe, ${name}: ${found.passes} rules passed, 0 violations`);
}

/// All that a screen reader is told from now on: what is added to the log.
async function listen(page) {
  await page.evaluate(() => {
    window.heard = [];
    window.listener?.disconnect();
    window.listener = new MutationObserver((changes) => window.heard.push(...changes.flatMap((each) => [...each.addedNodes]).map((each) => each.textContent)));
    window.listener.observe(document.getElementById("said"), { childList: true });
  });
}
async function isHeard(page, times, ...texts) {
  const heard = await page.evaluate(() => window.heard);
  for (const each of texts) assert.equal(heard.filter((said) => said.startsWith(each)).length, times, `${each} in: ${heard.join("; ")}`);
}
const heardOnce = (page, ...texts) => isHeard(page, 1, ...texts);

async function start(page) {
  await page.click("#pause");
  await page.click("#mains");
  await wait(page, 1);
  assert.equal(await text(page, "p-state"), "switch on disabled");
  await page.fill("#hertz", "30");
  await listen(page);
  await page.click("#start");
  await wait(page, 6);
  assert.equal(await text(page, "p-state"), "operation enabled");
  assert.equal(await text(page, "p-freq"), "30.0 Hz");
  assert.equal(await text(page, "p-motor"), "turns forward");
  assert.equal(await text(page, "p-order"), "ordered it to run");
  assert.match(await newestOrder(page), /^start at 30 Hz: done/);
  assert.equal(await page.textContent("#machine .here text"), "operation enabled");
  await heardOnce(page, "start at 30 Hz: done", "Motor: turns forward");
}

/// The frames of the start, oldest first, as the table shows them.
async function seeFrames(page) {
  const rows = (await page.$$eval("#frames tbody tr", (all) => all.map((row) => row.innerText.replace(/\s+/g, " ")))).reverse();
  const places = ["write CMD 0x0006", "write CMD 0x0007", "write LFR 30.0 Hz", "write CMD 0x000F"]
    .map((what) => rows.findIndex((row) => row.includes("client") && row.includes(what)));
  assert.ok(places.every((place, at) => place > (at === 0 ? -1 : places[at - 1])), `${places}: ${rows.join("\n")}`);
  assert.ok(rows[places[3]].includes("01 06 21 35 00 0F"), rows[places[3]]);
  await page.click("#frames tbody tr:has-text('write CMD 0x000F') button");
  const fields = await text(page, "detail");
  for (const part of ["write single register", "8501", "CRC", "right"]) assert.ok(fields.includes(part), fields);
}

async function cutCable(page) {
  await page.check("#cable input[value='1']");
  await wait(page, 2);
  assert.equal(await text(page, "p-client"), "no link");
  assert.equal(await text(page, "p-freq"), "30.0 Hz", "before the drive's time-out the motor turns");
  await wait(page, 5);
  assert.match(await text(page, "p-fault"), /SLF1/);
  assert.equal(await text(page, "p-order"), "it may still run");
  assert.equal(await text(page, "p-freq"), "0.0 Hz");
  assert.equal(await text(page, "p-motor"), "no power: it coasts");
  assert.match(await text(page, "now"), /^The drive heard nothing for its time-out.* coasts/);
  await shot(page, "cut");
  await wait(page, 5);
  await stands(page);
  await page.check("#cable input[value='0']");
  await wait(page, 20);
  assert.equal(await text(page, "p-client"), "fault", "the client sees the drive again");
  await stands(page);
  assert.equal(await text(page, "p-order"), "had ordered it to run");
  await page.click("#reset");
  await wait(page, 2);
  assert.match(await newestOrder(page), /^reset the fault: done/);
  assert.equal(await text(page, "p-state"), "switch on disabled");
  await stands(page);
}

async function makeFault(page) {
  await page.click("#start");
  await wait(page, 5);
  await page.click("#reverse");
  await wait(page, 8);
  assert.equal(await text(page, "p-freq"), "-30.0 Hz");
  await page.click("#fault");
  await wait(page, 1);
  assert.equal(await page.textContent("#machine .here text"), "fault");
  assert.match(await text(page, "p-fault"), /OCF/);
  assert.equal(await text(page, "p-motor"), "no power: it coasts");
  assert.doesNotMatch(await text(page, "now"), /time-out/, "the cause of this fault is another");
  await page.click("#start");
  await wait(page, 1);
  assert.match(await newestOrder(page), /the drive is in fault, LFT 9/);
  await page.check("#cable input[value='1']");
  await wait(page, 4);
  assert.doesNotMatch(await text(page, "now"), /time-out/, "nor is it the cable");
  await page.check("#cable input[value='0']");
  await wait(page, 20);
  await stands(page);
  await page.click("#fault");
  await page.click("#reset");
  await wait(page, 2);
  assert.equal(await text(page, "p-state"), "switch on disabled");
  await stands(page);
}

async function typeRequest(page) {
  await page.fill("#bytes", "01 03 0C 81 00 01");
  assert.match(await text(page, "judged"), /D7 72$/);
  await page.click("#offer");
  assert.equal(await text(page, "judged"), "A whole frame, and its CRC is right.");
  assert.match(await text(page, "typed"), /3201 \(ETA\)/);
  await page.click("#send");
  await wait(page, 1);
  const rows = await page.$$eval("#frames tbody tr", (all) => all.map((row) => row.innerText.replace(/\s+/g, " ")));
  const asked = rows.findIndex((row) => row.includes(" you 01 03 0C 81 00 01 D7 72"));
  assert.ok(asked >= 0, rows.slice(0, 12).join("\n"));
}

/// What is typed as a reference is what is asked for, or nothing is; what is no number stands as it was typed.
async function typeReference(page) {
  const numbers = ["6583.6", "-6523.6", "429496759.6", "0.04", "49.99999999"];
  const others = ["", "2,5", "0x10", "1e300", "1e309", "--5", "5 0"];
  for (const typed of [...numbers, ...others]) {
    await page.fill("#hertz", typed);
    for (const button of ["#start", "#change", "#reverse"]) {
      await page.click(button);
      await wait(page, 1);
      const reason = others.includes(typed) ? /: not given: type a number first/ : /: not given: value/;
      assert.match(await newestOrder(page), reason, `${button} with ${typed}`);
      assert.ok((await newestOrder(page)).includes(typed.replace("-", "")), `${button} with ${typed}`);
      if (others.includes(typed)) assert.equal(await page.inputValue("#hertz"), typed);
    }
    await stands(page);
  }
  await page.fill("#hertz", "-12.5");
  assert.equal(await page.inputValue("#slider"), "-12.5");
  await page.fill("#hertz", "2,5");
  assert.equal(await page.inputValue("#slider"), "-12.5");
  await page.fill("#slider", "7.5");
  assert.equal(await page.inputValue("#hertz"), "7.5");
  await page.fill("#hertz", "30");
}

const newestKind = (page) => page.getAttribute("#orders li:first-child", "class");

/// An order that was done, but not as it was given: its text begins with "done", and its colour is another.
async function endOtherwise(page) {
  await page.fill("#hertz", "60");
  await page.click("#start");
  await wait(page, 7);
  assert.match(await newestOrder(page), /^start at 60 Hz: done, at the drive's limit: /);
  assert.equal(await newestKind(page), "done otherwise");
  assert.equal(await text(page, "p-freq"), "50.0 Hz");
  assert.match(await text(page, "how-note"), /the motor coasts/);
  await page.click("#stop");
  await wait(page, 12);
  assert.match(await newestOrder(page), /^stop: on the ramp: done/);
  assert.equal(await newestKind(page), "done");
  await stands(page);
  await page.fill("#hertz", "30");
}

/// Without a look at the page: what changes for the motor is told, once, whoever or whatever changed it.
async function runUnseen(page) {
  const changes = [
    { act: () => page.click("#mains"), tells: ["The drive has no mains"], undo: () => page.click("#mains") },
    { act: () => page.click("#local"), tells: ["Somebody took the drive over"], undo: () => page.click("#local") },
    { act: () => page.click("#key"), tells: [], undo: () => {} },
    { act: () => page.click("#fault"), tells: ["The drive trips: OCF"], undo: () => page.click("#fault") },
    { act: () => page.check("#cable input[value='1']"), undo: () => page.check("#cable input[value='0']"),
      tells: ["The client gets no answers", "The client has given its order up", "The drive trips: SLF"] },
  ];
  for (const { act, tells, undo } of changes) {
    await listen(page);
    await page.click("#start");
    await wait(page, 5);
    await heardOnce(page, "start at 30 Hz: done", "Motor: turns forward");
    await listen(page);
    await act();
    await wait(page, 20);
    await heardOnce(page, ...tells, "Motor: no power: it coasts", "Motor: stands");
    await undo();
    await wait(page, 3);
    await page.click("#reset");
    await wait(page, 2);
    await stands(page);
  }
}

/// The picture's description is what it shows; and no motor that turns is thrown away with its drive.
async function describePicture(page) {
  await page.click("#start");
  assert.ok(await page.isEnabled("#drive"), "nothing has left yet");
  await wait(page, 5);
  await page.check("#cable input[value='2']");
  assert.equal(await text(page, "picture-text"), "Client: operation enabled, reads 30.0 Hz, ordered it to run. Cable: cut towards the drive. " +
    "ATV320: operation enabled, 30.0 Hz, no fault. Motor: turns forward.");
  assert.ok(await page.isDisabled("#drive"));
  assert.match(await text(page, "drive-note"), /once the motor stands/);
  await page.check("#cable input[value='0']");
  await wait(page, 1);
  await page.selectOption("#how", { label: "freewheel" });
  await page.click("#stop");
  await wait(page, 1);
  assert.equal(await text(page, "p-motor"), "no power: it coasts");
  assert.ok(await page.isDisabled("#drive"), "it still turns");
  await wait(page, 12);
  await page.selectOption("#how", { label: "on the ramp" });
  assert.ok(await page.isEnabled("#drive"));
  assert.equal(await text(page, "drive-note"), "");
}

/// An order that is under way is not pushed out of the list by those that are refused meanwhile.
async function startAgainAndAgain(page) {
  await listen(page);
  for (let i = 0; i < 15; ++i) await page.click("#start");
  const listed = () => page.$$eval("#orders li", (all) => all.map((each) => each.textContent));
  assert.equal((await listed()).filter((each) => / Hz: under way/.test(each)).length, 1);
  await wait(page, 5);
  assert.equal((await listed()).filter((each) => /^start at 30 Hz: done/.test(each)).length, 1);
  await heardOnce(page, "start at 30 Hz: done");
  await page.click("#stop");
  await wait(page, 12);
  await stands(page);
}

const sentence = async (page, pattern) => assert.match(await text(page, "now"), pattern);

/// The time-out is switched off while the motor runs: no sentence may say that the drive stops.
async function switchTimeOutOff(page) {
  await page.click("#start");
  await wait(page, 5);
  await page.uncheck("#supervised");
  await wait(page, 1);
  await sentence(page, /runs on if the line goes silent/);
  await page.check("#cable input[value='1']");
  await wait(page, 10);
  await sentence(page, /switched off: the motor turns until somebody stops it/);
  assert.equal(await text(page, "p-motor"), "turns forward");
  await page.check("#cable input[value='0']");
  await wait(page, 10);
  await sentence(page, /^The motor runs without an order.*time-out is switched off.*Press Stop/);
  assert.equal(await text(page, "p-order"), "had ordered it to run");
  await page.click("#stop");
  await wait(page, 8);
  await stands(page);
  await page.click("#mains");
  for (const id of ["supervised", "local", "key"]) assert.ok(await page.isDisabled("#" + id), id);
  await page.click("#fault");
  await page.click("#mains");
  await wait(page, 1);
  assert.ok(await page.isChecked("#supervised"), "the drive lost that setting");
  assert.match(await text(page, "p-fault"), /OCF/, "the cause was there when the mains came back");
  await page.click("#local");
  assert.equal(await page.getAttribute("#local", "aria-pressed"), "true");
  await page.click("#fault");
  await page.click("#mains");
  assert.equal(await page.getAttribute("#local", "aria-pressed"), "false");
  await page.click("#mains");
  await wait(page, 1);
  assert.equal(await text(page, "p-state"), "switch on disabled");
}

/// Bytes that no client sent run the motor: the client says that it is none of its orders.
async function runByTyping(page) {
  for (const frame of ["01 06 21 36 01 2C", "01 06 21 35 00 06", "01 06 21 35 00 07", "01 06 21 35 00 0F"]) {
    await page.fill("#bytes", frame);
    await page.click("#offer");
    await page.click("#send");
    await wait(page, 1);
  }
  await sentence(page, /not by an order of this client/);
  await page.check("#cable input[value='3']");
  await wait(page, 3);
  await sentence(page, /never ordered this motor.*the motor goes on/);
  await page.check("#cable input[value='0']");
  await wait(page, 3);
  await page.click("#stop");
  await wait(page, 8);
  await stands(page);
}

/// The same words twice are announced twice.
async function announceAgain(page) {
  await listen(page);
  for (let i = 0; i < 2; ++i) {
    await page.click("#reset");
    await wait(page, 2);
  }
  await isHeard(page, 2, "reset the fault: ");
  await listen(page);
  await wait(page, 30);
  assert.deepEqual(await page.evaluate(() => window.heard), [], "where nothing changes, nothing is said");
}

async function judgeBytes(page) {
  for (const [typed, judged] of [["01 03 0C 81 00 01 D7 72 01 03 0C 81 00 01 D7 72", /^Whole frames/], ["😀", /^character 1: not a hex/],
    ["01 é 03", /^character 4: not a hex/], ["--", /^No byte in it yet/], ["  ", /^Nothing typed yet/], ["0x01 0x03", /^No whole frame yet/]]) {
    await page.fill("#bytes", typed);
    assert.match(await text(page, "judged"), judged, typed);
  }
  for (const [typed, judged] of [["01 06 21 36 01 2C zz 99", /^character 19: not a hex/], ["01 10 21 35 00 02 04 00 0F 01 2C x", /^character 34: not a hex/],
    ["[12:34:56.123] TX 01 06 21 36 01 2C", /^character 13: a byte has two/], ["0000: 01 06 21 36 01 2C", /offset/], ["01 06 21 36 01 2C" + " ".repeat(2000), /^2017 characters/]]) {
    await page.fill("#bytes", typed);
    assert.match(await text(page, "judged"), judged, typed);
    assert.equal((await page.inputValue("#bytes")).length, typed.length);
    assert.deepEqual([await page.isDisabled("#offer"), await page.isDisabled("#send"), await text(page, "typed")], [true, true, ""], typed);
  }
}

/// While time stands the first bytes wait, and others do not take their place.
async function sendTwice(page) {
  await page.fill("#bytes", "01 03 0C 81 00 01 D7 72");
  await page.click("#send");
  assert.match(await text(page, "sent"), /^Your bytes leave/);
  await page.fill("#bytes", "01 03 0C 81 00 02 97 73");
  assert.equal(await text(page, "sent"), "");
  await page.click("#send");
  assert.match(await text(page, "sent"), /^Not sent: your bytes before these/);
  assert.match(await page.textContent("#said p:last-child"), /^Not sent/);
  await wait(page, 1);
  await page.click("#send");
  assert.match(await text(page, "sent"), /^Your bytes leave/);
  await wait(page, 1);
}

/// Who goes on to another page and comes back finds what a fresh page shows.
async function comeBack(page) {
  await page.selectOption("#speed", "0.01");
  await page.fill("#hertz", "-7");
  await page.fill("#bytes", "01 02");
  await page.uncheck("#hide");
  await page.check("#cable input[value='1']");
  await page.goto("about:blank");
  await page.goBack();
  await page.waitForSelector("html[data-ready=yes]");
  const shown = await page.evaluate(() => [...document.querySelectorAll("#speed, #slider, #hertz, #bytes, #cable :checked, #hide:checked")].map((each) => each.value));
  assert.deepEqual(shown, ["1", "30", "30", "0", "on", ""]);
  assert.equal(await text(page, "t-client"), "knows nothing, no order");
}

/// The examples one after the other, with the list closed; and a row that has the focus keeps it.
async function useKeyboard(page) {
  await page.focus("#example");
  const seen = new Set();
  for (let i = 0; i < 5; ++i) {
    await page.keyboard.press("ArrowDown");
    seen.add(await page.inputValue("#bytes"));
  }
  assert.equal(seen.size, 5);
  await page.uncheck("#hide");
  const number = await page.getAttribute("#frames tbody tr:first-child", "data-number");
  await page.focus("#frames tbody tr:first-child button");
  await page.evaluate(() => { for (let i = 0; i < 20; ++i) document.getElementById("second").click(); });
  assert.equal(await page.evaluate(() => document.activeElement.closest("tr")?.dataset.number), number);
  assert.ok(await page.evaluate(() => document.querySelectorAll("#frames tbody tr").length) <= 150);
  await page.check("#hide");
}

/// Without JavaScript the page says so.
async function openWithoutScripts(browser) {
  const page = await (await browser.newContext({ javaScriptEnabled: false })).newPage();
  await page.goto(pathToFileURL(path.resolve(page_file)).href);
  assert.match(await page.innerText("body"), /needs JavaScript/);
  await page.close();
}

/// By keyboard alone: the controls in their order, each with a focus that can be seen.
async function tabThrough(page) {
  await page.focus("#drive");
  const order = [];
  for (let i = 0; i < 8; ++i) {
    await page.keyboard.press("Tab");
    order.push(await page.evaluate(() => `${document.activeElement.id}:${getComputedStyle(document.activeElement).outlineStyle}`));
  }
  assert.deepEqual(order, ["mains", "slider", "hertz", "start", "change", "reverse", "stop", "how"].map((id) => id + ":solid"));
}

async function eachDrive(page) {
  for (const drive of ["ATV12", "ATV28", "ATV310", "ATV310 2026", "ATV320"]) {
    await page.selectOption("#drive", { label: drive });
    await page.fill("#hertz", "30");
    assert.equal(await text(page, "p-name"), drive);
    await page.click("#mains");
    await wait(page, 1);
    await page.click("#start");
    await wait(page, 6);
    assert.equal(await text(page, "p-motor"), "turns forward", drive);
    await page.click("#stop");
    await wait(page, 8);
    await wait(page, 3); // one that was told 0000 coasts
    await stands(page);
  }
}

/// An address is read as it was written, and one that is wrong is refused as a whole.
function readAddresses() {
  const drives = ["atv12", "atv320"];
  const acts = [[500000, "power", "1"], [1000001, "start", "-2,5 é;:="], [1000001, "key", ""]];
  const text = writeState("atv12", acts, 6400000);
  assert.deepEqual(readState(text, drives), { drive: 0, acts, time: 6400000 });
  assert.deepEqual(readState("atv320", drives), { drive: 1, acts: [], time: 0 });
  for (const name of Object.keys(namedStates)) assert.ok(readState(name, drives).acts.length > 0, name);
  assert.equal(writeState("atv12", Array(201).fill(acts[0]), 1), "");
  for (const [wrong, said] of [["", /neither a type of drive/], ["atv99;1", /neither a type of drive/], ["toString", /neither/], ["atv12;1:fly;2", /no act "fly"/],
    ["atv12;1:power=1", /not a time with an act/], ["atv12;2:power=1;1", /before the one ahead/], ["atv12;9999", /above 3600/], ["atv12;1;2", /not a time/],
    ["atv12;-1", /not a time/], ["atv12;1:start=%;2", /URI/], [`atv12;${"1:key;".repeat(300)}2`, /200 are done at most/]]) {
    assert.throws(() => readState(wrong, drives), said, wrong);
  }
}

/// What somebody saw, another sees by its address: the same orders at the same times, with the same ends.
async function shareState(browser) {
  const first = await open(browser, { viewport: { width: 1400, height: 900 } });
  await first.click("#pause");
  await first.selectOption("#drive", { label: "ATV12" });
  await first.click("#mains");
  await wait(first, 1);
  await first.fill("#hertz", "20");
  await first.click("#start");
  await wait(first, 6);
  await first.check("#cable input[value='3']");
  await wait(first, 1);
  const shown = async (page) => Promise.all(["p-name", "p-state", "p-fault", "p-motor"].map((id) => text(page, id)).concat(page.innerText("#orders")));
  const before = await shown(first);
  await first.click("#share");
  await first.waitForFunction(() => document.getElementById("shared").textContent !== "");
  assert.match(await text(first, "shared"), /^(Copied|The address of this state stands above)/);
  const state = await first.evaluate(() => location.hash);
  assert.match(state, /^#atv12;.*:power=1;.*:start=20;.*:cable=3;[\d.]+$/);
  const second = await open(browser, { viewport: { width: 1400, height: 900 } }, state);
  await second.click("#pause");
  assert.deepEqual((await shown(second)).map((each) => each.replace(/under way.*/, "")), before.map((each) => each.replace(/under way.*/, "")));
  assert.ok(await second.isChecked("#cable input[value='3']"));
  assert.equal(await second.inputValue("#hertz"), "20");

  // A state by its name, on a page that is open; it goes on from there.
  await second.evaluate(() => { location.hash = "#cut-cable-while-running"; });
  await second.waitForFunction(() => document.getElementById("p-name").textContent === "ATV320");
  assert.ok(await second.isChecked("#cable input[value='1']"));
  assert.equal(await text(second, "p-motor"), "turns forward");
  await wait(second, 12);
  assert.match(await text(second, "p-fault"), /SLF1/);
  await stands(second);

  // An address that is wrong is told, and the page is a fresh one.
  await second.evaluate(() => { location.hash = "#atv12;1:power=1;2:fly;3"; });
  await second.waitForFunction(() => document.getElementById("shared").textContent.includes('there is no act "fly"'));
  assert.equal(await text(second, "p-state"), "off");
  for (const page of [first, second]) assert.deepEqual(page.problems, []);
}

/// In a frame of another page: what the line does, its orders and its cable, and a way to the rest with the same state.
async function openSmall(browser) {
  for (const [width, most] of [[1130, 470], [362, 720]]) {
    const page = await open(browser, { viewport: { width, height: most } }, "?small#running");
    assert.equal(await text(page, "p-motor"), "turns forward");
    await page.check("#cable input[value='1']");
    await page.click("#pause");
    const high = await page.evaluate(() => document.documentElement.scrollHeight);
    assert.ok(high <= most, `a frame of ${width} pixels is ${high} high`);
    await page.focus("#whole");
    assert.match(await page.getAttribute("#whole", "href"), /^index\.html#atv320;0\.5:power=1;1:start=30;.*:cable=1;/);
    await checkAxe(page, `in a frame of ${width} pixels`);
    await shot(page, `small-${width}`);
    assert.deepEqual(page.problems, []);
  }
}

async function main() {
  readAddresses();
  fs.mkdirSync(shots, { recursive: true });
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: flags, timeout: patience });
  try {
    const page = await open(browser, { viewport: { width: 1400, height: 900 }, colorScheme: "light" });
    const paint = await page.evaluate(() => performance.getEntriesByType("paint").map((each) => `${each.name} ${each.startTime.toFixed(0)} ms`));
    console.log(`paint: ${paint.join(", ")}; the page has ${fs.statSync(page_file).size} bytes`);
    await start(page);
    await shot(page, "light");
    await seeFrames(page);
    await cutCable(page);
    await makeFault(page);
    await typeRequest(page);
    await typeReference(page);
    await endOtherwise(page);
    await startAgainAndAgain(page);
    await describePicture(page);
    await runUnseen(page);
    await switchTimeOutOff(page);
    await runByTyping(page);
    await announceAgain(page);
    await judgeBytes(page);
    await sendTwice(page);
    await useKeyboard(page);
    await checkAxe(page, "light");
    await shot(page, "end");
    await tabThrough(page);
    await eachDrive(page);
    await comeBack(page);
    assert.deepEqual(page.problems, []);

    await shareState(browser);
    await openSmall(browser);
    await openWithoutScripts(browser);
    const dark = await open(browser, { viewport: { width: 390, height: 844 }, colorScheme: "dark", reducedMotion: "reduce", hasTouch: true });
    await start(dark);
    const isWide = await dark.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);
    assert.equal(isWide, false, "the page is wider than a phone");
    assert.equal(await dark.innerText("#t-client"), "operation enabled, reads 30.0 Hz, ordered it to run");
    assert.equal(await dark.innerText("#t-motor"), "turns forward");
    const letters = await dark.evaluate(() => parseFloat(getComputedStyle(document.getElementById("t-client")).fontSize));
    assert.ok(letters >= 13, `the state is written in ${letters} pixels`);
    await checkAxe(dark, "dark, on a phone");
    await shot(dark, "phone");
    await dark.setViewportSize({ width: 1400, height: 900 });
    await checkAxe(dark, "dark");
    await shot(dark, "dark");
    assert.deepEqual(dark.problems, []);
  } finally {
    await browser.close();
  }
  console.log("the page shows what happens: a start, a cut cable, a fault, typed bytes, five drives");
}

main().catch((problem) => { console.error(problem); process.exitCode = 1; });

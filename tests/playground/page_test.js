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

const [page_file, shots] = process.argv.slice(2);
const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage"];
const patience = 120000; // of a busy machine, in ms
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

async function open(browser, options) {
  const page = await (await browser.newContext(options)).newPage();
  page.setDefaultTimeout(patience);
  page.problems = [];
  page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
  page.on("pageerror", (problem) => page.problems.push(String(problem)));
  page.on("request", (request) => request.url().startsWith("file:") || request.url().startsWith("data:") || page.problems.push(`asks for ${request.url()}`));
  await page.goto(pathToFileURL(path.resolve(page_file)).href);
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

async function start(page) {
  await page.click("#pause");
  await page.click("#mains");
  await wait(page, 1);
  assert.equal(await text(page, "p-state"), "switch on disabled");
  await page.fill("#hertz", "30");
  await page.click("#start");
  await wait(page, 6);
  assert.equal(await text(page, "p-state"), "operation enabled");
  assert.equal(await text(page, "p-freq"), "30.0 Hz");
  assert.equal(await text(page, "p-motor"), "turns forward");
  assert.equal(await text(page, "p-order"), "ordered it to run");
  assert.match(await newestOrder(page), /^start at 30.0 Hz: done/);
  assert.equal(await page.textContent("#machine .here text"), "operation enabled");
  assert.match(await text(page, "said"), /^start at 30.0 Hz: done/);
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
  await stands(page);
  await shot(page, "cut");
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
  await stands(page);
  await page.click("#start");
  await wait(page, 1);
  assert.match(await newestOrder(page), /the drive is in fault, LFT 9/);
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
    await stands(page);
  }
}

async function main() {
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
    await checkAxe(page, "light");
    await shot(page, "end");
    await tabThrough(page);
    await eachDrive(page);
    assert.deepEqual(page.problems, []);

    const dark = await open(browser, { viewport: { width: 390, height: 844 }, colorScheme: "dark", reducedMotion: "reduce", hasTouch: true });
    await start(dark);
    const isWide = await dark.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);
    assert.equal(isWide, false, "the page is wider than a phone");
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

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What the tests do with a page in Chromium: it is opened from its file with a `navigator.serial` of theirs, and asked for what a
// person sees.
"use strict";
const assert = require("node:assert/strict");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { chromium } = require("playwright-core");
const { whyNoRead } = require("./bridge.js");
const { installFakeSerial, fakeText } = require("./fake_serial.js");

const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-dev-shm-usage"];
const patience = Number(process.env.PATIENCE ?? 120000); // of a busy machine, in ms
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "line_page"));
const clean = () => fs.rmSync(folder, { recursive: true, force: true });
const wait = (milliseconds) => new Promise((resolve) => { setTimeout(resolve, milliseconds); });
const launch = () => chromium.launch({ executablePath: "/usr/bin/chromium", args: flags, timeout: patience });
const stepwise = () => async (name, act) => {
  const from = Date.now();
  await act();
  console.log(`${name}: ${((Date.now() - from) / 1000).toFixed(1)} s`);
};

async function open(page_file, browser, bridge, options = {}) {
  const { inWorker = true, names = ["units"], ...context } = options;
  const page = await (await browser.newContext({ bypassCSP: true, acceptDownloads: true, ...context })).newPage();
  page.setDefaultTimeout(patience);
  page.problems = [];
  page.on("console", (message) => message.type() === "error" && page.problems.push(message.text()));
  page.on("pageerror", (problem) => page.problems.push(String(problem)));
  page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || page.problems.push(`asks for ${request.url()}`));
  await page.addInitScript(installFakeSerial, { fake: fakeText, bridge, names, inWorker });
  await page.goto(pathToFileURL(path.resolve(page_file)).href);
  await page.waitForSelector("html[data-ready=yes]");
  return page;
}

const text = (page, id) => page.textContent("#" + id);
const told = (page) => page.innerText("#told");
const isPhase = (page, words) => page.waitForFunction((wanted) => document.getElementById("phase").textContent.includes(wanted), words);
const isTold = (page, words) => page.waitForFunction((wanted) => document.getElementById("told").innerText.includes(wanted), words);
const failed = (page, words) => page.waitForFunction((wanted) => document.getElementById("failures").innerText.includes(wanted), words);
const hasValue = (page, words) => page.waitForFunction((wanted) => document.getElementById("values").innerText.includes(wanted), words);
const choose = (page, name) => page.evaluate((wanted) => { navigator.serial.choice = { name: wanted }; }, name);

function areReads(adapter) {
  for (const { bytes } of adapter.sent) assert.equal(whyNoRead(bytes), "", bytes.toString("hex"));
}

async function connect(page, name, phase = "ready") {
  await choose(page, name);
  await page.click("#connect");
  await isPhase(page, phase);
}

async function download(page, id) {
  const [saved] = await Promise.all([page.waitForEvent("download"), page.click("#" + id)]);
  const place = path.join(folder, saved.suggestedFilename());
  await saved.saveAs(place);
  return place;
}

module.exports = { areReads, choose, clean, connect, download, failed, folder, hasValue, isPhase, isTold, launch, open, patience, stepwise, text, told, wait };

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Opens the built site from the disk in Chromium, as a phone and as a desktop, in light and in dark: nothing on a page may
// complain, be wider than the screen or be illegible, no rule of axe may be broken, the search has to find what is there, tables
// filter and sort, and the first page is light, moves nothing and runs the playground.
//
//     node browser.mjs SITE SCREENS
import {strict as assert} from "node:assert";
import fs from "node:fs";
import {createRequire} from "node:module";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {chromium} from "playwright-core";

const [site, screens] = process.argv.slice(2);
const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync"];
const sizes = {phone: {width: 390, height: 844}, desktop: {width: 1280, height: 900}};
// One of each kind of page; all of the guides are visited on the phone.
const shown = ["index", "readme", "start_two_commands", "start_wiring", "drives_atv320", "concepts", "errors", "names", "figures",
    "classrtuwire_1_1basic__client", "line/index", "playground/index"];
const mostBytes = 250_000; // of the first page with all that it loads, before the playground
const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const lanes = 4;
const limit = 60_000; // of a busy machine; no result depends on it
// What somebody types who does not know our words, and a word of what has to be found; null: nothing.
const wanted = {"xyzzy": null, "blocking_client": "blocking_client", "wiring": "Wiring", "start": "start",
    "crc_mismatch": "cause and remedy", "late answer": "Late answer", "crc mismatch": "cause and remedy", "exception 02": "illegal data address",
    "illegal data address": "illegal_data_address", "time-out": "TTO", "timeout of a drive": "TTO", "watchdog": "TTO", "heartbeat": "TTO",
    "baud": "bit rate", "parity": "bit rate", "8n1": "bit rate", "rs485": "common", "rs-485": "common", "de pin": "driver_enable",
    "driver enable": "driver_enable", "half duplex": "driver_enable", "termination": "termination", "atv12 scanner": "cyclic", "stop motor": "stop_by",
    "quick stop": "stop_by", "emergency stop": "hardware", "esp32": "UART", "stm32": "a file for your board", "platformio": "lib_deps", "modbus tcp": "mbap_stream",
    "windows": "host_serial", "write register": "write_single_register", "read holding registers": "read_holding_registers", "endian": "word_order",
    "word order": "word_order", "dma": "response_frame", "latency": "adapters", "acceleration ramp": "ACC", "slf": "reset_fault", "python": "--json",
    "install": "include/", "license": "BSL-1.0", "slave": "server", "master": "client", "thread": "one context", "no response": "timed_out",
    "multi drop": "32 units", "unit address": "unit", "eta": "state and warnings", "retries": "retries",
    "read coils": "coil", "mbpoll": "mbpoll", "how to stop": "stop_by", "pump": "cyclic", "restore": "rtuwire restore", "backup": "rtuwire backup"};
/// What these find first: what has changed is no answer.
const foremost = {"restore": "rtuwire restore", "backup": "rtuwire backup"};

const address = (page) => pathToFileURL(path.join(site, `${page}.html`)).href;
const guides = fs.readdirSync(site).filter((name) => /^[a-z][a-z0-9_]*\.html$/.test(name))
    .map((name) => name.replace(/\.html$/, ""))
    .filter((name) => !/^(class|struct|namespace|concept|functions|globals|files|annotated|classes|hierarchy)/.test(name) &&
        !/_8(hpp|md)/.test(name) && !/^dir_/.test(name));

/// What a page says of itself.
const measured = () => {
    const luminance = (colour) => {
        const [r, g, b] = colour.match(/[\d.]+/g).map((part) => {
            const value = part / 255;
            return value <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
        });
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const text = document.querySelector(".contents p, .contents td, .contents li") ?? document.querySelector(".contents, main, body");
    const [one, other] = [getComputedStyle(text).color, getComputedStyle(document.body).backgroundColor].map(luminance);
    return {
        wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
        contrast: (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05),
        ground: other,
        title: document.title,
    };
};

async function visit(browser, name, scheme, size, take) {
    const context = await browser.newContext({viewport: sizes[size], colorScheme: scheme, reducedMotion: "reduce"});
    const page = await context.newPage();
    page.setDefaultTimeout(limit);
    const complaints = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("request", (request) => !/^(?:file|data|blob):/.test(request.url()) && complaints.push(`asks for ${request.url()}`));
    await page.goto(address(name), {waitUntil: "load"});
    const seen = await page.evaluate(measured);
    if (take) {
        await page.screenshot({path: path.join(screens, `${name.replace("/", "-")}-${size}-${scheme}.png`)});
    }
    const where = `${name} on a ${size} in ${scheme}`;
    if (take) {
        await page.addScriptTag({content: axe});
        const broken = await page.evaluate(async () => (await axe.run(document, {preload: false})).violations.map(
            ({id, nodes}) => `${id}: ${nodes.slice(0, 3).map(({target}) => target.join(" ")).join(", ")}`));
        assert.deepEqual(broken, [], `${where} breaks a rule`);
    }
    await context.close();
    assert.deepEqual(complaints, [], `${where} complains`);
    assert.ok(seen.wide <= 0, `${where} is ${seen.wide} pixels wider than the screen`);
    assert.ok(seen.contrast >= 4.5, `${where} has text of a contrast of ${seen.contrast}`);
    assert.ok(scheme === "dark" ? seen.ground < 0.2 : seen.ground > 0.8, `${where} has a ground of ${seen.ground}`);
    assert.match(seen.title, /rtuwire/, `${where} has the title '${seen.title}'`);
}

/// Types into the search, and follows what it finds.
async function search(browser, words, expected) {
    const page = await browser.newPage({viewport: sizes.desktop});
    page.setDefaultTimeout(limit);
    await page.goto(address("figures"), {waitUntil: "load"});
    await page.fill("#find", words);
    await page.locator("#found [role=status]:not(:empty)").waitFor();
    const results = page.locator("#found li");
    const texts = await results.allInnerTexts();
    if (expected === null) {
        assert.deepEqual(texts, []);
        assert.match(await page.innerText("#found"), /^Nothing has this/);
    } else {
        const at = texts.findIndex((text) => text.includes(expected));
        assert.ok(at >= 0, `'${words}' finds ${texts.join(", ")}`);
        assert.ok(texts[0].includes(foremost[words] ?? ""), `'${words}' finds first ${texts[0]}`);
        const target = await results.nth(at).locator("a").evaluate((link) => link.href);
        for (let step = 0; step <= at; ++step) {
            await page.keyboard.press("ArrowDown");
        }
        await page.keyboard.press("Enter");
        await page.waitForURL((url) => url.href === target);
    }
    await page.close();
}

/// The results have the colours of the page, on the first page and on others; Escape closes them, "/" leads to the search.
async function lookAtResults(browser) {
    for (const [name, size, scheme] of [["index", "desktop", "light"], ["drives_atv320", "phone", "dark"]]) {
        const context = await browser.newContext({viewport: sizes[size], colorScheme: scheme, reducedMotion: "reduce"});
        const page = await context.newPage();
        await page.goto(address(name), {waitUntil: "load"});
        await page.keyboard.press("/");
        await page.keyboard.type("time-out");
        await page.locator("#found li").first().waitFor();
        await page.screenshot({path: path.join(screens, `search-${size}-${scheme}.png`)});
        await page.addScriptTag({content: axe});
        assert.deepEqual(await page.evaluate(async () => (await axe.run(document, {preload: false})).violations.map(({id}) => id)), []);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth));
        await page.keyboard.press("Escape");
        assert.ok(await page.isHidden("#found"));
        await context.close();
    }
}

/// The registers of a drive: limits are seen at once, the first column stays, rows are found and sorted.
async function useTable(browser, size, scheme) {
    const context = await browser.newContext({viewport: sizes[size], colorScheme: scheme});
    const page = await context.newPage();
    page.setDefaultTimeout(limit);
    await page.goto(`${address("drives_atv320")}#drives_atv320-registers`, {waitUntil: "load"});
    const frame = page.locator(".wide.long").first(), where = `on a ${size} in ${scheme}`;
    const cells = (at) => frame.locator(`tbody tr:not([hidden]) td:nth-child(${at})`).allInnerTexts();
    await page.screenshot({path: path.join(screens, `registers-${size}-${scheme}.png`)});
    const right = await frame.evaluate((element) => element.getBoundingClientRect().left + element.clientWidth);
    const seen = await frame.locator("th").evaluateAll((heads, edge) => heads.filter((head) => head.getBoundingClientRect().right <= edge).map(
        (head) => head.textContent), right);
    const least = size === "desktop" ? ["register", "address", "name", "lowest", "highest"] : ["register", "address", "name"];
    assert.deepEqual(seen.slice(0, least.length), least, where);
    await frame.evaluate((element) => element.scrollTo(10_000, 2000));
    const places = await frame.evaluate((element) => {
        const box = element.getBoundingClientRect();
        const row = [...element.querySelectorAll("tr")].find((each) => each.getBoundingClientRect().top > box.top + 60);
        return {first: row.cells[0].getBoundingClientRect().left - box.left, head: element.querySelector("th").getBoundingClientRect().top - box.top};
    });
    assert.ok(Math.abs(places.first) < 3 && Math.abs(places.head) < 3, `${where}: ${JSON.stringify(places)}`);
    await page.screenshot({path: path.join(screens, `registers-scrolled-${size}-${scheme}.png`)});
    const filter = page.locator(".filter input").first(), count = page.locator(".filter [role=status]").first();
    const whole = await count.innerText();
    await filter.fill("motor current");
    const left = await cells(3);
    assert.ok(left.length > 0 && left.length < 200, `${where}: ${left.length} rows`);
    assert.match(await count.innerText(), new RegExp(`^${left.length} of `));
    await filter.fill("");
    assert.equal(await count.innerText(), whole);
    await frame.evaluate((element) => element.scrollTo(0, 0));
    await frame.getByRole("button", {name: "address"}).click();
    await frame.getByRole("button", {name: "address"}).click();
    const addresses = (await cells(2)).map(Number);
    assert.deepEqual(addresses, [...addresses].sort((one, other) => other - one), where);
    assert.equal(await frame.locator("th").nth(1).getAttribute("aria-sort"), "descending");
    await frame.getByRole("button", {name: "register"}).click();
    const names = await cells(1);
    assert.ok(names[0].startsWith("A") && names.at(-1) > "V", `${where}: ${names[0]} ${names.at(-1)}`);
    await context.close();
}

/// What the first page loads before anything runs, that nothing on it moves, and that the playground runs in it: at once, or after a
/// click where motion is unwanted.
async function openFirst(browser, size, scheme, reducedMotion) {
    const context = await browser.newContext({viewport: sizes[size], colorScheme: scheme, reducedMotion});
    const page = await context.newPage();
    page.setDefaultTimeout(limit);
    const files = new Set();
    page.on("request", (request) => files.add(request.url()));
    await page.addInitScript(() => {
        window.shifts = 0;
        new PerformanceObserver((list) => { window.shifts += list.getEntries().reduce((sum, each) => sum + each.value, 0); }).observe({type: "layout-shift", buffered: true});
    });
    await page.goto(address("index"), {waitUntil: "load"});
    const before = [...files].filter((file) => !file.includes("/playground/"));
    const bytes = before.reduce((sum, file) => sum + fs.statSync(new URL(file)).size, 0);
    assert.ok(before.length >= 4 && bytes < mostBytes, `the first page loads ${bytes} bytes: ${before.join(", ")}`);
    if (reducedMotion === "reduce") {
        assert.equal(await page.locator("iframe").count(), 0, "it runs where motion is unwanted");
        await page.click("#run");
    }
    const frame = page.frameLocator("iframe");
    await frame.locator("#p-motor:text-is('turns forward')").waitFor();
    assert.equal(await page.evaluate(() => window.shifts), 0, "something moves on the first page");
    await page.screenshot({path: path.join(screens, `first-${size}-${scheme}.png`), fullPage: true});
    await context.close();
    return bytes;
}

/// The switch turns a page dark, and the next page keeps it.
async function toggle(browser) {
    const context = await browser.newContext({viewport: sizes.desktop, colorScheme: "light"});
    const page = await context.newPage();
    page.setDefaultTimeout(limit);
    await page.goto(address("index"), {waitUntil: "load"});
    await page.click("#theme");
    assert.ok((await page.evaluate(measured)).ground < 0.2, "the switch does not make the page dark");
    await page.goto(address("figures"), {waitUntil: "load"});
    assert.ok((await page.evaluate(measured)).ground < 0.2, "the next page is light again");
    await context.close();
}

/// Does all of `jobs`, a few at a time: a page spends most of its time on waiting.
async function allOf(jobs) {
    const lane = async () => {
        for (let job = jobs.shift(); job !== undefined; job = jobs.shift()) {
            await job();
        }
    };
    await Promise.all(Array.from({length: lanes}, lane));
}

fs.mkdirSync(screens, {recursive: true});
assert.ok(guides.length >= 40, `the site has only ${guides.length} guides`);
const browser = await chromium.launch({executablePath: "/usr/bin/chromium", args: flags});
try {
    const views = Object.keys(sizes).flatMap((size) => ["light", "dark"].flatMap((scheme) => shown.map(
        (name) => () => visit(browser, name, scheme, size, true))));
    const phones = guides.filter((guide) => !shown.includes(guide)).map((name) => () => visit(browser, name, "dark", "phone", false));
    const searches = Object.entries(wanted).map(([words, expected]) => () => search(browser, words, expected));
    const pages = views.length + phones.length;
    const each = (act) => ["desktop", "phone"].flatMap((size) => ["light", "dark"].map((scheme) => () => act(size, scheme)));
    const firsts = [];
    await allOf([...views, ...phones, ...searches, () => toggle(browser), () => lookAtResults(browser), ...each((size, scheme) => useTable(browser, size, scheme)),
        ...each(async (size, scheme) => firsts.push(await openFirst(browser, size, scheme, scheme === "dark" ? "reduce" : "no-preference")))]);
    console.log(`${pages} pages looked at, ${searches.length} searches, the first page loads ${firsts[0]} bytes, screens in ${screens}`);
} finally {
    await browser.close();
}

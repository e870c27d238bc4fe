// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The page: what a person asks for goes to the worker, and what it tells is shown. `rows` has the register files and the errors,
// `workerText` the worker.
"use strict";

/// What the manuals say each drive does once nobody asks it any more: docs/what-stops-my-motor.md.
const whenAskedNoMore = {
  atv12: "after TTO (10.0 s as delivered) it trips with SLF1 and its motor coasts; with SLL = 0 it goes on turning",
  atv28: "after 7 s it trips with SLF; with CMI bit 14 = 1 it goes on turning",
  atv310: "after parameter 704 (10.0 s as delivered) it trips and its motor coasts; with parameter 611 = 00 it goes on turning",
  atv310_2026: "after parameter 704 (10.0 s as delivered) it trips and its motor coasts; with parameter 611 = 00 it goes on turning",
  atv320: "after TTO (10.0 s as delivered) it trips with SLF1 and stops as SLL says, as delivered by coasting; with SLL = 0 it goes on turning",
};

/// Where the library's remedy speaks to a program.
const remedies = {
  0x97: "Check power, address, bit rate, format and the wires A and B. This page waits a second.",
  0x95: "The adapter hears itself. From here on the echo is taken out: ask again.",
};
const whenNobodyAnswers = "Look at the unit's power and address, exchange A and B, find rate and format, or scan more addresses. An adapter whose direction is switched by RTS needs a driver that does it.";
/// Bytes came, and none was a response to the request.
function whyNotTaken(unit, bytes) {
  const first = parseInt(bytes, 16);
  return first === unit ? "It begins as its response does, and is late or not whole" : `These bytes begin with address ${first}, as if another unit had answered`;
}
const phaseTexts = {
  listening: "listening", quiet: "nobody else talks: ready", others: "others talk: only listening", noise: "bytes that are no frames: only listening",
};

/// The worker as functions that answer.
class LineWorker {
  constructor(told) {
    const place = URL.createObjectURL(new Blob([workerText], { type: "text/javascript" }));
    this.worker = new Worker(place);
    this.told = told;
    this.asked = new Map();
    this.number = 0;
    this.worker.onmessage = ({ data }) => this.take(data);
    this.worker.onerror = (problem) => told({ trap: problem.message });
  }

  ask(act, what = {}) {
    return new Promise((resolve, reject) => {
      this.asked.set(++this.number, { resolve, reject });
      this.worker.postMessage({ number: this.number, act, ...what });
    });
  }
  act(name, ...args) { return this.ask("act", { name, args }).catch((problem) => this.told({ trap: problem.message })); }
  get(name, ...args) { return this.ask("get", { name, args }); }

  take(data) {
    if (data.relay) return this.relay(data);
    if (!data.number) return this.told(data);
    const { resolve, reject } = this.asked.get(data.number);
    this.asked.delete(data.number);
    if (data.problem === undefined) return resolve(data.result);
    return reject(Object.assign(new Error(data.problem), { name: data.kind }));
  }

  /// The port that this page opened, for a worker that has none.
  async relay({ relay, number, baud, format, bytes }) {
    const pass = (what) => (value) => this.worker.postMessage({ relayed: what, value });
    try {
      if (relay === "open") {
        this.end = new SerialEnd(this.port);
        await this.end.open(baud, format, { bytes: pass("bytes"), damage: pass("damage"), lost: pass("lost") });
      }
      if (relay === "write") await this.end.write(bytes);
      if (relay === "close") await this.end?.close();
      this.worker.postMessage({ answered: number });
    } catch (problem) {
      this.worker.postMessage({ answered: number, problem: problem.message });
    }
  }
}

class ValuesView {
  constructor() { this.clear(); }

  clear() {
    this.rows = new Map();
    this.kept = [];
    this.body = byId("values").tBodies[0];
    this.body.replaceChildren();
    byId("csv").disabled = true;
    this.draw();
  }

  note(unit, values, at) {
    const most = 200000, now = new Date().toISOString();
    for (const each of values) {
      const key = `${unit}/${each.name}`;
      if (!this.rows.has(key)) this.add(key, unit, each);
      const row = this.rows.get(key);
      row.text = each.text;
      if (each.number !== undefined) row.series.push([at, Number(each.number)]);
      if (row.series.length > 2000) row.series.splice(0, 200);
      if (this.kept.length < most) this.kept.push([now, unit, each.name, each.number ?? "", each.text, each.unit]);
    }
    this.timer ??= setTimeout(() => this.show(most), 200);
  }

  show(most) {
    this.timer = undefined;
    for (const row of this.rows.values()) if (row.cell.textContent !== row.text) row.cell.textContent = row.text;
    this.draw();
    setText("values-note", this.kept.length < most ? `${this.kept.length} values kept for CSV` : `${most} values kept for CSV: save them, later ones are not kept`);
    byId("csv").disabled = this.kept.length === 0;
  }

  add(key, unit, each) {
    const box = make("input", { type: "checkbox", "aria-label": `plot ${each.name}` });
    const isAmount = each.unit !== "" || each.text === String(each.number);
    box.checked = isAmount && [...this.rows.values()].filter((row) => row.box.checked).length < 3;
    box.addEventListener("change", () => this.draw());
    const cell = make("td", { class: "mono" }, each.text);
    this.body.append(make("tr", {}, make("td", {}, box), make("td", {}, `${each.name} (unit ${unit})`), cell));
    this.rows.set(key, { box, cell, series: [] });
  }

  /// Each curve between its own least and greatest value.
  draw() {
    const { context, width, height } = sheet("plot");
    const span = 120000, drawn = [...this.rows].filter(([, row]) => row.box.checked && row.series.length > 1).slice(0, 4);
    drawn.forEach(([key, row], at) => {
      const end = row.series.at(-1)[0], seen = row.series.filter(([time]) => time > end - span);
      const numbers = seen.map(([, number]) => number), low = Math.min(...numbers), high = Math.max(...numbers);
      const ink = colour(["--k1", "--k2", "--k3", "--go"][at]), top = 12 + 16 * drawn.length, room = height - top - 6;
      context.fillStyle = context.strokeStyle = ink;
      context.fillText(`${key.split("/")[1]}: ${low} to ${high}`, 6, 14 + 16 * at);
      context.beginPath();
      seen.forEach(([time, number], place) => {
        const x = width - (end - time) / span * width, y = top + room - (high > low ? (number - low) / (high - low) : 0.5) * room;
        if (place === 0) context.moveTo(x, y); else context.lineTo(x, y);
      });
      context.lineWidth = 2;
      context.stroke();
    });
  }

  csv() {
    const quoted = (field) => /[",\r\n]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field;
    // A text of a unit is no formula of a spreadsheet.
    const tame = (field) => /^([=+@\t]|-(?![\d.]))/.test(field) ? "'" + field : field;
    const line = (fields) => fields.map((field) => quoted(tame(String(field)))).join(",") + "\r\n";
    return line(["time", "unit", "name", "number", "value", "measure"]) + this.kept.map(line).join("");
  }
}

class LinePage {
  constructor() {
    this.line = new LineWorker((what) => this.take(what));
    this.values = new ValuesView();
    this.state = { isOpen: false, phase: "off", job: "" };
    this.units = new Map();
    this.failures = new Map();
    this.fill();
    this.listenToPerson();
  }

  async start() {
    await this.line.ask("start", { moduleText });
    byId("no-serial").hidden = Boolean(navigator.serial);
    if (!navigator.serial) byId("kind").value = "simulated";
    navigator.serial?.addEventListener("connect", (event) => this.comeBack(event.target));
    this.show();
  }

  fill() {
    const options = (id, texts) => byId(id).replaceChildren(...texts.map((each) => make("option", { value: each }, each)));
    options("baud", [1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200]);
    byId("baud").value = "19200";
    options("format", formatNames);
    this.devices = Object.entries(rows.files).map(([name, text]) => readRegisterFile(name, text));
    this.showDevices("");
  }

  showDevices(chosen) {
    byId("device").replaceChildren(make("option", { value: "" }, "what it says it is"), ...this.devices.map((each) => make("option", { value: each.name }, each.name)));
    byId("device").value = chosen;
  }
  get device() { return this.devices.find((each) => each.name === byId("device").value); }

  /// A register file of one's own. One of the same name takes the place of the one before; one with a flaw, of none.
  async openFile() {
    const [file] = byId("file").files;
    if (!file) return;
    byId("file").value = ""; // the same one may be opened again, mended
    try {
      if (file.size > 1e6) throw new Error("it is larger than a megabyte");
      const read = readRegisterFile(file.name, await file.text());
      this.devices = [...this.devices.filter(({ name }) => name !== read.name), read];
      this.showDevices(read.name);
      const left = read.leftOut.length ? ` This page does not read, and left out: ${read.leftOut.join(", ")}. The tool reads them.` : "";
      setText("file-note", `${read.name}: ${read.points.length} ${read.points.length === 1 ? "name" : "names"}.${left}`);
    } catch (problem) {
      setText("file-note", `${file.name} was not taken: ${problem.message}.`);
    }
    this.showNames();
  }

  tell(text) {
    const log = byId("told");
    log.append(make("p", {}, text));
    while (log.children.length > 200) log.firstChild.remove();
    log.scrollTop = log.scrollHeight;
  }

  show() {
    const { isOpen, phase, job } = this.state, isReady = isOpen && phase === "quiet" && !job;
    for (const id of ["connect", "kind"]) byId(id).disabled = isOpen || this.isOpening;
    byId("disconnect").disabled = byId("listen").disabled = !isOpen;
    byId("find").disabled = !isOpen || Boolean(job) || phase === "listening" || byId("kind").value === "simulated";
    for (const id of ["scan", "identify", "read", "watch"]) byId(id).disabled = !isReady;
    for (const id of ["stop", "stop-watch"]) byId(id).disabled = !job;
    byId("backup").disabled = !isReady || !this.units.get(Number(byId("unit").value))?.drive;
    byId("phase").className = "phase " + phase;
    setText("phase", job && phase === "quiet" ? jobTexts[job] : phaseTexts[phase] ?? { off: "not connected", lost: "the adapter is gone" }[phase]);
  }

  listenToPerson() {
    const on = (id, act) => byId(id).addEventListener("click", act);
    on("connect", () => this.connect());
    on("disconnect", () => this.line.ask("disconnect"));
    on("listen", () => this.line.act("listen"));
    on("find", () => this.find());
    on("scan", () => this.scan());
    for (const id of ["stop", "stop-watch"]) on(id, () => this.line.ask("stop"));
    on("identify", () => this.withUnit((unit) => this.line.act("identify", unit)));
    on("read", () => this.read(0));
    on("watch", () => this.read(Number(byId("period").value)));
    on("agree", () => this.agree());
    on("csv", () => save("values.csv", this.values.csv(), "text/csv"));
    on("capture", async () => save("line.pcapng", await this.line.get("capture"), "application/octet-stream"));
    on("backup", () => this.withUnit((unit) => this.line.act("backUp", unit, localTime())));
    byId("device").addEventListener("change", () => this.showNames());
    byId("file").addEventListener("change", () => this.openFile());
    byId("unit").addEventListener("input", () => { this.showNames(); this.show(); });
    byId("bytes").addEventListener("input", () => this.decode());
    addEventListener("beforeunload", (event) => { if (this.state.job === "watch" && this.polledDrive) event.preventDefault(); });
    addEventListener("resize", () => this.values.draw());
  }

  async connect() {
    const kind = byId("kind").value;
    this.isOpening = true;
    this.show();
    try {
      if (kind === "serial") this.line.port = await navigator.serial.requestPort();
      await this.open(kind);
    } catch (problem) {
      const words = { NotFoundError: "No adapter was chosen. Nothing was opened.", SecurityError: "This browser, or its owner's policy, does not allow serial ports here.",
        TypeError: "This browser has no Web Serial: Chrome and Edge have it, on a computer." };
      const text = words[problem.name] ?? `The port does not open: ${problem.message}. Does another program use it? On Linux: is your user in the group dialout?`;
      setText("line-note", text);
      this.tell(text);
    } finally {
      this.isOpening = false;
      this.show();
    }
  }

  async open(kind) {
    const count = kind === "serial" ? (await navigator.serial.getPorts()).length : 0;
    await this.line.ask("connect", { kind, count, baud: Number(byId("baud").value), format: byId("format").value });
  }

  /// An adapter that is back is opened, and listened to; what was asked before is not asked by itself.
  async comeBack(port) {
    if (this.state.phase !== "lost") return;
    this.line.port = port;
    try {
      await this.open("serial");
      this.tell("The adapter is back. It listens first; nothing is read until you ask for it.");
    } catch (problem) {
      this.tell(`The adapter is back and does not open: ${problem.message}`);
    }
  }

  find() {
    const isHeard = this.state.phase !== "quiet";
    this.state.job = "find";
    this.tell(isHeard ? "Listens at one usual setting after the other, and sends nothing." : "Asks addresses 1 to 10 at one usual setting after the other: where nobody answers, for two minutes.");
    this.line.ask("find", { isHeard });
    this.show();
  }

  scan() {
    const [first, last] = ["first", "last"].map((id) => Number(byId(id).value));
    const isRange = Number.isInteger(first) && Number.isInteger(last) && first >= 1 && first <= last && last <= 247;
    if (!isRange) return this.tell("Addresses are whole numbers of 1 to 247, the lower one first.");
    this.line.act("setTimeout", 300);
    this.line.act("scan", first, last);
  }

  withUnit(act) {
    const unit = Number(byId("unit").value);
    if (!Number.isInteger(unit) || unit < 1 || unit > 247) return this.tell("A unit is a whole number of 1 to 247.");
    this.line.act("setTimeout", 1000);
    return act(unit);
  }

  /// The drive whose values are being read; undefined where it is none.
  get polledDrive() {
    const unit = this.polled && this.units.get(this.polled);
    return unit?.mayBeDrive ? unit : undefined;
  }
  tellNotAsked() {
    const drive = this.polledDrive;
    if (drive) this.tell(`Unit ${drive.unit} is not asked any more: ${whenAskedNoMore[drive.drive] ?? "its own time-out counts from its last request"}.`);
  }

  namesOf(unit) {
    return this.device?.points ?? this.units.get(unit)?.registers ?? [];
  }

  async showNames() {
    const unit = Number(byId("unit").value), known = this.units.get(unit);
    if (known?.drive && !known.registers) known.registers = (await this.line.get("registers", unit)).map((each) => [each.name, "", "", each.unit, each.text, each.driving]);
    byId("names").replaceChildren(...this.namesOf(unit).map((each) => make("option", { value: each[0] }, !this.device && known?.registers ? each[4] : each[1])));
  }

  /// What was typed, as the module takes it: a line for each.
  pointLines(unit) {
    const names = this.namesOf(unit), isDevice = Boolean(this.device);
    const words = byId("points").value.split(",").map((each) => each.trim()).filter(Boolean);
    const line = (row) => isDevice ? row.slice(0, 6).join("\t") : row[0];
    return words.flatMap((word) => {
      if (word === "*") return names.filter((row) => isDevice || row[5]).map(line);
      const row = names.find((each) => each[0].toLowerCase() === word.toLowerCase());
      return [row ? line(row) : placeWord(word)];
    }).join("\n");
  }

  read(period) {
    this.withUnit(async (unit) => {
      const lines = this.pointLines(unit);
      const flaw = lines === "" ? "Type which values: a name, or a place such as input:1000:f32."
        : lines.length > 60000 ? "These are too many at once: name fewer than all." : await this.line.act("watch", unit, lines, period, this.device?.most ?? 0);
      setText("points-flaw", flaw);
      this.asked = { unit, period };
      this.polled = unit;
    });
  }

  async agree() {
    byId("consent").hidden = true;
    await this.line.act("consent", this.asked.unit);
    this.tell(`Unit ${this.asked.unit} may be polled until the line is closed.`);
    if (this.askedBackup) this.withUnit((unit) => this.line.act("backUp", unit, localTime()));
    else this.read(this.asked.period);
  }

  async decode() {
    const text = byId("bytes").value;
    const found = unreadable(text) ? { size: 0, flaw: unreadable(text), kind: "", offer: "", frames: [] } : await this.line.get("decode", text, 4);
    if (text !== byId("bytes").value) return;
    const [kind, words] = judged(found, text);
    byId("judged").className = "judged " + kind;
    byId("judged").textContent = words;
    byId("typed").replaceChildren(...(found.size ? found.frames.flatMap(fieldsOf) : []));
  }

  // What the worker tells.

  take(what) {
    if (what.trap) return this.trapped(what.trap);
    if (what.port) this.notePort(what);
    if (what.setting) this.noteSetting(what.setting);
    if ("found" in what) this.noteFound(what);
    for (const event of what.events ?? []) this["on_" + event.event]?.(event);
    if (what.frames?.length) this.noteFrames(what.frames);
    this.show();
  }

  trapped(problem) {
    this.line.worker.terminate();
    this.state = { isOpen: false, phase: "off", job: "" };
    document.body.prepend(make("p", { class: "trap", role: "alert" }, `The module stopped: ${problem}. Nothing more is sent. Reload the page.`));
  }

  notePort({ port, why, baud, format }) {
    this.state.isOpen = port === "open";
    this.state.job = "";
    if (port === "open") {
      this.state.phase = "listening";
      this.units.clear();
      this.values.clear();
      byId("units").tBodies[0].replaceChildren();
      this.freshFrames = [];
      byId("frames").tBodies[0].replaceChildren();
      byId("capture").disabled = false;
      this.tell(`Open at ${baud} ${format}: it listens.`);
    } else {
      this.state.phase = port === "lost" ? "lost" : "off";
      byId("consent").hidden = true;
      this.tell(port === "lost" ? `The adapter is gone: ${why}. Nothing is sent. Plug it in again: it is opened by itself.` : "Closed. Nothing is sent any more.");
      this.tellNotAsked();
    }
  }

  noteSetting({ baud, format }) {
    byId("baud").value = String(baud);
    byId("format").value = format;
    setText("line-note", `Tries ${baud} ${format}.`);
  }

  noteFound({ found, wasStopped, isHeard, refused }) {
    this.state.job = "";
    const nobody = isHeard ? "No whole frame at any usual setting. Is it Modbus RTU?" : "Nobody answers at any usual setting, at addresses 1 to 10. Exchange A and B, look at the power, and scan the other addresses.";
    if (refused.length) this.tell(`The adapter does not open at ${refused.join(", ")}: these were left out.`);
    const text = found ? `Found: ${found.baud} ${found.format}${found.format === "8N2" ? " (8N2 does for 8N1 as well)" : ""}.` : wasStopped ? "The search was stopped." : nobody;
    setText("line-note", text);
    this.tell(text);
  }

  on_phase({ phase, bytes, frames }) {
    this.state.phase = phase;
    const texts = {
      listening: "Listening…",
      quiet: bytes ? `Ready: ${bytes} stray bytes were heard, and no more.` : "Ready: a second was silent.",
      others: `Another client is on the line: ${frames} frames were heard. Two clients at once spoil both: nothing is sent. Its frames are shown below.`,
      noise: `${bytes} bytes came that are no frames: another bit rate or format, or noise. Nothing is sent. Find rate and format listens for it.`,
    };
    setText("line-note", texts[phase]);
    if (phase !== "listening") this.tell(texts[phase]);
  }

  on_begin({ job }) {
    byId("consent").hidden = true;
    if (this.state.job !== "find") this.state.job = job;
  }

  on_end({ job, how }) {
    if (this.state.job !== "find") this.state.job = "";
    byId("progress").value = 0;
    if (how !== "done") this.tell(`${job}: ${how}.`);
    if (job === "scan" && how === "done" && this.state.job !== "find") {
      this.tell(this.units.size ? `Scanned: ${this.units.size} ${this.units.size === 1 ? "unit is" : "units are"} known.` : "Scanned: nobody answers. " + whenNobodyAnswers);
    }
    if (job === "watch" && how !== "done") this.tellNotAsked();
  }

  on_progress({ done, of }) { byId("progress").value = of ? done / of : 0; }

  on_unit(event) {
    const isNew = !this.units.has(event.unit);
    this.units.set(event.unit, event);
    const who = [event.vendor, event.product].filter(Boolean).join(" ") || event.note;
    const choose = make("button", { type: "button" }, `${event.unit}`);
    choose.addEventListener("click", () => { byId("unit").value = String(event.unit); this.showNames(); this.show(); });
    const row = make("tr", { "data-unit": event.unit }, make("td", {}, choose),
      make("td", {}, who + (event.drive ? `; its table is ${event.drive}` : event.mayBeDrive ? "; it may be a drive" : "")), make("td", {}, event.revision));
    const body = byId("units").tBodies[0];
    body.querySelector(`[data-unit="${event.unit}"]`)?.remove();
    body.append(row);
    if (isNew) this.tell(`Unit ${event.unit} answers: ${who}.`);
    this.showNames();
  }

  on_values({ unit, values, time }) {
    this.values.note(unit, values.map((each) => (each.wide ? { ...each, ...wideValue(each) } : each)), time / 1000);
  }

  on_consent({ unit, drive }) {
    this.askedBackup = this.state.job === "backup";
    this.asked ??= { unit, period: 0 };
    this.asked.unit = unit;
    const what = whenAskedNoMore[drive] ?? "what it does after its own time-out, its manual says";
    setText("consent-text", `Unit ${unit} is a drive, or may be one. Polling feeds its time-out as a controller's requests do: while this page reads, a motor whose controller has failed is kept running. ` +
      `When this tab is closed, frozen, or the computer sleeps, nobody asks any more: ${what}. Do not poll a drive that another client runs.`);
    byId("consent").hidden = false;
    byId("agree").focus();
  }

  on_nothing({ unit }) { this.tell(`Unit ${unit} is no drive of which this page knows the settings: read its values by name and save them as CSV.`); }

  async on_backup({ unit, rows: count, refused }) {
    save(`unit-${unit}.json`, await this.line.get("file"), "application/json");
    this.tell(`Backup of unit ${unit}: ${count} settings, ${refused} refused by the drive. rtuwire restore reads the file.`);
  }

  on_slowed({ milliseconds }) {
    this.tell(`The browser held this page up for ${(milliseconds / 1000).toFixed(1)} s, or the computer slept: nothing was asked meanwhile.`);
  }

  on_held({ unit, milliseconds }) {
    setText("values-note", `Unit ${unit} may still answer a request before: so that its answer is not taken for another, it is asked in ${(milliseconds / 1000).toFixed(1)} s.`);
  }

  on_full() { this.tell("The capture is full, at 16 MB: save it. Later frames are shown, and are not in it; connect again for a new one."); }

  on_failure({ unit, what, error, name, bytes, cause }) {
    const key = [unit, what, error, bytes].join("|"), known = this.failures.get(key);
    const list = byId("failures");
    if (this.failures.size === 0) list.replaceChildren();
    const count = (known?.count ?? 0) + 1;
    const [meaning, remedy] = rows.errors[error] ?? ["", ""];
    const why = cause ? cause.replace(": --noise", "; the tool's --noise") : error === 0x97 && bytes ? whyNotTaken(unit, bytes) : "";
    const item = make("li", {}, make("b", {}, `Unit ${unit}, ${what}: ${name}`), count > 1 ? ` (${count} times)` : "", make("br"),
      ...(bytes ? [make("span", { class: "mono" }, `bytes: ${bytes}`), make("br")] : []), why ? `${why}. ` : `${meaning} `, remedies[error] ?? remedy);
    known?.item.remove();
    this.failures.delete(key); // the latest stand last
    this.failures.set(key, { count, item });
    list.prepend(item);
    for (const [oldest, { item: last }] of this.failures) {
      if (this.failures.size <= 60) break;
      last.remove();
      this.failures.delete(oldest);
    }
  }

  /// Laying the table out takes longer than the line does: twice a second is enough.
  noteFrames(frames) {
    this.freshFrames = [...this.freshFrames ?? [], ...frames].slice(-150);
    this.framesTimer ??= setTimeout(() => {
      this.framesTimer = undefined;
      this.showFrames(this.freshFrames.splice(0));
    }, 500);
  }

  showFrames(frames) {
    if (frames.length === 0) return;
    const body = byId("frames").tBodies[0], names = { client: "we", drive: "unit", you: "others" };
    for (const frame of frames.slice(-150)) {
      const choose = make("button", { type: "button" }, frame.summary);
      const row = make("tr", { class: frame.unanswered ? "none" : frame.exception || frame.damaged ? "bad" : "", "data-number": frame.number },
        make("td", { class: "t mono" }, seconds(frame.end)), make("td", { class: "from " + names[frame.from] }, frame.unanswered ? "" : names[frame.from]),
        make("td", { class: "hex" }, frame.hex), make("td", {}, choose));
      choose.addEventListener("click", () => this.choose(frame.number, row));
      body.prepend(row);
    }
    for (let at = body.rows.length - 1; at > 0 && body.rows.length > 150; --at) {
      if (!body.rows[at].contains(document.activeElement)) body.rows[at].remove();
    }
    setText("frame-count", `${frames.at(-1).number + 1} frames`);
  }

  async choose(number, row) {
    for (const each of byId("frames").querySelectorAll(".chosen")) each.classList.remove("chosen");
    row.classList.add("chosen");
    const { frames } = await this.line.get("explain", number);
    byId("detail").replaceChildren(...(frames.length ? frames.flatMap(fieldsOf) : [make("p", { class: "quiet" }, "It is too old: its fields are not kept.")]));
  }
}

const jobTexts = { scan: "scanning", identify: "asking who it is", watch: "reading", backup: "reading all settings", find: "finding rate and format" };

function save(name, content, type) {
  const link = make("a", { download: name, href: URL.createObjectURL(new Blob([content], { type })) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

/// As the command line tool writes it: with the offset of this place.
function localTime() {
  const now = new Date(), offset = -now.getTimezoneOffset(), two = (number) => String(Math.trunc(Math.abs(number))).padStart(2, "0");
  const local = new Date(now.getTime() + offset * 60000).toISOString().slice(0, 19);
  return `${local}${offset < 0 ? "-" : "+"}${two(offset / 60)}${two(offset % 60)}`;
}

requestAnimationFrame(() => setTimeout(async () => {
  try {
    const page = new LinePage();
    await page.start();
    document.documentElement.dataset.ready = "yes";
  } catch (problem) {
    document.body.prepend(make("p", { class: "trap", role: "alert" }, `The page does not start here: ${problem.message}`));
  }
}));

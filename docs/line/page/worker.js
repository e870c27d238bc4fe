// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The line, beside the page: a hidden page's own timers are slowed, a worker's are not. It carries bytes between a port and the
// module, and decides nothing; every frame that leaves is the module's.
"use strict";

/// The usual settings, the most frequent ones first; 8N2 does for 8N1 as well.
const usualSettings = [[19200, "8E1"], [9600, "8N2"], [9600, "8E1"], [19200, "8N2"], [38400, "8N2"], [115200, "8N2"], [38400, "8E1"], [57600, "8N2"],
  [4800, "8N2"], [115200, "8E1"], [57600, "8E1"], [4800, "8E1"], [2400, "8N2"], [2400, "8E1"], [9600, "8O1"], [19200, "8O1"], [38400, "8O1"],
  [115200, "8O1"], [57600, "8O1"], [1200, "8N2"], [1200, "8E1"], [4800, "8O1"], [2400, "8O1"], [1200, "8O1"]];

/// Milliseconds that go on while the computer sleeps, as those of `performance` do not on every system. A calendar that is set
/// forward counts as sleep, too: nobody can tell them apart.
class LineClock {
  constructor(own = () => performance.now(), calendar = () => Date.now()) {
    this.own = own;
    this.calendar = calendar;
    this.slept = 0;
    this.apart = calendar() - own();
  }

  now() {
    const own = this.own(), apart = this.calendar() - own, more = apart - this.apart;
    this.apart = apart;
    if (more > 1000) this.slept += more;
    return own + this.slept;
  }
}

class LineLoop {
  constructor(engine, post, clock = new LineClock()) {
    this.engine = engine;
    this.post = post;
    this.clock = clock;
    this.portWork = Promise.resolve();
    this.nextFrame = 0;
    this.untold = [];
    this.toldAt = 0;
    this.watchers = new Set();
  }

  /// A port is opened and closed by one at a time.
  exclusively(act) {
    const done = this.portWork.then(act);
    this.portWork = done.catch(() => {});
    return done;
  }

  connect(end, baud, format) {
    return this.exclusively(async () => {
      await this.shut();
      await end.open(baud, format, this.tells());
      this.end = end;
      this.setting = { baud, format };
      this.engine.open(baud, format, this.clock.now());
      this.nextFrame = 0;
      this.post({ port: "open", baud, format });
      this.pass();
    });
  }

  tells() {
    return {
      bytes: (bytes) => this.arrive(() => this.engine.receive(bytes, this.clock.now())),
      damage: () => this.arrive(() => this.engine.receiveError(this.clock.now())),
      lost: (why) => this.lose(why),
    };
  }

  arrive(take) {
    if (!this.end) return;
    this.guard(() => {
      this.noteSent();
      take();
    });
    this.pass();
  }

  /// A module that stopped does nothing more: nor does its port.
  guard(act) {
    try {
      act();
    } catch (problem) {
      const end = this.end;
      this.end = null;
      end?.close();
      this.post({ trap: problem.message });
    }
  }

  /// A response may come before the port has said that the request left.
  noteSent() {
    if (!this.isLeaving) return;
    this.isLeaving = false;
    this.engine.sent(this.clock.now());
  }

  /// What goes on ends, and is told.
  endAll() {
    const end = this.end;
    this.end = null;
    this.isFinding = false;
    clearTimeout(this.timer);
    this.engine.stop();
    this.deliver();
    this.tellPage();
    for (const watcher of [...this.watchers]) watcher(null);
    return end;
  }

  lose(why) {
    if (!this.end) return undefined;
    const end = this.endAll();
    return this.exclusively(async () => {
      await end.close();
      this.post({ port: "lost", why });
    });
  }

  disconnect() {
    this.isFinding = false;
    return this.exclusively(() => this.shut());
  }
  async shut() {
    if (!this.end) return;
    await this.endAll().close();
    this.post({ port: "closed" });
  }

  pass() {
    clearTimeout(this.timer);
    if (!this.end) return;
    this.guard(() => {
      // What is due at once is done at once: a timer in a chain of timers takes 4 ms.
      for (let turn = 0; turn < 4 && (turn === 0 || this.engine.timeLeft() === 0); ++turn) {
        const frame = this.engine.pass(this.clock.now());
        if (frame.length > 0) this.send(frame);
      }
      this.deliver();
      this.timer = setTimeout(() => this.pass(), this.engine.timeLeft());
    });
  }

  async send(frame) {
    this.isLeaving = true;
    const { end } = this;
    try {
      await end.write(frame);
    } catch (problem) {
      if (this.end === end) this.lose(problem.message);
      return;
    }
    this.guard(() => this.noteSent());
    this.pass();
  }

  /// What there is to tell goes to the page in pieces of a tenth of a second: it has more to do with each than the line.
  deliver() {
    const events = this.engine.events();
    this.untold.push(...events);
    for (const event of events) for (const watcher of [...this.watchers]) watcher(event);
    if (this.clock.now() - this.toldAt >= 100) this.tellPage();
    else this.tellingTimer ??= setTimeout(() => this.tellPage(), 100);
  }

  tellPage() {
    clearTimeout(this.tellingTimer);
    this.tellingTimer = undefined;
    this.toldAt = this.clock.now();
    const events = this.untold.splice(0), frames = this.engine.frames(this.nextFrame);
    if (frames.length > 0) this.nextFrame = frames.at(-1).number + 1;
    if (events.length + frames.length > 0) this.post({ events, frames });
  }

  /// Waits until an event passes a test; null where the port was closed before.
  until(test) {
    return new Promise((resolve) => {
      const watcher = (event) => {
        if (event && !test(event)) return;
        this.watchers.delete(watcher);
        resolve(event);
      };
      this.watchers.add(watcher);
    });
  }

  /// The same port at another setting. Whether it takes that: if not, the port is shut.
  async reopen(baud, format) {
    const end = this.end;
    if (!end) return false;
    clearTimeout(this.timer);
    this.end = null;
    await end.close();
    const isOpen = await end.open(baud, format, this.tells()).then(() => true, () => false);
    this.end = end;
    if (!isOpen) return false;
    this.engine.set(baud, format, this.clock.now());
    this.post({ setting: { baud, format } });
    return true;
  }

  /// Setting after setting. Of a silent line the lowest addresses are asked; where others talk, it listens until whole frames come.
  async find(isHeard) {
    if (!this.end || this.isFinding) return;
    this.isFinding = true;
    let found = null;
    const refused = [], before = this.setting;
    for (const [baud, format] of usualSettings) {
      if (!this.isFinding || !this.end) break;
      if (!await this.exclusively(() => this.reopen(baud, format))) refused.push(`${baud} ${format}`);
      else if (await (isHeard ? this.hears() : this.answers())) found = { baud, format };
      if (found) break;
    }
    const wasStopped = !this.isFinding;
    this.isFinding = false;
    if (!this.end) return;
    if (found) this.setting = found;
    else if (!await this.exclusively(() => this.reopen(before.baud, before.format))) return this.lose("it does not open again");
    this.tellPage();
    this.pass();
    this.post({ found, wasStopped, isHeard, refused });
  }

  async hears() {
    for (let i = 0; i < 2 && this.isFinding; ++i) {
      const heard = this.until((event) => event.event === "phase" && event.phase !== "listening");
      if (i > 0) this.engine.listen();
      this.pass();
      if ((await heard)?.frames >= 2) return true;
    }
    return false;
  }

  async answers() {
    let isThere = false, isEcho = true;
    const note = (event) => {
      isThere ||= event?.event === "unit";
      isEcho ||= event?.event === "failure" && event.error === 0x95; // which any setting has: it is taken out the second time
    };
    this.watchers.add(note);
    this.engine.setTimeout(200);
    for (let i = 0; i < 2 && isEcho && this.isFinding; ++i) {
      isEcho = false;
      const ended = this.until((event) => event.event === "end");
      this.engine.scan(1, 10);
      this.pass();
      if ((await ended)?.how !== "done") this.isFinding = false;
    }
    this.watchers.delete(note);
    this.engine.setTimeout(1000);
    return isThere;
  }

  act(name, args) {
    const result = this.engine[name](...args);
    this.pass();
    return result;
  }
}

/// The messages of the page: each is answered by its number.
function serveLine() {
  let loop, relayed;
  const asked = new Map();
  let number = 0;
  const ask = (relay, what) => new Promise((resolve, reject) => {
    asked.set(++number, { resolve, reject });
    postMessage({ relay, number, ...what });
  });
  const ports = async () => await self.navigator.serial?.getPorts() ?? [];
  const acts = {
    start: async ({ moduleText }) => { loop = new LineLoop(await loadLine(moduleText), (what) => postMessage(what)); },
    connect: async ({ kind, count, baud, format }) => {
      const own = kind === "serial" ? await ports() : [];
      relayed = null;
      // Of several it does not know which one was chosen.
      const isKnown = own.length === 1 && count === 1;
      const end = kind === "simulated" ? new SimulatedEnd(loop.engine.simulated) : isKnown ? new SerialEnd(own[0]) : relayed = new RelayedEnd(ask);
      await loop.connect(end, baud, format);
    },
    disconnect: () => loop.disconnect(),
    find: ({ isHeard }) => { loop.find(isHeard); },
    stop: () => { loop.isFinding = false; loop.act("stop", []); },
    act: ({ name, args }) => loop.act(name, args),
    get: ({ name, args }) => loop.engine[name](...args),
  };
  onmessage = async ({ data }) => {
    if (data.relayed) return relayed?.take(data.relayed, data.value);
    if (data.answered) {
      const { resolve, reject } = asked.get(data.answered);
      asked.delete(data.answered);
      return data.problem ? reject(new Error(data.problem)) : resolve();
    }
    try {
      postMessage({ number: data.number, result: await acts[data.act](data) });
    } catch (problem) {
      postMessage({ number: data.number, problem: problem.message, kind: problem.name });
    }
  };
}

if (typeof module !== "undefined") module.exports = { LineClock, LineLoop, usualSettings };
else if (typeof WorkerGlobalScope !== "undefined") serveLine();

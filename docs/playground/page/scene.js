// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The picture of client, cable, drive and motor; the orders; and what happens in a sentence.
"use strict";

const wantsStillness = matchMedia("(prefers-reduced-motion: reduce)");

class SceneView {
  constructor() { this.clear(); }
  clear() { this.angle = 0; this.time = 0; this.ended = new Set(); this.listed = ""; this.fault = ""; }

  show(state, frames) {
    this.showClient(state.client);
    this.showDrive(state.drive);
    this.showCable(state, frames);
    this.showSilence(state.drive);
    this.showOrders(state.orders);
    setText("now", sentenceOf(state));
    this.time = state.time;
  }

  showClient(client) {
    const isWatching = client.rounds > 0;
    setText("p-client", client.linked ? client.state : isWatching ? "no link" : "knows nothing");
    setText("p-client-2", client.linked ? `reads ${(client.frequency / 10).toFixed(1)} Hz` : client.error && client.error !== "busy" ? client.error : "");
    const runs = client.state === "operation enabled" ? "ordered it to run" : "had ordered it to run";
    setText("p-order", !client.ordered ? "no order" : client.linked ? runs : "it may still run");
  }

  showDrive(drive) {
    const isTurning = drive.frequency !== 0;
    byId("p-drive-box").setAttribute("class", !drive.on ? "off" : drive.fault ? "fault" : drive.state === "operation enabled" ? "running" : "");
    setText("p-state", drive.on ? drive.state : "off");
    setText("p-freq", hertz(drive.frequency));
    setText("p-fault", !drive.on ? "no mains" : drive.fault || (drive.local ? "local control" : "no fault"));
    setText("p-motor", !isTurning ? "stands" : drive.frequency > 0 ? "turns forward" : "turns in reverse");
    if (drive.fault && drive.fault !== this.fault) say(`The drive trips: ${drive.fault}`);
    this.fault = drive.fault;
  }

  turn(state) {
    if (wantsStillness.matches) return;
    // Slower than the motor, so that the eye can follow.
    this.angle = (this.angle + (state.time - this.time) / 1e6 * state.drive.frequency / 1000 * 360 / 40) % 360;
    byId("rotor").setAttribute("transform", `rotate(${this.angle.toFixed(1)} 812 98)`);
  }

  showCable(state, frames) {
    const towards = state.cable === 1 || state.cable === 2, from = state.cable === 1 || state.cable === 3;
    byId("x-to").classList.toggle("on", towards);
    byId("x-from").classList.toggle("on", from);
    byId("w-to").classList.toggle("broken", towards);
    byId("w-from").classList.toggle("broken", from);
    this.showPulses(state, frames);
  }

  /// A frame travels for as long as it takes on the line, and a little longer, to be seen.
  showPulses(state, frames) {
    const shown = 120000;
    const pulses = frames.filter((each) => each.hex !== "" && state.time - each.end < shown).map((each) => {
      const part = Math.max(0, Math.min(1, (state.time - each.end) / shown));
      const reach = each.lost ? part * 0.5 : part;
      const x = each.from === "drive" ? 470 - reach * 258 : 208 + reach * 258;
      return makeSvg("rect", { class: "pulse " + each.from, x, y: each.from === "drive" ? 109 : 75, width: 12, height: 14, rx: 3,
        opacity: each.lost ? 1 - part : 1 });
    });
    byId("pulses").replaceChildren(...(wantsStillness.matches ? [] : pulses));
  }

  showSilence(drive) {
    const limit = drive.timeout / 1e6, passed = Math.min(drive.silence / 1e6, limit);
    const meter = byId("silence");
    meter.max = limit || 1;
    meter.high = limit * 0.6;
    meter.value = passed;
    const count = passed < limit ? `${passed.toFixed(1)} s of ${limit.toFixed(1)} s until it trips`
      : `longer than its time-out of ${limit.toFixed(1)} s`;
    setText("silence-text", !drive.on ? "–" : drive.supervised ? count : "its time-out is switched off");
  }

  showOrders(orders) {
    const listed = JSON.stringify(orders);
    if (listed === this.listed) return;
    this.listed = listed;
    byId("orders").replaceChildren(...orders.slice().reverse().map((each) => make("li",
      { class: each.ended ? (each.done ? "done" : "not") : "" }, make("b", {}, each.what),
      each.ended ? `: ${each.outcome}` : " …", make("span", { class: "quiet" }, ` (${seconds(each.given, 1)})`))));
    for (const each of orders) {
      if (each.ended && !this.ended.has(each.number)) {
        this.ended.add(each.number);
        say(`${each.what}: ${each.outcome}`);
      }
    }
  }
}

function sentenceOf({ drive, client, cable }) {
  if (!drive.on) return "The drive has no mains. Choose a type and press Power.";
  if (drive.fault && !client.linked && cable !== 0) return "The drive heard nothing for its time-out and tripped by itself. The motor has no power. Mend the cable: nothing resumes.";
  if (drive.fault && drive.cause) return "The drive has tripped, and the cause is still there: a reset has no effect until Overcurrent is switched off.";
  if (drive.fault) return "The drive is in fault. The client sees it, and starts nothing by itself: reset the fault, then start again.";
  if (cable !== 0 && !client.linked && drive.frequency !== 0) return "The client got no answers. It has given its order up and keeps silent, so that the drive's own time-out can run out. The motor still turns until then.";
  if (cable !== 0) return "The cable is cut. What the client believes and what the drive does are two things now: compare the boxes.";
  if (drive.local) return "Somebody took the drive over at its keypad. Orders from the line are refused with that reason.";
  if (!drive.supervised) return "The drive would run on if its line went silent. The library refuses to start it.";
  if (drive.state === "operation enabled" && drive.frequency === 0) return "Operation is enabled. The motor follows its reference.";
  if (drive.frequency !== 0 && drive.state === "operation enabled") return "The motor runs. The client reads the drive five times a second; each request restarts the drive's time-out.";
  if (drive.state === "switch on disabled") return "The drive stands, and no stray word can start it. Start it, or send a request of your own.";
  return `The drive is in "${drive.state}".`;
}

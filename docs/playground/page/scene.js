// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The picture of client, cable, drive and motor; the orders; and what happens in a sentence.
"use strict";

const wantsStillness = matchMedia("(prefers-reduced-motion: reduce)");

const cableNames = ["whole", "cut", "cut towards the drive", "cut from the drive"];
const endingClasses = ["", "not", "done otherwise", "done"];

class SceneView {
  constructor() { this.clear(); }
  clear() { this.angle = 0; this.time = 0; this.listed = ""; }

  show(state, frames) {
    this.showClient(state.client);
    this.showDrive(state.drive);
    this.showCable(state, frames);
    this.showSilence(state.drive);
    this.showOrders(state.orders);
    setText("now", sentenceOf(state));
    this.showPlainly(state.cable);
    this.time = state.time;
  }

  showClient(client) {
    const isWatching = client.rounds > 0;
    setText("p-client", client.linked ? client.state : isWatching ? "no link" : "knows nothing");
    setText("p-client-2", client.linked ? `reads ${(client.frequency / 10).toFixed(1)} Hz` : client.error);
    setText("p-order", orderText(client));
  }

  /// The picture's texts again: for a screen on which they are too small, and for those who do not see it.
  showPlainly(cable) {
    const joined = (...ids) => ids.map((id) => byId(id).textContent).filter((each) => each !== "").join(", ");
    setText("t-client", joined("p-client", "p-client-2", "p-order"));
    setText("t-drive", joined("p-state", "p-freq", "p-fault"));
    setText("t-motor", joined("p-motor"));
    setText("picture-text", `Client: ${joined("t-client")}. Cable: ${cableNames[cable]}. ${joined("p-name")}: ${joined("t-drive")}. Motor: ${joined("t-motor")}.`);
  }

  showDrive(drive) {
    byId("p-drive-box").setAttribute("class", !drive.on ? "off" : drive.fault ? "fault" : drive.state === "operation enabled" ? "running" : "");
    setText("p-state", drive.on ? drive.state : "off");
    setText("p-freq", hertz(drive.frequency));
    setText("p-fault", !drive.on ? "no mains" : drive.fault || (drive.local ? "local control" : "no fault"));
    setText("p-motor", motorText(drive));
  }

  turn(state) {
    if (wantsStillness.matches) return;
    // Slower than the motor, so that the eye can follow.
    this.angle = (this.angle + (state.time - this.time) / 1e6 * state.drive.shaft / 1000 * 360 / 40) % 360;
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
      { class: endingClasses[each.ending] }, make("b", {}, each.what),
      each.ending ? `: ${each.outcome}` : each.what.startsWith("stop") ? ": under way; it gives up after 30 s" : ": under way", make("span", { class: "quiet" }, ` (${seconds(each.given, 1)})`))));
  }
}

function orderText(client) {
  if (client.order === "none") return "no order";
  if (client.order === "starting") return "starts it";
  if (!client.linked) return "it may still run";
  if (client.order === "stopping") return "ordered it to stop";
  return client.order === "ordered" && client.state === "operation enabled" ? "ordered it to run" : "had ordered it to run";
}

/// What the motor does, which is not what the drive puts out: without power it coasts.
function motorText(drive) {
  if (drive.shaft === 0) return "stands";
  return !drive.power ? "no power: it coasts" : drive.shaft > 0 ? "turns forward" : "turns in reverse";
}

/// The first that is true; what can hurt comes first.
function sentenceOf(state) {
  const { drive, client, cable } = state;
  if (!drive.on) return drive.shaft ? `The drive has no mains. ${coasting}` : "The drive has no mains. Choose a type and press Power.";
  if (drive.fault) return faultSentence(state);
  if (drive.power && drive.shaft && !client.linked && cable) return unheardSentence(state);
  if (cable) return `The cable is cut. What the client believes and what the drive does are two things now: compare the boxes.${drive.shaft && !drive.power ? " " + coasting : ""}`;
  if (drive.shaft && !drive.power) return coasting;
  if (drive.power && drive.shaft && ["none", "given up"].includes(client.order)) return strayingSentence(state);
  if (drive.local) return "Somebody took the drive over at its keypad. Orders from the line are refused with that reason.";
  if (!drive.supervised) return drive.power ? "The motor runs on if the line goes silent: the drive's time-out was switched off after the start." : "The drive would run on if its line went silent. The library refuses to start it.";
  if (drive.state === "operation enabled" && drive.halted && !drive.shaft) return "The motor is halted: it has power and its old reference, and any word 000F turns it again. Press Stop with \"on the ramp\" unless somebody waits beside it.";
  if (drive.state === "operation enabled" && !drive.shaft) return "Operation is enabled. The motor follows its reference.";
  if (drive.state === "operation enabled") return "The motor runs. The client reads the drive five times a second; each request restarts the drive's time-out.";
  if (drive.state === "switch on disabled") return "The drive stands, and no stray word can start it. Start it, or send a request of your own.";
  return `The drive is in "${drive.state}".`;
}

const coasting = "The motor has no power: it coasts, and nothing brakes it. A real machine may do so for minutes.";

function faultSentence({ drive, client, cable }) {
  const motor = drive.power ? "It is stopping the motor." : drive.shaft ? coasting : "The motor has no power.";
  const cause = drive.lineFault ? "The drive heard nothing for its time-out and tripped by itself." : "The drive has tripped.";
  if (drive.cause) return `${cause} ${motor} Overcurrent is still there: a reset has no effect until it is switched off.`;
  if (!client.linked && cable) return `${cause} ${motor} The client does not see it. Mend the cable: nothing resumes.`;
  return `${cause} ${motor} The client starts nothing by itself: reset the fault, then start again.`;
}

/// The motor turns, and the client gets no answers.
function unheardSentence({ drive, client, cable }) {
  const isReached = cable === 3; // what it sends arrives
  const cause = client.order === "none" ? "The client gets no answers. It never ordered this motor to run, and goes on asking."
    : client.order === "stopping" ? "The client ordered it to stop, and gets no answers."
      : "The client got no answers. It has given its order up and keeps silent, so that the drive's own time-out can run out.";
  if (!drive.supervised) return `${cause} But the drive's time-out is switched off: the motor turns until somebody stops it at the drive, or the cable is mended and Stop is pressed.`;
  if (client.order === "none" && isReached) return `${cause} Each request arrives and restarts the drive's time-out: the motor goes on.`;
  return `${cause} The motor turns until that time-out is over.`;
}

/// The motor turns, and the client reads it without an order of its own.
function strayingSentence({ drive, client }) {
  const cause = client.order === "none" ? "The motor runs, and not by an order of this client."
    : "The motor runs without an order: the client gave its own up when it got no answers, and resumes nothing.";
  const end = drive.supervised ? "Its reads keep the drive's time-out from running out." : "The drive's time-out is switched off: a silent line does not stop it either.";
  return `${cause} ${end} Press Stop.`;
}

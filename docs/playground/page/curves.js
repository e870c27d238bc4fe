// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// The curves of the last seconds, and the frames on a time axis.
"use strict";

const curveSpan = 20e6; // microseconds

class CurvesView {
  constructor() { this.clear(); }
  clear() { this.samples = []; }

  /// Samples that the picture cannot tell apart are left out.
  note(state) {
    const newest = this.samples[this.samples.length - 1];
    if (newest && state.time - newest.time < 20000) return;
    this.samples.push({ time: state.time, on: state.drive.on, frequency: state.drive.frequency / 1000,
      reference: state.drive.reference / 10, client: state.client.linked ? state.client.frequency / 10 : null });
    while (this.samples.length > 2 && this.samples[1].time < state.time - curveSpan) this.samples.shift();
  }

  draw(now) {
    const { context, width, height } = sheet("curves");
    const left = 38, right = 8, top = 8, bottom = 20;
    const largest = Math.max(50, ...this.samples.map((each) => Math.max(Math.abs(each.frequency), Math.abs(each.reference))));
    const x = (time) => left + (1 - (now - time) / curveSpan) * (width - left - right);
    const y = (value) => top + (1 - (value + largest) / (2 * largest)) * (height - top - bottom);
    context.strokeStyle = colour("--edge");
    context.fillStyle = colour("--quiet");
    context.lineWidth = 1;
    for (const value of [-50, -25, 0, 25, 50]) {
      context.beginPath(); context.moveTo(left, y(value)); context.lineTo(width - right, y(value)); context.stroke();
      context.fillText(String(value), 8, y(value) + 4);
    }
    for (let second = Math.ceil((now - curveSpan) / 5e6) * 5; second * 1e6 <= now; second += 5) {
      if (second < 0) continue;
      context.fillText(second + " s", Math.min(x(second * 1e6) - 8, width - 30), height - 5);
    }
    this.line(context, x, y, "reference", "--k2", 1.5, []);
    this.line(context, x, y, "frequency", "--k1", 2.5, []);
    this.line(context, x, y, "client", "--k3", 1.5, [3, 4]);
  }

  line(context, x, y, key, name, width, dash) {
    context.strokeStyle = colour(name);
    context.lineWidth = width;
    context.setLineDash(dash);
    context.beginPath();
    let isDown = false;
    for (const each of this.samples) {
      const value = each.on || key === "client" ? each[key] : null;
      if (value === null) { isDown = false; continue; }
      if (isDown) context.lineTo(x(each.time), y(value)); else context.moveTo(x(each.time), y(value));
      isDown = true;
    }
    context.stroke();
    context.setLineDash([]);
  }
}

/// How much of the line the strip shows, by the speed of time.
const stripSpan = (speed) => speed >= 1 ? 1e6 : speed >= 0.1 ? 250000 : 60000;

function drawStrip(frames, state, speed) {
  const { context, width, height } = sheet("strip");
  const span = stripSpan(speed), left = 64, now = state.time;
  const x = (time) => left + (1 - (now - time) / span) * (width - left - 4);
  context.fillStyle = colour("--quiet");
  context.fillText("client", 4, 24);
  context.fillText("drive", 4, 54);
  context.strokeStyle = colour("--edge");
  for (const y of [20, 50]) { context.beginPath(); context.moveTo(left, y); context.lineTo(width, y); context.stroke(); }
  context.fillText(`the last ${span / 1000} ms`, left, height - 4);
  for (const each of frames) {
    if (each.unanswered || each.end < now - span || each.hex === "") continue;
    const from = Math.max(left, x(each.begin - 570)), to = x(each.end);
    const y = each.from === "drive" ? 39 : 9;
    context.globalAlpha = each.lost ? 0.35 : 1;
    context.fillStyle = colour(each.exception || each.damaged ? "--stop" : { client: "--k1", drive: "--k2", you: "--k3" }[each.from]);
    context.fillRect(from, y, Math.max(2, to - from), 22);
    context.globalAlpha = 1;
    if (to - from > 90) {
      context.save();
      context.beginPath(); context.rect(from, y, to - from, 22); context.clip();
      context.fillStyle = colour("--card");
      context.fillText(each.hex, from + 5, y + 15);
      context.restore();
    }
  }
}

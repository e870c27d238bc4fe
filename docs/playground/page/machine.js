// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Draws the state machine. Which states and transitions there are comes from the module; only the places are from here.
"use strict";

const machinePlaces = {
  "not ready to switch on": [175, 34], "switch on disabled": [175, 128], "ready to switch on": [175, 222],
  "switched on": [175, 316], "operation enabled": [175, 424], "quick stop active": [452, 424],
  "fault reaction active": [452, 34], "fault": [452, 128],
};
const boxHalf = [84, 21];

/// The way of an arrow: [path, x and y of its number].
function machinePath(from, to) {
  if (from === "") {
    const [x, y] = machinePlaces[to];
    return [`M${x - boxHalf[0] - 34} ${y} H${x - boxHalf[0] - 3}`, x - boxHalf[0] - 24, y - 11];
  }
  const [x1, y1] = machinePlaces[from];
  const [x2, y2] = machinePlaces[to];
  if (x1 !== x2) {
    const side = x2 > x1 ? 1 : -1;
    const a = [x1 + side * boxHalf[0], y1 + (y1 === y2 ? (side > 0 ? -7 : 7) : 0)];
    const b = [x2 - side * (boxHalf[0] + 3), y2 + (y1 === y2 ? (side > 0 ? -7 : 7) : 10)];
    return [`M${a} L${b}`, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2 - (y1 === y2 ? side * 1 : 0)];
  }
  const down = y2 > y1 ? 1 : -1;
  const isNear = Math.abs(y2 - y1) < 115;
  if (isNear) {
    const x = x1 - down * 26;
    return [`M${x} ${y1 + down * boxHalf[1]} V${y2 - down * (boxHalf[1] + 3)}`, x, (y1 + y2) / 2];
  }
  // Over other states: around them, the longer the farther; down on the right, up on the left.
  const reach = 20 + Math.abs(y2 - y1) / 6 + (from === "switched on" ? -8 : 0);
  const edge = x1 - down * -boxHalf[0] * (from === "switched on" ? -1 : 1);
  const far = edge + Math.sign(edge - x1) * reach;
  const shift = down < 0 ? 8 : -8;
  return [`M${edge} ${y1 - shift} C${far} ${y1 - shift} ${far} ${y2 + shift} ${edge + Math.sign(edge - x1) * 3} ${y2 + shift}`,
    (edge + 3 * far) / 4, (y1 + y2) / 2];
}

class MachineView {
  constructor() { this.svg = byId("machine"); }

  draw(machine) {
    this.transitions = machine.transitions;
    const title = this.svg.querySelector("title");
    this.svg.replaceChildren(title, makeSvg("defs", {}, this.arrow()));
    this.arrows = machine.transitions.map((each) => this.drawTransition(each));
    this.boxes = new Map(machine.states.map((name) => [name, this.drawState(name)]));
    this.shown = null;
  }

  arrow() {
    return makeSvg("marker", { id: "tip", viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 8, markerHeight: 8,
      orient: "auto-start-reverse", markerUnits: "userSpaceOnUse" }, makeSvg("path", { d: "M0 0 L8 4 L0 8 z",
      style: "fill:var(--line);stroke:none" }));
  }

  drawState(name) {
    const [x, y] = machinePlaces[name];
    const group = makeSvg("g", {}, makeSvg("rect", { x: x - boxHalf[0], y: y - boxHalf[1], width: 2 * boxHalf[0],
      height: 2 * boxHalf[1], rx: 8 }), makeSvg("text", { x, y: y + 5 }, name));
    this.svg.append(group);
    return group;
  }

  drawTransition(each) {
    const [path, x, y] = machinePath(each.from, each.to);
    const width = 8 + 7 * each.number.length;
    const group = makeSvg("g", each.command ? {} : { class: "own" }, makeSvg("title", {}, `${each.number}: ${each.cause}`),
      makeSvg("path", { d: path, "marker-end": "url(#tip)" }),
      makeSvg("rect", { class: "num-bg", x: x - width / 2, y: y - 8, width, height: 16 }),
      makeSvg("text", { class: "num", x, y: y + 4 }, each.number));
    this.svg.append(group);
    return group;
  }

  show(drive) {
    const seen = drive.state + drive.last;
    if (seen === this.shown) return;
    this.shown = seen;
    const kind = /fault/.test(drive.state) ? " bad" : drive.state === "operation enabled" ? " run" : "";
    for (const [name, box] of this.boxes) box.setAttribute("class", name === drive.state ? "here" + kind : "");
    const last = this.transitions.findIndex((each) => each.number === drive.last && each.to === drive.state);
    this.arrows.forEach((each, at) => each.classList.toggle("taken", at === last));
    this.svg.querySelector("title").textContent = `State of the drive: ${drive.state || "off"}`;
    const ways = this.transitions.filter((each) => each.from === drive.state)
      .map((each) => `${each.number} ${each.cause} (to ${each.to})`);
    const came = last < 0 ? "" : `Last transition: ${drive.last}, by ${this.transitions[last].cause}. `;
    setText("last-transition", came + (ways.length ? `From here: ${ways.join("; ")}.`
      : "Transitions are drawn from the library's tables; dashed ones are the drive's own."));
  }
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A state as the part of an address behind its #: the drive's type and all that was done since it was opened, each with its time
// in seconds, and the time of the state itself: `atv320;0.5:power=1;1.5:start=30;6`. Time is virtual, so the same acts at the
// same times lead to the same state.
"use strict";

/// States that have a name.
const namedStates = {
  "running": "atv320;0.5:power=1;1:start=30;5",
  "cut-cable-while-running": "atv320;0.5:power=1;1:start=30;6:cable=1;6.4",
  "unheard-while-running": "atv320;0.5:power=1;1:start=30;6:cable=3;6.4",
  "overcurrent-while-running": "atv320;0.5:power=1;1:start=30;6:fault=1;6.4",
  "start-without-a-time-out": "atv320;0.5:power=1;0.8:supervised=0;1:start=30;2",
};

const mostActs = 200, longestState = 3600; // seconds; a second of the simulation takes a millisecond or two
const actNames = ["power", "fault", "local", "key", "supervised", "start", "change", "stop", "reset", "cable", "send"];

/// Of an address's text: the drive's number, the acts as [microseconds, name, value], and the time. What it does not know it
/// throws, in words; nothing of it is done then.
function readState(text, drives) {
  const [drive, ...parts] = (Object.hasOwn(namedStates, text) ? namedStates[text] : text).split(";");
  const index = drives.indexOf(drive);
  if (index < 0) throw new Error(`"${drive.slice(0, 40)}" is neither a type of drive nor the name of a state`);
  if (parts.length > mostActs + 1) throw new Error(`it has ${parts.length - 1} acts, and ${mostActs} are done at most`);
  let last = 0;
  const read = parts.map((part, at) => {
    const [, time, name, value] = part.match(/^(\d{1,4}(?:\.\d{1,6})?)(?::([a-z]+)(?:=(.*))?)?$/) ?? [];
    const isEnd = at === parts.length - 1;
    if (time === undefined || (name === undefined) !== isEnd) throw new Error(`"${part.slice(0, 40)}" is not a time with an act, or the time at the end`);
    if (Number(time) < last || Number(time) > longestState) throw new Error(`the time ${time} s is before the one ahead of it, or above ${longestState} s`);
    if (name !== undefined && !actNames.includes(name)) throw new Error(`there is no act "${name.slice(0, 40)}"`);
    last = Number(time);
    return [Math.round(last * 1e6), name, decodeURIComponent(value ?? "")];
  });
  const end = read.pop();
  return { drive: index, acts: read, time: end ? end[0] : 0 };
}

/// The text of an address; empty where there is more in it than an address is read with.
function writeState(drive, acts, time) {
  if (acts.length > mostActs || time > longestState * 1e6) return "";
  const shown = (microseconds) => String(microseconds / 1e6);
  const parts = acts.map(([when, name, value]) => `${shown(when)}:${name}${value === "" ? "" : "=" + encodeURIComponent(value)}`);
  return [drive, ...parts, shown(time)].join(";");
}

if (typeof module !== "undefined") module.exports = { namedStates, readState, writeState };

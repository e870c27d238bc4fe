// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Register files, the shipped ones and a person's own, as rows of names and places for the module. What this page does not read of
// one is left out by name.
"use strict";

/// TOML as register files are written: without dates, dotted keys and texts of several lines. A flaw is an error that names its line.
class TomlReader {
  constructor(text) {
    this.text = text;
    this.at = 0;
  }

  fail(why) { throw new Error(`line ${this.text.slice(0, this.at).split("\n").length}: ${why}`); }
  take(pattern) {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    if (found) this.at += found[0].length;
    return found;
  }
  skip() { this.take(/(?:[ \t\r\n]|#[^\n]*)*/y); }

  document() {
    const root = Object.create(null);
    let table = root;
    for (this.skip(); this.at < this.text.length; this.skip()) {
      const head = this.take(/\[(\[?)[ \t]*([\w-]+)[ \t]*\](\]?)/y);
      if (head) table = this.begin(root, head);
      else this.pair(table);
      if (!this.take(/[ \t]*(?:#[^\n]*)?(?:\r?\n|$)/y)) this.fail("a line ends behind its value");
    }
    return root;
  }

  begin(root, [, isList, name, closes]) {
    const table = Object.create(null);
    if (isList.length !== closes.length) this.fail("brackets do not match");
    if (isList ? name in root && !Array.isArray(root[name]) : name in root) this.fail(`'${name}' stands there twice`);
    if (isList) (root[name] ??= []).push(table);
    else root[name] = table;
    Object.defineProperty(table, "line", { value: this.text.slice(0, this.at).split("\n").length });
    return table;
  }

  pair(table) {
    const key = this.take(/[\w-]+|"[^"\\\n]*"|'[^'\n]*'/y)?.[0].replace(/^["']|["']$/g, "");
    if (key === undefined || !this.take(/[ \t]*=[ \t]*/y)) this.fail("neither 'name = value' nor [[register]]");
    if (Object.hasOwn(table, key)) this.fail(`'${key}' stands there twice`);
    table[key] = this.value();
  }

  value() {
    const text = this.take(/"((?:[^"\\\n]|\\.)*)"(?!")|'([^'\n]*)'(?!')/y);
    if (text) return text[2] ?? this.unescaped(text[1]);
    if (this.take(/\[/y)) return this.list("]", (all) => { all.push(this.value()); }, []);
    if (this.take(/\{/y)) return this.list("}", (all) => this.pair(all), Object.create(null));
    const word = this.take(/[+-]?[\w.]+(?:[eE]?[+-]\d+)?(?![\w.:+-])/y)?.[0].replace(/(?<=[\da-fA-F])_(?=[\da-fA-F])/g, "") ?? "";
    if (word === "true" || word === "false") return word === "true";
    if (/^([+-]?(0|[1-9]\d*)|0x[\da-fA-F]+|0o[0-7]+|0b[01]+)$/.test(word)) return word.startsWith("-") ? -BigInt(word.slice(1)) : BigInt(word.replace("+", ""));
    if (/^[+-]?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?$/.test(word)) return Number(word);
    return this.fail("a value is a text, a number, true, false, [a list] or { a = table }");
  }

  unescaped(text) {
    try {
      return JSON.parse(`"${text.replaceAll("\t", "\\t")}"`);
    } catch {
      return this.fail(`"${text}" has a \\ before what needs none`);
    }
  }

  list(end, take, all) {
    for (;;) {
      this.skip();
      if (this.text[this.at] === end) break;
      take(all);
      this.skip();
      if (!this.take(/,/y) && this.text[this.at] !== end) this.fail(`'${end}' is missing`);
    }
    ++this.at;
    return all;
  }
}

const spacesOfList = { 0: "coil", 1: "discrete", 3: "input", 4: "holding" };
const spacesByLetter = { h: "holding", i: "input", c: "coil", d: "discrete" };
const longNames = { uint16: "u16", int16: "i16", uint32: "u32", int32: "i32", uint64: "u64", int64: "i64", float32: "f32", float64: "f64" };
const keysOfRegister = ["name", "space", "address", "bits", "type", "order", "scale", "unit", "offset", "access", "min", "max", "choices", "invalid", "setting",
  "stored", "moves", "group", "simulated"];

/// 40001 is the first holding register: the space, and the address in it.
function listed(number) {
  const size = number > 99999 ? 100000 : 10000;
  return [spacesOfList[Math.trunc(number / size)], number % size - 1];
}

/// A place as it may be typed, in the words of the module: "i:100:float32" is "input:100:f32", "list:40001" is "holding:0".
function placeWord(word) {
  if (!word.includes(":")) return word;
  const [first, second, ...rest] = word.toLowerCase().split(":").map((part) => longNames[part] ?? part);
  const [space, at] = first === "list" && /^\d+$/.test(second) ? listed(Number(second)) : [spacesByLetter[first] ?? first, second];
  return space === undefined || at < 0 ? word : [space, at, ...rest].join(":");
}

/// Name, place, scale, unit, choices, and the bits that mean no value, as the module takes them.
function rowOf(register, line) {
  const fail = (why) => { throw new Error(`line ${line}: ${why}`); };
  const { name, scale = 1n, unit = "", choices = {}, invalid = [] } = register;
  if (typeof name !== "string" || !/^[a-z]\w{0,39}$/i.test(name)) fail("a register has a name: letters, digits and _, a letter first");
  const foreign = Object.keys(register).find((key) => !keysOfRegister.includes(key));
  if (foreign) fail(`${name}: '${foreign}' is no key of a register`);
  let { space = "holding", address, type, order = "" } = register;
  if (typeof address !== "bigint") fail(`${name}: address is missing, or no whole number`);
  let at = Number(address);
  if (space === "list") {
    [space, at] = listed(at);
  }
  if (!Object.values(spacesOfList).includes(space) || at < 0 || at > 65535) fail(`${name}: no such register`);
  const isBit = space === "coil" || space === "discrete";
  type = longNames[type] ?? type ?? (isBit ? "" : "u16");
  for (const each of [type, order, unit]) if (typeof each !== "string") fail(`${name}: type, order and unit are texts`);
  const factor = String(scale);
  if (!/^-?\d+(\.\d+)?$/.test(factor)) fail(`${name}: scale is a decimal number such as 0.01`);
  const numbers = Object.entries(choices), none = Array.isArray(invalid) ? invalid : [invalid];
  if (![...numbers.map(([, number]) => number), ...none].every((each) => typeof each === "bigint")) fail(`${name}: choices and invalid are whole numbers`);
  const bits = /64$/.test(type) ? 64 : /32$/.test(type) ? 32 : 16;
  return [name, [space, at, type, order].filter((part) => part !== "").join(":"), factor === "1" ? "" : factor, unit.replace(/[\t\n\r]/g, " "),
    numbers.map(([choice, number]) => `${choice}=${number}`).join(","), none.map((each) => (bits === 64 ? BigInt.asIntN : BigInt.asUintN)(bits, each)).join(",")];
}

/// Why this page does not read a register, in a word; empty where it does.
function whyLeftOut({ type = "", order = "", bits, offset }) {
  if (bits !== undefined) return "bits";
  if (offset !== undefined) return "offset";
  return order.length > 4 ? `order ${order}` : /^(u16|i16|u32|i32|u64|i64|f32|f64|bcd16|bcd32|hex|bits|text\d+|u?int(16|32|64)|float(32|64)|)$/.test(type) ? "" : `type ${type}`;
}

/// The rows of a register file; `leftOut` names the registers that this page does not read, with the reason.
function readRegisterFile(name, text) {
  const told = new TomlReader(text.replace(/^\uFEFF/, "")).document();
  const foreign = Object.keys(told).find((key) => !["device", "groups", "register"].includes(key));
  if (foreign) throw new Error(`'${foreign}' is neither [device], [groups] nor [[register]]`);
  if (!Array.isArray(told.register)) throw new Error("it has no registers: each is a table that begins with [[register]]");
  const points = [], leftOut = [];
  for (const each of told.register) {
    const why = whyLeftOut(each), row = rowOf(why ? { ...each, type: undefined, order: undefined } : each, each.line);
    if (points.some(([other]) => other.toLowerCase() === row[0].toLowerCase())) throw new Error(`line ${each.line}: the name '${row[0]}' stands there twice`);
    if (why) leftOut.push(`${row[0]} (${why})`);
    else points.push(row);
  }
  return { name, points, leftOut, most: Number(told.device?.max_registers ?? 0) };
}

/// What only JavaScript writes in decimal: numbers of 64 bits, and floats with a scale, as the tool shows them.
function wideValue({ wide, step, unit }) {
  const [type, digits] = wide.split(":"), bits = BigInt(digits), places = (step.split(".")[1] ?? "").length, factor = BigInt(step.replace(".", ""));
  const withUnit = (text) => (unit ? `${text} ${unit}` : text);
  if (type === "f64" || type === "f32") {
    const view = new DataView(new ArrayBuffer(8));
    view.setBigUint64(0, type === "f64" ? bits : bits << 32n);
    const number = type === "f64" ? view.getFloat64(0) : view.getFloat32(0), amount = step === "1" ? number : number * Number(factor) / 10 ** places;
    if (!Number.isFinite(number)) return { text: Number.isNaN(number) ? "not a number" : number < 0 ? "below any number" : "above any number" };
    const text = String(type === "f64" ? amount : Number(amount.toPrecision(7)));
    return { number: text, text: withUnit(text) };
  }
  const count = (type === "i64" ? BigInt.asIntN(64, bits) : bits) * factor, sign = count < 0n ? "-" : "";
  const text = String(count < 0n ? -count : count).padStart(places + 1, "0"), point = text.length - places;
  const number = sign + text.slice(0, point) + (places ? "." + text.slice(point) : "");
  return { number, text: withUnit(number) };
}

if (typeof module !== "undefined") module.exports = { TomlReader, placeWord, readRegisterFile, wideValue };

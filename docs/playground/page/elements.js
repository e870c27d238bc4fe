// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Small words for the document: find, make, colour.
"use strict";

const byId = (id) => document.getElementById(id);

/// Sets a text only where it differs, so that nothing is announced or laid out for nothing.
function setText(id, text) {
  const element = byId(id);
  if (element.textContent !== text) element.textContent = text;
}

function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

function makeSvg(name, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/// Whether the module reads a reference as a number: what shows it, as the slider does, needs one.
const isNumber = (text) => /^-?\d+(\.\d+)?$/.test(text.trim());

const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const seconds = (microseconds, digits = 3) => (microseconds / 1e6).toFixed(digits) + " s";
const hertz = (millihertz) => (millihertz / 1000).toFixed(1) + " Hz";

/// A canvas that is as sharp as the screen: its context, width and height.
function sheet(id) {
  const canvas = byId(id);
  const height = Number(canvas.dataset.height || (canvas.dataset.height = canvas.getAttribute("height")));
  const width = canvas.clientWidth;
  const ratio = window.devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    canvas.style.height = height + "px";
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = "12px system-ui, sans-serif";
  return { context, width, height };
}

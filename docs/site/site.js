// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What each page does when it is there: the switch between light and dark, the search, and of Doxygen's pages the buttons that
// copy code, links to headings, landmarks, tables that scroll, filter and sort. What scrolls can be reached by keyboard.
"use strict";

const make = (name, attributes = {}, ...children) => {
    const element = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        element.setAttribute(key, value);
    }
    element.append(...children);
    return element;
};

// Light or dark as the system has it, until somebody presses the button; then as it was left. A browser may keep nothing.
const root = document.documentElement;
const wear = (theme) => ["light", "dark"].forEach((each) => root.classList.toggle(`${each}-mode`, each === theme));
const isDark = () => getComputedStyle(root).getPropertyValue("--find-ground").trim() !== "#fff";
const kept = (act) => { try { return act(); } catch { return null; } };
wear(kept(() => localStorage.getItem("theme")));

const prepareTheme = () => document.getElementById("theme").addEventListener("click", () => {
    const theme = isDark() ? "light" : "dark";
    wear(theme);
    kept(() => localStorage.setItem("theme", theme));
});

// The search. search.py writes what there is to find, as [shown, words, place, where, rank], into a script, as a page from the
// disk may read no other file; it comes when somebody turns to the search.
const plain = (text) => text.toLowerCase().replace(/[^\p{L}\p{N}]+/gu, " ").trim();

/// The better the fit, the larger; 0: none.
const fit = (text, also, phrase, words) => {
    const has = (within, each) => ` ${within}`.includes(` ${each}`);
    if (text === phrase) {
        return 1000;
    }
    if (text.startsWith(phrase)) {
        return 600;
    }
    return has(text, phrase) ? 400 : words.every((each) => has(text, each)) ? 200 : words.every((each) => has(`${text} ${also}`, each)) ? 100 : 0;
};

const find = (index, typed) => {
    const phrase = plain(typed), words = phrase.split(" "), seen = new Set();
    if (phrase === "") {
        return [];
    }
    return index.map(([shown, text, place, where, rank]) => ({shown, place, where, fit: fit(plain(text || shown), plain(`${shown} ${where}`), phrase, words), rank,
        size: shown.length})).filter((each) => each.fit > 0).sort((one, other) => other.fit + other.rank - one.fit - one.rank || one.size - other.size)
        .filter(({shown, place}) => !seen.has(`${shown} ${place}`) && seen.add(`${shown} ${place}`));
};

const prepareSearch = () => {
    const field = document.getElementById("find"), most = 40;
    const said = make("p", {role: "status"}), list = make("ul"), found = make("div", {id: "found", role: "region", "aria-label": "Found"}, said, list);
    found.hidden = true;
    document.body.append(found);
    const here = document.querySelector('script[src$="site.js"]').getAttribute("src").replace("site.js", "");
    const load = () => {
        if (!document.getElementById("index")) {
            document.head.append(make("script", {id: "index", src: `${here}search.js`}));
            document.getElementById("index").addEventListener("load", show);
        }
    };
    const show = () => {
        found.hidden = plain(field.value) === "";
        if (found.hidden || !window.searchIndex) {
            return;
        }
        const results = find(window.searchIndex, field.value);
        said.textContent = results.length === 0 ? "Nothing has this. Fewer letters find more." : `${results.length} found${results.length > most ? `, the first ${most} of them` : ""}`;
        list.replaceChildren(...results.slice(0, most).map(({shown, place, where}) => make("li", {}, make("a", {href: here + place}, make("b", {}, shown), make("span", {}, where)))));
        const {left, bottom} = field.getBoundingClientRect();
        found.style.top = `${bottom + 6}px`;
        found.style.left = `${Math.max(12, Math.min(left, window.innerWidth - found.offsetWidth - 12))}px`;
    };
    const close = () => { found.hidden = true; };
    /// To the result before or behind the one that has the focus; from the first one back into the field.
    const move = (by) => {
        const links = [...list.querySelectorAll("a")], at = links.indexOf(document.activeElement) + by;
        (at < 0 ? field : links[Math.min(at, links.length - 1)])?.focus();
    };
    field.addEventListener("focus", load);
    field.addEventListener("input", () => { load(); show(); });
    document.addEventListener("keydown", (event) => {
        const isTyped = /^(?:INPUT|TEXTAREA|SELECT)$/.test(document.activeElement.tagName);
        if (event.key === "/" && !isTyped) {
            event.preventDefault();
            field.focus();
        } else if (event.key === "Escape") {
            close();
        } else if (!found.hidden && (document.activeElement === field || found.contains(document.activeElement))) {
            if (event.key === "ArrowDown" || event.key === "ArrowUp") {
                event.preventDefault();
                move(event.key === "ArrowDown" ? 1 : -1);
            } else if (event.key === "Enter" && document.activeElement === field) {
                list.querySelector("a")?.click();
            }
        }
    });
    document.addEventListener("click", (event) => {
        if (event.target !== field && (!found.contains(event.target) || event.target.closest("a"))) {
            close();
        }
    });
};

const reachable = (element, name) => {
    element.tabIndex = 0;
    element.setAttribute("role", "group");
    element.setAttribute("aria-label", name);
};

const longTable = 20; // rows: from here on it is searched and not read

/// A field above a long table that leaves the rows with all of the typed words.
const prepareFilter = (table, frame, rows) => {
    const field = make("input", {type: "search", autocomplete: "off", spellcheck: "false"}), count = make("span", {role: "status"});
    const texts = rows.map((row) => row.textContent.toLowerCase());
    const show = () => {
        const words = field.value.toLowerCase().split(/\s+/);
        rows.forEach((row, at) => { row.hidden = !words.every((each) => texts[at].includes(each)); });
        count.textContent = `${rows.filter((row) => !row.hidden).length} of ${rows.length} rows`;
    };
    field.addEventListener("input", show);
    frame.before(make("div", {class: "filter"}, make("label", {}, "Rows with ", field), count));
    show();
};

/// Each heading of a long table sorts by its column, numbers as numbers; once more turns it round.
const prepareSort = (head, rows) => {
    const order = new Intl.Collator("en", {numeric: true}).compare;
    const number = (text) => Number.parseFloat(text.replace(/[\s\u00a0]/g, ""));
    const compare = (one, other) => number(one) - number(other) || order(one, other);
    [...head.cells].forEach((cell, at) => {
        const button = make("button", {type: "button"}, cell.textContent.trim());
        cell.replaceChildren(button);
        button.addEventListener("click", () => {
            const sign = cell.getAttribute("aria-sort") === "ascending" ? -1 : 1;
            for (const each of head.cells) {
                each.removeAttribute("aria-sort");
            }
            cell.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
            const text = (row) => row.cells[at].textContent.trim();
            const by = (one, other) => (text(one) === "") - (text(other) === "") || sign * compare(text(one), text(other));
            rows[0].parentNode.append(...[...rows].sort(by));
        });
    });
};

const prepareTable = (table) => {
    const frame = make("div", {class: "wide"}), [head, ...rows] = table.rows;
    reachable(frame, "table");
    table.replaceWith(frame);
    frame.append(table);
    if (rows.length >= longTable && table.matches(".markdownTable") && [head, ...rows].every((row) => row.cells.length === head.cells.length)) {
        frame.classList.add("long");
        prepareFilter(table, frame, rows);
        prepareSort(head, rows);
    }
};

const landmark = (selector, role, name) => {
    const element = document.querySelector(selector);
    element?.setAttribute("role", role);
    if (name) {
        element?.setAttribute("aria-label", name);
    }
};

/// What Doxygen's pages lack.
const prepareDoxygen = () => {
    landmark("#top", "banner");
    landmark("#side-nav", "navigation", "Pages");
    landmark("#nav-path", "contentinfo");
    landmark("#doc-content", "main");
    landmark(".title", "heading");
    document.querySelector(".title")?.setAttribute("aria-level", "1");
    landmark(".toc h3", "heading");
    document.querySelector(".toc h3")?.setAttribute("aria-level", "2");
    for (const block of document.querySelectorAll("div.fragment, pre.fragment")) {
        reachable(block, "code");
    }
    for (const picture of document.querySelectorAll(".diagram")) {
        reachable(picture, "picture");
    }
    document.querySelectorAll(".contents table.markdownTable, .contents table.doxtable").forEach(prepareTable);
};

if (typeof DoxygenAwesomeFragmentCopyButton !== "undefined") {
    DoxygenAwesomeFragmentCopyButton.init();
    DoxygenAwesomeParagraphLink.init();
    DoxygenAwesomeInteractiveToc.init();
    document.addEventListener("DOMContentLoaded", prepareDoxygen);
}
document.addEventListener("DOMContentLoaded", () => {
    prepareTheme();
    prepareSearch();
});

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What each page does when it is there: the switch between light and dark, buttons that copy code, links to headings; and
// wide tables scroll by themselves, so that the page does not. What scrolls can be reached by keyboard, and the search has a name.
"use strict";

DoxygenAwesomeDarkModeToggle.init();
DoxygenAwesomeFragmentCopyButton.init();
DoxygenAwesomeParagraphLink.init();
DoxygenAwesomeInteractiveToc.init();

const reachable = (element, name) => {
    element.tabIndex = 0;
    element.setAttribute("role", "group");
    element.setAttribute("aria-label", name);
};

document.addEventListener("DOMContentLoaded", () => {
    for (const block of document.querySelectorAll("div.fragment, pre.fragment")) {
        reachable(block, "code");
    }
    for (const picture of document.querySelectorAll(".diagram")) {
        reachable(picture, "picture");
    }
    for (const table of document.querySelectorAll(".contents table.markdownTable, .contents table.doxtable")) {
        const frame = document.createElement("div");
        frame.className = "wide";
        reachable(frame, "table");
        table.replaceWith(frame);
        frame.append(table);
    }
});

// Doxygen's menu puts the search onto the page at some time.
new MutationObserver((_, observer) => {
    const field = document.getElementById("MSearchField");
    if (field) {
        field.setAttribute("aria-label", "Search");
        observer.disconnect();
    }
}).observe(document.documentElement, {childList: true, subtree: true});

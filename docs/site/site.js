// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What each page does when it is there: the switch between light and dark, buttons that copy code, links to headings; and
// wide tables scroll by themselves, so that the page does not. What scrolls can be reached by keyboard, and the search has a name.
"use strict";

DoxygenAwesomeDarkModeToggle.init();
DoxygenAwesomeFragmentCopyButton.init();
DoxygenAwesomeParagraphLink.init();
DoxygenAwesomeInteractiveToc.init();

const region = (element, name) => {
    element.tabIndex = 0;
    element.setAttribute("role", "region");
    element.setAttribute("aria-label", name);
};

document.addEventListener("DOMContentLoaded", () => {
    document.getElementById("MSearchField")?.setAttribute("aria-label", "Search");
    for (const block of document.querySelectorAll("div.fragment, pre.fragment")) {
        region(block, "code");
    }
    for (const picture of document.querySelectorAll(".diagram")) {
        region(picture, "picture");
    }
    for (const table of document.querySelectorAll(".contents table.markdownTable, .contents table.doxtable")) {
        const frame = document.createElement("div");
        frame.className = "wide";
        region(frame, "table");
        table.replaceWith(frame);
        frame.append(table);
    }
});

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What each page does when it is there: the switch between light and dark, buttons that copy code, links to headings; and
// wide tables scroll by themselves, so that the page does not.
"use strict";

DoxygenAwesomeDarkModeToggle.init();
DoxygenAwesomeFragmentCopyButton.init();
DoxygenAwesomeParagraphLink.init();
DoxygenAwesomeInteractiveToc.init();

document.addEventListener("DOMContentLoaded", () => {
    for (const table of document.querySelectorAll(".contents table.markdownTable, .contents table.doxtable")) {
        const frame = document.createElement("div");
        frame.className = "wide";
        frame.tabIndex = 0;
        frame.setAttribute("role", "region");
        frame.setAttribute("aria-label", "table");
        table.replaceWith(frame);
        frame.append(table);
    }
});

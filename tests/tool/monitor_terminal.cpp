// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What `monitor` sends a terminal, and the keys in what a terminal sends.
#include <string>
#include <string_view>
#include <vector>

#include "../../tools/rtuwire/monitor/painter.hpp"
#include "../../tools/rtuwire/monitor/typed_keys.hpp"
#include "../../tools/rtuwire/output/width.hpp"
#include "support/catch.hpp"

using namespace tool;

namespace {

std::vector<text_line> page_of(std::vector<std::string> const& texts, std::size_t width = 20)
{
    std::vector<text_line> page;
    for (std::string const& each : texts) {
        page.push_back(text_line{width}.add(each));
    }
    return page;
}

/// All keys in some bytes, `none` left out.
std::vector<key> keys_in(typed_keys& keys, std::string_view bytes)
{
    std::vector<key> found;
    for (char const each : bytes) {
        if (key const pressed = keys.push(each); pressed != key::none) {
            found.push_back(pressed);
        }
    }
    return found;
}

std::vector<key> keys_in(std::string_view bytes)
{
    typed_keys keys;
    return keys_in(keys, bytes);
}

} // namespace

TEST_CASE("monitor: a page that has not changed sends no byte, a digit that has changed only itself")
{
    painter screen{true, true};
    CHECK(screen.paint(page_of({"RFR 49.9 Hz", "°C ▁▂"}), 20, 4) ==
          "\x1b[0m\x1b[2J\x1b[1;1H\x1b[0m\x1b[KRFR 49.9 Hz\x1b[2;1H\x1b[0m\x1b[K°C ▁▂");
    CHECK(screen.paint(page_of({"RFR 49.9 Hz", "°C ▁▂"}), 20, 4).empty());
    CHECK(screen.paint(page_of({"RFR 49.8 Hz", "°C ▁▂"}), 20, 4) == "\x1b[1;8H\x1b[0m8");
    CHECK(screen.paint(page_of({"RFR 149.8 Hz", "°C ▁▂"}), 20, 4) == "\x1b[1;5H\x1b[0m\x1b[K149.8 Hz");
    // Behind a character that some terminals show wider no column is counted.
    CHECK(screen.paint(page_of({"RFR 149.8 Hz", "°C ▁▃"}), 20, 4) == "\x1b[2;1H\x1b[0m\x1b[K°C ▁▃");
    CHECK(screen.paint(page_of({"RFR 149.8 Hz"}), 20, 4) == "\x1b[2;1H\x1b[0m\x1b[K");
    CHECK(screen.paint(page_of({"RFR 149.8 Hz  ", "   "}), 20, 4).empty());
    CHECK(screen.paint(page_of({"RFR 149.8 Hz"}), 20, 3) == "\x1b[0m\x1b[2J\x1b[1;1H\x1b[0m\x1b[KRFR 149.8 Hz");
    screen.forget();
    CHECK(screen.paint(page_of({"a"}), 20, 3) == "\x1b[0m\x1b[2J\x1b[1;1H\x1b[0m\x1b[Ka");
}

TEST_CASE("monitor: nothing is sent beyond the screen, and nothing that acts on a terminal")
{
    painter screen{true, true};
    CHECK(screen.paint(page_of({"one", "two"}), 1, 1) == "\x1b[0m\x1b[2J\x1b[1;1H\x1b[0m\x1b[Ko");
    CHECK(screen.paint({}, 20, 1) == "\x1b[0m\x1b[2J");
    // C1 in UTF-8, bytes that are none, a text turned around.
    CHECK(screen.paint(page_of({"a\xC2\x9B"
                                "b\xFF"
                                "c\x80"
                                "d\xE2\x80\xAE"
                                "e"}),
                       20, 1) == "\x1b[1;1H\x1b[0m\x1b[Ka?b?c?d?e");
    painter plain{false, true};
    CHECK(plain.paint(page_of({"1 °C"}), 20, 1) == "\x1b[0m\x1b[2J\x1b[1;1H\x1b[0m\x1b[K1 ?C");
}

TEST_CASE("monitor: looks, with and without colours")
{
    std::vector<text_line> page{
        text_line{20}.add("a", look::strong).add("b", look::faint).add("c").add("d", look::alarm),
        text_line{20}.add("e").add("f", look::alarm).select()};
    CHECK(painter{true, true}.paint(page, 20, 2) ==
          "\x1b[0m\x1b[2J\x1b[1;1H\x1b[0m\x1b[K\x1b[0;1ma\x1b[0;2mb\x1b[0mc\x1b[0;1;31md"
          "\x1b[2;1H\x1b[0m\x1b[K\x1b[0;7me\x1b[0;1;31;7mf");
    CHECK(painter{true, false}.paint(page, 20, 2) ==
          "\x1b[0m\x1b[2J\x1b[1;1H\x1b[0m\x1b[K\x1b[0;1ma\x1b[0;2mb\x1b[0mc\x1b[0;1;7md"
          "\x1b[2;1H\x1b[0m\x1b[K\x1b[0;7me\x1b[0;1mf");
}

TEST_CASE("monitor: arrows in both forms are keys, other sequences are none as a whole")
{
    CHECK(keys_in("\x1b[A\x1bOB\x1b[C\x1bOD") == std::vector{key::up, key::down, key::next_value, key::value_before});
    CHECK(keys_in("jk?q") == std::vector{key::down, key::up, key::help, key::quit});
    // Ctrl and an arrow, F5, page down, a keypad's 1, the cursor's form, a title, a device's string.
    CHECK(keys_in("\x1b[1;5A\x1b[15~\x1b[6~\x1bOq\x1b[2 q\x1b]0;q\a\x1bPq+q\x1b\\\x1b_q\x1b\\").empty());
    CHECK(keys_in("ü€q") == std::vector{key::quit});
    CHECK(keys_in("\x1b\x1b[A") == std::vector{key::up});
    // Esc, or Alt and a letter.
    CHECK(keys_in("\x1bq") == std::vector{key::quit});
}

TEST_CASE("monitor: a sequence that does not go on is given up")
{
    for (std::string_view const begun : {"\x1b", "\x1b[", "\x1bO", "\x1b[1;", "\x1b]0;q", "\x1bP"}) {
        typed_keys keys;
        CHECK(keys_in(keys, begun).empty());
        CHECK(keys.is_within());
        keys.give_up();
        CHECK_FALSE(keys.is_within());
        CHECK(keys_in(keys, "q") == std::vector{key::quit});
    }
}

TEST_CASE("monitor: what is wide, and what stands on a letter, is cut where the screen ends")
{
    // 3 columns a row, of which a wide character has two.
    painter screen{true, true};
    CHECK(screen.paint(page_of({"风机a", "e\u0301te\u0301s"}), 3, 2) ==
          "\x1b[0m\x1b[2J\x1b[1;1H\x1b[0m\x1b[K风\x1b[2;1H\x1b[0m\x1b[Ke\u0301te\u0301");
    CHECK(screen.paint(page_of({"风a", "e\u0301te\u0301"}), 3, 2) == "\x1b[1;1H\x1b[0m\x1b[K风a");
    CHECK(cut_to("风机泵", 6, true) == "风机泵");
    CHECK(cut_to("风机泵", 5, true) == "风机…");
    CHECK(cut_to("风机泵", 4, true) == "风…");
    CHECK(cut_to("e\u0301te\u0301", 3, true) == "e\u0301te\u0301");
    CHECK(text_line{8}.column("风", 4).add("x").text() == "风  x");
    CHECK(wrapped("风机 泵", 1) == std::vector<std::string>{"风", "机", "泵"});
    // By other sources: EastAsianWidth.txt, and what xterm does.
    CHECK(width_of("Aé°µ▁⣿…") == 7);
    CHECK(width_of("⚡✅한ア（𠀀🔧") == 14);
    CHECK(width_of("ア\u3099\u200B") == 2);
}

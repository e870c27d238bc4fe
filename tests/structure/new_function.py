# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""Adds a made-up function, 65, to a copy of the project: a file of its own, its line in the list and a test; shows that
nothing else had to be touched, and that all that is made of the list knows it.

    python3 new_function.py PROJECT COMPILER [OPTION...]
"""
import hashlib
import pathlib
import shutil
import subprocess
import sys
import tempfile

LIST = "include/rtuwire/wire/functions.hpp"
FUNCTION = "include/rtuwire/wire/pdu/double_number.hpp"
TEST = "tests/wire/pdu/double_number.cpp"
GENERIC = ["tests/wire/pdu/all_pdus.cpp"]
FOLDERS = ["include", "tests", "fuzz", "bench", "examples"]

FUNCTION_TEXT = """\
// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Function 65, which nobody has: it doubles a number.
#pragma once

#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/frame_rules.hpp>
#include <rtuwire/wire/parts/pdu_fields.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The response to function 65.
struct double_number_response {
    static constexpr function_code code = static_cast<function_code>(65);
    static constexpr std::size_t max_size = 3;

    std::uint16_t doubled; ///< modulo 65536

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(to_u8(code));
        out.u16(doubled);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<double_number_response> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return double_number_response{u16_at(pdu, 1)};
    }
};

/// Has a number doubled by one unit.
struct double_number {
    using response = double_number_response;
    static constexpr function_code code = response::code;
    static constexpr frame_rules rules{sized(length_rule::fixed, 6), sized(length_rule::fixed, 6), answer_rule::own};
    static constexpr std::size_t max_size = 3;

    std::uint16_t number;

    [[nodiscard]] constexpr errc check() const noexcept { return errc::none; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return max_size; }
    constexpr void write(byte_writer& out) const noexcept
    {
        out.u8(to_u8(code));
        out.u16(number);
    }

    /// Reads a PDU. Errors: `wrong_function`, `wrong_length`.
    [[nodiscard]] static constexpr result<double_number> decode(byte_view pdu) noexcept
    {
        if (errc const wrong = check_size(pdu, code, max_size); wrong != errc::none) {
            return wrong;
        }
        return double_number{u16_at(pdu, 1)};
    }

    /// Whether the number is the double of the one that was sent.
    /// Internal.
    [[nodiscard]] static constexpr errc check_response(byte_view request_pdu, byte_view response_pdu) noexcept
    {
        auto const told = response::decode(response_pdu);
        if (not told) {
            return told.error();
        }
        return told->doubled == twice(u16_at(request_pdu, 1)) ? errc::none : errc::response_mismatch;
    }

    /// Answers a request.
    /// Internal.
    template <typename Memory, typename Server>
    [[nodiscard]] static constexpr errc respond(Memory& pdu, Server const&) noexcept
    {
        auto const asked = decode(pdu.view());
        if (not asked) {
            return errc::illegal_data_value;
        }
        put_u16(&pdu.bytes[1], twice(asked->number));
        return errc::none;
    }

private:
    static constexpr std::uint16_t twice(std::uint16_t number) noexcept
    {
        return static_cast<std::uint16_t>(2U * number);
    }
};

} // namespace rtuwire
"""

TEST_TEXT = """\
// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A client asks a server for function 65, and all that is made of the list of functions knows it.
#include <rtuwire/wire/pdu/double_number.hpp>

#include <array>

#include "support/fact.hpp"
#include "support/pdus.hpp"
#include "support/proof.hpp"

#include <rtuwire/ask/single_request.hpp>
#include <rtuwire/client/client.hpp>
#include <rtuwire/core/hex.hpp>
#include <rtuwire/server/bank/register_bank.hpp>
#include <rtuwire/server/server.hpp>
#include <rtuwire/wire/frame_length.hpp>
#include <rtuwire/wire/response.hpp>

using namespace rtuwire;
using test::is;

namespace {

constexpr auto request = "02 41 12 34 00 00"_hex;
constexpr length_hint whole{6, true};

STATIC_CHECK(all_functions.contains(static_cast<function_code>(65)));
STATIC_CHECK(test::all_pdus::contains<double_number> and test::all_pdus::contains<double_number_response>);

// Both directions end at their size.
STATIC_CHECK(frame_length(direction::request, byte_view{request}.first(2)) == whole);
STATIC_CHECK(frame_length(direction::response, byte_view{request}.first(2)) == whole);
STATIC_CHECK(longest_response(request) == whole);
STATIC_CHECK(frame_length(direction::response, "02 C1"_hex) == length_hint{5, true});

template <std::size_t Size> constexpr errc verdict(std::array<std::byte, Size> const& response_adu)
{
    return check_response(request, adu{response_adu});
}
STATIC_CHECK(verdict("02 41 24 68 00 00"_hex) == errc::none);
STATIC_CHECK(verdict("02 41 24 69 00 00"_hex) == errc::response_mismatch);
STATIC_CHECK(verdict("02 41 24 00 00"_hex) == errc::wrong_length);
STATIC_CHECK(verdict("02 41 12 34 00 00"_hex) == errc::line_echo);
STATIC_CHECK(verdict("02 C1 02 00 00"_hex) == errc::illegal_data_address);

// Requests of the other functions stay what they were.
STATIC_CHECK(check_response("02 03 00 00 00"_hex, adu{"02 03 02 12 34 00 00"_hex}) == errc::none);
STATIC_CHECK(check_response("02 2B 0E 04 00 00"_hex, adu{"02 2B 01 00 00"_hex}) == errc::none);

/// A request travels from a client to a server, and its response back.
constexpr bool is_asked_and_answered()
{
    line_timing const line{19'200, character_format::even_8_1};
    host_client client{line};
    basic_server<loopback_only, function_list<read_holding_registers, double_number>> node{unit_id{2}, line};
    word_bank<4> bank;
    single_request ask{unit_id{2}, double_number{0x9001}};
    instant now{0};
    for (int pass = 0; pass < 100 and not ask.settled(); ++pass) {
        now = now + milliseconds(5);
        client.advance(now);
        client.converse(ask, now);
        node.advance(now);
        if (byte_view const sent = client.poll_transmit(); not sent.empty()) {
            now = now + line.characters(sent.size());
            client.sent(now);
            node.receive(sent, now);
        }
        node.serve(bank, now);
        now = now + milliseconds(5);
        node.advance(now);
        if (byte_view const told = node.poll_transmit(); not told.empty()) {
            now = now + line.characters(told.size());
            client.receive(told, now);
            node.sent(now);
        }
    }
    auto const outcome = ask.outcome();
    return is(outcome.has_value(), "a response came") and
           is(outcome->to<double_number>()->doubled == 0x2002, "it is the double");
}
PROOF("a client asks a server for the new function", is_asked_and_answered)

} // namespace
"""


def copy_of(project, folder):
    for name in FOLDERS:
        shutil.copytree(project / name, folder / name,
                        ignore=shutil.ignore_patterns("__pycache__", "build"))
    return folder


def prints(folder):
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in folder.rglob("*") if path.is_file()}


def add_to_list(text):
    """The include, where the alphabet has it, and the name behind the first one."""
    lines = text.splitlines(keepends=True)
    include = '#include <rtuwire/wire/pdu/double_number.hpp>\n'
    behind = max(at for at, line in enumerate(lines) if line.startswith("#include <rtuwire/wire/pdu/") and line < include)
    lines.insert(behind + 1, include)
    text = "".join(lines)
    last = "read_device_identification>;"
    if text.count(last) != 1:
        raise RuntimeError("the list does not end as it did")
    return text.replace(last, "read_device_identification, double_number>;")


def start(folder, words):
    return subprocess.Popen(words, cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def ended_well(*processes):
    """Whether all of them did; what the others said is printed."""
    told = [(process.communicate()[0], process.returncode) for process in processes]
    for text, status in told:
        if status != 0:
            print(text[-4000:])
    return all(status == 0 for _, status in told)


def build(folder, compiler, options):
    """The test's program, compiled beside the generic tests and without the line in the list."""
    compile_as = [compiler, "-std=gnu++20", "-O0", "-Wall", "-Wextra", "-Werror", "-Itests", "-Iinclude", *options]
    listed = folder / LIST
    unlisted = listed.read_text(encoding="utf-8")
    objects = [start(folder, [*compile_as, "-c", "-o", name, source])
               for name, source in (("main.o", "tests/support/catch_main.cpp"), ("test.o", TEST))]
    generic = [start(folder, [*compile_as, "-fsyntax-only", source]) for source in GENERIC]
    steps = {"its test compiles": ended_well(*objects), "the generic tests take it": ended_well(*generic)}
    steps["its test passes"] = (
        ended_well(start(folder, [compiler, *options, "-o", "double_number", "main.o", "test.o"]))
        and ended_well(start(folder, ["./double_number"])))
    listed.write_text(unlisted.replace(", double_number>", ">"), encoding="utf-8")
    refused = start(folder, [*compile_as, "-fsyntax-only", TEST])
    steps["without its line its test is refused"] = (
        "double_number" in refused.communicate()[0] and refused.returncode != 0)
    return steps


def main(project, compiler, *options):
    project = pathlib.Path(project).resolve()
    with tempfile.TemporaryDirectory(prefix="function-") as name:
        folder = copy_of(project, pathlib.Path(name))
        before = prints(folder)
        (folder / FUNCTION).write_text(FUNCTION_TEXT, encoding="utf-8")
        (folder / TEST).write_text(TEST_TEXT, encoding="utf-8")
        listed = folder / LIST
        listed.write_text(add_to_list(listed.read_text(encoding="utf-8")), encoding="utf-8")
        after = prints(folder)
        touched = {path for path in before.keys() | after.keys() if before.get(path) != after.get(path)}
        lists = start(folder, [sys.executable, "-B", "tests/structure/lists.py", "."])
        steps = {"exactly three files are touched": touched == {LIST, FUNCTION, TEST},
                 "the list agrees with the headers": ended_well(lists),
                 **build(folder, compiler, options)}
    for what, is_so in steps.items():
        print("ok  " if is_so else "FAIL", what)
    return 0 if all(steps.values()) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

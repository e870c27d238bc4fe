# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What each size trick of the headers saves: builds the images without it, by a change of text in a copy of them.

    /usr/bin/python3 bench/size/notes.py [WORD...]   rows of docs/size-notes.md, of the tricks whose names or files hold a word
    /usr/bin/python3 bench/size/notes.py --update    writes the table of docs/size-notes.md anew

A change whose text is not found exactly once is an error. A figure is the flash that the image has more without
the trick, on a Cortex-M0+, or with --m3 on a Cortex-M3; a negative one is what the trick costs there.
"""
import concurrent.futures
import dataclasses
import functools
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import sizes

PAGE = sizes.HERE.parent.parent / "docs" / "size-notes.md"
# The last, a large one, is built for what no other includes.
IMAGES = ("server_frames", "server", "server_all", "client_frames", "client", "typed_read", "client_counting_fixed", "two_conversations")
# The smaller processor, for which the tricks are made; --m3 takes the other.
CPU = "cortex-m3" if "--m3" in sys.argv else "cortex-m0plus"
HEAD = f"| trick | where | {' | '.join(IMAGES)} |\n|{'---|' * (2 + len(IMAGES))}\n"


@dataclasses.dataclass(frozen=True)
class Trick:
    name: str
    header: str
    changes: tuple  # of (what stands there, what stands there without the trick)


def inlining(kind, header, *texts):
    """Functions that are forced inline, or kept out of line: the attribute goes. Each text is the declaration
    behind it, as far as it is needed to find it."""
    name = f"{kind}: " + ", ".join(re.search(r"(\w+)\($", text)[1] for text in texts)
    attribute = {"inline": "always_inline", "not inline": "noinline"}[kind]
    changes = []
    for text in texts:
        for before, after in (("[[gnu::{}]] ", ""), ("[[nodiscard, gnu::{}]] ", "[[nodiscard]] ")):
            changes.append((before.format(attribute) + text, after + text))
    return Trick(name, header, tuple(changes))


TRICKS = (
    inlining("inline", "core/time.hpp", "constexpr void add("),
    Trick("durations compared in place", "core/time.hpp", (("[[gnu::always_inline]] friend constexpr auto", "friend constexpr auto"),)),
    inlining("inline", "wire/response.hpp", "constexpr errc check_fields("),
    inlining("inline", "wire/response.hpp", "constexpr answer_rule answer_of("),
    inlining("inline", "wire/serial_line_rules.hpp", "static constexpr raw_length length("),
    inlining("inline", "wire/functions.hpp", "constexpr std::uint8_t of_others("),
    inlining("inline", "wire/functions.hpp", "constexpr raw_length own("),
    inlining("inline", "wire/functions.hpp", "constexpr raw_length length_by_rule("),
    inlining("inline", "wire/functions.hpp", "constexpr std::size_t size_hint("),
    inlining("inline", "wire/functions.hpp", "static constexpr end_hint apply("),
    inlining("inline", "wire/functions.hpp", "constexpr end_hint apply("),
    inlining("inline", "rtu/framer.hpp", "constexpr bool apply_length_rule("),
    inlining("inline", "server/server.hpp", "constexpr void serve_by("),
    inlining("not inline", "server/respond.hpp", "constexpr errc respond_apart("),
    inlining("inline", "client/client.hpp", "constexpr void replace_asker("),
    inlining("inline", "client/line/request.hpp", "constexpr bool may_pause("),
    inlining("inline", "client/line/request.hpp", "constexpr void note_sent("),
    inlining("not inline", "client/line/transaction.hpp", "constexpr void wait_for_silence("),
    inlining("not inline", "client/line/transaction.hpp", "constexpr void limit_sending("),
    inlining("inline", "client/line/transaction.hpp", "constexpr void attempt_failed("),
    inlining("inline", "client/line/transaction.hpp", "constexpr bool advance("),
    inlining("inline", "client/line/transaction.hpp", "constexpr result<response> take_outcome("),
    inlining("inline", "client/line/transaction.hpp", "constexpr void wake("),
    inlining("inline", "client/line/request.hpp", "constexpr errc keep("),
    inlining("inline", "client/line/request.hpp", "constexpr bool covers("),
    inlining("not inline", "client/line/request.hpp", "constexpr void suspect("),
    inlining("not inline", "client/turns.hpp", "constexpr void renew("),
    Trick("words of a bank taken from a writer at once", "server/banks.hpp", (
        ("        std::byte* at = out.take(2 * count);\n        if (at == nullptr) {\n"
         "            return errc::server_device_failure;\n        }\n", ""),
        ("            put_u16(at, *word++);\n            at += 2;\n        }\n        return errc::none;",
         "            out.u16(*word++);\n        }\n        return out.ok() ? errc::none : errc::server_device_failure;"))),
    Trick("the head of a request taken from a writer at once", "wire/function.hpp", (
        ("    constexpr std::size_t size = 5;\n    if (std::byte* const at = out.take(size); at != nullptr) {\n"
         "        at[0] = to_byte(to_u8(code));\n        put_u16(at + 1, static_cast<std::uint16_t>(first));\n"
         "        put_u16(at + 3, static_cast<std::uint16_t>(second));\n    }\n",
         "    out.u8(to_u8(code));\n    out.u16(first);\n    out.u16(second);\n"),)),
    Trick("a word loaded from one pointer", "core/bytes.hpp", (
        ("    std::byte const* const at = bytes.data() + offset;\n    return to_u16(at[0], at[1]);",
         "    return to_u16(bytes[offset], bytes[offset + 1]);"),)),
    Trick("the CRC's loop tested at its end", "core/crc16.hpp", (
        ("        if (at != end) {\n            do { // tested at its end: an instruction less for each byte where a compiler "
         "optimises for size\n                crc.add(*at++);\n            } while (at != end);\n        }\n",
         "        while (at != end) {\n            crc.add(*at++);\n        }\n"),)),
    Trick("a PDU's view made of pointer and size", "wire/adu.hpp", (
        ("    return {frame.data() + 1, frame.size() - adu_overhead};",
         "    return frame.subspan(1, frame.size() - adu_overhead);"),)),
    Trick("a server's deadline in a form of its own", "rtu/framer.hpp", (
        ("        return activity_ == activity::unknown or not waits_for_silence() ? deadline{} : deadline{last_ + "
         "end_silence()};", "        earliest next;\n        add_to(next);\n        return next;"),)),
    Trick("a state's step by one comparison", "rtu/framer.hpp", (
        ("        if (waits_for_silence()) {\n"
         "            state_ = state_ == state::synchronising ? state::idle : state::done;\n        }\n",
         "        switch (state_) {\n        case state::synchronising: state_ = state::idle; break;\n"
         "        case state::receiving:\n        case state::open_end: state_ = state::done; break;\n"
         "        case state::idle:\n        case state::done: break;\n        }\n"),)),
    Trick("characters added without a check", "rtu/line.hpp", (
        ("return duration{length.microseconds + characters(count).microseconds};",
         "return length + characters(count);"),)),
    Trick("a request copied backwards", "client/line/request.hpp", (
        ("        std::size_t i = frame.size();\n        do { // backwards: 8 bytes less\n            --i;\n"
         "            in.bytes[i] = frame[i];\n        } while (i != 0);\n",
         "        for (std::size_t i = 0; i < frame.size(); ++i) {\n            in.bytes[i] = frame[i];\n        }\n"),)),
    Trick("a response's view constructed anew", "ask/conversation.hpp", (
        ("return {pdu_.data(), pdu_.size()};", "return pdu_;"),)),
    Trick("the response time-out constructed anew", "client/client.hpp", (
        ("duration{all.response_timeout.microseconds}", "all.response_timeout"),)),
)


def without(trick, place):
    """A copy of the headers, without one trick; none where a text of it is not there exactly once."""
    include = place / "include"
    shutil.copytree(sizes.INCLUDE, include)
    path = include / "rtuwire" / trick.header
    text, found = path.read_text(encoding="utf-8"), 0
    for before, after in trick.changes:
        lines = [before] if "[[" not in before else [" " + before, "\n" + before]
        for each in lines:
            if text.count(each) == 1:
                text, found = text.replace(each, each[0] * (len(each) - len(before)) + after), found + 1
    wanted = 1 if "gnu::" in trick.changes[0][0] else len(trick.changes)
    if found != wanted:
        return None
    path.write_text(text, encoding="utf-8")
    return include


@functools.cache
def headers_of(image):
    """What an image includes."""
    said = subprocess.check_output(["arm-none-eabi-g++", *sizes.FLAGS, "-MM", sizes.IMAGES / f"{image}.cpp"], text=True)
    return frozenset(re.findall(r"rtuwire/(\S+\.hpp)", said))


def flash_of(include, image, place):
    """The flash of an image with the headers of a folder."""
    flags = [each for each in sizes.FLAGS if not each.startswith("-I")] + [f"-I{include}"]
    made, elf = place / "image.o", place / "image.elf"
    compiler = ["arm-none-eabi-g++", *flags, f"-mcpu={CPU}"]
    subprocess.check_call([*compiler, "-c", "-o", made, sizes.IMAGES / f"{image}.cpp"])
    subprocess.check_call([*compiler, *sizes.LINK, "-o", elf, sizes.IMAGES / "start.cpp", made])
    text, data, _ = sizes.sections_of(elf)
    return text + data


def flash_everywhere(include, images):
    """The flash of each of these images, two built at a time."""
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        def build(image):
            place = pathlib.Path(folder, image)
            place.mkdir()
            return flash_of(include, image, place)
        return dict(zip(images, pool.map(build, images)))


def rows(tricks):
    whole = flash_everywhere(sizes.INCLUDE, IMAGES)
    for trick in tricks:
        with tempfile.TemporaryDirectory() as folder:
            include = without(trick, pathlib.Path(folder))
            if include is None:
                raise SystemExit(f"notes.py: {trick.header}: the text of \"{trick.name}\" is not there exactly once")
            images = [image for image in IMAGES if trick.header in headers_of(image)]
            now = flash_everywhere(include, [each for each in images if each != IMAGES[-1]] or images)
        cells = [str(now[image] - whole[image]) if image in now else "" for image in IMAGES]
        yield f"| {trick.name} | `{trick.header}` | {' | '.join(cells)} |\n"


def main(options):
    words = [each for each in options if not each.startswith("--")]
    chosen = [trick for trick in TRICKS
              if not words or any(word in trick.name or word in trick.header for word in words)]
    table = HEAD
    print(HEAD, end="")
    for row in rows(chosen):
        print(row, end="", flush=True)
        table += row
    if "--update" in options and not words:
        page = PAGE.read_text(encoding="utf-8")
        begin = page.index("| trick |")
        end = page.index("\n\n", begin)
        PAGE.write_text(page[:begin] + table.rstrip("\n") + page[end:], encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

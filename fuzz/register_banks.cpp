// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Reads and writes of any range to a typed bank and to a simulated drive: what is refused changes
// nothing, and what is taken is read back.
#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using fuzz::require;

namespace {

template <typename Bank> void use(Bank& bank, std::uint16_t start, register_view values)
{
    std::size_t const count = values.size();
    bool const may_read = bank.check_read(start, count) == errc::none;
    std::array<std::byte, 128> before{};
    byte_writer out{before};
    if (may_read) {
        require(bank.read(start, count, out) == errc::none and out.size() == 2 * count);
    }
    if (count == 0 or bank.check_write(start, values) != errc::none) {
        return;
    }
    require(bank.write(start, values) == errc::none);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    bank<atv12::eta, atv12::acc, atv12::dec, atv12::cmd, atv12::lfrd> typed;
    word_bank<64> words{3200};
    instant now{0};
    detail::simulated_drive<atv320::device> new_drive{now};
    detail::simulated_drive<atv28::device> old_drive{now};
    fuzz::input in{data, size};
    while (not in.is_empty()) {
        std::uint8_t const what = in.u8();
        std::uint16_t const start = in.u16();
        register_view const values{in.some(2U * (what & 0x0FU))};
        use(typed, start, values);
        use(words, start, values);
        use(new_drive, start, values);
        use(old_drive, start, values);
        now = now + microseconds(std::uint32_t{in.u8()} << (what >> 4U));
        new_drive.note_contact();
        new_drive.advance(now);
        old_drive.advance(now);
        require(typed.get<atv12::acc>().count() <= 9'999);
        require(cia402::decode(new_drive.word("ETA")) == new_drive.state_machine().state());
    }
    return 0;
}

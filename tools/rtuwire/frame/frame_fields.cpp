// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/frame_fields.hpp"

#include <algorithm>

#include "catalog/value_text.hpp"
#include "frame/hex_text.hpp"

namespace tool {

namespace {

constexpr std::size_t in_a_row = 8;

/// What a drive's register holds. Nobody knows here what sets the step of some.
std::string value_of(register_entry const& entry, drive_catalog const& drive, std::uint16_t word)
{
    auto const step = step_of(entry, drive);
    return step ? full_text(entry, word, *step)
                : std::to_string(entry.count_of(word)) + " steps of a size that " + std::string{entry.steps_set_by} +
                      " sets";
}

} // namespace

bool field_reader::has(std::size_t length)
{
    if (is_short_) {
        return false;
    }
    size_ = at_ + length;
    is_short_ = length > left();
    return not is_short_;
}

void field_reader::add(std::size_t length, std::string name, std::string value)
{
    fields_.push_back({at_ + 1, length, std::move(name), std::move(value)});
    at_ += length;
}

std::optional<unsigned> field_reader::take(std::size_t length)
{
    if (not has(length)) {
        return std::nullopt;
    }
    unsigned value = 0;
    for (std::byte const each : pdu_.subspan(at_, length)) {
        value = value << 8U | std::to_integer<unsigned>(each);
    }
    return value;
}

register_entry const* field_reader::entry_at(unsigned address) const
{
    return drive_ == nullptr or address > 0xFFFFU ? nullptr : drive_->at(static_cast<std::uint16_t>(address));
}

unsigned field_reader::number(std::size_t length, std::string_view name)
{
    return number(length, name, [](unsigned value) { return std::to_string(value); });
}

unsigned field_reader::register_address(std::string_view name)
{
    return number(2, name, [this](unsigned address) {
        register_entry const* const entry = entry_at(address);
        return std::to_string(address) + (entry == nullptr ? "" : " (" + std::string{entry->code} + ")");
    });
}

void field_reader::registers(std::size_t count, std::optional<unsigned> first, bool are_holding)
{
    for (std::size_t i = 0; i < count and not is_short_; ++i) {
        unsigned const address = first.value_or(0) + static_cast<unsigned>(i);
        register_entry const* const entry = first and are_holding ? entry_at(address) : nullptr;
        std::string name = first ? "register " + std::to_string(address)
                                 : "register no. " + std::to_string(i + 1) + " of " + std::to_string(count);
        name += entry == nullptr ? "" : " " + std::string{entry->code};
        number(2, name, [&](unsigned word) {
            return entry == nullptr ? std::to_string(word)
                                    : value_of(*entry, *drive_, static_cast<std::uint16_t>(word));
        });
    }
}

void field_reader::bits(std::size_t bytes, std::size_t count, std::optional<unsigned> first, std::string_view one)
{
    for (std::size_t i = 0; i < bytes and not is_short_; ++i) {
        std::size_t const begin = 8 * i;
        std::size_t const end = (std::min)(begin + 8, (std::max)(count, begin + 1));
        std::size_t const from = first ? *first : 1;
        std::string const name = std::string{one} + (first ? "s " : "s no. ") + std::to_string(from + begin) + " to " +
                                 std::to_string(from + end - 1);
        number(1, name, [&](unsigned value) {
            std::string text;
            for (std::size_t bit = 0; bit < end - begin; ++bit) {
                text += (bit == 0 ? "" : " ") + std::to_string(value >> bit & 1U);
            }
            return text;
        });
    }
}

void field_reader::raw(std::size_t length, std::string_view name)
{
    std::size_t const there = (std::min)(length, is_short_ ? 0 : left());
    for (std::size_t done = 0; done < there;) {
        std::size_t const row = (std::min)(in_a_row, there - done);
        add(row, std::string{name}, hex_of(pdu_.subspan(at_, row)));
        done += row;
    }
    static_cast<void>(has(length - there));
}

void field_reader::text(std::size_t length, std::string const& name)
{
    if (not has(length)) {
        return;
    }
    std::string characters;
    for (std::byte const each : pdu_.subspan(at_, length)) {
        auto const c = std::to_integer<char>(each);
        characters += c >= ' ' and c <= '~' ? c : '.';
    }
    add(length, name, '"' + characters + '"');
}

} // namespace tool

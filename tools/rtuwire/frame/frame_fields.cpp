// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "frame/frame_fields.hpp"

#include <algorithm>

#include "frame/frame_fit.hpp"
#include "frame/hex_text.hpp"

namespace tool {

namespace {

constexpr std::size_t in_a_row = 8;

/// "register 5", "coils no. 1 to 8".
std::string run_text(std::string_view one, std::string_view mark, std::size_t first, std::size_t count)
{
    std::string const number = std::string{mark} + std::to_string(first);
    return std::string{one} + (count == 1 ? ' ' + number : "s " + number + " to " + std::to_string(first + count - 1));
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

void field_reader::add(std::size_t length, std::string const& where, passed_value const& what)
{
    add(length, where + (what.name.empty() ? "" : ' ' + what.name), what.text);
    fields_.back().label = what.name;
    fields_.back().holds = what.value;
    fields_.back().measure = what.measure;
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

unsigned field_reader::number(std::size_t length, std::string_view name)
{
    return number(length, name, [](unsigned value) { return std::to_string(value); });
}

unsigned field_reader::number(std::size_t length, std::string_view name, std::string (*text_of)(unsigned))
{
    std::optional<unsigned> const found = take(length);
    if (found) {
        add(length, std::string{name}, text_of(*found));
    }
    return found.value_or(0);
}

unsigned field_reader::address(std::string_view name, register_space space)
{
    std::optional<unsigned> const found = take(2);
    if (found) {
        std::string const names = names_ == nullptr ? std::string{} : names_->name_at(space, *found);
        add(2, std::string{name}, std::to_string(*found) + (names.empty() ? "" : " (" + names + ")"));
    }
    return found.value_or(0);
}

void field_reader::registers(std::size_t count, std::optional<unsigned> first, register_space space)
{
    std::size_t const there = (std::min)(count, is_short_ ? 0 : left() / 2);
    for (std::size_t i = 0; i < there and not first; ++i) {
        number(2, "register no. " + std::to_string(i + 1) + " of " + std::to_string(count));
    }
    if (first) {
        std::size_t const begin = at_;
        std::vector<std::uint16_t> words;
        for (std::size_t i = 0; i < there; ++i) {
            words.push_back(word_at(pdu_, begin + 2 * i));
        }
        for (passed_value const& each : values_in(names_, space, *first, words)) {
            at_ = begin + 2 * (each.address - *first); // bits stand where their register does
            std::string const name = run_text("register", "", each.address, each.count);
            static_cast<void>(has(2 * each.count));
            add(2 * each.count, name, each);
        }
    }
    if (there < count) {
        static_cast<void>(has(2));
    }
}

void field_reader::bits(std::size_t bytes, std::size_t count, std::optional<unsigned> first, std::string_view one,
                        register_space space)
{
    for (std::size_t i = 0; i < bytes and not is_short_; ++i) {
        std::size_t const begin = 8 * i;
        std::size_t const end = (std::min)(begin + 8, (std::max)(count, begin + 1));
        std::vector<std::uint16_t> values;
        if (std::optional<unsigned> const found = take(1)) {
            std::string text;
            for (std::size_t bit = 0; bit < end - begin; ++bit) {
                values.push_back(*found >> bit & 1U);
                text += (bit == 0 ? "" : " ") + std::to_string(values.back());
            }
            add(1, run_text(one, first ? "" : "no. ", first.value_or(1) + begin, end - begin), text);
        }
        if (first) {
            values.resize(count > begin ? values.size() : 0); // more bytes than bits
            add_named_bits(1, *first + static_cast<unsigned>(begin), values, one, space);
        }
    }
}

void field_reader::named_coil(unsigned address, bool is_on)
{
    std::uint16_t const value = is_on ? 1 : 0;
    add_named_bits(2, address, {&value, 1}, "coil", register_space::coil);
}

void field_reader::add_named_bits(std::size_t bytes, unsigned first, std::span<std::uint16_t const> values,
                                  std::string_view one, register_space space)
{
    for (passed_value const& each : values_in(names_, space, first, values)) {
        if (not each.name.empty()) {
            at_ -= bytes;
            add(bytes, run_text(one, "", each.address, 1), each);
        }
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

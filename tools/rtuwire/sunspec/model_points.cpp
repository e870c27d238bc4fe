// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "sunspec/model_points.hpp"

#include <algorithm>
#include <optional>

#include "import/sunspec_types.hpp"
#include "output/plain_text.hpp"
#include "words/place_value.hpp"

namespace tool {

namespace {

constexpr std::size_t most_points = 4'000;

std::span<std::uint16_t const> words_at(sunspec_point const& point, std::span<std::uint16_t const> words)
{
    return words.subspan(point.offset, point.registers);
}

/// What a point of this group, or of one around it, is called by.
sunspec_point const* point_named(std::string_view name, std::string group, std::span<sunspec_point const> all)
{
    while (true) {
        std::string const whole = group + std::string{name};
        auto const found = std::ranges::find(all, whole, &sunspec_point::name);
        if (found != all.end()) {
            return &*found;
        }
        if (group.empty()) {
            return nullptr;
        }
        group.pop_back();
        group.erase(std::min(group.rfind('.') + 1, group.size()));
    }
}

class point_collector {
public:
    point_collector(std::span<std::uint16_t const> words, std::vector<std::string>& told) : words_{words}, told_{told}
    {}

    std::vector<sunspec_point> run(source_value const& group)
    {
        bool const is_whole = add_group(group, {});
        if (is_whole and at_ < words_.size()) {
            told_.push_back("its last " + std::to_string(words_.size() - at_) +
                            " registers are left out: its file ends before them");
        }
        return std::move(points_);
    }

private:
    /// Whether what stands behind it has a known place.
    bool add_group(source_value const& group, std::string const& prefix)
    {
        source_value const* const points = group.find("points");
        for (std::size_t i = 0; points != nullptr and i < points->fields.size(); ++i) {
            if (not add_point(points->fields[i].second, prefix)) {
                return false;
            }
        }
        source_value const* const groups = group.find("groups");
        for (std::size_t i = 0; groups != nullptr and i < groups->fields.size(); ++i) {
            if (not add_groups(groups->fields[i].second, prefix)) {
                return false;
            }
        }
        return true;
    }

    bool add_groups(source_value const& group, std::string const& prefix)
    {
        std::string const name = prefix + group.text_of("name");
        source_value const* const count = group.find("count");
        if (count == nullptr) {
            return add_group(group, name + '.');
        }
        std::int64_t times = count->whole_number().value_or(-1);
        if (times < 0) {
            sunspec_point const* const counter = point_named(count->text, prefix, points_);
            if (counter == nullptr or counter->registers != 1) {
                told_.push_back(name + ": no point " + count->text + " says how many there are");
                return false;
            }
            times = words_at(*counter, words_)[0];
        } else if (times == 0) {
            times = 0xFFFF; // up to the end
        }
        bool const is_to_the_end = times == 0xFFFF;
        for (std::int64_t i = 1; i <= times and (at_ < words_.size() or not is_to_the_end); ++i) {
            std::size_t const before = at_;
            if (not add_group(group, name + '_' + std::to_string(i) + '.') or at_ == before) {
                return false;
            }
        }
        return true;
    }

    bool add_point(source_value const& from, std::string const& prefix)
    {
        std::string const type = from.text_of("type");
        sunspec_type const* const known = sunspec_type_named(type);
        source_value const* const size = from.find("size");
        std::int64_t const registers =
            size == nullptr ? (known == nullptr ? 0 : known->registers) : size->whole_number().value_or(0);
        std::string const name = prefix + from.text_of("name");
        if (registers < 1 or registers > 125) {
            told_.push_back(name + ": no size is known of it, so what stands behind it is not shown");
            return false;
        }
        if (at_ + static_cast<std::size_t>(registers) > words_.size() or points_.size() == most_points) {
            told_.push_back(name + " and what stands behind it are left out: " +
                            (points_.size() == most_points
                                 ? "it has more than " + std::to_string(most_points) + " points"
                                 : "the device's model ends before"));
            at_ = words_.size();
            return false;
        }
        if (type != "pad") {
            points_.push_back({.name = name,
                               .title = from.text_of("label"),
                               .offset = static_cast<std::uint16_t>(at_),
                               .registers = static_cast<std::uint16_t>(registers),
                               .from = &from,
                               .group = prefix});
        }
        at_ += static_cast<std::size_t>(registers);
        return true;
    }

    std::span<std::uint16_t const> words_;
    std::vector<std::string>& told_;
    std::vector<sunspec_point> points_{};
    std::size_t at_{0};
};

/// "0.01", "1", "100"; nothing where a power is beyond what a form holds.
std::optional<std::string> scale_of(std::int64_t power)
{
    constexpr std::int64_t most = 8;
    if (power < -most or power > most) {
        return std::nullopt;
    }
    auto const zeros = static_cast<std::size_t>(power < 0 ? -power : power);
    return power < 0 ? "0." + std::string(zeros - 1, '0') + '1' : '1' + std::string(zeros, '0');
}

/// The power of ten that a point's file says, or the point that it names; nothing where the device does not tell.
std::optional<std::int64_t> power_of(sunspec_point const& point, std::span<sunspec_point const> all,
                                     std::span<std::uint16_t const> words)
{
    source_value const* const factor = point.from->find("sf");
    if (factor == nullptr) {
        return 0;
    }
    if (auto const said = factor->whole_number()) {
        return said;
    }
    sunspec_point const* const other = point_named(factor->text, point.group, all);
    if (other == nullptr or other->registers != 1) {
        return std::nullopt;
    }
    auto const held = static_cast<std::int16_t>(words_at(*other, words)[0]);
    constexpr std::int16_t not_there = -0x8000;
    return held == not_there ? std::nullopt : std::optional{std::int64_t{held}};
}

bool is_missing(sunspec_type const& type, std::span<std::uint16_t const> words)
{
    std::uint64_t bits = 0;
    for (std::uint16_t const each : words) {
        bits = bits << 16U | each;
    }
    return type.missing and bits == *type.missing;
}

/// The names of a number, or of the bits of one.
std::string symbols_of(sunspec_point const& point, std::uint64_t number, bool are_bits)
{
    source_value const* const symbols = point.from->find("symbols");
    std::string names;
    for (std::size_t i = 0; symbols != nullptr and i < symbols->fields.size(); ++i) {
        source_value const& each = symbols->fields[i].second;
        source_value const* const value = each.find("value");
        auto const said = value == nullptr ? std::nullopt : value->whole_number();
        bool const is_meant = said and *said >= 0 and
                              (are_bits ? *said < 64 and (number >> static_cast<unsigned>(*said) & 1U) != 0
                                        : static_cast<std::uint64_t>(*said) == number);
        if (is_meant) {
            names += (names.empty() ? "" : "+") + plain_text(each.text_of("name"));
        }
    }
    return names;
}

} // namespace

std::vector<sunspec_point> points_of(source_value const& file, std::span<std::uint16_t const> words,
                                     std::vector<std::string>& told)
{
    return point_collector{words, told}.run(*file.find("group"));
}

sunspec_value value_of(sunspec_point const& point, std::span<sunspec_point const> all,
                       std::span<std::uint16_t const> words)
{
    std::span<std::uint16_t const> const own = words_at(point, words);
    sunspec_value result{.raw = own.size() == 1 ? cell{std::int64_t{own[0]}} : cell{hex_words(own)}};
    std::string const type = point.from->text_of("type");
    sunspec_type const* const known = sunspec_type_named(type);
    bool const is_text = type == "string";
    if (not is_text and (known == nullptr or known->registers != point.registers)) {
        result.text = hex_words(own);
        return result;
    }
    auto const power = power_of(point, all, words);
    if ((known != nullptr and is_missing(*known, own)) or not power) {
        result.text = power ? "not implemented" : "not implemented: no scale factor";
        return result;
    }
    std::string const form =
        is_text ? "text" + std::to_string(2 * point.registers) : std::string{known->type.empty() ? "u16" : known->type};
    auto const scale = scale_of(*power);
    std::string const unit = point.from->text_of("units");
    std::string const typed = "holding:0:" + form;
    places_typed place =
        is_text or known->type == "hex" ? read_places(typed) : read_places(typed + ':' + scale.value_or("0") + unit);
    if (place.refused and scale) { // by a unit that no place has
        place = read_places(typed + ':' + *scale);
    }
    if (place.refused) {
        result.text = hex_words(own) + ", times ten to the power of " + std::to_string(*power);
        return result;
    }
    formed_value const formed = value_of(place.places[0], own);
    bool const is_float = form == "f32" or form == "f64";
    result.value = formed.value;
    result.text = is_float and std::holds_alternative<std::monostate>(formed.value) ? "not implemented" : formed.text;
    result.measure = place.places[0].form.unit;
    bool const are_bits = type.starts_with("bitfield");
    if (are_bits or type.starts_with("enum")) {
        std::uint64_t number = 0;
        for (std::uint16_t const each : own) {
            number = number << 16U | each;
        }
        std::string const names = symbols_of(point, number, are_bits);
        result.text = names.empty() ? (are_bits ? hex_words(own) : formed.text)
                                    : names + " (" + (are_bits ? hex_words(own) : formed.text) + ')';
        result.value = names.empty() or are_bits ? result.value : cell{names};
    }
    return result;
}

} // namespace tool

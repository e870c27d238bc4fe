// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include "exit_status.hpp"
#include "import/forms.hpp"
#include "import/sunspec_types.hpp"

namespace tool {

namespace {

constexpr std::string_view point_fields[]{"name", "type", "size", "sf", "units", "symbols", "access", "value",
                                          // for people, and for whoever makes a device
                                          "label", "desc", "detail", "notes", "comments", "mandatory", "static",
                                          "standards"};
constexpr std::string_view group_fields[]{"name", "type",   "points", "groups",   "count",    "label",
                                          "desc", "detail", "notes",  "comments", "standards"};

class sunspec_reader {
public:
    sunspec_reader(std::int64_t base, register_file_writer& into) : at_{base}, into_{into} {}

    /// Whether what stands behind it has a known place.
    bool read_group(source_value const& group, std::string const& prefix)
    {
        lose_other_fields(into_, group, group.text_of("name"), group_fields);
        if (source_value const* const points = group.find("points")) {
            for (auto const& [key, each] : points->fields) {
                if (not read_point(each, prefix)) {
                    return false;
                }
            }
        }
        source_value const* const groups = group.find("groups");
        for (std::size_t i = 0; groups != nullptr and i < groups->fields.size(); ++i) {
            if (not read_groups_within(groups->fields[i].second, prefix)) {
                return false;
            }
        }
        return true;
    }

private:
    bool read_groups_within(source_value const& group, std::string const& prefix)
    {
        source_value const* const count = group.find("count");
        auto const times = count == nullptr ? std::optional<std::int64_t>{1} : count->whole_number();
        std::string const name = prefix + group.text_of("name");
        if (not times or *times < 1) {
            into_.lose(count->place,
                       name + ": how many of this group there are, the device says; it is left out with what "
                              "stands behind it");
            return false;
        }
        for (std::int64_t i = 1; i <= std::min<std::int64_t>(*times, 100); ++i) {
            std::string const mark = *times > 1 ? '_' + std::to_string(i) : std::string{};
            if (not read_group(group, count == nullptr ? prefix : name + mark + '_')) {
                return false;
            }
        }
        return true;
    }

    bool read_point(source_value const& point, std::string const& prefix)
    {
        written_register one;
        one.place = point.place;
        one.name = prefix + point.text_of("name");
        lose_other_fields(into_, point, one.name, point_fields);
        std::string const type = point.text_of("type");
        sunspec_type const* const found = sunspec_type_named(type);
        source_value const* const said = point.find("size");
        auto const size = said == nullptr ? std::nullopt : said->whole_number();
        if (found == nullptr and (not size or *size < 1 or *size > 125)) {
            into_.lose(point.place,
                       one.name + " is left out with what stands behind it: no size is known of '" + type + '\'');
            return false;
        }
        std::int64_t const registers = size.value_or(found == nullptr ? 0 : found->registers);
        one.address = at_;
        at_ += registers;
        if (type == "pad") {
            return true;
        }
        if (type == "string") {
            one.type = "text" + std::to_string(2 * registers);
        } else if (found != nullptr and found->registers == registers) {
            one.type = found->type;
        } else {
            into_.lose(point.place, one.name + " is left out: no register file has a '" + type + "' of " +
                                        std::to_string(registers) + " registers");
            return true;
        }
        read_meaning(point, type, one);
        if (found != nullptr and found->missing) {
            one.invalid = {*found->missing};
        }
        into_.add(std::move(one));
        return true;
    }

    void read_meaning(source_value const& point, std::string const& type, written_register& one)
    {
        one.is_writable = point.text_of("access") == "RW";
        one.unit = point.text_of("units");
        if (source_value const* const factor = point.find("sf")) {
            auto const power = factor->whole_number();
            bool const is_small = power and *power >= -10 and *power <= 10;
            one.scale = is_small ? std::pow(10.0, std::abs(static_cast<double>(*power))) : 1;
            one.scale = is_small and *power < 0 ? 1 / one.scale : one.scale;
            if (not is_small) {
                one.not_the_value = "it is to be multiplied by ten to the power of " +
                                    (power ? factor->text : "what " + factor->text + " holds");
            }
        }
        source_value const* const symbols = point.find("symbols");
        bool const is_choice = type.starts_with("enum");
        for (std::size_t i = 0; symbols != nullptr and i < symbols->fields.size(); ++i) {
            source_value const& symbol = symbols->fields[i].second;
            if (auto const number = is_choice ? whole_field(into_, symbol, "value") : std::nullopt) {
                one.choices.emplace_back(symbol.text_of("name"), *number);
            } else {
                into_.lose(symbol.place, one.name + ": the name of bit " + symbol.text_of("value") + ", " +
                                             symbol.text_of("name") + ", is not carried over");
            }
        }
    }

    std::int64_t at_;
    register_file_writer& into_;
};

} // namespace

bool is_sunspec(source_value const& file)
{
    source_value const* const group = file.find("group");
    return group != nullptr and group->kind == source_kind::table and group->find("points") != nullptr;
}

void import_sunspec(source_value const& file, std::optional<std::int64_t> base, register_file_writer& into)
{
    source_value const& group = *file.find("group");
    if (not base) {
        refuse_word(into.file() +
                    ": a model of SunSpec stands where its device says: say the address of its first register, "
                    "such as --base 40070; identify shows it");
    }
    into.add_comment("Imported from the SunSpec model " + file.text_of("id") + ", " + group.text_of("name") + '.');
    static_cast<void>(sunspec_reader{*base, into}.read_group(group, {}));
}

} // namespace tool

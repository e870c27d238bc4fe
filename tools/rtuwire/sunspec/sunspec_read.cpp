// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "sunspec/sunspec_read.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "files/regular_file.hpp"
#include "import/forms.hpp"
#include "line/line_words.hpp"
#include "output/plain_text.hpp"
#include "sunspec/model_points.hpp"

namespace tool {

namespace {

constexpr unsigned most_at_once = 125;

/// The file of a model; nothing where the folder has none.
std::optional<source_value> file_of(std::string const& folder, std::uint16_t id)
{
    std::string const path = folder + "/model_" + std::to_string(id) + ".json";
    file_text const found = text_of_file(path);
    if (found.is_missing) {
        return std::nullopt;
    }
    if (not found.failure.empty()) {
        refuse_word(path + ": " + found.failure);
    }
    if (found.text.size() > most_source_bytes) {
        refuse_word(path + ": " + std::to_string(found.text.size()) + " bytes; a model has at most " +
                    std::to_string(most_source_bytes));
    }
    source_value read = json_source(path, found.text);
    if (not is_sunspec(read)) {
        refuse_word(path + ": this is no model of SunSpec");
    }
    return read;
}

/// Registers from a model's first on, into `words`.
void read_words(open_line& line, unit_address unit, sunspec_model const& model, unsigned from, unsigned count,
                std::vector<std::uint16_t>& words)
{
    auto const read =
        line.ask(unit, rtuwire::read_holding_registers{.start = static_cast<std::uint16_t>(model.address + from),
                                                       .count = static_cast<std::uint16_t>(count)});
    if (not read) {
        throw ended{status_of(read.error()),
                    "unit " + std::to_string(unit.byte()) + ": model " + std::to_string(model.id) + " at " +
                        std::to_string(model.address + from) + ": " + line.words_of_failure(read.error())};
    }
    for (unsigned i = 0; i < count; ++i) {
        words[from + i] = read->registers[i];
    }
}

/// The registers of a model. One that is longer than a response is read a second time, so that each value comes by one.
std::vector<std::uint16_t> words_of(open_line& line, unit_address unit, sunspec_model const& model,
                                    source_value const& file)
{
    unsigned const size = model.length + 2U;
    std::vector<std::uint16_t> words(size);
    for (unsigned at = 0; at < size; at += most_at_once) {
        read_words(line, unit, model, at, std::min(most_at_once, size - at), words);
    }
    if (size <= most_at_once) {
        return words;
    }
    std::vector<std::string> ignored;
    unsigned first = 0;
    unsigned end = 0;
    for (sunspec_point const& each : points_of(file, words, ignored)) {
        if (each.offset + each.registers > first + most_at_once) {
            read_words(line, unit, model, first, end - first, words);
            first = each.offset;
        }
        end = each.offset + unsigned{each.registers};
    }
    if (end > first) {
        read_words(line, unit, model, first, end - first, words);
    }
    return words;
}

/// Whether all of it was shown.
bool put_model(choices const& chosen, unit_address unit, sunspec_model const& model, std::string const& prefix,
               source_value const& file, std::vector<std::uint16_t> const& words, output& results)
{
    std::vector<std::string> told;
    std::vector<sunspec_point> const points = points_of(file, words, told);
    for (std::string const& each : told) {
        tell_error("model " + std::to_string(model.id) + ": " + each);
    }
    for (sunspec_point const& each : points) {
        sunspec_value const it = value_of(each, points, words);
        std::string const name = prefix + plain_text(each.name);
        auto const address = static_cast<std::int64_t>(model.address) + each.offset;
        if (chosen.form == output_form::table) {
            results.put(
                {{"register", name}, {"address", address}, {"value", it.text}, {"name", plain_text(each.title)}});
        } else {
            results.put({{"unit", std::int64_t{unit.byte()}},
                         {"register", name},
                         {"address", address},
                         {"raw", it.raw},
                         {"value", it.value},
                         {"measure", it.measure},
                         {"text", it.text}});
        }
    }
    return told.empty();
}

void refuse_folder_without_models(std::string const& folder)
{
    std::error_code why;
    bool has_model = false;
    for (std::filesystem::directory_iterator each{folder, why}, end; not why and each != end; each.increment(why)) {
        std::string const name = each->path().filename().string();
        has_model = has_model or (name.starts_with("model_") and name.ends_with(".json"));
    }
    if (why or not has_model) {
        refuse_word("--sunspec " + folder + ": " + (why ? why.message() : "no model_1.json or the like is in it"));
    }
}

} // namespace

exit_status read_sunspec(choices const& chosen)
{
    refuse_folder_without_models(chosen.sunspec);
    unit_address const unit = unit_in(chosen.line).unit;
    open_line line{chosen.line};
    output results{chosen.form, false};
    sunspec_models const found = sunspec_models_of(line, unit);
    if (not found.mark) {
        throw ended{found.outcome == exit_status::done ? exit_status::differs : found.outcome,
                    "unit " + std::to_string(unit.byte()) + " has no mark of SunSpec at 40000, 0 or 50000" +
                        (found.failure.empty() ? "" : ": " + found.failure)};
    }
    bool is_whole = true;
    for (std::size_t i = 0; i < found.models.size(); ++i) {
        sunspec_model const& model = found.models[i];
        auto const before = std::count_if(found.models.begin(), found.models.begin() + static_cast<std::ptrdiff_t>(i),
                                          [&model](sunspec_model const& each) { return each.id == model.id; });
        std::string const prefix =
            std::to_string(model.id) + (before == 0 ? "" : '_' + std::to_string(before + 1)) + '.';
        auto const file = file_of(chosen.sunspec, model.id);
        if (not file) {
            tell_error("model " + std::to_string(model.id) + " at " + std::to_string(model.address) + ": " +
                       chosen.sunspec + " has no model_" + std::to_string(model.id) + ".json");
            continue;
        }
        is_whole =
            put_model(chosen, unit, model, prefix, *file, words_of(line, unit, model, *file), results) and is_whole;
    }
    results.finish();
    if (not found.failure.empty()) {
        tell_error("unit " + std::to_string(unit.byte()) + ": " + found.failure);
    }
    return found.outcome == exit_status::done and not is_whole ? exit_status::differs : found.outcome;
}

} // namespace tool

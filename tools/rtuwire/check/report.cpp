// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/report.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>

#include "../support/platform.hpp"
#include "exit_status.hpp"
#include "frame/hex_text.hpp"
#include "output/plain_text.hpp"

namespace tool {

namespace {

std::string_view name_of(clause_level level)
{
    return level == clause_level::must ? "must" : level == clause_level::should ? "should" : "may";
}

/// "> 01 03 00 00 00 01 84 0A, 12.3 ms < 01 83 02 C0 F1", and no more than anybody reads.
std::string passed_text(std::vector<passed_bytes> const& all)
{
    constexpr std::size_t most = 400;
    std::string text;
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i) {
        if (i > 0) {
            std::chrono::duration<double, std::milli> const since = all[i].at - all[i - 1].at;
            std::array<char, 24> time{};
            std::snprintf(time.data(), time.size(), ", %.1f ms ", since.count());
            text += time.data();
        }
        text += (all[i].is_sent ? "> " : "< ") + hex_of(all[i].bytes);
    }
    return text + (all.size() > most ? " and " + std::to_string(all.size() - most) + " more" : std::string{});
}

std::string escaped(std::string_view text)
{
    std::string out;
    for (char const each : text) {
        out += each == '&'   ? "&amp;"
               : each == '<' ? "&lt;"
               : each == '>' ? "&gt;"
               : each == '"' ? "&quot;"
                             : std::string{each};
    }
    return out;
}

} // namespace

record record_of(judged_clause const& each, output_form form)
{
    clause const& which = *each.which;
    bool const fails = each.found.how == verdict::fails;
    record row{{"clause", std::string{which.id}},
               {"level", std::string{name_of(which.level)}},
               {"verdict", std::string{name_of(each.found.how)}}};
    if (form == output_form::table) {
        return row.add("why", fails ? std::string{which.harm} + " " + each.found.why : each.found.why);
    }
    return row.add("group", std::string{which.group})
        .add("source", std::string{which.source})
        .add("why", each.found.why)
        .add("harm", fails ? std::string{which.harm} : std::string{})
        .add("frames", passed_text(each.found.passed));
}

std::string explained(clause const& which)
{
    std::string text = std::string{which.id} + ", " + std::string{name_of(which.level)} + ", " +
                       std::string{which.source} + "\n" + "what fails in the field: " + std::string{which.harm} + "\n";
    if (which.group == client_group) {
        text += "the client is told: " + std::string{which.sends} +
                "\nit is answered: " + (which.comes == "-" ? "nothing" : std::string{which.comes}) + "\n";
        std::string const answered = " " + std::string{which.comes} + " ";
        for (auto const& [word, meaning] : client_words()) {
            bool const is_begin = word.starts_with('~'); // of a word with a number
            std::string const looked = " " + std::string{word} + (is_begin ? "" : " ");
            text += answered.find(looked) == answered.npos
                        ? std::string{}
                        : "  " + std::string{word} + ": " + std::string{meaning} + "\n";
        }
        return text + "what is judged: " + std::string{which.applies} + "\n";
    }
    text += "asked where: " + std::string{which.applies} + "\n";
    std::string const needs{which.needs};
    text += needs.find("scratch") != needs.npos      ? "needs: --scratch or --scratch-coils, as it writes\n"
            : needs.find("disruptive") != needs.npos ? "needs: --disruptive\n"
            : needs.find("hostile") != needs.npos    ? "needs: --hostile\n"
                                                     : "";
    if (which.sends.starts_with('@')) {
        return text + "sent: " + std::string{which.sends.substr(1)} + "\nmay come: " + std::string{which.comes} + "\n";
    }
    std::vector<std::string_view> const sends = steps_of(which.sends), comes = steps_of(which.comes);
    for (std::size_t i = 0; i < sends.size(); ++i) {
        text += "sent: " + std::string{sends[i]} +
                "\n  may come: " + std::string{comes[i] == "-" ? "nothing" : comes[i]} + "\n";
    }
    return text;
}

void write_junit(std::string const& path, std::string const& unit, std::span<judged_clause const> all)
{
    std::size_t failures = 0, skipped = 0, errors = 0;
    std::string cases;
    for (judged_clause const& each : all) {
        clause const& which = *each.which;
        bool const fails = each.found.how == verdict::fails and which.level == clause_level::must;
        bool const is_cut = each.is_cut;
        bool const is_skipped =
            not is_cut and (each.found.how == verdict::does_not_apply or each.found.how == verdict::not_tried or
                            each.found.how == verdict::known);
        errors += is_cut ? 1U : 0U;
        failures += fails ? 1U : 0U;
        skipped += is_skipped ? 1U : 0U;
        std::string const why = escaped(plain_text(each.found.why)); // XML has no control characters
        cases += "    <testcase classname=\"" + escaped(which.group) + "\" name=\"" + escaped(which.id) + "\">";
        cases += fails         ? "<failure message=\"" + escaped(which.harm) + "\">" + why + "</failure>"
                 : is_cut      ? "<error message=\"" + why + "\"/>"
                 : is_skipped  ? "<skipped message=\"" + why + "\"/>"
                 : why.empty() ? std::string{}
                               : "<system-out>" + escaped(name_of(each.found.how)) + ": " + why + "</system-out>";
        cases += "</testcase>\n";
    }
    std::string const text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"" +
                             escaped(unit) + "\" tests=\"" + std::to_string(all.size()) + "\" failures=\"" +
                             std::to_string(failures) + "\" skipped=\"" + std::to_string(skipped) + "\" errors=\"" +
                             std::to_string(errors) + "\">\n" + cases + "  </testsuite>\n</testsuites>\n";
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file{open_stream(path, "w"), &std::fclose};
    bool const is_written = file and std::fwrite(text.data(), 1, text.size(), file.get()) == text.size() and
                            std::fclose(file.release()) == 0;
    if (not is_written) {
        throw ended{exit_status::port, "--junit " + path + ": " + std::strerror(errno)};
    }
}

} // namespace tool

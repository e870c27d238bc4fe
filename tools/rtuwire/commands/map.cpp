// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Finds which addresses a unit has: as many at once as it answers, in halves what it refuses, one alone where that is
// refused, too. It only reads.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "commands/commands.hpp"
#include "line/end_wish.hpp"
#include "line/left_alone.hpp"
#include "line/line_words.hpp"
#include "line/map_file.hpp"
#include "line/map_log.hpp"
#include "line/map_words.hpp"
#include "line/open_line.hpp"
#include "line/register_reader.hpp"
#include "line/who_is_it.hpp"
#include "motion/fed_drive.hpp"
#include "output/plain_text.hpp"
#include "output/progress.hpp"

namespace tool {

namespace {

using rtuwire::errc;

/// How many addresses a unit is asked for at once, by what it answered so far.
class window {
public:
    explicit window(unsigned most) : all_{most}, most_{most}, size_{most} {}

    [[nodiscard]] unsigned size() const { return size_; }

    void take(unsigned first, unsigned count)
    {
        singles_ = count > 1 ? 0 : singles_ + (refused_pairs_.contains(first - 1) and first == last_alone_ + 1 ? 1 : 0);
        last_alone_ = count > 1 ? nowhere : first;
        most_ = singles_ < enough_pairs ? most_ : 1; // it answers one register a request
        size_ = std::min(2 * count, most_);
    }
    /// Whether it is to be asked in smaller parts: one alone is what it is.
    [[nodiscard]] bool halve(unsigned first, unsigned count, errc why)
    {
        if (count == 2) {
            refused_pairs_.insert(first);
        }
        if (why == errc::illegal_data_value and singles_ < enough_pairs) { // too many at once, or it has none there
            most_ = count > 1 ? count / 2 : all_;
        }
        size_ = std::max(count / 2, 1U);
        return count > 1;
    }

private:
    static constexpr unsigned enough_pairs = 3, nowhere = 0x1'0000;

    unsigned all_; ///< that its function allows
    unsigned most_;
    unsigned size_;
    unsigned singles_{0};
    unsigned last_alone_{nowhere};
    std::set<unsigned> refused_pairs_{};
};

class mapping {
public:
    explicit mapping(choices const& chosen)
        : chosen_{chosen}, ranges_{ranges_in(chosen.words)}, unit_{unit_in(chosen.line)},
          log_{chosen.scan.resume_file, unit_.unit.byte()}, results_{chosen.form, true}, bar_{addresses()}
    {
        for (named_place const& each : unit_.names == nullptr ? std::vector<named_place>{} : unit_.names->places) {
            for (unsigned at = each.where.address; at < each.where.address + unsigned{each.where.size()}; ++at) {
                std::string& names = names_[{each.where.space, at}];
                names += (names.empty() ? "" : ", ") + each.where.name;
            }
        }
    }

    exit_status run()
    {
        if (not chosen_.file.empty() and std::filesystem::exists(std::filesystem::symlink_status(chosen_.file))) {
            refuse_word("-o " + chosen_.file + ": it is there already, and stays as it is; name a new file");
        }
        open_line line{chosen_.line};
        drive_catalog const* const drive = drive_there(line);
        tell_before(line, drive);
        if (not chosen_.scan.resume_file.empty()) {
            log_.begin(head_of(line));
        }
        note_signals();
        bool is_through = true;
        try {
            for (address_range const& each : ranges_) {
                is_through = is_through and walk(line, each, drive);
            }
        } catch (ended const&) { // what was found is told all the same
            finish();
            tell_end();
            throw;
        }
        finish();
        if (drive != nullptr) {
            leave(line, *drive);
        } else if (first_) {
            tell("what is there? " + reading_text(*first_));
        }
        tell_names(line);
        if (noted_signal() != 0) {
            tell_end();
            return static_cast<exit_status>(128 + noted_signal());
        }
        return is_through and here_ == 0 ? exit_status::differs : exit_status::done;
    }

private:
    void finish()
    {
        close_run();
        bar_.clear();
        results_.finish();
        write_file();
    }

    /// How long it may take, where that is more than a moment: a unit that has all of it answers as many at once as may be
    /// asked, and one that has every second of it refuses each pair before it answers one of them.
    void tell_before(open_line& line, drive_catalog const* drive)
    {
        constexpr double moment = 20, system = 0.002, refused = 1.5;
        constexpr std::size_t request = 8, exception = 5, largest = 255;
        line_setting const how = setting_in(chosen_.line);
        rtuwire::line_timing const wire{how.baud, how.format};
        auto const time_of = [&](std::size_t characters) {
            return system + 1e-6 * wire.characters(request + characters).microseconds +
                   2e-6 * wire.t3_5().microseconds + 1e-3 * chosen_.line.pause;
        };
        double quick = 0;
        double slow = 0;
        for (address_range const& each : ranges_) {
            double const many = each.last - each.first + 1;
            quick += many / most_of(each.space, drive) * time_of(largest);
            slow += many * refused * time_of(exception);
        }
        if (line.port().is_simulated() or slow < moment) {
            return;
        }
        auto const whole = [](double seconds) {
            return time_in_words(std::chrono::seconds{static_cast<long>(seconds) + 1});
        };
        tell(
            std::to_string(addresses()) + " addresses: from " + whole(quick) + " of a unit that has all of them to " +
            whole(slow) +
            " of one that has every second of them, and longer of one that is slow or silent to what it lacks. It only "
            "reads; Ctrl-C shows what was found so far" +
            (chosen_.scan.resume_file.empty() ? ", and with --resume FILE it goes on from there" : ""));
    }

    /// A register file of what has no name yet.
    void write_file()
    {
        if (not chosen_.file.empty()) {
            written_map const written = write_map(chosen_.file, found_);
            tell(written.registers == 0
                     ? chosen_.file + " is not written: nothing was found that has no name"
                     : chosen_.file + " has " + std::to_string(written.registers) + " registers" +
                           (written.beyond == 0 ? std::string{}
                                                : ", as many as a file may have; " + std::to_string(written.beyond) +
                                                      " more were found") +
                           ", each by its address: give them names, types, orders and units of measure (" +
                           device_help() + ')');
        }
    }

    void tell_end() const
    {
        std::fprintf(stderr, "ended after %zu of %zu addresses%s\n", done_, addresses(),
                     chosen_.scan.resume_file.empty() ? "; with --resume FILE the same command would go on from there"
                                                      : "; the same command goes on from there");
    }

    /// What a register file names, and what was mapped does not tell of.
    void tell_names(open_line& line)
    {
        std::size_t beyond = 0;
        for (named_place const& each : unit_.names == nullptr ? std::vector<named_place>{} : unit_.names->places) {
            beyond += std::ranges::none_of(ranges_, [&each](address_range const& range) {
                return range.space == each.where.space and range.first <= each.where.address and
                       each.where.address + each.where.size() - 1U <= range.last;
            });
        }
        if (beyond > 0) {
            tell(std::to_string(beyond) + " of the registers of " + unit_.names->file + " are beyond what was mapped");
        }
        if (unit_.names != nullptr and noted_signal() == 0) {
            tell_another_device(line, unit_);
        }
    }

    std::size_t addresses() const
    {
        std::size_t all = 0;
        for (address_range const& each : ranges_) {
            all += each.last - each.first + 1;
        }
        return all;
    }

    /// Not one that somebody said is none: a register file is no such word, where a drive would be fed for hours.
    bool is_asked_who() const
    {
        return unit_.drive != no_drive or (unit_.names != nullptr and chosen_.line.drive != no_drive);
    }

    /// Who is asked for hours is told what that does to it, where it is a drive. The drive, where it is known.
    drive_catalog const* drive_there(open_line& line) const
    {
        if (line.port().is_simulated() or not is_asked_who()) {
            return nullptr;
        }
        fed_unit const who = who_is_fed(line, unit_);
        ask_before_it_is_fed(who, unit_, chosen_.allowed, "a map", "map it?");
        return who.drive;
    }

    map_head head_of(open_line& line) const
    {
        map_head head{std::to_string(chosen_.line.baud) + ' ' + chosen_.line.format,
                      std::to_string(unit_.unit.byte()),
                      "that is not asked what it is",
                      {}};
        if (is_asked_who()) {
            identity_words who;
            errc const outcome = read_identity(line, unit_.unit, who);
            if (status_of(outcome) == exit_status::port) {
                throw ended{exit_status::port, line.port().failure()};
            }
            head.device = outcome == errc::none            ? who.vendor + ' ' + who.product + ' ' + who.revision
                          : rtuwire::is_exception(outcome) ? "that does not say what it is"
                                                           : "that does not answer what it is";
        }
        for (address_range const& each : ranges_) {
            head.range += (head.range.empty() ? "" : " ") + std::string{name_of(each.space)} + ':' +
                          std::to_string(each.first) + '-' + std::to_string(each.last);
        }
        return head;
    }

    unsigned most_of(register_space space, drive_catalog const* drive) const
    {
        auto const of_file = unit_.names == nullptr ? std::nullopt : unit_.names->max_registers;
        return space >= register_space::coil                           ? rtuwire::max_bit_quantity
               : drive != nullptr and space == register_space::holding ? drive->limits.read
                                                                       : of_file.value_or(rtuwire::max_read_quantity);
    }

    /// All addresses of a range; false where somebody ended it.
    bool walk(open_line& line, address_range const& range, drive_catalog const* drive)
    {
        window size{most_of(range.space, drive)};
        bool has_answered = false;
        for (unsigned at = range.first; at <= range.last;) {
            if (noted_signal() != 0 or not results_.is_open()) {
                return false;
            }
            if (found_address const before = log_.at(range.space, at); before.what != found_address::kind::unknown) {
                pass(range.space, at++, before);
                continue;
            }
            unsigned const count = unknown_from(range, at, size.size());
            bar_.show(done_, ", at " + std::string{name_of(range.space)} + ':' + std::to_string(at) + ", " +
                                 std::to_string(here_) + " found");
            held_words const held = read_run(line, unit_.unit, range.space, static_cast<std::uint16_t>(at),
                                             static_cast<std::uint16_t>(count));
            if (held.why == errc::illegal_function and not has_answered) {
                tell("the unit has no " + std::string{name_of(range.space)} + " addresses: " + held.failure);
                for (; at <= range.last; ++at) {
                    found_address const known = log_.at(range.space, at);
                    pass(range.space, at,
                         known.what == found_address::kind::unknown ? found_address{found_address::kind::none} : known);
                }
                return true;
            }
            refuse_lost(line, held, range.space, at, count);
            has_answered = has_answered or held.why == errc::none;
            if (held.why == errc::none) {
                size.take(at, count);
                keep(range.space, at, count, {found_address::kind::here});
            } else if (not size.halve(at, count, held.why)) {
                bool const is_none = held.why == errc::illegal_data_address or held.why == errc::illegal_data_value;
                keep(range.space, at, 1,
                     is_none ? found_address{found_address::kind::none}
                             : found_address{found_address::kind::other, plain_text(held.failure)});
                ++at;
                continue;
            }
            at += held.why == errc::none ? count : 0;
        }
        return true;
    }

    /// So many addresses, up to one that is known.
    unsigned unknown_from(address_range const& range, unsigned at, unsigned most) const
    {
        unsigned count = 1;
        while (count < most and at + count <= range.last and
               log_.at(range.space, at + count).what == found_address::kind::unknown) {
            ++count;
        }
        return count;
    }

    /// Ends the command where the port fails, the line echoes, or the unit is silent to what it has answered before. One that
    /// is silent to what it lacks is asked on.
    void refuse_lost(open_line& line, held_words const& held, register_space space, unsigned at, unsigned count)
    {
        if (status_of(held.why) == exit_status::port) {
            throw ended{exit_status::port, line.port().failure()};
        }
        if (held.why == errc::line_echo) {
            throw ended{exit_status::differs, held.failure};
        }
        if (held.why != errc::timed_out) {
            if (held.why == errc::none or rtuwire::is_exception(held.why)) {
                answered_ = {space, static_cast<std::uint16_t>(at), static_cast<std::uint16_t>(count)};
                is_there_ = true;
            }
            silent_ = 0;
            return;
        }
        constexpr unsigned patience = 3;
        if (++silent_ < patience and is_there_) {
            return;
        }
        silent_ = 0;
        rtuwire::read_device_identification const anything{rtuwire::identification_access::basic, 0};
        errc const again = answered_
                               ? read_run(line, unit_.unit, answered_->space, answered_->first, answered_->count).why
                               : line.ask(unit_.unit, anything).error();
        is_there_ = again != errc::timed_out;
        if (not is_there_) {
            throw ended{exit_status::no_answer, "unit " + std::to_string(unit_.unit.byte()) +
                                                    (answered_ ? " answers no more" : ": " + held.failure)};
        }
    }

    void keep(register_space space, unsigned first, unsigned count, found_address const& found)
    {
        log_.note(space, first, first + count - 1, found);
        for (unsigned each = first; found.what == found_address::kind::here and each < first + count; ++each) {
            pass(space, each, found);
        }
        if (found.what != found_address::kind::here) {
            pass(space, first, found);
        }
    }

    /// In rising order: addresses of a kind are a row.
    void pass(register_space space, unsigned address, found_address const& found)
    {
        ++done_;
        here_ += found.what == found_address::kind::here ? 1 : 0;
        auto const named = names_.find({space, address});
        std::string const names = named == names_.end() ? std::string{} : named->second;
        bool const goes_on = run_ and run_->where.space == space and run_->where.last + 1 == address and
                             run_->found == found and run_->names == names;
        if (goes_on) {
            run_->where.last = address;
            return;
        }
        close_run();
        run_ = {{space, address, address}, found, names};
    }

    void close_run()
    {
        bool const is_none = run_ and run_->found.what == found_address::kind::none;
        bool const is_shown = run_ and (not is_none or not run_->names.empty());
        if (run_ and run_->found.what == found_address::kind::here) {
            first_ = first_ ? first_ : run_->where;
            if (run_->names.empty()) {
                found_.push_back(run_->where);
            }
        }
        if (is_shown) {
            bar_.clear();
            record row{{"unit", std::int64_t{unit_.unit.byte()}},
                       {"space", std::string{name_of(run_->where.space)}},
                       {"first", std::int64_t{run_->where.first}},
                       {"last", std::int64_t{run_->where.last}},
                       {"count", std::int64_t{run_->where.last - run_->where.first + 1}}};
            if (unit_.names != nullptr) {
                row.add("register", run_->names);
            }
            results_.put(row.add("note", is_none ? "the unit has no such address" : run_->found.why), is_none);
        }
        run_.reset();
    }

    /// Where the form of a register file is told; as the program was called, without a line.
    std::string device_help() const
    {
        line_choices no_line;
        no_line.typed.program = chosen_.line.typed.program;
        return shown_command(no_line, "device --help");
    }

    /// What is next: one place in the forms that a value may have.
    std::string reading_text(address_range const& found) const
    {
        std::string const place = std::string{name_of(found.space)} + ':' + std::to_string(found.first);
        bool const has_forms = found.space < register_space::coil and found.last > found.first;
        std::string words = "read " + place;
        if (has_forms) {
            words = "read " + place + ":hex";
            for (char const* const form : {":i16", ":u32", ":u32:cdab", ":f32", ":f32:cdab"}) {
                words += ' ' + place + form;
            }
        }
        return '`' + shown_command(chosen_.line, unit_.unit, words) + "` shows the first" +
               (has_forms ? " in several forms" : "") +
               "; a register file gives all of it names, types and units: " + device_help();
    }

    void tell(std::string const& text)
    {
        bar_.clear();
        std::fprintf(stderr, "note: %s\n", plain_text(text).c_str());
    }

    void leave(open_line& line, drive_catalog const& drive)
    {
        left_alone left;
        left.note(line, unit_.unit, drive, shown_command(chosen_.line, unit_.unit, "--write reset"));
        if (std::string const sentence = left.sentence(); not sentence.empty()) {
            tell(sentence);
        }
    }

    struct asked_run {
        register_space space;
        std::uint16_t first;
        std::uint16_t count;
    };
    struct run_of_addresses {
        address_range where;
        found_address found;
        std::string names; ///< by a register file
    };

    choices const& chosen_;
    std::vector<address_range> ranges_;
    named_unit unit_;
    map_log log_;
    std::map<std::pair<register_space, unsigned>, std::string> names_{};
    output results_;
    progress bar_;
    std::optional<run_of_addresses> run_{};
    std::optional<address_range> first_{}; ///< that the unit has
    std::vector<address_range> found_{};   ///< that it has, and no register file names
    std::optional<asked_run> answered_{};  ///< the last that the unit answered
    std::size_t done_{0};
    std::size_t here_{0};
    unsigned silent_{0};
    bool is_there_{false};
};

} // namespace

exit_status run_map(choices const& chosen) { return mapping{chosen}.run(); }

} // namespace tool

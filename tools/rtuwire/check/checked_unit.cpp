// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "check/checked_unit.hpp"

#include <algorithm>
#include <array>

#include "exit_status.hpp"
#include "frame/hex_text.hpp"
#include "words/time_words.hpp"
#include "words/words.hpp"

namespace tool {

namespace {

constexpr unsigned tries = 6;
constexpr std::uint16_t first_scratch_word = 0x5A00;
constexpr line_time quiet_silence{1'000'000};

std::byte low(unsigned value) { return static_cast<std::byte>(value & 0xFFU); }
std::byte high(unsigned value) { return static_cast<std::byte>(value >> 8U & 0xFFU); }

/// "f08": what a clause of function 08 needs.
std::string need_of(unsigned function) { return "f" + hex_of(line_bytes{low(function)}); }

/// Without its high bit, or with a second byte, too: one clause judges that.
bool is_exception(line_bytes const& came, unsigned code)
{
    bool const is_long = came.size() == 6 and came[1] >= std::byte{0x80};
    return has_right_crc(came) and (came.size() == 5 or is_long) and came[2] == low(code);
}

} // namespace

bool is_refusal(line_bytes const& came, line_bytes const& asked)
{
    bool const has_high_bit = came.size() > 1 and came[1] == (asked[1] | std::byte{0x80});
    // Without it, it has the form of no normal answer: function, code.
    bool const lacks_it = came.size() == 5 and came[1] == asked[1] and stated_size(came, asked) != 5U;
    return has_high_bit or (lacks_it and has_right_crc(came));
}

namespace {

/// "100-107", "100..107", "100": the first, and how many. Refuses others.
std::pair<std::uint16_t, unsigned> range_in(std::string const& word, std::string const& option)
{
    std::size_t const dots = word.find(".."), dash = word.find('-');
    std::size_t const at = std::min({dots, dash, word.size()});
    std::size_t const behind = at == word.size() ? at : at + (at == dots ? 2 : 1);
    auto const first = word_number(std::string_view{word}.substr(0, at));
    auto const last = at == word.size() ? first : word_number(std::string_view{word}.substr(behind));
    if (not first or not last or *last < *first) {
        refuse_word(option + ": '" + word + "' is no range of addresses such as 100-107");
    }
    return {*first, *last - *first + 1U};
}

} // namespace

scratch_places scratch_in(check_choices const& how)
{
    scratch_places all;
    if (not how.scratch.empty()) {
        auto const [first, count] = range_in(how.scratch, "--scratch");
        if (count < 8 or count > 100) {
            refuse_word("--scratch " + how.scratch + ": " + std::to_string(count) +
                        (count == 1 ? " register" : " registers") + "; the clauses need 8 to 100");
        }
        all.first = first;
        all.count = count;
    }
    if (not how.scratch_coils.empty()) {
        auto const [first, count] = range_in(how.scratch_coils, "--scratch-coils");
        if (count != 16) {
            refuse_word("--scratch-coils " + how.scratch_coils + ": the clauses need 16 of them");
        }
        all.first_coil = first;
    }
    return all;
}

line_answer checked_unit::ask(std::vector<sent_piece> const& pieces, std::string_view clause)
{
    line_answer answer = line_.ask(pieces);
    line_bytes const asked = bytes_of(pieces);
    longest_answer_ = std::max(longest_answer_, answer.took);
    longest_gap_ = std::max(longest_gap_, answer.largest_gap);
    bool const is_plain = pieces.size() == 1 and has_right_crc(asked) and asked[0] == std::byte{where_.unit} and
                          asked[1] > std::byte{0} and asked[1] < std::byte{0x80};
    if (is_plain) {
        exchanges_.push_back({asked, answer, clause});
    }
    return answer;
}

bool checked_unit::feed_before(line_time next)
{
    if (not longest_pause_ or not(where_.holding or where_.input) or line_.since_answered() + next <= *longest_pause_) {
        return true;
    }
    line_bytes const read = plain_read(where_);
    return is_allowed("OK1", line_.ask(read).bytes, read, {}, where_);
}

line_answer checked_unit::ask_fed(std::vector<sent_piece> const& pieces)
{
    static_cast<void>(feed_before(line_.time_without_answer(pieces, line_.longest_wait())));
    return line_.ask(pieces);
}

namespace {

/// "U 03" of "U 03 R 00 01 CRC": a question and its answer have the same.
std::string_view unit_and_function(std::string_view step)
{
    return step.substr(0, step.find(' ', std::min(step.find(' '), step.size() - 1) + 1));
}

} // namespace

/// That they take without an answer.
line_time checked_unit::time_of(std::span<std::string_view const> steps) const
{
    line_time all{0};
    for (std::string_view const each : steps) {
        all += each == "READ" ? line_time{0} : line_.time_without_answer(pieces_of(each, where_), line_.longest_wait());
    }
    return all;
}

std::span<std::string_view const> checked_unit::run_of(std::span<std::string_view const> steps) const
{
    auto const read = std::ranges::find(steps, "READ");
    if (read == steps.end()) {
        return steps.first(1);
    }
    auto const judged = steps.first(static_cast<std::size_t>(read - steps.begin()) + 1);
    if (not longest_pause_ or time_of(judged) <= *longest_pause_) {
        return judged;
    }
    std::size_t same = 1;
    while (unit_and_function(judged[same]) == unit_and_function(judged[0])) {
        ++same;
    }
    return judged.first(same);
}

/// Without a request that the unit answers, where it answers those that it has to.
line_time checked_unit::longest_pause_of(clause const& which) const
{
    line_time const once = line_.time_without_answer({}, line_.longest_wait());
    if (not which.sends.starts_with('@')) {
        line_time longest = which.state == clause_state::quiet ? quiet_silence : line_time{0};
        std::vector<std::string_view> const steps = steps_of(which.sends);
        for (std::span<std::string_view const> left{steps}; not left.empty();) {
            auto const run = run_of(left);
            longest = std::max(longest, time_of(run));
            left = left.subspan(run.size());
        }
        return longest;
    }
    if (which.group == "hostile") {
        line_time const sent = which.id == "H06"
                                   ? line_time{3'000'000}
                                   : rtuwire::to_chrono(line_.wire().characters(which.id == "H04" ? 1'000 : 300));
        return sent + std::max(once, usual_wait());
    }
    return which.group == "08" ? 2 * once : once; // between two looks at a counter
}

std::optional<obstacle> checked_unit::pause_obstacle(clause const& which) const
{
    if (not longest_pause_) {
        return std::nullopt;
    }
    try {
        line_time const pause = longest_pause_of(which) + known_silence;
        return pause <= *longest_pause_
                   ? std::nullopt
                   : std::optional{obstacle{false, "for up to " + seconds_text(pause) +
                                                       " the unit hears no request that it answers, and " +
                                                       may_pause_}};
    } catch (unknown_place const&) {
        return std::nullopt; // whoever judges it says that
    }
}

void checked_unit::forget(std::string_view clause)
{
    std::erase_if(exchanges_, [clause](kept_exchange_of_check const& each) { return each.clause == clause; });
}

bool checked_unit::reads(std::string_view words, std::size_t data)
{
    line_bytes const asked = bytes_of(pieces_of(words, where_));
    line_bytes const came = ask_fed({sent_piece{.bytes = asked}}).bytes;
    return is_normal(came, asked) and came.size() == 5 + data;
}

bool checked_unit::is_there(unsigned function, std::uint16_t address)
{
    line_bytes const asked =
        framed({std::byte{where_.unit}, low(function), high(address), low(address), std::byte{0}, std::byte{1}});
    line_bytes const came = ask_fed({sent_piece{.bytes = asked}}).bytes;
    return is_normal(came, asked) and came.size() == (function < 3 ? 6U : 7U);
}

bool checked_unit::is_missing(unsigned function, std::uint16_t address)
{
    line_bytes const asked =
        framed({std::byte{where_.unit}, low(function), high(address), low(address), std::byte{0}, std::byte{1}});
    return is_exception(ask_fed({sent_piece{.bytes = asked}}).bytes, 2);
}

/// What the request before did to the unit is not this one's, and one lost frame is no silence.
line_bytes checked_unit::ask_from_known(std::vector<sent_piece> const& pieces)
{
    if (where_.holding or where_.input) {
        static_cast<void>(establish(clause_state::known));
    }
    line_bytes const came = ask_fed(pieces).bytes;
    return came.empty() ? ask_fed(pieces).bytes : came;
}

/// A place that most devices have one of; nothing where none of them answers.
std::optional<std::uint16_t> checked_unit::first_readable(unsigned function)
{
    constexpr std::uint16_t usual[]{0, 1, 100, 1'000, 3'201, 4'000, 40'000, 40'001, 50'000, 0x1000, 0x2000, 0x6000};
    for (std::uint16_t const each : usual) {
        line_bytes const asked =
            framed({std::byte{where_.unit}, low(function), high(each), low(each), std::byte{0}, std::byte{1}});
        static_cast<void>(feed_before(line_.time_without_answer({}, line_.longest_wait())));
        line_bytes const came = ask({sent_piece{.bytes = asked}}, "discovery").bytes;
        if (is_normal(came, asked)) {
            functions_.insert(function);
            return each;
        }
        if (came.empty() or is_exception(came, 1)) {
            return std::nullopt; // it has no such function
        }
        functions_.insert(function);
    }
    return std::nullopt;
}

/// The first address behind one that is there, that is not: by halves, behind a jump that finds one.
std::optional<std::uint16_t> checked_unit::first_missing(unsigned function, std::uint16_t there)
{
    unsigned has = there, lacks = 0x1'0000;
    for (unsigned step = 1; has + step < 0x1'0000; step *= 2) {
        if (is_there(function, static_cast<std::uint16_t>(has + step))) {
            has += step;
        } else {
            lacks = has + step;
            break;
        }
    }
    if (lacks == 0x1'0000) {
        return std::nullopt;
    }
    while (lacks - has > 1) {
        unsigned const middle = has + (lacks - has) / 2;
        (is_there(function, static_cast<std::uint16_t>(middle)) ? has : lacks) = middle;
    }
    // What is misunderstood may be there: clauses write to an address that is said to be missing.
    auto const found = static_cast<std::uint16_t>(lacks);
    return is_missing(function, found) ? std::optional{found} : std::nullopt;
}

void checked_unit::find_crc_place()
{
    for (unsigned address = 0; address < 0x1'0000; ++address) {
        line_bytes const crc = crc_of(line_bytes{std::byte{where_.unit}, std::byte{3}, high(address), low(address)});
        unsigned const quantity = std::to_integer<unsigned>(crc[0]) << 8U | std::to_integer<unsigned>(crc[1]);
        if (quantity > 0 and quantity <= 125 and (not where_.crc_address or quantity < where_.crc_quantity)) {
            where_.crc_address = static_cast<std::uint16_t>(address);
            where_.crc_quantity = static_cast<std::uint16_t>(quantity);
        }
    }
}

void checked_unit::find_functions()
{
    struct harmless {
        unsigned function;
        std::string_view words;
    };
    // Writing functions are asked where there is a place for them.
    constexpr harmless reading[]{{0x08, "U 08 00 00 A5 5A CRC"}, {0x18, "U 18 R CRC"}, {0x2B, "U 2B 0E 01 00 CRC"}};
    for (auto const& [function, words] : reading) {
        if (not is_needed(need_of(function)) or (function == 0x18 and not where_.holding)) {
            continue;
        }
        line_bytes const came = ask_from_known(pieces_of(words, where_));
        if (not came.empty() and not is_exception(came, 1)) {
            functions_.insert(function);
        }
        names_singly_ =
            function == 0x2B ? came.size() > 5 and has_right_crc(came) and came[4] >= std::byte{0x81} : names_singly_;
    }
    // Clearing and waking only where that is allowed; silencing is the clause's that judges it.
    constexpr unsigned counting[]{0x0B, 0x0C, 0x0D, 0x0E, 0x0F}, disturbing[]{0x0A, 0x01};
    std::vector<unsigned> subfunctions{std::begin(counting), std::end(counting)};
    if (how_.may_disrupt) {
        subfunctions.insert(subfunctions.end(), std::begin(disturbing), std::end(disturbing));
    }
    for (unsigned const sub : has_function(0x08) ? subfunctions : std::vector<unsigned>{}) {
        line_bytes const asked =
            framed({std::byte{where_.unit}, std::byte{8}, std::byte{0}, low(sub), std::byte{0}, std::byte{0}});
        if (is_normal(ask_from_known({sent_piece{.bytes = asked}}), asked)) {
            subfunctions_.insert(sub);
        }
    }
}

/// An address at which nobody answers a read.
void checked_unit::find_other()
{
    constexpr std::uint8_t candidates[]{247, 246, 199, 133};
    for (std::uint8_t const each : candidates) {
        where_.other = each;
        line_bytes read = plain_read(where_);
        read.front() = std::byte{each};
        read.resize(read.size() - 2);
        if (each != where_.unit and ask_fed({sent_piece{.bytes = framed(read)}}).bytes.empty()) {
            return;
        }
    }
    where_.other = where_.unit == 247 ? 246 : 247; // it answers for all: a clause says so
}

/// The data of a read of the scratch places; ends the command where there are none.
line_bytes checked_unit::scratch_data(unsigned function, std::uint16_t first, unsigned count, std::size_t size,
                                      std::string const& option)
{
    line_bytes const asked =
        framed({std::byte{where_.unit}, low(function), high(first), low(first), std::byte{0}, low(count)});
    line_bytes const came = line_.ask(asked).bytes;
    if (not is_normal(came, asked) or came.size() != 5 + size) {
        throw ended{exit_status::differs, option + ": unit " + std::to_string(where_.unit) +
                                              " does not read them by function 0" + std::to_string(function) + " (" +
                                              (came.empty() ? "no response" : hex_of(came)) + "); nothing was written"};
    }
    return {came.begin() + 3, came.end() - 2};
}

/// Each writes what stands there. By 16, 06, 15 and 05 the known state is made, too.
void checked_unit::find_writing(std::span<line_bytes const> pdus)
{
    for (line_bytes const& each : pdus) {
        unsigned const function = std::to_integer<unsigned>(each[0]);
        if ((function == 0x16 or function == 0x17) and not is_needed(need_of(function))) {
            continue;
        }
        line_bytes frame{std::byte{where_.unit}};
        frame.insert(frame.end(), each.begin(), each.end());
        line_bytes const answer = ask_from_known({sent_piece{.bytes = framed(frame)}});
        if (not answer.empty() and not is_exception(answer, 1)) {
            functions_.insert(function);
        }
    }
}

/// All of it is read before any of it is written.
void checked_unit::find_scratch(scratch_places const& places)
{
    line_bytes words, bits;
    if (places.first) {
        words = scratch_data(3, *places.first, places.count, 2 * places.count, "--scratch " + how_.scratch);
    }
    if (places.first_coil) {
        bits = scratch_data(1, *places.first_coil, 16, 2, "--scratch-coils " + how_.scratch_coils);
    }
    where_.scratch = places.first;
    where_.scratch_count = places.count;
    where_.scratch_coil = places.first_coil;
    if (places.first) {
        for (std::size_t i = 0; i < words.size(); i += 2) {
            words_before_.push_back(static_cast<std::uint16_t>(std::to_integer<unsigned>(words[i]) << 8U |
                                                               std::to_integer<unsigned>(words[i + 1])));
        }
        std::byte const to_high = high(*places.first), to_low = low(*places.first), none{0}, all{0xFF};
        line_bytes sixteen{std::byte{0x10}, to_high, to_low, none, low(places.count), low(2 * places.count)};
        sixteen.insert(sixteen.end(), words.begin(), words.end());
        line_bytes const pdus[]{sixteen,
                                {std::byte{6}, to_high, to_low, words[0], words[1]},
                                {std::byte{0x16}, to_high, to_low, all, all, none, none},
                                {std::byte{0x17}, to_high, to_low, none, std::byte{1}, to_high, to_low, none,
                                 std::byte{1}, std::byte{2}, words[0], words[1]}};
        find_writing(pdus);
        unsigned const behind = *places.first + places.count;
        is_end_known_ = behind <= 0xFFFFU and is_missing(3, static_cast<std::uint16_t>(behind));
    }
    if (places.first_coil) {
        coils_before_ =
            static_cast<std::uint16_t>(std::to_integer<unsigned>(bits[1]) << 8U | std::to_integer<unsigned>(bits[0]));
        std::byte const to_high = high(*places.first_coil), to_low = low(*places.first_coil), none{0};
        bool const is_on = (*coils_before_ & 1U) != 0;
        line_bytes const pdus[]{{std::byte{0x0F}, to_high, to_low, none, std::byte{16}, std::byte{2}, bits[0], bits[1]},
                                {std::byte{5}, to_high, to_low, is_on ? std::byte{0xFF} : none, none}};
        find_writing(pdus);
    }
}

bool checked_unit::is_needed(std::string_view need) const
{
    bool const is_claimed =
        std::ranges::any_of(claimed_, [need](unsigned function) { return need_of(function) == need; });
    return std::ranges::any_of(wanted_, [need, is_claimed](clause const* each) {
        bool const asks_for_claims = each->needs.find("claimed") != each->needs.npos;
        return each->needs.find(need) != each->needs.npos or (asks_for_claims and is_claimed);
    });
}

bool checked_unit::discover(std::span<clause const* const> wanted, scratch_places const& scratch)
{
    wanted_ = wanted;
    line_.wait_for_quiet(known_silence);
    auto const place_of = [this](unsigned function) {
        if (not how_.readable) {
            return first_readable(function);
        }
        bool const is_one = is_there(function, *how_.readable);
        if (is_one) {
            functions_.insert(function);
        }
        return is_one ? how_.readable : first_readable(function);
    };
    where_.holding = place_of(3);
    where_.input = place_of(4);
    where_.coil = first_readable(1);
    where_.discrete = first_readable(2);
    if (not where_.holding and where_.input) {
        where_.read_function = std::byte{4};
    }
    for (unsigned const count : {2U, 8U, 16U, 125U}) {
        where_.readable = where_.holding and reads("U 03 R 00 B(" + std::to_string(count) + ") CRC", 2 * count)
                              ? count
                              : where_.readable;
    }
    if (functions_.empty()) {
        return false;
    }
    if (not where_.holding and not where_.input) {
        throw ended{exit_status::differs, "unit " + std::to_string(where_.unit) +
                                              ": no register was found that can be read, and each clause begins with a "
                                              "read that is answered; --readable names one"};
    }
    find_other();
    find_functions();
    find_crc_place();
    if (where_.holding and is_needed("XA")) {
        where_.behind_holding = first_missing(3, *where_.holding);
    }
    if (where_.coil and is_needed("XC")) {
        where_.behind_coil = first_missing(1, *where_.coil);
    }
    constexpr std::string_view writing[]{"scratch", "f05", "f06", "f0F", "f10", "f16", "f17"};
    if (std::ranges::any_of(writing, [this](std::string_view need) { return is_needed(need); })) {
        find_scratch(scratch);
    }
    return true;
}

std::optional<obstacle> checked_unit::obstacle_of(std::string_view need) const
{
    using found = std::optional<obstacle>;
    auto const known = [](bool is_there, std::string_view what) {
        return is_there ? found{} : found{{true, std::string{what}}};
    };
    auto const allowed = [](bool is_so, std::string_view what) {
        return is_so ? found{} : found{{false, std::string{what}}};
    };
    line_bytes const read = where_.holding or where_.input ? plain_read(where_) : line_bytes(8);
    if (need == "R") {
        // A clause that names a holding register itself does not apply without one.
        return allowed(where_.holding or where_.input, "no register was found that can be read; --readable names one");
    }
    if (need == "scratch") {
        return allowed(where_.scratch.has_value() or where_.scratch_coil.has_value(),
                       "it writes: --scratch names registers that may be changed");
    }
    if (need == "alone") {
        return allowed(how_.is_alone, "it writes to another address: --alone says that nobody else is on the line");
    }
    if (need == "disruptive") {
        return allowed(how_.may_disrupt, "it may disturb the unit: --disruptive allows it");
    }
    if (need == "hostile") {
        return allowed(how_.hostile > 0, "it sends what no client would: --hostile allows it");
    }
    if (need == "claimed") {
        return allowed(not claimed_.empty(), "nobody says which functions it has: --profile does");
    }
    if (need == "wire") {
        return allowed(line_.has_wire(), "this port has no wire whose silences are known");
    }
    if (need == "two") {
        return known(where_.readable >= 2, "no two registers can be read together");
    }
    if (need == "unknown") {
        return {}; // the clause's own answers say that
    }
    if (need == "exception") {
        bool const came =
            std::ranges::any_of(exchanges_, [](auto const& each) { return is_refusal(each.answer.bytes, each.asked); });
        return known(came, "no exception came");
    }
    if (need == "single") {
        return known(names_singly_, "the unit does not name single objects by function 43/14");
    }
    if (need == "end") {
        return known(is_end_known_, "a register stands behind the scratch registers");
    }
    if (need == "crc-differs") {
        return known(read[6] != read[7], "both bytes of the CRC are the same");
    }
    if (need == "crc-no-constant") {
        return known(not(read[6] == read[7] and (read[6] == std::byte{0} or read[6] == std::byte{0xFF})),
                     "the right CRC is a constant");
    }
    if (need == "RI" or need == "RC" or need == "RD" or need == "XA" or need == "XC") {
        auto const& place = need == "RI"   ? where_.input
                            : need == "RC" ? where_.coil
                            : need == "RD" ? where_.discrete
                            : need == "XA" ? where_.behind_holding
                                           : where_.behind_coil;
        return known(place.has_value(), need == "XA" or need == "XC" ? "no address was found that is not there"
                                                                     : "none was found that can be read");
    }
    unsigned const number = static_cast<unsigned>(std::stoul(std::string{need.substr(1)}, nullptr, 16));
    if (need.front() == 's') {
        return known(subfunctions_.contains(number), "the unit does not have that sub-function");
    }
    if (has_function(number)) {
        return {};
    }
    constexpr unsigned words[]{0x06, 0x10, 0x16, 0x17}, coils[]{0x05, 0x0F};
    bool const is_unknown = (std::ranges::count(words, number) > 0 and not where_.scratch) or
                            (std::ranges::count(coils, number) > 0 and not where_.scratch_coil);
    return is_unknown ? found{{false, "whether the unit has function " + std::to_string(number) +
                                          " is looked for in what --scratch or --scratch-coils names"}}
                      : found{{true, "the unit does not have function " + std::to_string(number)}};
}

/// Over Modbus TCP only whole frames to the unit alone go, as a message each.
bool checked_unit::needs_serial_line(clause const& which) const
{
    constexpr std::string_view whole_groups[]{"link", "hostile", "08"}; // 08 is of serial lines (AP 6.8)
    bool const is_first = which.id == "L01";
    if (not is_first and std::ranges::count(whole_groups, which.group) > 0) {
        return true;
    }
    return std::ranges::any_of(steps_of(which.sends), [&](std::string_view step) {
        if (step.starts_with('@')) {
            return false;
        }
        std::vector<sent_piece> pieces;
        try {
            pieces = pieces_of(step, where_);
        } catch (unknown_place const&) {
            return false; // whoever judges it says that
        }
        line_bytes const& frame = pieces.front().bytes;
        return pieces.size() != 1 or frame.size() < rtuwire::min_adu_size or frame.size() > rtuwire::max_adu_size or
               not has_right_crc(frame) or frame[0] != std::byte{where_.unit};
    });
}

std::optional<obstacle> checked_unit::why_not_asked(clause const& which) const
{
    std::string_view rest = which.needs;
    while (not rest.empty()) {
        std::size_t const end = std::min(rest.find(' '), rest.size());
        if (auto const why = obstacle_of(rest.substr(0, end))) {
            return why;
        }
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (which.state == clause_state::words and not where_.scratch) {
        return obstacle{false, "it writes: --scratch names registers that may be changed"};
    }
    if (which.state == clause_state::coils and not where_.scratch_coil) {
        return obstacle{false, "it writes: --scratch-coils names 16 coils that may be changed"};
    }
    if (auto const why = pause_obstacle(which)) {
        return why;
    }
    if (line_.has_numbers() and needs_serial_line(which)) {
        return obstacle{true, "it needs a serial line: Modbus TCP has no CRC, no silence and no broadcast"};
    }
    return std::nullopt;
}

bool checked_unit::holds_words(std::vector<std::uint16_t> const& values)
{
    std::uint16_t const first = *where_.scratch;
    line_bytes const asked = framed({std::byte{where_.unit}, std::byte{3}, high(first), low(first), std::byte{0},
                                     low(static_cast<unsigned>(values.size()))});
    line_bytes due{asked[0], asked[1], low(static_cast<unsigned>(2 * values.size()))};
    for (std::uint16_t const each : values) {
        due.push_back(high(each));
        due.push_back(low(each));
    }
    return line_.ask(asked).bytes == framed(due);
}

bool checked_unit::write_words(std::vector<std::uint16_t> const& values)
{
    std::uint16_t const first = *where_.scratch;
    bool is_written = true;
    if (has_function(0x10)) {
        line_bytes frame{std::byte{where_.unit},
                         std::byte{0x10},
                         high(first),
                         low(first),
                         std::byte{0},
                         low(static_cast<unsigned>(values.size())),
                         low(static_cast<unsigned>(2 * values.size()))};
        for (std::uint16_t const each : values) {
            frame.push_back(high(each));
            frame.push_back(low(each));
        }
        line_bytes const asked = framed(frame);
        is_written = is_normal(line_.ask(asked).bytes, asked);
    } else {
        for (std::size_t i = 0; i < values.size(); ++i) {
            unsigned const at = first + static_cast<unsigned>(i);
            line_bytes const asked =
                framed({std::byte{where_.unit}, std::byte{6}, high(at), low(at), high(values[i]), low(values[i])});
            is_written = is_normal(line_.ask(asked).bytes, asked) and is_written;
        }
    }
    return holds_words(values) and is_written;
}

bool checked_unit::holds_coils(std::uint16_t bits)
{
    std::uint16_t const first = *where_.scratch_coil;
    line_bytes const asked =
        framed({std::byte{where_.unit}, std::byte{1}, high(first), low(first), std::byte{0}, std::byte{16}});
    return line_.ask(asked).bytes == framed({asked[0], asked[1], std::byte{2}, low(bits), high(bits)});
}

bool checked_unit::write_coils(std::uint16_t bits)
{
    std::uint16_t const first = *where_.scratch_coil;
    if (has_function(0x0F)) {
        static_cast<void>(line_.ask(framed({std::byte{where_.unit}, std::byte{0x0F}, high(first), low(first),
                                            std::byte{0}, std::byte{16}, std::byte{2}, low(bits), high(bits)})));
    } else {
        for (unsigned i = 0; i < 16; ++i) {
            unsigned const at = first + i;
            static_cast<void>(
                line_.ask(framed({std::byte{where_.unit}, std::byte{5}, high(at), low(at),
                                  (bits >> i & 1U) != 0 ? std::byte{0xFF} : std::byte{0}, std::byte{0}})));
        }
    }
    return holds_coils(bits);
}

bool checked_unit::establish(clause_state state)
{
    if (state == clause_state::last) {
        return true;
    }
    if (state == clause_state::quiet) {
        static_cast<void>(feed_before(quiet_silence));
    }
    line_.wait_for_quiet(state == clause_state::quiet ? quiet_silence : std::max(known_silence, line_.silence()));
    if (state == clause_state::quiet) {
        return true;
    }
    line_bytes const read = plain_read(where_);
    bool is_known = false;
    // Once is enough for a unit that all tries have lost already.
    for (unsigned i = is_lost_ ? tries - 1 : 0; i < tries and not is_known; ++i) {
        line_bytes const came = line_.ask(read).bytes;
        is_known = is_allowed("OK1", came, read, {}, where_);
        if (not is_known and i + 1 < tries) {
            line_.wait_for_quiet(line_.longest_wait());
        }
    }
    is_lost_ = not is_known;
    if (is_lost_) {
        return false;
    }
    if (state == clause_state::words) {
        std::vector<std::uint16_t> values(where_.scratch ? where_.scratch_count : 0);
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<std::uint16_t>(first_scratch_word + i);
        }
        return where_.scratch and write_words(values);
    }
    return state != clause_state::coils or (where_.scratch_coil and write_coils(0));
}

std::string checked_unit::put_back()
{
    std::string what;
    line_.wait_for_quiet(known_silence);
    // After a clause that a signal cut, the unit may need a moment.
    auto const held = [&](auto const& write) {
        for (unsigned i = 0; i < 3; ++i) {
            if (write()) {
                return true;
            }
            line_.wait_for_quiet(line_.longest_wait());
        }
        return false;
    };
    if (where_.scratch and not held([&] { return holds_words(words_before_) or write_words(words_before_); })) {
        what += "registers " + how_.scratch + " (they held";
        for (std::uint16_t const each : words_before_) {
            what += ' ' + std::to_string(each);
        }
        what += ')';
    }
    if (where_.scratch_coil and not held([&] { return holds_coils(*coils_before_) or write_coils(*coils_before_); })) {
        what += (what.empty() ? "coils " : ", coils ") + how_.scratch_coils;
    }
    return what;
}

} // namespace tool

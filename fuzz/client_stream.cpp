// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Any bytes in any chunking and any pauses to a client that keeps asking, by any function: every request ends by its
// deadline, is sent no more often than it may be, and waits for its unit no longer than rules 17 to 19 of
// docs/engine-rules.md say.
#include <array>

#include <rtuwire/rtuwire.hpp>

#include "input.hpp"

#include "../tests/support/asking.hpp"

using namespace rtuwire;
using namespace rtuwire::detail;
using fuzz::require;

namespace {

constexpr line_timing line{19'200, character_format::even_8_1};
constexpr unsigned retries = 2, busy_retries = 3;
constexpr unit_id unit{1};

// What stands behind the code of a request, in the forms that there are.
constexpr auto address = "04 DE"_hex;
constexpr auto two_words = "0C 81 00 01"_hex;
constexpr auto coil = "00 AC FF 00"_hex;
constexpr auto identification = "0E 01 00"_hex;
constexpr auto coils = "00 13 00 03 01 05"_hex;
constexpr auto masks = "00 04 00 F2 00 25"_hex;
constexpr auto registers = "23 29 00 01 02 00 0F"_hex;
constexpr auto run = "07 06 00 04 00 01 00 02"_hex;
constexpr auto run_of_values = "09 06 00 04 00 07 00 01 06 AF"_hex;
constexpr auto both = "0C 81 00 01 21 35 00 01 02 00 0F"_hex;

/// A request of a function: the first form that it decodes.
template <typename Function> fixed_buffer<max_adu_size> request_of()
{
    fixed_buffer<max_adu_size> found;
    auto const look = [&](byte_view fields) {
        std::array<std::byte, max_pdu_size> pdu{static_cast<std::byte>(Function::code)};
        for (std::size_t i = 0; i < fields.size(); ++i) {
            pdu[1 + i] = fields[i];
        }
        auto const value = Function::decode(byte_view{pdu}.first(1 + fields.size()));
        if (found.empty() and value) {
            found.resize(encode_into(found.storage(), unit, *value)->size());
        }
    };
    look({});
    look(address);
    look(two_words);
    look(coil);
    look(identification);
    look(coils);
    look(masks);
    look(registers);
    look(run);
    look(run_of_values);
    look(both);
    require(not found.empty());
    return found;
}

/// One request of each function in the list.
template <typename... Functions> auto requests_of(function_list<Functions...>)
{
    return std::array{request_of<Functions>()...};
}

/// What the sendings of one request leave behind, at most.
class debt {
public:
    debt(client_options const& options, byte_view request) : late_{options.late_response}
    {
        length_hint const response = longest_response(request);
        each_ = options.response_timeout + line.characters(response.size()) + late_;
        each_ = response.is_final() ? each_ : each_ + line.frame_end();
    }

    void forget() { sendings_ = 0; }
    void note_sent(instant at)
    {
        first_ = sendings_ == 0 ? at : first_;
        last_ = at;
        ++sendings_;
        require(sendings_ <= 1 + retries + busy_retries);
    }

    /// When its unit may be asked again at the latest, where this was the outcome at `now`: one response has come, and
    /// each other may take as long as all did so far; or none has, and each takes its time behind the last.
    instant end(bool has_response, instant now) const
    {
        if (sendings_ == 0) {
            return now;
        }
        return has_response ? now + ((now - first_) + late_) * (sendings_ - 1) : last_ + each_ * sendings_;
    }

    /// The same behind bytes that came at `now` while it was held: one of them may be a late answer, and others may come as late
    /// as all together may be (rule 19).
    instant end_behind_late(instant now) const { return now + (each_ + line.characters(max_adu_size)) * most_ + late_; }

private:
    static constexpr unsigned most_ = 1 + retries + busy_retries;

    duration late_;
    duration each_{};
    unsigned sendings_{0};
    instant first_{0};
    instant last_{0};
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    constexpr std::uint32_t longest_us = 30'000'000; // with passes up to a second apart
    static auto const requests = requests_of(public_functions{});
    fuzz::input in{data, size};
    std::uint8_t const flags = in.u8();
    client_options options{.response_timeout = milliseconds(100), .retries = retries};
    options.has_line_echo = (flags & 1U) != 0;
    options.max_leading_noise = (flags & 2U) != 0 ? 3 : 0;
    // The third function, 03, is asked without further flags.
    auto const& frame = requests[(2U + (flags >> 2U)) % requests.size()];
    static constexpr client_needs<public_functions, unit_statistics<2>> needs{.request_room = max_adu_size};
    using engine = basic_client<needs>;
    test::asking<engine> link{line, options};
    engine const& under_way = link;
    instant now{0xFFFF'0000U};
    link.advance(now);
    instant started = now;
    instant held_until = now;
    unsigned visits = 0;
    debt owed{options, frame};
    while (not in.is_empty()) {
        std::uint8_t const what = in.u8();
        now = now + microseconds(std::uint32_t{in.u8()} * ((what & 0x40U) != 0 ? 4'000U : 40U));
        if ((what & 0x20U) != 0) {
            link.receive_error(now);
        }
        fuzz::frame const heard{in.some(what & 0x1FU), (what & 0x80U) != 0};
        link.receive(heard.view(), now);
        if (under_way.is_held(unit) and not heard.view().empty()) {
            instant const later = owed.end_behind_late(now);
            held_until = reached(later, held_until) ? later : held_until;
        }
        bool is_same = under_way.is_busy();
        link.advance(now);
        if (auto const outcome = link.poll_outcome()) {
            bool const has_response = outcome->has_value() or is_exception(outcome->error());
            held_until = owed.end(has_response, now);
            owed.forget();
            is_same = false;
        }
        if (not link.is_busy()) {
            require(link.start(request_frame{frame}, now).has_value());
        }
        // Its unit is held no longer than for the debt; then it is asked on a quiet line, where the first visit may
        // be for whoever asked last.
        require(not under_way.is_held(unit) or not reached(now, held_until));
        bool const might_ask = not under_way.is_held(unit) and under_way.is_quiet();
        visits = under_way.is_busy() ? 0 : visits + (might_ask ? 1U : 0U);
        require(visits <= 1);
        started = is_same ? started : now;
        if (not link.poll_transmit().empty()) {
            now = now + milliseconds(5);
            link.sent(now);
            owed.note_sent(now);
        }
        require(link.poll_deadline().has_value());
        require((now - started).microseconds < longest_us);
    }
    return 0;
}

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What people write: values, errors and reasons on a stream, by std::format and by fmt.
#if __has_include(<fmt/format.h>)
#define FMT_HEADER_ONLY
#include <fmt/format.h>
#endif

#include <rtuwire/print.hpp>

#include <algorithm>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>

#include "support/catch.hpp"
#include "support/drives.hpp"

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/server.hpp>
#include <rtuwire/sim.hpp>

// Enumerations of a program: nothing of this library shows them.
namespace a_program {
enum unscoped : std::uint16_t { seven = 7 };
enum class scoped : std::uint16_t { one };
} // namespace a_program

namespace {

namespace altivar = rtuwire::altivar;

template <typename T> std::string shown(T const& value)
{
    std::ostringstream out;
    out << value;
    return out.str();
}

static_assert(not rtuwire::detail::has_text<a_program::unscoped> and not rtuwire::detail::has_text<a_program::scoped>);
static_assert(not rtuwire::detail::has_text<char[4]> and not rtuwire::detail::has_text<std::string> and
              not rtuwire::detail::has_text<int>);

} // namespace

// Without a using directive: what is found is found by the value's type.
TEST_CASE("amounts, settings, enumerators, errors and outcomes go to a stream")
{
    CHECK(shown(rtuwire::signed_decihertz{-5}) == "-0.5 Hz");
    CHECK(shown(rtuwire::deciamperes{52} - rtuwire::deciamperes{60}) == "-0.8 A");
    rtuwire::setting<altivar::atv12::acc> const ramp =
        *rtuwire::setting<altivar::atv12::acc>::checked(rtuwire::deciseconds{13});
    CHECK(shown(ramp) == "1.3 s");
    CHECK(shown(altivar::atv320::fault_code::slf1) == "SLF1: Modbus interrupted");
    CHECK(shown(altivar::compact::fault_code::ocf) == "OCF: overcurrent");
    CHECK(shown(altivar::atv28::fault_code::slf) == "SLF: serial link interrupted");
    CHECK(shown(altivar::status_word{0x0237}) == "0x0237");
    CHECK(shown(rtuwire::errc::timed_out) == "no response in time");
    CHECK(shown(rtuwire::errc::value_too_high) == "value above the register's maximum");
    CHECK(shown(altivar::outcome_kind::silent) == "no response");
    CHECK(shown(rtuwire::cia402::state::operation_enabled) == "operation enabled");
    CHECK(shown(rtuwire::cia402::command{}) == std::string{rtuwire::cia402::name_of(rtuwire::cia402::command{})});
    CHECK(shown(rtuwire::cia402::transition{}) == std::string{rtuwire::cia402::name_of(rtuwire::cia402::transition{})});
    CHECK(shown(rtuwire::literal{"as it is"}) == "as it is");
    CHECK(shown(text_of(rtuwire::rpm{1'500})) == "1500 rpm");
}

TEST_CASE("a result goes to a stream as its value or its error")
{
    using rtuwire::errc;
    using rtuwire::result;
    CHECK(shown(result<rtuwire::decihertz>{rtuwire::decihertz{523}}) == "52.3 Hz");
    CHECK(shown(result<rtuwire::decihertz>{errc::timed_out}) == "no response in time");
    CHECK(shown(result<altivar::status_word>{altivar::status_word{0x0237}}) == "0x0237");
    CHECK(shown(result<rtuwire::real<rtuwire::volts>>{errc::value_without_meaning}) ==
          "value without a meaning in the register");
    CHECK(shown(result<void>{}) == "no error");
    CHECK(shown(result<void>{errc::overruled}) == shown(errc::overruled));
    std::ostringstream out;
    out << std::setw(10) << result<rtuwire::decihertz>{rtuwire::decihertz{500}} << '|';
    CHECK(out.str() == "   50.0 Hz|");
}

TEST_CASE("a reason tells all that is known")
{
    using altivar::outcome_kind;
    using rtuwire::errc;
    using rtuwire::cia402::state;
    CHECK(shown(altivar::reason{}) == "not ended");
    CHECK(shown(altivar::reason{.kind = outcome_kind::silent, .error = errc::timed_out}) == "no response in time");
    CHECK(shown(altivar::reason{.kind = outcome_kind::silent, .error = errc::unit_lost}) ==
          "no response: " + shown(errc::unit_lost));
    CHECK(shown(altivar::reason{.kind = outcome_kind::aborted, .error = errc::timed_out}) ==
          "given up before it was done: look at the line, the drive's state and the time limit: no response in time");
    CHECK(shown(altivar::reason{.kind = outcome_kind::in_fault, .state = state::fault, .fault = 5}) ==
          "the drive is in fault, LFT 5 (SLF: nobody asked the drive for longer than its time-out), state fault; "
          "reset_fault resets it once its cause is gone");
    CHECK(shown(altivar::reason{.kind = outcome_kind::in_fault, .fault = 250}) ==
          "the drive is in fault, LFT 250; reset_fault resets it once its cause is gone");
    CHECK(shown(altivar::reason{.kind = outcome_kind::succeeded, .is_other_stop = true}) ==
          "done, another stop than the one ordered");
    CHECK(shown(altivar::reason{.kind = outcome_kind::above_hsp, .limit = 505}) ==
          "the reference is above the drive's highest frequency, HSP: 50.5 Hz");
    // The longest of all fits.
    std::size_t longest = 0;
    for (unsigned kind = 0; kind <= 0xFF; ++kind) {
        for (unsigned error = 0; error <= 0xFF; ++error) {
            altivar::reason const why{static_cast<outcome_kind>(kind),
                                      static_cast<errc>(error),
                                      state::fault_reaction_active,
                                      65'535,
                                      true,
                                      65'535};
            std::string const text{text_of(why)};
            longest = std::max(longest, text.size());
            REQUIRE(text.starts_with(std::string{altivar::name_of(why.kind)}));
        }
    }
    CHECK(longest > 150);
}

TEST_CASE("a reason calls a fault as each drive's last fault does")
{
    unsigned compared = 0;
    rtuwire::test::all_drives::for_each([&]<typename Device>() {
        Device::registers::for_each([&]<auto const & R>() {
            for (std::uint16_t lft = 0; lft < 256 and R.code == rtuwire::literal{"LFT"}; ++lft) {
                std::string const called = shown(altivar::common_fault(lft)),
                                  own = shown(rtuwire::detail::from_word<rtuwire::value_of<R>>(lft));
                CHECK((called.empty() or called.substr(0, 3) == own.substr(0, 3)));
                compared += called.empty() ? 0U : 1U;
            }
        });
    });
    CHECK(compared == 9 * 5);
}

TEST_CASE("a stream's width holds for the whole of a value")
{
    std::ostringstream out;
    out << std::setw(10) << rtuwire::decihertz{500} << '|' << std::left << std::setw(10) << rtuwire::errc::none << '|';
    CHECK(out.str() == "   50.0 Hz|no error  |");
    CHECK(shown("a plain text") == "a plain text");
    CHECK(shown(a_program::seven) == "7");
}

TEST_CASE("what a register holds goes to a stream, with each drive")
{
    rtuwire::test::all_drives::for_each([]<typename Device>() {
        Device::registers::for_each([]<auto const & R>() {
            auto const value = rtuwire::detail::from_word<rtuwire::value_of<R>>(1);
            std::string const code{R.code};
            INFO(code);
            CHECK(shown(value) == std::string{rtuwire::text_of(value)});
        });
    });
}

// The design's call sites: read and show, write what is known only now.
TEST_CASE("a program shows what it read, and why it could not write")
{
    using namespace rtuwire;
    constexpr station<altivar::atv12::device> drive{unit_id{7}};
    bank<altivar::atv12::rfr, altivar::atv12::acc, altivar::atv12::dec> registers{};
    registers.set<altivar::atv12::rfr>(52.3_Hz);
    sim::bench line{line_timing{19'200, character_format::even_8_1}, bank_at{drive.unit(), registers}};
    std::ostringstream out;
    auto const speed = line.run(read<altivar::atv12::rfr>(drive));
    if (not speed) {
        out << speed.error() << '\n';
    } else if (*speed > 50_Hz) {
        out << *speed << '\n';
    }
    for (int const ramp : {30, 10'000, -1}) {
        auto const done = line.run(write<altivar::atv12::dec>(drive, checked(ramp * 0.1_s)));
        if (not done) {
            out << done.error() << '\n';
        }
    }
    CHECK(registers.get<altivar::atv12::dec>() == 3_s);
    CHECK(out.str() == "52.3 Hz\nvalue above the register's maximum\nvalue below the register's minimum\n");
}

#if defined(__cpp_lib_format)
TEST_CASE("std::format takes what a stream takes")
{
    CHECK(std::format("{}|{:>8}|{}|{}", rtuwire::decihertz{5}, rtuwire::rpm{7}, rtuwire::errc::none,
                      altivar::atv320::fault_code::slf1) == "0.5 Hz|   7 rpm|no error|SLF1: Modbus interrupted");
    CHECK(std::format("{} {}", rtuwire::literal{"a"}, text_of(rtuwire::rpm{7})) == "a 7 rpm");
    CHECK(std::format("{:>8}|{}|{}", rtuwire::result<rtuwire::rpm>{rtuwire::rpm{7}},
                      rtuwire::result<rtuwire::rpm>{rtuwire::errc::timed_out},
                      rtuwire::result<void>{}) == "   7 rpm|no response in time|no error");
}
#endif

#if defined(FMT_VERSION)
TEST_CASE("fmt takes what a stream takes")
{
    CHECK(fmt::format("{}|{:>8}|{}|{}", rtuwire::decihertz{5}, rtuwire::rpm{7}, rtuwire::errc::none,
                      altivar::atv320::fault_code::slf1) == "0.5 Hz|   7 rpm|no error|SLF1: Modbus interrupted");
    CHECK(fmt::format("{} {}", rtuwire::literal{"a"}, text_of(rtuwire::rpm{7})) == "a 7 rpm");
    CHECK(fmt::format("{:>8}|{}|{}", rtuwire::result<rtuwire::rpm>{rtuwire::rpm{7}},
                      rtuwire::result<rtuwire::rpm>{rtuwire::errc::timed_out},
                      rtuwire::result<void>{}) == "   7 rpm|no response in time|no error");
}
#endif

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What is told of a write: never more than the drive showed. Its table, row by row.
#include <rtuwire/altivar/maintenance/guarded_write.hpp>

#include "support/catch.hpp"
#include "support/proof.hpp"

using namespace rtuwire;
using namespace rtuwire::altivar;
using told = restore_outcome;
using verdict = row_write::verdict;

namespace {

constexpr std::uint16_t wanted = 20, old = 10, third = 15;

constexpr bool is(row_write const& one, told outcome, std::optional<std::uint16_t> held, errc error = errc::none)
{
    return one.report() == restore_report{outcome, held, error};
}

constexpr bool is_told_right()
{
    row_write confirmed{wanted, old, false};
    bool is_right = confirmed.confirm() == verdict::read_back;
    row_write one = confirmed;
    is_right = is_right and one.compare(wanted) == verdict::next and is(one, told::written, wanted);
    is_right = is_right and one.has_written();
    one = confirmed;
    is_right = is_right and one.compare(third) == verdict::next and is(one, told::differs, third);
    is_right = is_right and not one.has_written();
    one = confirmed;
    is_right = is_right and one.go_without(errc::timed_out) == verdict::end;
    is_right = is_right and is(one, told::confirmed, std::nullopt, errc::timed_out) and not one.has_written();
    one = confirmed;
    is_right = is_right and one.go_without(errc::server_device_busy) == verdict::next;
    is_right = is_right and is(one, told::confirmed, std::nullopt, errc::server_device_busy);
    is_right = is_right and not one.has_written();
    return is_right;
}

constexpr bool is_refused_right()
{
    row_write refused{wanted, old, false};
    bool is_right = refused.fail(errc::illegal_data_value) == verdict::read_back;
    row_write one = refused;
    is_right = is_right and one.compare(old) == verdict::next;
    is_right = is_right and is(one, told::refused, old, errc::illegal_data_value) and not one.has_written();
    one = refused; // it said no, and did it
    is_right = is_right and one.compare(wanted) == verdict::next and is(one, told::written, wanted);
    one = refused;
    is_right = is_right and one.go_without(errc::server_device_busy) == verdict::next;
    is_right = is_right and is(one, told::refused, old, errc::illegal_data_value);
    return is_right;
}

/// Sent at most three times, each after another check.
constexpr bool is_lost_right()
{
    row_write one{wanted, old, false};
    bool is_right = true;
    for (unsigned attempt = 1; attempt <= 5; ++attempt) {
        is_right = is_right and one.fail(errc::timed_out) == verdict::read_back;
        is_right = is_right and one.compare(old) == (attempt < 5 ? verdict::check_again : verdict::end);
    }
    is_right = is_right and is(one, told::not_reached, old, errc::timed_out);
    row_write arrived{wanted, old, false};
    is_right = is_right and arrived.fail(errc::crc_mismatch) == verdict::read_back;
    is_right = is_right and arrived.compare(wanted) == verdict::next and is(arrived, told::written, wanted);
    row_write gone{wanted, old, false};
    is_right = is_right and gone.fail(errc::timed_out) == verdict::read_back;
    is_right = is_right and gone.go_without(errc::timed_out) == verdict::end;
    is_right = is_right and is(gone, told::unconfirmed, std::nullopt, errc::timed_out);
    row_write device{wanted, old, false};
    is_right = is_right and device.fail(errc::device_vanished) == verdict::end;
    return is_right and is(device, told::unconfirmed, std::nullopt, errc::device_vanished);
}

constexpr bool is_stopped_right()
{
    row_write one{wanted, old, false};
    return one.stop(errc::overruled) == verdict::end and is(one, told::not_reached, old, errc::overruled);
}

/// A word that moves the drive is believed where it was confirmed, and looked for where it was not.
constexpr bool is_link_right()
{
    row_write one{wanted, old, true};
    bool is_right = one.confirm() == verdict::next and is(one, told::not_read_back, old) and one.has_written();
    row_write lost{wanted, old, true};
    is_right = is_right and lost.fail(errc::timed_out) == verdict::read_back;
    is_right = is_right and lost.go_without(errc::timed_out) == verdict::end;
    return is_right and is(lost, told::unconfirmed, std::nullopt, errc::timed_out);
}

} // namespace

PROOF("a confirmed write is told by what is read back", is_told_right)
PROOF("a refused write is told by what is read back", is_refused_right)
PROOF("a write without a response is looked for before it is sent again", is_lost_right)
PROOF("a write that was never sent leaves the old word", is_stopped_right)
PROOF("a write of the link is not read back once it was confirmed", is_link_right)

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A restore of one type of drive. Included by one file, which makes those of all.
#pragma once

#include <array>

#include "backup/drive_restore.hpp"
#include "line/end_wish.hpp"
#include "port/named_drives.hpp"

namespace tool {

/// Ends between two parameters once a signal has asked for it: what was begun with one is brought to its end first, so
/// that what became of it is told. `has_told` says that something was told behind the signal.
template <rtuwire::device_type Device, typename Words, typename Report>
class endable_restore : public rtuwire::altivar::restore<Device, Words, Report> {
public:
    using base = rtuwire::altivar::restore<Device, Words, Report>;

    endable_restore(rtuwire::station<Device> const& drive, restore_work const& work,
                    rtuwire::altivar::wanted_settings<Words> const& wanted, Report report, bool const& has_told)
        : base{drive, work.drive.map, wanted, report, work.options}, has_told_{has_told}
    {}

    std::optional<rtuwire::request_frame> next() noexcept
    {
        if (not was_ended_ and noted_signal() != 0 and has_told_) {
            was_ended_ = true;
            this->cancel();
        }
        return base::next();
    }
    bool was_ended() const noexcept { return was_ended_; }

private:
    bool const& has_told_;
    bool was_ended_{false};
};

template <rtuwire::device_type Device> restored restore_to(restore_work const& work)
{
    bool has_told = false;
    auto words = [&work](rtuwire::altivar::parameter const& row) {
        return work.settings.word_of(std::string_view{row.code});
    };
    auto report = [&work, &has_told](rtuwire::altivar::parameter_group const&, rtuwire::altivar::parameter const& row,
                                     rtuwire::altivar::restore_report const& what) {
        has_told = noted_signal() != 0;
        if (register_entry const* const entry = work.drive.at(row.address)) {
            work.told(*entry, what);
        }
    };
    rtuwire::altivar::wanted_settings const wanted{rtuwire::altivar::drive_family::of(work.settings.drive->reference),
                                                   words};
    std::string const name{work.drive.name};
    endable_restore<Device, decltype(words), decltype(report)> conversation{station_at<Device>(work.unit.byte(), name),
                                                                            work, wanted, report, has_told};
    rtuwire::host_client::traced_by<exchange_log> client{work.port.timing(), work.line_options};
    client.trace_to(work.exchange);
    std::array<std::byte, rtuwire::max_adu_size> input{};
    rtuwire::result<void> passed{};
    while (passed and not conversation.settled()) {
        rtuwire::instant const now = work.port.now();
        client.advance(now);
        client.converse(conversation, now);
        passed = finish_pass(client, work.port, input, now + rtuwire::milliseconds(10));
    }
    return {conversation.reason(), conversation.was_ended(), passed.error(), conversation.saved()};
}

} // namespace tool

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// One drive on a line with a client, in virtual time: what a person can do to them, and what there is to see.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <rtuwire/client.hpp>
#include <rtuwire/drives.hpp>
#include <rtuwire/sim.hpp>

#include "any_drive.hpp"
#include "cabled_drive.hpp"
#include "client_orders.hpp"
#include "frame_log.hpp"
#include "line_tap.hpp"
#include "typed_frames.hpp"

namespace playground {

/// Where the cable is cut.
enum class cable : std::uint8_t { whole, cut, towards_drive, from_drive };

class scene final : frame_taker {
public:
    explicit scene(std::unique_ptr<any_drive> drive);
    scene(scene const&) = delete;
    scene& operator=(scene const&) = delete;
    ~scene() = default;

    /// Lets time pass, one second at most in one call.
    void run(rtuwire::duration length);

    /// Lets time pass until a frame has ended, or a request was given up; at most for a second.
    void run_to_next_frame();

    // At the drive.
    void switch_mains(bool on);
    void cut(cable where);
    /// The cause of an overcurrent, which the mains do not remove.
    void make_fault(bool present);
    // Its keypad, which does nothing without mains.
    void set_local(bool is_local);
    void press_stop();
    /// Whether it trips when its line goes silent: its setting, which a loss of mains takes back.
    void set_supervised(bool is_supervised);

    // At the client: orders, which end on their own and say how.
    void start(std::string_view reference) { orders_.start(reference, now_us_); }
    void change(std::string_view reference) { orders_.change(reference, now_us_); }
    void stop(rtuwire::altivar::stop_by how);
    void reset_fault() { orders_.reset_fault(now_us_); }

    /// Bytes that leave as they are, once the line is free; false where others still wait for that.
    [[nodiscard]] bool send(rtuwire::byte_view bytes) { return typed().give(bytes); }

    /// What there is to see now, in JSON.
    [[nodiscard]] std::string state();

    /// What does not change: the drive, its limits, the ways it can be stopped; in JSON.
    [[nodiscard]] std::string description() const;

    [[nodiscard]] tool::drive_catalog const& catalog() const noexcept { return drive_->catalog(); }
    [[nodiscard]] frame_log const& frames() const noexcept { return frames_; }

private:
    using bench = rtuwire::sim::bench<link, cabled_drive, line_tap, typed_frames>;

    cabled_drive& end() noexcept { return bench_.unit<0>(); }
    line_tap& tap() noexcept { return bench_.unit<1>(); }
    typed_frames& typed() noexcept { return bench_.unit<2>(); }

    rtuwire::altivar::drive_layout const& layout() const noexcept { return catalog().layout; }
    std::uint64_t us_of(rtuwire::instant at) const noexcept;

    void run_until(std::uint32_t frames, rtuwire::duration longest);
    void keep_time(rtuwire::instant now) noexcept;
    void visit(rtuwire::instant now);
    void take(rtuwire::heard_frame const& heard) override;
    void note_unheard(std::vector<std::byte> const& bytes, rtuwire::instant now);
    void turn_shaft(std::uint32_t passed_us) noexcept;
    bool is_supervised() const noexcept;
    std::uint32_t time_out_us() const noexcept;
    void put_drive(json_text& out);
    void put_client(json_text& out);

    std::unique_ptr<any_drive> drive_;
    tool::names_by_drive names_{catalog()};
    frame_log frames_;
    client_orders orders_;
    bench bench_;
    std::vector<std::byte> last_request_{};
    std::uint64_t now_us_{0};
    rtuwire::instant last_{0};
    std::int32_t shaft_{0}; ///< what the motor turns at, in mHz of the output
    cable cable_{cable::whole};
    bool has_cause_{false};
    bool is_local_{false};
};

} // namespace playground

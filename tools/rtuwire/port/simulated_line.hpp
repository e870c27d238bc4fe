// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Simulated drives of any kind on one port of a host, and what can happen to them.
#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <rtuwire/client.hpp>
#include <rtuwire/sim.hpp>

#include "drive_events.hpp"
#include "named_drives.hpp"
#include "whole_drive.hpp"

namespace tool {

/// A drive on a line, whichever it is.
class simulated_drive {
public:
    simulated_drive() = default;
    simulated_drive(simulated_drive const&) = delete;
    simulated_drive& operator=(simulated_drive const&) = delete;
    virtual ~simulated_drive() = default;

    virtual void receive(rtuwire::byte_view bytes, rtuwire::instant now) = 0;
    virtual void receive_error(rtuwire::instant now) = 0;
    virtual void sent(rtuwire::instant now) = 0;
    virtual void advance(rtuwire::instant now) = 0;
    virtual rtuwire::byte_view poll_transmit() = 0;
    virtual rtuwire::deadline poll_deadline() const = 0;

    virtual rtuwire::unit_id address() const = 0;
    virtual bool is_at_rest() const = 0;

    /// What it does, in words: its state, its output frequency, and its last fault's number (LFT).
    virtual std::string shown() const = 0;

    /// Lets something happen to it, one of `drive_events`; false for what it does not know.
    virtual bool suffer(std::string const& what, rtuwire::instant now) = 0;

    /// What it would have known, or why it did not take what it knows.
    virtual std::string understood() const { return std::string{"UNIT show|"} + drive_events; }
};

template <rtuwire::device_type Device> class simulated final : public simulated_drive {
public:
    simulated(rtuwire::unit_id address, rtuwire::line_timing const& line, rtuwire::instant now,
              rtuwire::device_objects const& objects)
        : address_{address}, profile_{rtuwire::sim::line_profile_with<Device>(objects)}, unit_{address, line, now,
                                                                                               profile_}
    {}

    void receive(rtuwire::byte_view bytes, rtuwire::instant now) override
    {
        if (not is_cut_off_) {
            unit_.receive(bytes, now);
        }
    }
    void receive_error(rtuwire::instant now) override
    {
        if (not is_cut_off_) {
            unit_.receive_error(now);
        }
    }
    void sent(rtuwire::instant now) override { unit_.sent(now); }
    void advance(rtuwire::instant now) override { unit_.advance(now); }
    rtuwire::byte_view poll_transmit() override { return is_mute_ ? rtuwire::byte_view{} : unit_.poll_transmit(); }
    rtuwire::deadline poll_deadline() const override { return unit_.poll_deadline(); }
    rtuwire::unit_id address() const override { return address_; }
    bool is_at_rest() const override { return unit_.drive().motor().is_at_rest(); }
    std::string shown() const override
    {
        auto const& drive = unit_.drive();
        using tenths = rtuwire::quantity<rtuwire::frequency, std::int32_t, std::deci>;
        return std::string{text_of(drive.state_machine().state())} + ", " +
               std::string{text_of(tenths{drive.motor().frequency() / 100})} + ", LFT " + std::to_string(drive.fault());
    }

    bool suffer(std::string const& what, rtuwire::instant now) override
    {
        if (what == "cut" or what == "join" or what == "deaf" or what == "mute") {
            is_cut_off_ = what == "cut" or what == "deaf";
            is_mute_ = what == "cut" or what == "mute";
            return true;
        }
        return happens(unit_.drive(), words_of(what), now);
    }

private:
    rtuwire::unit_id address_;
    rtuwire::server_profile profile_;
    rtuwire::sim::unit<Device> unit_;
    bool is_cut_off_{false};
    bool is_mute_{false};
};

/// Drives that hear one line, and each other.
template <typename Port> class simulated_line {
    using identity_bytes = std::array<std::byte, rtuwire::max_adu_size>;

public:
    /// The drives say of themselves what their manuals print, or that `vendor` made them.
    simulated_line(Port& port, rtuwire::line_timing const& timing, std::string const& vendor = {})
        : port_{port}, timing_{timing}, last_{port.now()}, vendor_{vendor}
    {}

    /// Adds a drive by its name, with all its parameters. Refuses a name of none, and an address that is taken or out of
    /// the device's range.
    void add(std::string const& name, std::uint32_t address)
    {
        if (find(address) != nullptr) {
            throw usage_error{"unit " + std::to_string(address) + " is given twice"};
        }
        with_drive(name, [&](auto device) {
            using type = typename whole_drive<typename decltype(device)::type>::type;
            drives_.push_back(std::make_unique<simulated<type>>(station_at<type>(address, name).unit(), timing_, last_,
                                                                identity_of_a<type>()));
        });
    }

    /// Adds what is no drive. Refuses an address that is taken.
    void add(std::unique_ptr<simulated_drive> one)
    {
        if (find(one->address().byte()) != nullptr) {
            throw usage_error{"unit " + std::to_string(one->address().byte()) + " is given twice"};
        }
        drives_.push_back(std::move(one));
    }

    simulated_drive* find(std::uint32_t address) const
    {
        for (auto const& each : drives_) {
            if (each->address().byte() == address) {
                return each.get();
            }
        }
        return nullptr;
    }

    bool is_at_rest() const
    {
        bool all = true;
        for (auto const& each : drives_) {
            all = all and each->is_at_rest();
        }
        return all;
    }

    /// Waits for bytes, at most for `time_limit`, and lets the drives do what is due. Errors: those of
    /// the port.
    rtuwire::result<void> pass(rtuwire::duration time_limit)
    {
        rtuwire::deadline until = port_.now() + time_limit;
        for (auto const& each : drives_) {
            until = rtuwire::earlier(until, each->poll_deadline());
        }
        auto const bytes = port_.read(input_, *until);
        if (not bytes) {
            return bytes.error();
        }
        // Nothing came until then; whatever came since is read in the next pass, however late that is. A port may come back
        // before, as where a client has come.
        bool const is_damaged = has_receive_error();
        rtuwire::instant const seen = port_.now();
        bool const is_late = bytes->empty() and not is_damaged and reached(seen, *until);
        rtuwire::instant const now = is_late ? *until : seen;
        // An hour in which the program was stopped looks as if the time had gone back, but by more than a pass takes.
        bool const goes_back = last_ - now < rtuwire::milliseconds(10'000);
        last_ = goes_back ? last_ : now;
        for (auto const& each : drives_) {
            each->receive(*bytes, last_);
            if (is_damaged) {
                each->receive_error(last_);
            }
            each->advance(last_);
        }
        return response();
    }

    rtuwire::instant now() const { return last_; }

private:
    /// The objects of a drive; their bytes live as long as this line.
    template <rtuwire::device_type Device> rtuwire::device_objects identity_of_a()
    {
        using rtuwire::sim::line_profile;
        auto const& printed = line_profile<Device>::objects;
        auto const& bytes = identities_.emplace_back(std::make_unique<identity_bytes>());
        rtuwire::byte_writer out{*bytes};
        for (rtuwire::device_object const& each : printed) {
            if (each.id == rtuwire::vendor_name and not vendor_.empty()) {
                write_vendor(out);
            } else {
                each.write(out);
            }
        }
        auto const made = rtuwire::device_objects::from(out.written());
        return made ? *made : rtuwire::device_objects{};
    }

    void write_vendor(rtuwire::byte_writer& out) const
    {
        out.u8(rtuwire::vendor_name);
        out.u8(static_cast<std::uint32_t>(vendor_.size()));
        for (char const letter : vendor_) {
            out.u8(static_cast<std::uint8_t>(letter));
        }
    }

    bool has_receive_error()
    {
        if constexpr (requires { port_.take_receive_error(); }) {
            return port_.take_receive_error();
        } else {
            return false;
        }
    }

    rtuwire::result<void> response()
    {
        constexpr rtuwire::duration write_limit = rtuwire::milliseconds(1'000);
        for (auto const& sender : drives_) {
            rtuwire::byte_view const frame = sender->poll_transmit();
            if (frame.empty()) {
                continue;
            }
            auto const written = port_.write(frame, port_.now() + write_limit);
            last_ = port_.now();
            for (auto const& other : drives_) {
                if (other != sender) {
                    other->receive(frame, last_);
                }
            }
            sender->sent(last_);
            if (not written and written.error() != rtuwire::errc::transmit_stalled) {
                return written;
            }
        }
        return {};
    }

    Port& port_;
    rtuwire::line_timing timing_;
    rtuwire::instant last_;
    std::string vendor_;
    std::vector<std::unique_ptr<identity_bytes>> identities_{};
    std::vector<std::unique_ptr<simulated_drive>> drives_{};
    std::array<std::byte, rtuwire::max_adu_size> input_{};
};

} // namespace tool

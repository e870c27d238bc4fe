// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A simulated drive of any type, as the line and the judge see it.
#pragma once

#include <cstdint>
#include <memory>

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/sim/drive/unit.hpp>

namespace rtuwire::lives {

enum class model : unsigned { atv310_2014, atv310_2026, atv320, atv12, atv28, count };

/// Calls with a value of the device's type.
template <typename Work> auto with_device(model which, Work work)
{
    switch (which) {
    case model::atv310_2014: return work(altivar::atv310::device{});
    case model::atv310_2026: return work(altivar::atv310::device_2026{});
    case model::atv12: return work(altivar::atv12::device{});
    case model::atv28: return work(altivar::atv28::device{});
    case model::atv320:
    case model::count: break;
    }
    return work(altivar::atv320::device{});
}

/// How a drive is set: what it does when its line goes silent, and its ramps.
struct drive_setting {
    model which{model::atv320};
    std::uint8_t address{1};
    std::uint16_t sll{1};
    std::uint16_t tto{100};      ///< 0.1 s
    bool is_link_ignored{false}; ///< NTO of an ATV28
    std::uint16_t ramp{10};      ///< 0.1 s from 0 to 50 Hz
    std::uint16_t lsp{0};        ///< 0.1 Hz
    bool is_io{false};           ///< an ATV320 in its I/O profile: bit 0 of the control word runs it
    model called{model::atv320}; ///< by its user

    /// Whether a lost link takes the motor's power away.
    bool is_supervised() const
    {
        return which == model::atv28 ? not is_link_ignored : sll != 0 and sll != 4 and sll != 5;
    }
    /// How long after its last answered request a controller has to take the drive for lost: where the drive supervises
    /// nothing, the longest time-out of its type.
    std::uint64_t lost_after_us() const
    {
        bool const is_known = which == model::atv28 or sll != 0;
        return is_known ? time_out_us() : 30'000'000U;
    }
    std::uint64_t time_out_us() const { return which == model::atv28 ? 7'000'000U : std::uint64_t{tto} * 100'000U; }
};

class far_drive {
public:
    virtual ~far_drive() = default;
    virtual void receive(byte_view frame, instant at) = 0;
    virtual void advance(instant now) = 0;
    virtual byte_view poll_transmit() = 0;
    virtual void sent(instant at) = 0;
    virtual deadline poll_deadline() const = 0;

    virtual cia402::state state() const = 0;
    virtual std::int32_t frequency() const = 0; ///< mHz
    virtual std::int16_t reference() const = 0; ///< LFR, 0.1 Hz
    virtual std::uint16_t status() const = 0;

    virtual void trip(std::uint16_t code) = 0;
    virtual void clear_cause() = 0;
    virtual void press_stop() = 0;
    virtual void set_local(bool is_local) = 0;
    virtual void power_cycle(instant now) = 0;
    virtual altivar::drive_layout const& profile() const = 0;
    virtual std::uint16_t frequency_reference() const = 0;
    virtual std::uint16_t speed_reference() const = 0;
};

template <device_type Device> class far_drive_of : public far_drive {
public:
    far_drive_of(drive_setting const& set, line_timing const& line, instant now)
        : set_{set}, unit_{*unit_id::checked(set.address), line, now}
    {
        commission();
    }

    void receive(byte_view frame, instant at) override { unit_.receive(frame, at); }
    void advance(instant now) override { unit_.advance(now); }
    byte_view poll_transmit() override { return unit_.poll_transmit(); }
    void sent(instant at) override { unit_.sent(at); }
    deadline poll_deadline() const override { return unit_.poll_deadline(); }

    cia402::state state() const override { return unit_.drive().state_machine().state(); }
    std::int32_t frequency() const override { return unit_.drive().motor().frequency(); }
    std::int16_t reference() const override { return static_cast<std::int16_t>(unit_.drive().word("LFR")); }
    std::uint16_t status() const override { return unit_.drive().word("ETA"); }

    void trip(std::uint16_t code) override { unit_.drive().inject_fault(code); }
    void clear_cause() override { unit_.drive().clear_cause(); }
    void press_stop() override { unit_.drive().press_stop(); }
    void set_local(bool is_local) override { unit_.drive().set_local(is_local); }
    void power_cycle(instant now) override
    {
        unit_.drive().power_cycle(now);
        commission();
    }
    altivar::drive_layout const& profile() const override { return Device::layout; }
    std::uint16_t frequency_reference() const override { return Device::frequency_reference.address; }
    std::uint16_t speed_reference() const override { return Device::speed_reference.address; }

private:
    /// What stands in its memory; written past its line.
    void commission()
    {
        auto const put = [&](std::uint16_t address, std::uint16_t word) {
            if (address != 0) {
                register_block const value{word};
                unit_.drive().write(address, value);
            }
        };
        altivar::safeguard_layout const& at = Device::layout.safeguards;
        put(at.sll, set_.sll);
        put(at.tto, set_.tto);
        if (set_.is_io) {
            constexpr std::uint16_t io_profile = 3;
            put(at.chcf, io_profile);
        }
        if (at.nto != 0 and set_.is_link_ignored) {
            put(Device::layout.cmi, at.nto);
        }
        std::uint16_t const ramps = Device::layout.direct_control != 0 ? 252 : 9'001; // ACC, then DEC
        put(ramps, set_.ramp);
        put(static_cast<std::uint16_t>(ramps + 1), set_.ramp);
        put(Device::layout.direct_control != 0 ? 251 : 3'105, set_.lsp);
    }

    drive_setting set_;
    sim::unit<Device> unit_;
};

inline std::unique_ptr<far_drive> make_drive(drive_setting const& set, line_timing const& line, instant now)
{
    return with_device(set.which, [&]<typename Device>(Device) -> std::unique_ptr<far_drive> {
        return std::make_unique<far_drive_of<Device>>(set, line, now);
    });
}

} // namespace rtuwire::lives

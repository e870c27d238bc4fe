// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
#include "any_drive.hpp"

#include <rtuwire/altivar/all.hpp>

namespace playground {

namespace {

using rtuwire::byte_view;
using rtuwire::instant;

template <rtuwire::device_type Device> class drive_of final : public any_drive {
    using hertz = rtuwire::setting<Device::frequency_reference>;

public:
    explicit drive_of(tool::drive_catalog const& catalog) : catalog_{catalog} {}

    tool::drive_catalog const& catalog() const noexcept override { return catalog_; }

    void receive(byte_view bytes, instant now) noexcept override { unit_.receive(bytes, now); }
    void receive_error(instant now) noexcept override { unit_.receive_error(now); }
    void sent(instant now) noexcept override { unit_.sent(now); }
    void advance(instant now) noexcept override { unit_.advance(now); }
    byte_view poll_transmit() noexcept override { return unit_.poll_transmit(); }
    rtuwire::deadline poll_deadline() const noexcept override { return unit_.poll_deadline(); }
    std::uint32_t requests() const noexcept override { return unit_.requests(); }

    void power_cycle(instant now) noexcept override { unit_.drive().power_cycle(now); }
    void inject_fault(std::uint16_t code) noexcept override { unit_.drive().inject_fault(code); }
    void clear_cause() noexcept override { unit_.drive().clear_cause(); }
    void set_local(bool is_local) noexcept override { unit_.drive().set_local(is_local); }
    void press_stop() noexcept override { unit_.drive().press_stop(); }
    void write(std::uint16_t address, std::uint16_t word) noexcept override
    {
        rtuwire::register_block const words{word};
        static_cast<void>(unit_.drive().write(address, words));
    }
    std::uint16_t word(rtuwire::literal code) const noexcept override { return unit_.drive().word(code); }
    rtuwire::cia402::state state() const noexcept override { return unit_.drive().state_machine().state(); }
    rtuwire::cia402::transition last_transition() const noexcept override
    {
        return unit_.drive().state_machine().last();
    }
    std::int32_t frequency() const noexcept override { return unit_.drive().motor().frequency(); }
    std::uint16_t fault() const noexcept override { return unit_.drive().fault(); }

    void watch(link& line, std::size_t slot, instant now) noexcept override { line.converse(slot, watch_, now); }
    client_sight sight() const noexcept override
    {
        return {not watch_.link_lost(), watch_.rounds(), watch_.error(), watch_.state(), watch_.frequency().count()};
    }

    rtuwire::errc make(std::optional<rtuwire::altivar::start>& order, given_frequency reference) const override
    {
        return make_with_reference(order, reference, rtuwire::altivar::run_direction::forward,
                                   rtuwire::milliseconds(3'000),
                                   rtuwire::altivar::supervision_options{.beyond = beyond});
    }
    rtuwire::errc make(std::optional<rtuwire::altivar::change_reference>& order,
                       given_frequency reference) const override
    {
        return make_with_reference(order, reference, rtuwire::milliseconds(30'000), beyond);
    }
    void make(std::optional<rtuwire::altivar::stop>& order, rtuwire::altivar::stop_by how) const override
    {
        order.emplace(station, how);
    }
    void make(std::optional<rtuwire::altivar::reset_fault>& order) const override { order.emplace(station); }

private:
    /// Whoever plays sees what a drive does with a reference beyond its limits.
    static constexpr rtuwire::altivar::beyond_limits beyond = rtuwire::altivar::beyond_limits::limit;

    template <typename Order, typename... More>
    static rtuwire::errc make_with_reference(std::optional<Order>& order, given_frequency reference,
                                             More const&... more)
    {
        auto const checked = hertz::checked(reference);
        if (not checked) {
            return checked.error();
        }
        order.emplace(station, *checked, more...);
        return rtuwire::errc::none;
    }

    static constexpr rtuwire::station<Device> station{playground::unit};

    tool::drive_catalog const& catalog_;
    rtuwire::sim::unit<Device> unit_{playground::unit, line_speed, instant{0}};
    rtuwire::altivar::watch<Device> watch_{station, {.period = rtuwire::milliseconds(200)}};
};

} // namespace

std::unique_ptr<any_drive> make_drive(std::size_t place)
{
    std::unique_ptr<any_drive> made;
    std::size_t at = 0;
    rtuwire::altivar::all_drives::for_each([&]<typename Device>() {
        if (at == place) {
            made = std::make_unique<drive_of<Device>>(*tool::all_catalogs()[place]);
        }
        ++at;
    });
    return made;
}

} // namespace playground

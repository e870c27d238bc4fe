// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What a commissioning engineer watches on any of the drives, by each drive's own registers.
#pragma once

#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv310.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/client.hpp>

namespace examples {

template <auto const& Eta, auto const& Rfr, auto const& Frh, auto const& Lcr, auto const& Uln, auto const& Thr,
          auto const& Lft>
struct panel {
    static constexpr auto const& eta = Eta;
    static constexpr auto const& rfr = Rfr;
    static constexpr auto const& frh = Frh;
    static constexpr auto const& lcr = Lcr;
    static constexpr auto const& uln = Uln;
    static constexpr auto const& thr = Thr;
    static constexpr auto const& lft = Lft;
    template <typename Device> using plan = rtuwire::read_plan<Device, Eta, Rfr, Frh, Lcr, Uln, Thr, Lft>;
};

template <typename Device> struct panel_of;

namespace atv12 = rtuwire::altivar::atv12;
namespace atv28 = rtuwire::altivar::atv28;
namespace atv310 = rtuwire::altivar::atv310;
namespace atv320 = rtuwire::altivar::atv320;

template <>
struct panel_of<atv12::device>
    : panel<atv12::eta, atv12::rfr, atv12::frh, atv12::lcr, atv12::uln, atv12::thr, atv12::lft> {};
template <>
struct panel_of<atv28::device>
    : panel<atv28::eta, atv28::rfr, atv28::frh, atv28::lcr, atv28::uln, atv28::thr, atv28::lft> {};
template <>
struct panel_of<atv310::device>
    : panel<atv310::eta, atv310::rfr, atv310::frh, atv310::lcr, atv310::uln, atv310::thr, atv310::lft> {};
template <> struct panel_of<atv310::device_2026> : panel_of<atv310::device> {};
template <>
struct panel_of<atv320::device>
    : panel<atv320::eta, atv320::rfr, atv320::frh, atv320::lcr, atv320::uln, atv320::thr, atv320::lft> {};

/// A quantity in its unit, for people.
template <typename Quantity> double number(Quantity value)
{
    using scale = typename Quantity::scale;
    return double(value.count()) * double(scale::num) / double(scale::den);
}

/// Hands `run` the conversations that set ramps of one second and, where it can be set, a time-out of
/// three seconds; whether all went well.
template <typename Device, typename Run> bool set_short_times(rtuwire::station<Device> const& drive, Run run)
{
    using namespace rtuwire;
    if constexpr (std::is_same_v<Device, atv320::device>) {
        return run(write_with_step<deciseconds, atv320::acc>(drive, 1_s)) and
               run(write_with_step<deciseconds, atv320::dec>(drive, 1_s)) and run(write<atv320::tto>(drive, 3_s));
    } else if constexpr (std::is_same_v<Device, atv28::device>) {
        return run(write<atv28::acc>(drive, 1_s)) and run(write<atv28::dec>(drive, 1_s));
    } else if constexpr (std::is_same_v<Device, atv12::device>) {
        return run(write<atv12::acc>(drive, 1_s)) and run(write<atv12::dec>(drive, 1_s)) and
               run(write<atv12::tto>(drive, 3_s));
    } else {
        return run(write<atv310::acc>(drive, 1_s)) and run(write<atv310::dec>(drive, 1_s)) and
               run(write<atv310::tto>(drive, 3_s));
    }
}

} // namespace examples

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a device's image holds the registers that the simulated drive reads or shows: by the addresses of its layout,
// and by mnemonic where no controller needs the address.
// Internal: may change with any version.
#pragma once

#include <cstddef>
#include <cstdint>

#include <rtuwire/altivar/device/drive_layout.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// Places in a device's image; `nowhere` for what the device does not have.
template <device_type Device> struct register_index {
    using registers = image<Device>;
    static constexpr altivar::drive_layout const& layout = Device::layout;
    static constexpr altivar::safeguard_layout const& guards = Device::layout.safeguards;

    /// The place of an address; 0 is none.
    [[nodiscard]] static constexpr std::size_t place(std::uint16_t address) noexcept
    {
        return address == 0 ? registers::nowhere : registers::at_address(address);
    }

    std::size_t cmd{place(layout.cmd)};
    std::size_t cmi{place(layout.cmi)};
    std::size_t eta{place(layout.eta)};
    std::size_t eti{place(layout.eti)};
    std::size_t rfr{place(layout.rfr)};
    std::size_t lft{place(layout.lft)};
    std::size_t lfr{place(Device::frequency_reference.address)};
    std::size_t lfrd{place(Device::speed_reference.address)};
    std::size_t tto{place(guards.tto)};
    std::size_t sll{place(guards.sll)};
    std::size_t chcf{place(guards.chcf)};
    std::size_t cd1{place(guards.cd1)};
    std::size_t fr1{place(guards.fr1)};
    std::size_t flo{place(guards.flo)};
    std::size_t atr{place(guards.atr)};
    std::size_t dotd{place(guards.dotd)};
    std::size_t inputs{place(guards.inputs)};

    std::size_t cmdd{registers::at("CMDD")}, etad{registers::at("ETAD")};
    std::size_t frh{registers::at("FRH")}, rfrd{registers::at("RFRD")};
    std::size_t frhd{registers::at("FRHD")}, spd{registers::at("SPD")};
    std::size_t lcr{registers::at("LCR")}, otr{registers::at("OTR")};
    std::size_t opr{registers::at("OPR")}, uln{registers::at("ULN")};
    std::size_t thd{registers::at("THD")}, thr{registers::at("THR")};
    std::size_t hmis{registers::at("HMIS")}, acc{registers::at("ACC")};
    std::size_t dec{registers::at("DEC")}, inr{registers::at("INR")};
    std::size_t hsp{registers::at("HSP")}, lsp{registers::at("LSP")};
    std::size_t frs{registers::at("FRS")}, nsp{registers::at("NSP")};
    std::size_t sds{registers::at("SDS")}, ncr{registers::at("NCR")};
    std::size_t inv{registers::at("INV")}, ith{registers::at("ITH")};
    std::size_t stt{registers::at("STT")}, li3{registers::at("LI3")};
    std::size_t li4{registers::at("LI4")}, add{registers::at("ADD")};
    std::size_t tbr{registers::at("TBR")}, tfo{registers::at("TFO")};
    std::size_t bdr{registers::at("BDR")}, eti2{registers::at("ETI2")};
    std::size_t ftd{registers::at("FTD")}, ctd{registers::at("CTD")};

    [[nodiscard]] static constexpr bool has(std::size_t place) noexcept { return place != registers::nowhere; }
};

} // namespace rtuwire::sim

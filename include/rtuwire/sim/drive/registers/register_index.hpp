// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Where a device's image holds the registers that the simulated drive reads or shows.
// Internal: may change with any version.
#pragma once

#include <cstddef>

#include <rtuwire/core/version.hpp>
#include <rtuwire/sim/drive/registers/image.hpp>

namespace rtuwire::inline RTUWIRE_BUILD::sim {

/// Places in a device's image by mnemonic; `nowhere` for what the device does not have.
template <device_type Device> struct register_index {
    using registers = image<Device>;

    std::size_t cmd{registers::at("CMD")}, cmdd{registers::at("CMDD")};
    std::size_t lfr{registers::at("LFR")}, lfrd{registers::at("LFRD")};
    std::size_t cmi{registers::at("CMI")}, eta{registers::at("ETA")};
    std::size_t etad{registers::at("ETAD")}, eti{registers::at("ETI")};
    std::size_t rfr{registers::at("RFR")}, frh{registers::at("FRH")};
    std::size_t rfrd{registers::at("RFRD")}, frhd{registers::at("FRHD")};
    std::size_t spd{registers::at("SPD")}, lcr{registers::at("LCR")};
    std::size_t otr{registers::at("OTR")}, opr{registers::at("OPR")};
    std::size_t uln{registers::at("ULN")}, thd{registers::at("THD")};
    std::size_t thr{registers::at("THR")}, hmis{registers::at("HMIS")};
    std::size_t acc{registers::at("ACC")}, dec{registers::at("DEC")};
    std::size_t inr{registers::at("INR")}, hsp{registers::at("HSP")};
    std::size_t lsp{registers::at("LSP")}, frs{registers::at("FRS")};
    std::size_t nsp{registers::at("NSP")}, sds{registers::at("SDS")};
    std::size_t ncr{registers::at("NCR")}, inv{registers::at("INV")};
    std::size_t ith{registers::at("ITH")}, tto{registers::at("TTO")};
    std::size_t sll{registers::at("SLL")}, stt{registers::at("STT")};
    std::size_t chcf{registers::at("CHCF")}, cd1{registers::at("CD1")};
    std::size_t fr1{registers::at("FR1")}, flo{registers::at("FLO")};
    std::size_t li3{registers::at("LI3")}, li4{registers::at("LI4")};
    std::size_t add{registers::at("ADD")}, tbr{registers::at("TBR")};
    std::size_t tfo{registers::at("TFO")}, bdr{registers::at("BDR")};
    std::size_t eti2{registers::at("ETI2")}, ftd{registers::at("FTD")};
    std::size_t ctd{registers::at("CTD")}, atr{registers::at("ATR")};
    std::size_t dotd{registers::at("DOTD")}, il1r{registers::at("IL1R")};
    std::size_t il1i{registers::at("IL1I")}, iolr{registers::at("IOLR")};

    [[nodiscard]] static constexpr bool has(std::size_t place) noexcept { return place != registers::nowhere; }
};

} // namespace rtuwire::sim

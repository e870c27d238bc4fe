// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// More registers in one exchange than the drive takes.
// EXPECT: this device takes fewer registers in one exchange
#include <rtuwire/altivar/atv12.hpp>
#include <rtuwire/altivar/atv28.hpp>
#include <rtuwire/altivar/atv320.hpp>
#include <rtuwire/ask/access.hpp>
#include <rtuwire/ask/poller.hpp>

using namespace rtuwire;
using namespace rtuwire::altivar;

inline constexpr station<atv12::device> drive{unit_id{7}};
inline constexpr station<atv28::device> old{unit_id{3}};

inline constexpr reg<count16> after_lsp{.code = "X", .address = 3106};
struct wide_device : atv12::device {
    using registers = table<atv12::sfr, atv12::tfr, atv12::hsp, atv12::lsp, after_lsp, atv12::nc1>;
};
inline constexpr station<wide_device> wide{unit_id{7}};

void act()
{
#ifdef REFUSED
    static_cast<void>(
        exchange<contiguous<atv12::sfr, atv12::tfr, atv12::hsp, atv12::lsp, after_lsp>, atv12::nc1>(wide, 6_raw));
#else
    static_cast<void>(exchange<contiguous<atv12::rfr, atv12::frh, atv12::lcr>, atv12::nc1>(drive, 6_raw));
#endif
}

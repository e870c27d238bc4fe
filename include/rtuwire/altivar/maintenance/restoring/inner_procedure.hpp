// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The procedures that a restore runs inside itself, one at a time: the check before a write, the last look after some,
// and the save.
// Internal: may change with any version.
#pragma once

#include <cstdint>

#include <rtuwire/altivar/maintenance/guarded_write.hpp>
#include <rtuwire/altivar/procedure/commissioning/last_look.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// One of three procedures, the one that was begun last.
class inner_procedure {
public:
    enum class kind : std::uint8_t { guard, look, save };

    constexpr inner_procedure(drive_layout const& layout, terminal_options const& terminals) noexcept
        : guard_{layout, terminals}, look_{layout, 0}, save_{layout}, layout_{&layout}
    {}

    [[nodiscard]] constexpr kind running() const noexcept { return running_; }

    /// The check before a write.
    constexpr action begin_guard(write_care care) noexcept
    {
        running_ = kind::guard;
        return guard_.begin(care);
    }

    /// The last look, behind which the restore ends as `so`, or goes on where that is a success.
    constexpr action begin_look(altivar::reason const& so) noexcept
    {
        running_ = kind::look;
        look_ = last_look{*layout_, 0};
        return so.kind == outcome_kind::refused_while_running ? look_.begin_cut(so.state) : look_.begin(so, so.state);
    }

    constexpr action begin_save() noexcept
    {
        running_ = kind::save;
        save_ = save_procedure{*layout_};
        return save_.step({event::kind::begun});
    }

    constexpr action step(event what) noexcept
    {
        switch (running_) {
        case kind::guard: return guard_.step(what);
        case kind::look: return look_.step(what);
        case kind::save: break;
        }
        return save_.step(what);
    }

    /// Whether what runs has to come to its end, whoever gives the restore up: a look that may take a motor's power away, or
    /// the end of an order to save.
    [[nodiscard]] constexpr bool has_to_end() const noexcept
    {
        return running_ == kind::look or (running_ == kind::save and save_.is_taking_back());
    }

    /// How the procedure that runs has ended.
    [[nodiscard]] constexpr altivar::reason const& reason() const noexcept { return now().reason(); }

    /// What a status that was read shows of the motor's power, and whether a fault; each call clears what it returns.
    constexpr detail::power_seen take_power() noexcept { return now().take_power(); }
    constexpr bool take_fault() noexcept { return now().take_fault(); }

private:
    [[nodiscard]] constexpr procedure const& now() const noexcept
    {
        switch (running_) {
        case kind::guard: return guard_;
        case kind::look: return look_;
        case kind::save: break;
        }
        return save_;
    }
    constexpr procedure& now() noexcept
    {
        switch (running_) {
        case kind::guard: return guard_;
        case kind::look: return look_;
        case kind::save: break;
        }
        return save_;
    }

    write_guard guard_;
    last_look look_;
    save_procedure save_;
    drive_layout const* layout_;
    kind running_{kind::guard};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// A procedure that goes on being visited after its end, as by a loop that knows no end; how it ended is kept.
#pragma once

#include <rtuwire/altivar/procedure/outcome.hpp>
#include <rtuwire/ask/conversation.hpp>

namespace rtuwire::test {

template <typename Procedure> class remembered : public Procedure {
public:
    using Procedure::Procedure;
    explicit constexpr remembered(Procedure const& same) noexcept : Procedure{same} {}

    constexpr void advance(instant now) noexcept
    {
        Procedure::advance(now);
        keep();
    }
    constexpr void accept(result<response> const& outcome) noexcept
    {
        Procedure::accept(outcome);
        keep();
    }
    constexpr void note_loss() noexcept
    {
        Procedure::note_loss();
        keep();
    }

    constexpr altivar::reason reason() const noexcept { return kept_; }
    constexpr bool succeeded() const noexcept { return kept_.kind == altivar::outcome_kind::succeeded; }

private:
    constexpr void keep() noexcept
    {
        if (kept_.kind == altivar::outcome_kind::pending) {
            kept_ = Procedure::reason();
        }
    }

    altivar::reason kept_{};
};

} // namespace rtuwire::test

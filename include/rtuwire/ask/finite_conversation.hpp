// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What conversations that end have in common: whether this one has ended, and how. Knows neither its requests nor the
// value that it was asked for.
#pragma once

#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// The base of every conversation that ends once. One that reads a value has an `outcome` of its own, which gives the
/// value.
class finite_conversation : public asker {
public:
    /// Whether it has ended: the outcome is there, and no request follows.
    [[nodiscard]] constexpr bool settled() const noexcept { return is_settled_; }

    /// How it ended. Before that it is `busy`, so that an outcome that is read too early is never a success; `settled`
    /// tells whether it is the outcome. To be read in the pass in which it settles: from the next visit on it is
    /// `used_already`.
    [[nodiscard]] constexpr result<void> outcome() const noexcept { return error(); }

protected:
    /// It ends; `none` is success.
    constexpr void settle(errc how) noexcept
    {
        error_ = how;
        is_settled_ = true;
    }

    /// It begins anew with nothing to send: how it ended is told once more.
    constexpr void tell_again() noexcept { static_cast<asker&>(*this) = asker{}; }

    /// It begins anew; the outcome of its last request is dropped.
    constexpr void reopen() noexcept
    {
        forget();
        error_ = errc::busy;
        is_settled_ = false;
    }

    /// Why there is no value; `none` after success, `busy` before the end.
    [[nodiscard]] constexpr errc error() const noexcept { return is_used_already() ? errc::used_already : error_; }

private:
    errc error_{errc::busy};
    bool is_settled_{false};
};

} // namespace detail

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

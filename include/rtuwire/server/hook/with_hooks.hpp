// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Callables at the registers of a server: one that may refuse a value before it is written, one that acts on it after.
//
//     bank<pump::setpoint, pump::actual> registers;
//     auto served = with_hooks(registers)
//                       .check<pump::setpoint>([&](decihertz asked) {
//                           return tank.is_empty() ? errc::server_device_failure : errc::none;
//                       })
//                       .on_write<pump::setpoint>([&](decihertz speed) { inverter.go(speed); });
//     node.serve(served, now);
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/bank/register_bank.hpp>
#include <rtuwire/server/hook/bank_parts.hpp>
#include <rtuwire/server/hook/register_hook.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/register_view.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// Whether a bank that lists its registers has this one; one of plain words has any.
/// Internal.
template <typename Bank, auto const& R> inline constexpr bool may_hold = true;
template <typename Bank, auto const& R>
    requires requires { Bank::template contains<R>; }
inline constexpr bool may_hold<Bank, R> = Bank::template contains<R>;

/// Whether a bank has typed registers and nothing else.
/// Internal.
template <typename Bank> inline constexpr bool is_typed_bank = false;
template <typename Bank>
    requires std::same_as<typename Bank::typed_bank, Bank>
inline constexpr bool is_typed_bank<Bank> = true;

/// A bank with hooks, made by `with_hooks`; serve this one. The order of a write: the addresses of all registers (half a
/// register that has a hook, then those of the bank), then what each may be (the bank's limits; a value of the type that
/// its hook takes), then the checks named here, then the write of all values, then the actions; checks and actions in the
/// order of the addresses, at one address in the order in which they were named. The first refusal ends it: nothing was
/// written, and no action is called. Function 23 reads after the actions. The same holds for a broadcast, which nobody
/// answers. What the program itself writes into the bank (`set`) calls no hook.
/// Internal.
template <register_bank Bank, typename Hooks = no_hooks> class hooked_bank : public bank_parts<Bank> {
public:
    constexpr hooked_bank(Bank& bank, Hooks hooks) noexcept : bank_parts<Bank>{bank}, hooks_{std::move(hooks)} {}

    /// Asks `call(value)` before register R is written: `errc::none`, or the exception to send,
    /// `errc::illegal_data_value` (03) for a value that is never allowed, `errc::server_device_failure` (04) where the
    /// device cannot do it now. It changes nothing: another register may be refused after it.
    template <auto const& R, typename Callable> [[nodiscard]] constexpr auto check(Callable call) && noexcept
    {
        static_assert(may_hold<Bank, R>, "this bank has no such register");
        static_assert(R.space == register_space::holding,
                      "a hook is of a holding register: coils and inputs have none");
        static_assert(not has_scale_register<R>, "another register sets this one's scale: no hook sees its value");
        static_assert(R.mode != access::read_only, "this register is read-only: no client writes it, so no hook would "
                                                   "ever be called");
        static_assert(takes<Callable const&, value_of<R>>,
                      "a check is called with the value of its register, [&](decihertz asked) { ... } for a "
                      "reg<decihertz>, and is not mutable");
        static_assert(gives<errc, Callable const&, value_of<R>>,
                      "a check returns an errc: none, illegal_data_value (exception 03: not this value) or "
                      "server_device_failure (exception 04: not now)");
        return std::move(*this).with(write_check<typed_place<R>, Callable>{{}, std::move(call)});
    }

    /// The same for the word at an address.
    template <typename Callable> [[nodiscard]] constexpr auto check(std::uint16_t address, Callable call) && noexcept
    {
        static_assert(not is_typed_bank<Bank>,
                      "the registers of this bank have types: name one, .check<R>(call), instead of an address");
        static_assert(takes<Callable const&, std::uint16_t>,
                      "a check of an address is called with its word, [&](std::uint16_t asked) { ... }, and is not "
                      "mutable");
        static_assert(gives<errc, Callable const&, std::uint16_t>,
                      "a check returns an errc: none, illegal_data_value (03) or server_device_failure (04)");
        return std::move(*this).with(write_check<word_place, Callable>{{address}, std::move(call)});
    }

    /// Calls `call(value)` after a client has written register R.
    template <auto const& R, typename Callable> [[nodiscard]] constexpr auto on_write(Callable call) && noexcept
    {
        static_assert(may_hold<Bank, R>, "this bank has no such register");
        static_assert(R.space == register_space::holding,
                      "a hook is of a holding register: coils and inputs have none");
        static_assert(not has_scale_register<R>, "another register sets this one's scale: no hook sees its value");
        static_assert(R.mode != access::read_only, "this register is read-only: no client writes it, so no hook would "
                                                   "ever be called");
        static_assert(takes<Callable&, value_of<R>>, "an action is called with the value of its register, "
                                                     "[&](decihertz now) { ... } for a reg<decihertz>");
        static_assert(gives<void, Callable&, value_of<R>>,
                      "an action returns nothing: what is refused is refused by a check, before the write");
        return std::move(*this).with(write_action<typed_place<R>, Callable>{{}, std::move(call)});
    }

    /// The same for the word at an address.
    template <typename Callable> [[nodiscard]] constexpr auto on_write(std::uint16_t address, Callable call) && noexcept
    {
        static_assert(not is_typed_bank<Bank>,
                      "the registers of this bank have types: name one, .on_write<R>(call), instead of an address");
        static_assert(takes<Callable&, std::uint16_t>,
                      "an action at an address is called with its word, [&](std::uint16_t now) { ... }");
        static_assert(gives<void, Callable&, std::uint16_t>, "an action returns nothing: a check refuses");
        return std::move(*this).with(write_action<word_place, Callable>{{address}, std::move(call)});
    }

    [[nodiscard]] constexpr errc check_write(std::uint16_t start, register_view values) const noexcept
    {
        errc wrong = first_refusal(errc::none, start, values, [](auto const& hook, auto const&... word) {
            return splits(hook.place, word...) ? errc::illegal_data_address : errc::none;
        });
        if (wrong == errc::none) {
            wrong = static_cast<Bank const&>(this->bank()).check_write(start, values);
        }
        // What is no value could be neither checked nor told.
        wrong = first_refusal(wrong, start, values, [](auto const& hook, auto const&... word) {
            return holds_no_value(hook.place, word...) ? errc::illegal_data_value : errc::none;
        });
        return first_refusal(wrong, start, values,
                             [](auto const& hook, auto const&... word) { return hook.check(word...); });
    }

    constexpr errc write(std::uint16_t start, register_view values) noexcept
    {
        errc const wrong = this->bank().write(start, values);
        for (std::size_t i = 0; wrong == errc::none and i < values.size(); ++i) {
            hooks_.for_each([&](auto& hook) { hook.act(address_of(start, i), values, i); });
        }
        return wrong;
    }

private:
    /// What the first hook says that refuses a word, unless something is wrong already.
    template <typename Ask>
    [[nodiscard]] constexpr errc first_refusal(errc wrong, std::uint16_t start, register_view values,
                                               Ask ask) const noexcept
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            hooks_.for_each([&](auto const& hook) {
                wrong = wrong == errc::none ? ask(hook, address_of(start, i), values, i) : wrong;
            });
        }
        return wrong;
    }

    template <typename Hook> constexpr auto with(Hook hook) && noexcept
    {
        using hooks = hook_list<Hooks, Hook>;
        return hooked_bank<Bank, hooks>{this->bank(), hooks{std::move(hooks_), std::move(hook)}};
    }

    static constexpr std::uint32_t address_of(std::uint16_t start, std::size_t index) noexcept
    {
        return std::uint32_t{start} + static_cast<std::uint32_t>(index);
    }

    [[no_unique_address]] Hooks hooks_;
};

/// Puts hooks in front of a bank of any kind: `with_hooks(registers).check<R>(call).on_write<R>(call)`, or by address,
/// `.check(100, call).on_write(100, call)`. The bank must outlive what this returns; the callables are stored in that.
/// No heap; a server without hooks pays nothing for them.
template <register_bank Bank> [[nodiscard]] constexpr auto with_hooks(Bank& bank) noexcept
{
    return hooked_bank<Bank>{bank, no_hooks{}};
}
template <register_bank Bank> constexpr auto with_hooks(Bank const&& bank) noexcept
{
    static_assert(not std::is_object_v<Bank>,
                  "a bank that ends with its expression cannot be served: give it a name, and the hooks refer to it");
    return bank;
}

} // namespace rtuwire

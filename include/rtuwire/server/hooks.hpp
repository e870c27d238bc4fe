// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Callables at the registers of a server: one that may refuse a value before it is written, one that acts on it after. A
// register is named by its type, or by its address as a plain word.
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

#include <rtuwire/core/bytes.hpp>
#include <rtuwire/core/result.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/server/banks.hpp>
#include <rtuwire/server/decoded_request.hpp>
#include <rtuwire/table/form/form.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/wire/errc.hpp>
#include <rtuwire/wire/functions.hpp>
#include <rtuwire/wire/serial_line/file_records.hpp>
#include <rtuwire/wire/views.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// A register of a table. Its words may be no value of it (a floating point number that is none) in a bank of plain
/// words.
template <auto const& R> struct typed_place {
    static constexpr std::uint16_t address = R.address;
    static constexpr std::size_t size = R.word_count;
    [[nodiscard]] static constexpr result<value_of<R>> value(register_view words, std::size_t index) noexcept
    {
        return value_in<R>(words, index, index); // the second: of a scale, which it has not
    }
};

/// A word at an address.
struct word_place {
    static constexpr std::size_t size = 1;
    std::uint16_t address;
    [[nodiscard]] static constexpr result<std::uint16_t> value(register_view words, std::size_t index) noexcept
    {
        return words[index];
    }
};

/// Whether the words of a request from `index` on, which go to `address`, are this register.
template <typename Place>
[[nodiscard]] constexpr bool holds(Place const& place, std::uint32_t address, register_view words,
                                   std::size_t index) noexcept
{
    return address == place.address and words.size() - index >= Place::size;
}

/// Whether the word of a request at `index`, which goes to `address`, is of this register, and the request has not all of
/// its words. Half a register passes no check and calls nothing, so it is not written: exception 02, as in a typed bank.
template <typename Place>
[[nodiscard]] constexpr bool splits([[maybe_unused]] Place const& place, [[maybe_unused]] std::uint32_t address,
                                    [[maybe_unused]] register_view words, [[maybe_unused]] std::size_t index) noexcept
{
    if constexpr (Place::size == 1) {
        return false;
    } else {
        std::uint32_t const offset = address - place.address; // far above the size in front of the register
        return offset < Place::size and (offset > index or words.size() - index < Place::size - offset);
    }
}

/// Whether the words of a request from `index` on are this register, and no value of it.
template <typename Place>
[[nodiscard]] constexpr bool holds_no_value(Place const& place, std::uint32_t address, register_view words,
                                            std::size_t index) noexcept
{
    return holds(place, address, words, index) and not place.value(words, index);
}

/// Whether a callable takes a value.
template <typename Callable, typename Value> inline constexpr bool takes = std::is_invocable_v<Callable, Value>;
/// Whether a callable that takes a value returns a type.
template <typename Returned, typename Callable, typename Value> inline constexpr bool gives = true;
template <typename Returned, typename Callable, typename Value>
    requires takes<Callable, Value>
inline constexpr bool gives<Returned, Callable, Value> =
    std::is_same_v<std::invoke_result_t<Callable, Value>, Returned>;

/// A callable that is asked before a write; it cannot change itself.
template <typename Place, typename Callable> struct write_check {
    [[no_unique_address]] Place place;
    [[no_unique_address]] Callable call;

    [[nodiscard]] constexpr errc check(std::uint32_t address, register_view words, std::size_t index) const noexcept
    {
        if (not holds(place, address, words, index)) {
            return errc::none;
        }
        auto const value = place.value(words, index);
        return value ? call(*value) : errc::illegal_data_value;
    }
    static constexpr void act(std::uint32_t, register_view, std::size_t) noexcept {}
};

/// A callable that is told after a write.
template <typename Place, typename Callable> struct write_action {
    [[no_unique_address]] Place place;
    [[no_unique_address]] Callable call;

    [[nodiscard]] static constexpr errc check(std::uint32_t, register_view, std::size_t) noexcept { return errc::none; }
    constexpr void act(std::uint32_t address, register_view words, std::size_t index) noexcept
    {
        if (holds(place, address, words, index)) {
            if (auto const value = place.value(words, index)) {
                call(*value);
            }
        }
    }
};

/// No hook.
struct no_hooks {
    template <typename Visit> static constexpr void for_each(Visit&&) noexcept {}
};

/// Hooks in the order in which they were named.
template <typename Before, typename Hook> struct hook_list {
    [[no_unique_address]] Before before;
    [[no_unique_address]] Hook last;

    template <typename Visit> constexpr void for_each(Visit&& visit) noexcept
    {
        before.for_each(visit);
        visit(last);
    }
    template <typename Visit> constexpr void for_each(Visit&& visit) const noexcept
    {
        before.for_each(visit);
        visit(last);
    }
};

/// Whether a bank that lists its registers has this one; one of plain words has any.
template <typename Bank, auto const& R> inline constexpr bool may_hold = true;
template <typename Bank, auto const& R>
    requires requires { Bank::template contains<R>; }
inline constexpr bool may_hold<Bank, R> = Bank::template contains<R>;

/// Whether a bank has typed registers and nothing else.
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
template <register_bank Bank, typename Hooks = no_hooks> class hooked_bank {
public:
    constexpr hooked_bank(Bank& bank, Hooks hooks) noexcept : bank_{&bank}, hooks_{std::move(hooks)} {}

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
            wrong = static_cast<Bank const&>(*bank_).check_write(start, values);
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
        errc const wrong = bank_->write(start, values);
        for (std::size_t i = 0; wrong == errc::none and i < values.size(); ++i) {
            hooks_.for_each([&](auto& hook) { hook.act(address_of(start, i), values, i); });
        }
        return wrong;
    }

    // All else is the bank's own, passed on. Each part is there only where the bank has it, so that a server finds the same
    // functions.

    [[nodiscard]] constexpr errc check_read(std::uint16_t start, std::size_t count) const noexcept
    {
        return bank_->check_read(start, count);
    }
    constexpr errc read(std::uint16_t start, std::size_t count, byte_writer& out) noexcept
    {
        return bank_->read(start, count, out);
    }

    constexpr decltype(auto) coils() noexcept requires requires(Bank& at) { at.coils(); }
    {
        return bank_->coils();
    }
    constexpr decltype(auto) discrete_inputs() noexcept requires requires(Bank& at) { at.discrete_inputs(); }
    {
        return bank_->discrete_inputs();
    }
    constexpr decltype(auto) input_registers() noexcept requires requires(Bank& at) { at.input_registers(); }
    {
        return bank_->input_registers();
    }
    constexpr auto exception_status() noexcept requires requires(Bank& at) { at.exception_status(); }
    {
        return bank_->exception_status();
    }
    constexpr decltype(auto) server_id() noexcept requires requires(Bank& at) { at.server_id(); }
    {
        return bank_->server_id();
    }
    constexpr errc read_fifo(std::uint16_t address, byte_writer& out) noexcept requires requires(Bank& at)
    {
        at.read_fifo(address, out);
    }
    {
        return bank_->read_fifo(address, out);
    }
    constexpr errc check_read_file(file_run run) noexcept requires requires(Bank& at) { at.check_read_file(run); }
    {
        return bank_->check_read_file(run);
    }
    constexpr errc read_file(file_run run, byte_writer& out) noexcept requires requires(Bank& at)
    {
        at.read_file(run, out);
    }
    {
        return bank_->read_file(run, out);
    }
    constexpr errc check_write_file(file_run run, register_view values) noexcept requires requires(Bank& at)
    {
        at.check_write_file(run, values);
    }
    {
        return bank_->check_write_file(run, values);
    }
    constexpr errc write_file(file_run run, register_view values) noexcept requires requires(Bank& at)
    {
        at.write_file(run, values);
    }
    {
        return bank_->write_file(run, values);
    }
    constexpr auto respond(function_code function, pdu_buffer& pdu) noexcept requires requires(Bank& at)
    {
        at.respond(function, pdu);
    }
    {
        return bank_->respond(function, pdu);
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
        return hooked_bank<Bank, hooks>{*bank_, hooks{std::move(hooks_), std::move(hook)}};
    }

    static constexpr std::uint32_t address_of(std::uint16_t start, std::size_t index) noexcept
    {
        return std::uint32_t{start} + static_cast<std::uint32_t>(index);
    }

    Bank* bank_;
    [[no_unique_address]] Hooks hooks_;
};

} // namespace detail

/// Puts hooks in front of a bank of any kind: `with_hooks(registers).check<R>(call).on_write<R>(call)`, or by address,
/// `.check(100, call).on_write(100, call)`. The bank must outlive what this returns; the callables are stored in that.
/// No heap; a server without hooks pays nothing for them.
template <register_bank Bank> [[nodiscard]] constexpr auto with_hooks(Bank& bank) noexcept
{
    return detail::hooked_bank<Bank>{bank, detail::no_hooks{}};
}
template <register_bank Bank> constexpr auto with_hooks(Bank const&& bank) noexcept
{
    static_assert(not std::is_object_v<Bank>,
                  "a bank that ends with its expression cannot be served: give it a name, and the hooks refer to it");
    return bank;
}

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

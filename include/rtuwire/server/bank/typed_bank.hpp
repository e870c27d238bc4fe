// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A server's registers by type: each has its own address, limits and access, which the bank enforces. For a device of
// your own as well as for a drive.
#pragma once

#include <type_traits>

#include <rtuwire/core/version.hpp>
#include <rtuwire/server/bank/typed_space.hpp>
#include <rtuwire/table/key_index.hpp>
#include <rtuwire/table/register.hpp>
#include <rtuwire/table/setting.hpp>
#include <rtuwire/table/table.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The registers of a bank that has other kinds than holding registers, too.
/// Internal.
template <auto const&... Registers>
class bank_of_kinds : public typed_words<bank_space<register_space::holding, Registers...>> {
    template <register_space Space> using list = bank_space<Space, Registers...>;
    using holding = typed_words<list<register_space::holding>>;

public:
    /// What a server of function 04 asks for.
    [[nodiscard]] constexpr auto& input_registers() noexcept requires(list<register_space::input>::size > 0)
    {
        return inputs_;
    }
    /// What a server of functions 01, 05 and 15 asks for.
    [[nodiscard]] constexpr auto& coils() noexcept requires(list<register_space::coil>::size > 0) { return coils_; }
    /// What a server of function 02 asks for.
    [[nodiscard]] constexpr auto& discrete_inputs() noexcept requires(list<register_space::discrete_input>::size > 0)
    {
        return discrete_inputs_;
    }

protected:
    template <register_space Space> [[nodiscard]] constexpr auto& part() noexcept { return part_of<Space>(*this); }
    template <register_space Space> [[nodiscard]] constexpr auto const& part() const noexcept
    {
        return part_of<Space>(*this);
    }

private:
    template <register_space Space, typename Self> static constexpr auto& part_of(Self& self) noexcept
    {
        if constexpr (Space == register_space::holding) {
            return static_cast<std::conditional_t<std::is_const_v<Self>, holding const, holding>&>(self);
        } else if constexpr (Space == register_space::input) {
            return self.inputs_;
        } else if constexpr (Space == register_space::coil) {
            return self.coils_;
        } else {
            return self.discrete_inputs_;
        }
    }

    typed_words<list<register_space::input>> inputs_{};
    typed_bits<list<register_space::coil>> coils_{};
    typed_bits<list<register_space::discrete_input>> discrete_inputs_{};
};

/// Holding registers only.
/// Internal.
template <auto const&... Registers>
class bank_of_holding : public typed_words<bank_space<register_space::holding, Registers...>> {
    using words = typed_words<bank_space<register_space::holding, Registers...>>;

protected:
    template <register_space> [[nodiscard]] constexpr words& part() noexcept { return *this; }
    template <register_space> [[nodiscard]] constexpr words const& part() const noexcept { return *this; }
};

/// The values of some registers of any kinds, initially their factory values (0 where none is known). Exception 02:
/// reading an address without a register, writing one, writing a read-only register, or reading or writing only part of
/// a register of several words. Exception 03, only if none of the registers written is a case of 02: a value outside its
/// register's limits, one that is no value (a floating point number that is infinite or none), or one that the names of
/// its enumeration do not list (`enumerators`; any value is allowed where they are not given). A signed register's words
/// are compared as signed. Nothing is written in part.
template <auto const&... Registers>
class bank : public std::conditional_t<are_all<(Registers.space == register_space::holding)...>,
                                       bank_of_holding<Registers...>, bank_of_kinds<Registers...>> {
    using registers = table<Registers...>;
    static_assert(are_all<has_own_steps<Registers>...>,
                  "another register sets this register's steps: name them with restepped");
    static_assert(registers::size == sizeof...(Registers)); // a table refuses registers that overlap

public:
    /// Itself, to be known by: nobody has to find out which registers the bank has.
    /// Internal.
    using typed_bank = bank;

    /// Whether a register is one of this bank's.
    template <auto const& R> static constexpr bool contains = registers::template contains<R>;

    /// The value of a register; of one whose words may be no value (a floating point number, `known` enumerators) a
    /// result.
    template <auto const& R> [[nodiscard]] constexpr auto get() const noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        return this->template part<R.space>().template value<R>();
    }

    /// Sets a register from the device's own side, also where a client may only read it.
    template <auto const& R> constexpr void set(value_of<R> value) noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        this->template part<R.space>().template set_value<R>(value);
    }

    /// Whether a client has written a register since the last call.
    template <auto const& R> [[nodiscard]] constexpr bool take_written() noexcept
    {
        static_assert(registers::template contains<R>, "this bank has no such register");
        bool& is_written = this->template part<R.space>().template written<R>();
        bool const was = is_written;
        is_written = false;
        return was;
    }
};

} // namespace rtuwire

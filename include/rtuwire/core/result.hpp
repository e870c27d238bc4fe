// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// A value or the reason why there is none, with the member names of std::expected. Reading a missing value
// does not compile in a constant expression; at run time, where RTUWIRE_CHECKED is 1, it stops the program.
// Knows of errc only that its zero is no error; wire/errc.hpp says what the codes mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <rtuwire/core/version.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {

namespace detail {

/// What a stream becomes for the operators of values that nothing shows, so that the compiler says a sentence in place of
/// all that a std::ostream takes; one that takes a std::ostream is better. It knows a stream by its sentry, so that no
/// header of streams is needed.
struct include_rtuwire_print_hpp_to_show_this {
    template <typename Stream>
        requires requires { typename Stream::sentry; }
    include_rtuwire_print_hpp_to_show_this(Stream const&) = delete;
};

/// The same for a result, which rtuwire/print.hpp shows where it shows its value.
struct include_rtuwire_print_hpp_or_show_its_value_or_its_error {
    template <typename Stream>
        requires requires { typename Stream::sentry; }
    include_rtuwire_print_hpp_or_show_its_value_or_its_error(Stream const&) = delete;
};

} // namespace detail

enum class errc : std::uint8_t;

/// A hook for the program to define: called once before the program traps because it read the value of a
/// result that failed with `why`, or a register that a view does not have (`invalid_address_range`). A program
/// that runs a motor defines it, and stops the motor in it:
///
///     void rtuwire::on_missing_value(rtuwire::errc) noexcept { board::motor_off(); }
///
/// A program without it only traps. Either says why on its standard error before, on a POSIX system with ELF. All builds
/// of rtuwire in one program share the hook, so that each calls it. Where functions that are missing cannot be linked, on
/// Windows and macOS, it is looked for by its name when it is needed: it stands in the program itself, not in a library that is
/// loaded, and on macOS it is [[gnu::used]] where the linker drops what nobody calls.
#if defined(_WIN32)
[[gnu::dllexport]] void on_missing_value(errc why) noexcept __asm__("rtuwire_on_missing_value");
#elif defined(__APPLE__)
[[gnu::visibility("default")]] void on_missing_value(errc why) noexcept __asm__("_rtuwire_on_missing_value");
#else
[[gnu::weak]] void on_missing_value(errc why) noexcept __asm__("rtuwire_on_missing_value");
#endif

namespace detail {

#if defined(_WIN32) || defined(__APPLE__)

// The system's own calls, by names that its headers do not know.
#if defined(_WIN32) && defined(__i386__)
extern "C" [[gnu::stdcall]] void* rtuwire_module(char const*) __asm__("_GetModuleHandleA@4");
extern "C" [[gnu::stdcall]] void* rtuwire_symbol(void*, char const*) __asm__("_GetProcAddress@8");
#elif defined(_WIN32)
extern "C" void* rtuwire_module(char const*) __asm__("GetModuleHandleA");
extern "C" void* rtuwire_symbol(void*, char const*) __asm__("GetProcAddress");
#else
extern "C" void* rtuwire_symbol(void*, char const*) __asm__("_dlsym");
#endif

inline void call_missing_value_hook(errc why) noexcept
{
#ifdef _WIN32
    void* const program = rtuwire_module(nullptr);
#else
    auto* const program = reinterpret_cast<void*>(std::intptr_t{-2}); // RTLD_DEFAULT
#endif
    if (void* const hook = rtuwire_symbol(program, "rtuwire_on_missing_value"); hook != nullptr) {
        reinterpret_cast<void (*)(errc) noexcept>(hook)(why);
    }
}

#else

[[gnu::always_inline]] inline void call_missing_value_hook(errc why) noexcept
{
    if (on_missing_value != nullptr) {
        on_missing_value(why);
    }
}

#endif

#if RTUWIRE_HAS_SYSTEM && defined(__ELF__)

/// POSIX's `write`, by a name that its header does not know; null where there is none.
extern "C" [[gnu::weak]] long rtuwire_posix_write(int, void const*, std::size_t) __asm__("write");

/// Says on the standard error why the program ends.
inline void tell_missing_value(errc why) noexcept
{
    constexpr int standard_error = 2;
    char text[]{"rtuwire: the program ends: it read a value that is not there (errc 0x00, see rtuwire/wire/errc.hpp): "
                "look at has_value() or size() first\n"};
    constexpr char const* digits = "0123456789ABCDEF";
    constexpr std::size_t place = 69; // of the two digits
    text[place] = digits[static_cast<unsigned>(why) >> 4U & 0xFU];
    text[place + 1] = digits[static_cast<unsigned>(why) & 0xFU];
    if (rtuwire_posix_write != nullptr) {
        static_cast<void>(rtuwire_posix_write(standard_error, text, sizeof text - 1));
    }
}

#else

inline void tell_missing_value(errc) noexcept {}

#endif

} // namespace detail

/// Ends a program that misuses a result: reads a value that is not there, or fails without an error. Not
/// constexpr, so that in a constant expression the compiler reports one of these names.
[[noreturn, gnu::cold, gnu::noinline]] inline void a_failed_result_has_no_value(errc why) noexcept
{
    detail::call_missing_value_hook(why);
    detail::tell_missing_value(why);
    __builtin_trap();
}
[[noreturn]] inline void a_failed_result_has_an_error() noexcept { a_failed_result_has_no_value(errc{}); }

namespace detail {

/// Whether misuse is checked here: always in a constant expression.
[[nodiscard, gnu::always_inline]] constexpr bool is_misuse_caught() noexcept
{
    return RTUWIRE_CHECKED or __builtin_is_constant_evaluated();
}

/// A union has no copy and no end of a member's own, so that copying one shows whether the member is copied as bytes.
template <typename T> union maybe_unset {
    char unset;
    T value;
};

/// Whether a result can hold a value. The union answers for almost all types, for a quarter of what the standard trait
/// costs the compiler, which is asked only where the union says no.
template <typename T>
concept copied_as_bytes = requires(maybe_unset<T>& to, maybe_unset<T> const& from)
{
    maybe_unset<T>(from);
    to = from;
}
or std::is_trivially_copyable_v<T>;

} // namespace detail

/// A value, or an errc. The value may be read only where `has_value()`; the top of this file says what
/// happens otherwise.
template <typename T> class [[nodiscard]] result {
    static_assert(detail::copied_as_bytes<T>, "a result holds trivially copyable values only");

public:
    using value_type = T;

    constexpr result(T const& its_value) noexcept : value_{its_value} {}

    /// A failure; `error` is not zero.
    constexpr result(errc error) noexcept : nothing_{}, error_{error}
    {
        if (detail::is_misuse_caught() and has_value()) {
            a_failed_result_has_an_error();
        }
    }

    [[nodiscard]] constexpr bool has_value() const noexcept { return error_ == errc{}; }
    explicit constexpr operator bool() const noexcept { return has_value(); }

    [[nodiscard]] constexpr T const& operator*() const& noexcept
    {
        require_value();
        return value_;
    }
    /// For a temporary result: the value itself, so that a reference to it stays valid, and an object that would
    /// keep a view of its bytes is refused as for any other temporary.
    [[nodiscard]] constexpr T operator*() const&& noexcept
    {
        require_value();
        return value_;
    }
    [[nodiscard]] constexpr T const* operator->() const noexcept
    {
        require_value();
        return &value_;
    }

    /// Why there is no value; zero when there is one.
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }

    [[nodiscard]] constexpr T value_or(T const& other) const noexcept { return has_value() ? value_ : other; }

    /// Calls `next` with the value, or passes the error on. `next` returns a result.
    template <typename Next> constexpr auto and_then(Next&& next) const -> std::invoke_result_t<Next, T const&>
    {
        if (not has_value()) {
            return error_;
        }
        return next(value_);
    }

    /// Equal when both hold equal values or the same error.
    friend constexpr bool operator==(result const& left, result const& right)
    {
        return left.error_ == right.error_ and (not left.has_value() or left.value_ == right.value_);
    }

    /// Equal to a value when it holds an equal one.
    template <typename Other>
        requires(not std::is_same_v<Other, errc>)
    friend constexpr bool operator==(result const& left, Other const& right)
    {
        return left.has_value() and left.value_ == right;
    }

    /// Equal to an error when it holds that one.
    friend constexpr bool operator==(result const& left, errc right) noexcept
    {
        return not left.has_value() and left.error_ == right;
    }

private:
    constexpr void require_value() const noexcept
    {
        if (detail::is_misuse_caught() and not has_value()) {
            a_failed_result_has_no_value(error_);
        }
    }

    struct nothing {};
    union {
        nothing nothing_;
        T value_;
    };
    errc error_{};
};

/// Success, or an errc.
template <> class [[nodiscard]] result<void> {
public:
    using value_type = void;

    constexpr result() noexcept = default;
    constexpr result(errc error) noexcept : error_{error} {}

    [[nodiscard]] constexpr bool has_value() const noexcept { return error_ == errc{}; }
    explicit constexpr operator bool() const noexcept { return has_value(); }
    [[nodiscard]] constexpr errc error() const noexcept { return error_; }

    friend constexpr bool operator==(result left, errc right) noexcept
    {
        return left.error_ == right and right != errc{};
    }

private:
    errc error_{};
};

/// Does not compile.
void operator<<(detail::include_rtuwire_print_hpp_to_show_this, errc);
template <typename T>
void operator<<(detail::include_rtuwire_print_hpp_or_show_its_value_or_its_error, result<T> const&);

} // namespace RTUWIRE_BUILD
} // namespace rtuwire

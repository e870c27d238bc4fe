// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// What became of the write of one parameter: decided by what the drive holds afterwards, not by what it said. Knows no
// request.
// Internal: may change with any version.
#pragma once

#include <cstdint>
#include <optional>

#include <rtuwire/altivar/maintenance/restore_options.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/errc.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// Decides one write, step by step. Each write is sent once, to a drive that was just checked; after no response it is
/// read back, and sent again after another check. What follows each step:
///
/// | step         | what came               | next      | told as                                        |
/// |--------------|-------------------------|-----------|------------------------------------------------|
/// | check failed |                         | end       | not_reached                                    |
/// | write        | confirmed               | read back |                                                |
/// |              | confirmed, of the link  | the next  | not_read_back                                  |
/// |              | exception               | read back |                                                |
/// |              | no response             | read back |                                                |
/// |              | never sent              | end       | not_reached                                    |
/// |              | other                   | end       | unconfirmed                                    |
/// | read back    | the wanted word         | the next  | written                                        |
/// |              | another, confirmed      | the next  | differs                                        |
/// |              | another, refused        | the next  | refused                                        |
/// |              | another, no response    | check     | the fifth time: end, not_reached               |
/// |              | exception               | the next  | unconfirmed; refused where the write was       |
/// |              | other                   | end       | unconfirmed                                    |
class row_write {
public:
    enum class verdict : std::uint8_t {
        read_back,
        check_again, ///< and write again
        next,        ///< the parameter is told
        end,         ///< it is told, and the restore ends
    };

    constexpr row_write() noexcept = default;

    /// A write of `wanted` to a register that holds `held`; one of the link is not read back.
    constexpr row_write(std::uint16_t wanted, std::uint16_t held, bool is_of_link) noexcept
        : report_{restore_outcome::not_reached, held}, wanted_{wanted}, is_of_link_{is_of_link}
    {}

    /// The word that is sent.
    [[nodiscard]] constexpr std::uint16_t wanted() const noexcept { return wanted_; }

    /// The drive may not be written to, or the write was never sent.
    constexpr verdict stop(errc error) noexcept { return tell(restore_outcome::not_reached, error, verdict::end); }

    constexpr verdict confirm() noexcept
    {
        is_confirmed_ = true;
        error_ = errc::none;
        return is_of_link_ ? tell(restore_outcome::not_read_back, errc::none, verdict::next) : verdict::read_back;
    }

    /// The write was sent, and failed.
    constexpr verdict fail(errc error) noexcept
    {
        error_ = error;
        return is_exception(error) or is_silence(error) ? verdict::read_back : lose(error);
    }

    /// It was read back.
    constexpr verdict compare(std::uint16_t word) noexcept
    {
        report_.held = word;
        if (word == wanted_) {
            return tell(restore_outcome::written, errc::none, verdict::next);
        }
        if (is_confirmed_) {
            return tell(restore_outcome::differs, errc::none, verdict::next);
        }
        if (is_exception(error_)) {
            return tell(restore_outcome::refused, error_, verdict::next);
        }
        constexpr std::uint8_t most_attempts = 5;
        return ++attempts_ < most_attempts ? verdict::check_again : stop(error_);
    }

    /// It could not be read back.
    constexpr verdict go_without(errc error) noexcept
    {
        if (not is_exception(error)) {
            return lose(error);
        }
        if (is_exception(error_)) {
            return tell(restore_outcome::refused, error_, verdict::next);
        }
        report_.held = std::nullopt;
        return tell(restore_outcome::unconfirmed, error, verdict::next);
    }

    [[nodiscard]] constexpr restore_report const& report() const noexcept { return report_; }

    /// Whether it was confirmed, or read back as wanted.
    [[nodiscard]] constexpr bool has_written() const noexcept
    {
        return report_.outcome == restore_outcome::written or report_.outcome == restore_outcome::not_read_back;
    }

private:
    /// Whether it is worth asking the drive; not where its user gave it up.
    static constexpr bool is_silence(errc error) noexcept
    {
        error_category const of = category_of(error);
        bool const is_given_up = error == errc::cancelled;
        return not is_given_up and (of == error_category::no_response or of == error_category::reception);
    }

    constexpr verdict lose(errc error) noexcept
    {
        report_.held = std::nullopt;
        return tell(restore_outcome::unconfirmed, error, verdict::end);
    }

    constexpr verdict tell(restore_outcome outcome, errc error, verdict next) noexcept
    {
        report_.outcome = outcome;
        report_.error = error;
        return next;
    }

    restore_report report_{restore_outcome::not_reached};
    std::uint16_t wanted_{0};
    std::uint8_t attempts_{0};
    errc error_{errc::none}; ///< of the write
    bool is_confirmed_{false};
    bool is_of_link_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

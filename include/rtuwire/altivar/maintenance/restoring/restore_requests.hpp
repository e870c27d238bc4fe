// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The requests of a restore, as a client has to know them: one at a time, a block or a word to read, a word to write, a
// pause between. What follows from a response, `restore` decides, which derives from this.
// Internal: may change with any version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/altivar/procedure/procedure.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// A commander of one unit that has a request, a pause, or its end.
class restore_requests : public detail::commander {
public:
    static constexpr conversation_properties properties{.urgency = detail::urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
    static constexpr function_set asks{function_code::read_holding_registers, function_code::write_single_register,
                                       function_code::encapsulated_interface};

    using commander::unit;

    /// For the client: what the next request does to the motor, and when a unit counts as lost.
    [[nodiscard]] constexpr detail::effect intent() const noexcept { return this->effect_now(does_); }
    [[nodiscard]] constexpr duration drive_timeout() const noexcept { return layout_->longest_silence; }
    [[nodiscard]] static constexpr std::uint8_t tolerated_misses() noexcept { return 1; }

    constexpr std::optional<request_frame> next() noexcept
    {
        if (now_is_ != kind::request) {
            return std::nullopt;
        }
        is_asking_ = true;
        return request_frame{byte_view{frame_}.first(size_), again_};
    }

    /// Whether it has ended.
    [[nodiscard]] constexpr bool settled() const noexcept { return now_is_ == kind::end; }

    /// When `advance` has something to do; nothing while a request is under way.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept
    {
        return now_is_ == kind::pause ? deadline{pause_end_} : deadline{};
    }

protected:
    constexpr restore_requests(unit_id its_unit, drive_layout const& layout) noexcept
        : commander{its_unit}, layout_{&layout}
    {}

    [[nodiscard]] constexpr drive_layout const& layout() const noexcept { return *layout_; }
    [[nodiscard]] constexpr bool has_begun() const noexcept { return now_is_ != kind::nothing; }
    [[nodiscard]] constexpr bool is_asking() const noexcept { return is_asking_; }
    [[nodiscard]] constexpr bool is_stopping() const noexcept { return does_ == detail::effect::stopping; }

    constexpr void tick(instant now) noexcept
    {
        if (now_is_ == kind::pause) {
            detail::keep_over(pause_end_, now, detail::within_reach(now_, now));
        }
        now_ = now;
    }
    [[nodiscard]] constexpr bool is_pause_over() const noexcept
    {
        return now_is_ == kind::pause and reached(now_, pause_end_);
    }
    constexpr void note_outcome() noexcept { is_asking_ = false; }

    constexpr void read_block(detail::address_block block) noexcept
    {
        count_ = block.count;
        put(encode_into(frame_, unit(), read_holding_registers{block.start, block.count}));
    }

    /// The product code, by function 43/14. A drive of conformity 02 has no access to a single object.
    constexpr void read_product() noexcept
    {
        put(encode_into(frame_, unit(), read_device_identification{identification_access::basic, product_code}));
    }

    /// What a procedure decided, unless that is its end.
    constexpr void perform(action what) noexcept
    {
        if (what_of(what) == action_kind::pause) {
            now_is_ = kind::pause;
            does_ = detail::effect::none;
            pause_end_ = now_ + length_of(what);
        } else if (what_of(what) == action_kind::read) {
            read_block({address_of(what), 1});
        } else if (what_of(what) == action_kind::write) {
            count_ = 0;
            put(encode_into(frame_, unit(), write_single_register{address_of(what), word_of(what)}),
                repetition_of(what), effect_of(what));
        }
    }

    constexpr void end() noexcept
    {
        now_is_ = kind::end;
        does_ = detail::effect::none;
    }

    /// The words of a block that was read, or why there are none.
    [[nodiscard]] constexpr result<register_view> words_of(result<response> const& outcome) const noexcept
    {
        if (not outcome) {
            return outcome.error();
        }
        auto const told = outcome->to<read_holding_registers>();
        if (not told) {
            return told.error();
        }
        return told->registers.size() == count_ ? result<register_view>{told->registers} : errc::wrong_length;
    }

    /// The same for a procedure that asked for a word, or wrote one.
    [[nodiscard]] constexpr event event_of(result<response> const& outcome) const noexcept
    {
        if (count_ == 0) {
            return outcome ? event{event::kind::written} : event{event::kind::failed, 0, outcome.error()};
        }
        auto const words = words_of(outcome);
        return words ? event{event::kind::word_read, (*words)[0]} : event{event::kind::failed, 0, words.error()};
    }

private:
    enum class kind : std::uint8_t { nothing, request, pause, end };

    constexpr void put(result<byte_span> const& frame, repetition again = repetition::allowed,
                       detail::effect does = detail::effect::none) noexcept
    {
        size_ = static_cast<std::uint8_t>(frame ? frame->size() : 0);
        now_is_ = kind::request;
        again_ = again;
        does_ = does;
    }

    drive_layout const* layout_;
    instant now_{0};
    instant pause_end_{0};
    std::array<std::byte, 8> frame_{};
    std::uint16_t count_{0}; ///< how many words were asked for; 0 after a write
    std::uint8_t size_{0};
    kind now_is_{kind::nothing};
    repetition again_{repetition::allowed};
    detail::effect does_{detail::effect::none};
    bool is_asking_{false};
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

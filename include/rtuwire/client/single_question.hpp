// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// The conversation of one question: it owns the question and keeps a copy of the answer, so that nothing
// else on the line can change what it says.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <rtuwire/client/conversation.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/wire/limits.hpp>
#include <rtuwire/wire/pdu/write_multiple_registers.hpp>
#include <rtuwire/wire/pdu/write_single_register.hpp>

namespace rtuwire::inline RTUWIRE_BUILD {

/// The largest answer PDU to a question of this type, in octets.
template <typename Request> inline constexpr std::size_t largest_answer = max_pdu_size;
template <> inline constexpr std::size_t largest_answer<write_single_register> = 5;
template <typename Words>
inline constexpr std::size_t largest_answer<write_multiple_registers<Words>> = 5;

/// One question in a frame of at most `FrameSize` octets, and room for an answer PDU of `AnswerSize`.
template <std::size_t FrameSize, std::size_t AnswerSize> class framed_question : public asker {
public:
    /// Encodes the question; where that fails, nothing is asked and `outcome()` says why.
    template <typename To, pdu Request>
    constexpr framed_question(To to, Request const& question) noexcept
    {
        auto const written = encode_into(frame_, to, question);
        if (written) {
            size_ = static_cast<std::uint16_t>(written->size());
        } else {
            error_ = written.error();
        }
    }

    /// Asks the same once more; the outcome is then `pending` again.
    constexpr void begin() noexcept
    {
        if (size_ != 0) {
            forget();
            error_ = errc::pending;
        }
    }

    constexpr std::optional<request> next() const& noexcept
    {
        if (settled()) {
            return std::nullopt;
        }
        return request{byte_view{frame_}.first(size_)};
    }
    std::optional<request> next() const&& = delete;

    constexpr void accept(result<response> const& outcome) noexcept
    {
        error_ = outcome.error();
        if (not outcome) {
            return;
        }
        byte_view const pdu = outcome->pdu();
        if (pdu.size() > AnswerSize) {
            error_ = errc::wrong_length;
            return;
        }
        answer_size_ = static_cast<std::uint8_t>(pdu.size());
        for (std::size_t i = 0; i < pdu.size(); ++i) {
            answer_[i] = pdu[i];
        }
    }

    /// Whether the outcome is there.
    [[nodiscard]] constexpr bool settled() const noexcept { return error_ != errc::pending; }

    /// What came of it, `pending` until it is settled. The answer is a view of this conversation's memory.
    [[nodiscard]] constexpr result<response> outcome() const& noexcept
    {
        if (error_ != errc::none) {
            return error_;
        }
        return response{byte_view{answer_}.first(answer_size_)};
    }
    result<response> outcome() const&& = delete;

private:
    std::array<std::byte, FrameSize> frame_{};
    std::array<std::byte, AnswerSize> answer_{};
    std::uint16_t size_{0};
    std::uint8_t answer_size_{0};
    errc error_{errc::pending};
};

/// The conversation of one question of a type: `single_question ask{unit_id{7}, read_holding_registers{...}}`.
template <pdu Request>
class single_question
    : public framed_question<Request::max_size + adu_overhead, largest_answer<Request>> {
public:
    template <typename To>
    constexpr single_question(To to, Request const& question) noexcept
        : framed_question<Request::max_size + adu_overhead, largest_answer<Request>>{to, question}
    {
        static_assert(std::same_as<To, unit_id> or broadcastable<Request>,
                      "a broadcast has no answer, so only a write can be broadcast");
    }
};

template <typename To, pdu Request> single_question(To, Request) -> single_question<Request>;

} // namespace rtuwire

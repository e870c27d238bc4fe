// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// One conversation twice: with the library and with the model. Both get the same requests and note what they are
// told.
#pragma once

#include <rtuwire/ask/conversation.hpp>

#include "compare.hpp"
#include "model_conversation.hpp"

namespace compare {

using model::bytes;
using model::microseconds;

/// What a conversation was told.
struct outcome {
    int whom;
    int error;
    bytes pdu;

    friend bool operator==(outcome const&, outcome const&) = default;
};

/// What a conversation asks, and until when.
struct procedure {
    int id{0};
    std::vector<bytes> requests{};
    std::size_t at{0};
    bool may_be_repeated{true};
    bool is_thinking{false}; ///< has no request for now
    bool is_settled{true};
    bool is_endless{false};
    std::vector<outcome>* told{nullptr};
    unsigned asked{0}; ///< how often `next` was called

    bytes const* next()
    {
        ++asked;
        return is_thinking or is_settled ? nullptr : &requests[at % requests.size()];
    }
    void accept(int error, bytes const& pdu)
    {
        told->push_back({id, error, pdu});
        ++at;
        is_settled = is_settled or (not is_endless and at >= requests.size());
    }
};

/// With the library.
struct engine_conversation : rtuwire::asker {
    procedure says;

    std::optional<rtuwire::request_frame> next()
    {
        bytes const* const frame = says.next();
        if (frame == nullptr) {
            return std::nullopt;
        }
        return rtuwire::request_frame{view(*frame),
                                      says.may_be_repeated ? rtuwire::repetition::allowed : rtuwire::repetition::never};
    }
    void accept(rtuwire::result<rtuwire::response> const& outcome)
    {
        if (outcome) {
            says.accept(0, copy(outcome->pdu()));
        } else {
            says.accept(static_cast<int>(outcome.error()), {});
        }
    }
    bool settled() const { return says.is_settled; }
};
/// The same with a unit of its own, for which the line must be free.
struct prompt_engine_conversation : engine_conversation {
    static constexpr rtuwire::conversation_properties properties{.freshness = rtuwire::freshness::when_free};
    std::uint8_t own_unit{1};
    rtuwire::unit_id unit() const { return *rtuwire::unit_id::checked(own_unit); }
};

/// With the model.
struct model_conversation : model::conversation {
    procedure says;

    std::optional<model::request_frame> next() override
    {
        bytes const* const frame = says.next();
        if (frame == nullptr) {
            return std::nullopt;
        }
        return model::request_frame{*frame, says.may_be_repeated};
    }
    void accept(model::fault error, bytes const& pdu) override { says.accept(error, pdu); }
    bool settled() const override { return says.is_settled; }
};

/// The two of them.
struct both {
    prompt_engine_conversation engine{};
    model_conversation second{};

    void say(procedure const& what, int prompt_unit)
    {
        std::vector<outcome>* const own = second.says.told;
        std::vector<outcome>* const engines = engine.says.told;
        engine.says = second.says = what;
        engine.says.told = engines;
        second.says.told = own;
        second.prompt_unit = prompt_unit;
        engine.own_unit = static_cast<std::uint8_t>(std::max(prompt_unit, 1));
    }
    void forget()
    {
        engine.forget();
        second.whose.forget();
    }
    bool is_prompt() const { return second.prompt_unit >= 0; }
};

} // namespace compare

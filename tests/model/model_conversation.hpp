// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What asks a model client, and whose turn it is (rules 20 to 23). Shares no code with the headers.
#pragma once

#include "model_line.hpp"

namespace model {

/// Who holds which request; a copy holds the same.
struct asker {
    void const* line{nullptr}; ///< where
    long number{0};            ///< of the request asked last, or of the one that was under way when it was marked
    bool is_due{false};        ///< its outcome did not come yet
    bool is_marked{false};     ///< as in rule 21; a mark takes the place of a number
    int generation{0};         ///< of its mark

    void forget() { is_due = false; }
};

struct request_frame {
    bytes frame;
    bool may_be_repeated;
};

/// A conversation with a client; `prompt_unit` is none or that of a prompt conversation.
struct conversation {
    asker whose{};
    int prompt_unit{-1};

    conversation() = default;
    conversation(conversation const&) = default;
    conversation& operator=(conversation const&) = default;
    virtual ~conversation() = default;
    virtual std::optional<request_frame> next() = 0;
    virtual void accept(fault error, bytes const& pdu) = 0;
    virtual bool settled() const = 0;
};

enum class standing { waits, is_next, is_last };

/// The turns of a line.
struct turns {
    long last{1};      ///< the number of who asked last
    int generation{0}; ///< of the marks that are good; a mark that was void four times counts again
    bool others_wait{false};
    bool is_missed{false};

    bool is_last(asker const& who) const { return who.line == this and not who.is_marked and who.number == last; }
    bool is_due(asker const& who) const { return is_last(who) and who.is_due; }
    /// Whether the request of `who` was dropped: somebody asked since, or nothing is under way.
    bool is_lost(asker const& who, bool is_idle) const
    {
        return who.line == this and who.is_due and (is_idle or who.number != last);
    }
    void void_marks() { generation = (generation + 1) % 4; }
    /// Somebody comes by where it may not ask.
    standing visit(asker& who)
    {
        if (is_last(who)) {
            return standing::is_last;
        }
        others_wait = true;
        bool const is_next = who.line == this and who.is_marked and who.number == last and who.generation == generation;
        if (is_next) {
            void_marks();
        }
        who = asker{this, last, false, true, generation};
        return is_next ? standing::is_next : standing::waits;
    }
    void take(asker& who)
    {
        renew(who);
        who.is_due = true;
    }
    /// Another number for who asked last: all marks are void, and copies of `who` hold nothing any more.
    void renew(asker& who)
    {
        bool const is_due = who.is_due;
        who = asker{this, ++last, is_due, false, 0};
        is_missed = false;
    }
    /// The outcome of `who` was taken.
    void given(asker& who)
    {
        renew(who);
        who.is_due = false;
    }
};

} // namespace model

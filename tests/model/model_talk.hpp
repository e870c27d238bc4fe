// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// What asks a model client, and whose turn it is (rules 20 to 23). Shares no code with the headers.
#pragma once

#include "model_line.hpp"

namespace model {

/// Who holds which request; a copy holds the same.
struct asker {
    void const* line{nullptr}; ///< where
    long number{0};            ///< of the request asked last
    bool is_due{false};        ///< its outcome did not come yet
    long mark{-1};             ///< as in rule 21, good for one generation of marks

    /// One that is marked counts as the one who asked last from here on.
    void forget()
    {
        is_due = false;
        mark = -1;
    }
};

struct question {
    bytes frame;
    bool may_be_repeated;
};

/// A conversation with a client; `prompt_unit` is none or that of a prompt conversation.
struct talk {
    asker whose{};
    int prompt_unit{-1};

    talk() = default;
    talk(talk const&) = default;
    talk& operator=(talk const&) = default;
    virtual ~talk() = default;
    virtual std::optional<question> next() = 0;
    virtual void accept(fault error, bytes const& pdu) = 0;
    virtual bool settled() const = 0;
};

/// The turns of a line.
struct turns {
    long last{1};  ///< the number of who asked last
    long marks{0}; ///< the generation of marks that are good
    bool others_wait{false};

    bool is_last(asker const& who) const
    {
        return who.line == this and who.mark < 0 and who.number == last;
    }
    bool is_due(asker const& who) const { return is_last(who) and who.is_due; }
    bool is_lost(asker const& who) const
    {
        return who.line == this and who.number != last and who.is_due;
    }
    /// Marks somebody. Whether it was marked already.
    bool marks_again(asker& who) const
    {
        bool const was = who.line == this and who.mark == marks;
        who.line = this;
        who.is_due = false;
        who.mark = marks;
        who.number = last; // and nothing of its own any more
        return was;
    }
    void take(asker& who)
    {
        who.line = this;
        who.number = ++last;
        who.is_due = true;
        who.mark = -1;
        ++marks;
        others_wait = false;
    }
    /// Another number for who asked last: all marks are void, and copies of `who` hold nothing any more.
    void renew(asker& who)
    {
        who.number = ++last;
        ++marks;
    }
    /// The outcome of `who` was taken.
    void given(asker& who)
    {
        renew(who);
        who.is_due = false;
    }
};

} // namespace model

// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
// Says who a unit is.
#include "commands/commands.hpp"
#include "line/line_words.hpp"
#include "line/shared_address.hpp"
#include "line/who_is_it.hpp"
#include "sunspec/model_list.hpp"

namespace tool {

exit_status run_identify(choices const& chosen)
{
    open_line line{chosen.line};
    named_unit const asked = unit_in(chosen.line);
    identity_words const who = who_is_it(line, asked.unit);
    std::string const shared = who.outcome == exit_status::no_answer ? std::string{} : why_shared(line, asked.unit);
    bool const may_be_sunspec = who.drive.empty() and (who.outcome == exit_status::done or who.has_answered);
    sunspec_models const found = may_be_sunspec ? sunspec_models_of(line, asked.unit) : sunspec_models{};
    std::string const models = text_of(found);
    bool const has_failed = found.outcome == exit_status::port;
    std::string const note = not models.empty() ? models : has_failed ? found.failure : who.note;
    output results{chosen.form, false};
    results.put({{"unit", std::int64_t{asked.unit.byte()}},
                 {"vendor", who.vendor},
                 {"product", who.product},
                 {"revision", who.revision},
                 {"drive", who.drive},
                 {"note", note + (note.empty() or shared.empty() ? "" : "; ") + shared}});
    results.finish();
    bool const was_lost = who.outcome == exit_status::port or who.outcome == exit_status::no_answer;
    bool const is_known = (not who.product.empty() and not was_lost) or not who.drive.empty() or not models.empty();
    if (has_failed or (shared.empty() and found.mark and found.outcome != exit_status::done)) {
        return found.outcome;
    }
    return not shared.empty() ? exit_status::differs : is_known ? exit_status::done : who.outcome;
}

} // namespace tool

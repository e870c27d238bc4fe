// SPDX-FileCopyrightText: 2026 The rtuwire authors
// SPDX-License-Identifier: BSL-1.0
//
// Writes a configuration into a drive that stands: what differs, one parameter at a time, each read back. It may be cut
// at any moment: each parameter then holds its old word or the new one, the report says which, and a second restore goes
// on where the first one ended.
//
// Here is each stage and what follows it. What is written in which order is restore_agenda.hpp's, what is told of a
// parameter restore_plan.hpp's, and what stands before and behind one write guarded_write.hpp's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <rtuwire/altivar/device/drive_type.hpp>
#include <rtuwire/altivar/maintenance/block_walk.hpp>
#include <rtuwire/altivar/maintenance/guarded_write.hpp>
#include <rtuwire/altivar/maintenance/restore_plan.hpp>
#include <rtuwire/altivar/procedure/commissioning/last_look.hpp>
#include <rtuwire/altivar/procedure/commissioning/save_to_eeprom.hpp>
#include <rtuwire/ask/commander.hpp>
#include <rtuwire/ask/conversation.hpp>
#include <rtuwire/core/time.hpp>
#include <rtuwire/core/version.hpp>
#include <rtuwire/table/device.hpp>
#include <rtuwire/table/request_plan.hpp>
#include <rtuwire/wire/registers.hpp>
#include <rtuwire/wire/serial_line/device_identification.hpp>

namespace rtuwire {
inline namespace RTUWIRE_BUILD {
namespace altivar {

/// The request that a restore has last made: a block or a word to read, a word to write, or a question who the drive is.
/// Internal.
class restore_request {
public:
    constexpr void read_block(unit_id unit, detail::address_block block) noexcept
    {
        count_ = block.count;
        put(encode_into(frame_, unit, read_holding_registers{block.start, block.count}));
    }

    /// The product code, by function 43/14. A drive of conformity 02 has no access to a single object.
    constexpr void read_product(unit_id unit) noexcept
    {
        put(encode_into(frame_, unit, read_device_identification{identification_access::basic, product_code}));
    }

    /// The read or the write that a procedure decided.
    constexpr void perform(unit_id unit, action what) noexcept
    {
        if (what_of(what) == action_kind::read) {
            return read_block(unit, {address_of(what), count_of(what)});
        }
        count_ = 0;
        put(encode_into(frame_, unit, write_single_register{address_of(what), word_of(what)}), repetition_of(what),
            effect_of(what));
    }

    /// It is over, and does nothing to the motor any more.
    constexpr void clear() noexcept { does_ = detail::effect::none; }

    [[nodiscard]] constexpr request_frame frame() const noexcept
    {
        return request_frame{byte_view{frame_}.first(size_), again_};
    }
    [[nodiscard]] constexpr detail::effect does() const noexcept { return does_; }

    /// What came of it: the words that were read, or an error; for a procedure, which read one or two words or wrote one.
    [[nodiscard]] constexpr result<register_view> words_of(result<response> const& outcome) const noexcept
    {
        return words_in(outcome, count_);
    }
    [[nodiscard]] constexpr event event_of(result<response> const& outcome) const noexcept
    {
        if (count_ == 0) {
            return outcome ? event{event::kind::written} : event{event::kind::failed, 0, outcome.error()};
        }
        auto const words = words_of(outcome);
        return words ? event{event::kind::word_read, (*words)[0], errc::none, (*words)[words->size() - 1]}
                     : event{event::kind::failed, 0, words.error()};
    }

private:
    constexpr void put(result<byte_span> const& frame, repetition again = repetition::allowed,
                       detail::effect does = detail::effect::none) noexcept
    {
        size_ = static_cast<std::uint8_t>(frame ? frame->size() : 0);
        again_ = again;
        does_ = does;
    }

    std::array<std::byte, 8> frame_{};
    std::uint16_t count_{0}; ///< how many words were asked for; 0 after a write
    std::uint8_t size_{0};
    repetition again_{repetition::allowed};
    detail::effect does_{detail::effect::none};
};

/// Restores a configuration: `restore conversation{drive, atv320::parameters, wanted, report, options}`.
///
/// `report(parameter_group const&, parameter const&, restore_report const&)` is called for each parameter of the map; the
/// last call about a parameter counts. What is left out is told before anything is sent, and what is left out for want
/// of an option, once more with the word that the drive holds. ATR, FLR and what else lets the drive start by itself are
/// told with their words before anything is written.
///
/// Before each write, and before it saves, the drive is read to stand (states 2, 3, 4, or in fault), its command to be
/// 0000 and its output frequency 0; before CFG, channels, run inputs, supervision and automatic restart also to be
/// without fault, with its run inputs open. A drive that does not, ends the restore; so does one that names another
/// family. The order of the writes is restore_agenda.hpp's. A motor that a terminal starts before the look after such
/// writes is sent 0000 once; one that it starts later ends the restore as `refused_while_running`.
///
/// What depends on others is not sent without them: a ramp, where the drive does not hold the INR of the configuration,
/// and INR, where a ramp is left out (`other_steps`); TFR, HSP and LSP where they do not fit each other
/// (`out_of_limits`).
///
/// `reason()`: `succeeded` where the drive holds all that was wanted and allowed, or the dry run is told; `not_taken`
/// where it refused some or reads back otherwise, and `failed()` is how many; `other_family`; `refused_while_running`;
/// `overwritten` where its command is not 0000; `run_input_closed`; `unknown_register` where its inputs cannot be read;
/// `in_fault`; `started_by_terminals`; `silent` and `refused`, by `error`; `executed_unconfirmed` where that was after a
/// write of the link's own; `overruled` where this client ordered the unit to run, or a stop came later. A
/// lost response that a repetition or a look made good is not in it: the client's statistics count those (`timeout`).
///
/// The map's groups outlive it; what it calls does not throw.
///
/// | stage     | sends               | answered                              | exception           | no response |
/// |-----------|---------------------|---------------------------------------|---------------------|-------------|
/// | identify  | 43/14               | this family: check; another: fail     | 01, 02, 03: compare | fail        |
/// | compare   | read-only blocks    | the next; after the last: check       | fail: other_family  | fail        |
/// | check     | as `write_guard`    | with a write open: write; with a save | as `write_guard`    | fail        |
/// |           |                     | due: save; else: read                 |                     |             |
/// | read      | the next block      | each parameter that differs: check;   | halves; of a single | fail        |
/// |           |                     | in the end: the next block            | one: the next       |             |
/// | write     | the word, once      | read_back; of the link: the next one  | read_back           | read_back   |
/// | read_back | its register        | as `row_write`: the next parameter, check once more, or fail              |
/// | save      | as `save_procedure` | read                                  | fail                | fail        |
/// | settle    | nothing for 50 ms   | look                                  |                     |             |
/// | look      | as `last_look`      | read; the end, where "fail" began it  | as `last_look`      | the same    |
///
/// "No response" stands behind the client's `retries`; the word of a parameter is never repeated.
///
/// Where no block is left, the next step of the agenda begins; before its first check the drive is identified anew. Settle
/// and look stand behind each step with a delicate write, one that needs more than `write_care::rest`. "Fail" looks first
/// where such a write was sent since the last look, tells of what was not reached, and ends.
template <drive_type Device, typename Words, typename Report> class restore : public detail::commander {
public:
    static constexpr conversation_properties properties{.urgency = detail::urgency::stop_of_unit,
                                                        .freshness = freshness::when_free};
    static constexpr function_set asks{function_code::read_holding_registers, function_code::write_single_register,
                                       function_code::encapsulated_interface};

    using commander::unit;

    /// Writes to this drive what is wanted of the map's parameters; the map's groups and the wanted words outlive it,
    /// the report is copied.
    constexpr restore(station<Device> const& its_drive, parameter_map const& map,
                      wanted_settings<Words> const& its_wanted, Report report,
                      restore_options const& options = {}) noexcept
        : commander{its_drive.unit()}, plan_{map, its_wanted, report, options},
          identity_{drive_family::of(Device::reference), its_wanted.family, map.family(),
                    detail::implements<Device>(function_code::encapsulated_interface)},
          guard_{layout, options.terminals}
    {}

    /// Begins anew, as it was made, and tells each parameter once more. One under way is given up first, as if it had been
    /// destroyed. Not to be called by the report.
    constexpr void again() noexcept
    {
        asker const former{*this};
        static_cast<commander&>(*this) = commander{unit()};
        replace(former);
        plan_.begin();
        identity_ = identity_.anew();
        walk_.begin();
        row_ = {};
        is_in_block_ = false;
        reason_ = {};
        go_to(stage::made);
        is_asking_ = has_lost_ = may_have_started_ = is_given_up_ = is_inside_ = is_unwanted_ = false;
    }

    /// How many writes the drive took: each was read back as wanted, or confirmed where it is the link's own. More than
    /// one a parameter where a later write had undone it.
    [[nodiscard]] constexpr std::uint16_t written() const noexcept { return plan_.progress().written(); }

    /// How many of the parameters that were wanted and allowed the drive does not hold, those among them whose words were
    /// never sent (`out_of_limits`, `other_steps`); known at the end.
    [[nodiscard]] constexpr std::uint16_t failed() const noexcept { return plan_.progress().failed(); }

    /// Whether the drive was told to save what it now holds, and did. It is not told where something is known not to be
    /// held; what only the verification behind it finds is in `failed()`.
    [[nodiscard]] constexpr bool saved() const noexcept { return plan_.progress().is_saved(); }

    /// How it ended; `pending` until it is settled. To be read in the pass in which it settles: from the next visit on it
    /// is `used_already`.
    [[nodiscard]] constexpr altivar::reason reason() const noexcept
    {
        return this->is_used_already() ? altivar::reason{outcome_kind::used_already} : reason_;
    }

    /// Whether it has ended.
    [[nodiscard]] constexpr bool settled() const noexcept { return stage_ == stage::ended; }

    /// Ends it as `aborted`: tells what became of the write under way, and what was not reached. One that has not begun
    /// sends nothing. A last look, what takes the motor's power away, and the end of an order to save are not given up:
    /// run it on until it is settled, however often this is called. A report may call it, too.
    constexpr void cancel() noexcept
    {
        is_unwanted_ = true;
        if (not is_inside_) {
            is_inside_ = true;
            leave();
        }
    }

    /// For the client: what the next request does to the motor, and when a unit counts as lost.
    [[nodiscard]] constexpr detail::effect intent() const noexcept { return this->effect_now(request_.does()); }
    [[nodiscard]] static constexpr duration drive_timeout() noexcept { return layout.longest_silence; }
    [[nodiscard]] static constexpr std::uint8_t tolerated_misses() noexcept { return 1; }

    constexpr std::optional<request_frame> next() noexcept
    {
        if (stage_ == stage::made or settled() or pause_end_) {
            return std::nullopt;
        }
        is_asking_ = true;
        return request_.frame();
    }

    /// When `advance` has something to do; nothing while a request is under way.
    [[nodiscard]] constexpr deadline poll_deadline() const noexcept { return pause_end_; }

    // Each of these is one call of the client; what a report asks for in the middle of one is done at its end.

    /// Processes the time: begins, and ends pauses.
    constexpr void advance(instant now) noexcept
    {
        if (pause_end_) {
            detail::keep_over(*pause_end_, now, detail::within_reach(now_, now));
        }
        now_ = now;
        is_inside_ = true;
        if (stage_ == stage::made) {
            this->note_order();
            begin();
        } else if (not settled() and not is_asking_) {
            go_on_in_time();
        }
        leave();
    }

    constexpr void accept(result<response> const& outcome) noexcept
    {
        is_inside_ = true;
        take(outcome);
        leave();
    }

    constexpr void note_loss() noexcept
    {
        is_inside_ = true;
        has_lost_ = stage_ != stage::made and not settled();
        heed_loss();
        leave();
    }

private:
    enum class stage : std::uint8_t {
        made,
        identify,
        compare,
        check,
        read,
        write,
        read_back,
        save,
        settle,
        look,
        ended
    };

    static constexpr drive_layout const& layout = drive_check<Device>::layout;

    // From stage to stage.

    constexpr void go_to(stage next) noexcept
    {
        stage_ = next;
        pause_end_ = {};
        request_.clear();
    }

    /// With the read, the write or the pause by which it begins or goes on.
    constexpr void go_to(stage next, action what) noexcept
    {
        go_to(next);
        if (what_of(what) == action_kind::pause) {
            pause_end_ = now_ + length_of(what);
        } else {
            request_.perform(unit(), what);
        }
    }

    constexpr void begin() noexcept
    {
        plan_.tell_left_out();
        if (identity_.is_meant()) {
            check();
        } else {
            fail({outcome_kind::other_family});
        }
    }

    constexpr void go_on_in_time() noexcept
    {
        if (is_stopping() and this->is_unit_ordered()) {
            finish({outcome_kind::overruled}); // the motor now runs by an order: it is not this one's to stop
        } else if (pause_end_ and reached(now_, *pause_end_)) {
            run({event::kind::pause_over});
        }
    }

    /// What came of the request of this stage.
    constexpr void take(result<response> const& outcome) noexcept
    {
        bool const was_sent = std::exchange(is_asking_, false);
        switch (stage_) {
        case stage::made:
        case stage::ended: return;
        case stage::identify: on_identification(outcome); break;
        case stage::compare: on_compared(request_.words_of(outcome)); break;
        case stage::read: on_block(request_.words_of(outcome)); break;
        case stage::write: on_write(request_.event_of(outcome), was_sent); break;
        case stage::read_back: on_read_back(request_.event_of(outcome)); break;
        case stage::check:
        case stage::save:
        case stage::settle:
        case stage::look: run(request_.event_of(outcome)); break;
        }
        heed_loss();
    }

    /// The unit was lost: what would wait until the drive has stopped by itself fails now.
    constexpr void heed_loss() noexcept
    {
        if (not has_lost_ or is_asking_ or settled()) {
            return;
        }
        has_lost_ = false;
        if (not is_stopping()) {
            take(errc::unit_lost);
        }
    }

    /// A call that may have reported is over: what its user wants ends now.
    constexpr void leave() noexcept
    {
        if (is_unwanted_ and not settled()) {
            is_unwanted_ = false;
            give_up();
        }
        is_inside_ = false;
    }

    constexpr void give_up() noexcept
    {
        if (stage_ == stage::made) {
            plan_.tell_left_out();
            return finish(reason_for(errc::cancelled));
        }
        is_given_up_ = true;
        bool const is_looking = stage_ == stage::settle or stage_ == stage::look;
        if (not is_looking and not(stage_ == stage::save and save_.is_taking_back())) {
            this->forget();
            take(errc::cancelled);
        }
    }

    [[nodiscard]] constexpr bool is_stopping() const noexcept { return request_.does() == detail::effect::stopping; }

    // Who the drive is, and whether it stands.

    /// Checks the drive: for the write that is open, before it saves, or as a whole.
    constexpr void check() noexcept
    {
        if (identity_.holds()) {
            go_to(stage::check, guard_.begin(care()));
        } else {
            identify();
        }
    }

    constexpr void identify() noexcept
    {
        if (identity_.has_identification()) {
            go_to(stage::identify);
            return request_.read_product(unit());
        }
        walk_.begin();
        compare_next();
    }

    constexpr void on_identification(result<response> const& outcome) noexcept
    {
        errc error{};
        switch (identity_.judge(outcome, error)) {
        case identity_check::verdict::same: return check();
        case identity_check::verdict::not_told: return identify();
        case identity_check::verdict::other: return fail({outcome_kind::other_family, error});
        case identity_check::verdict::not_reached: break;
        }
        fail(reason_for(error));
    }

    constexpr void compare_next() noexcept
    {
        if (walk_.find(plan_.map(), identity_check::is_compared)) {
            return ask_block(stage::compare);
        }
        identity_.note_same();
        check();
    }

    constexpr void on_compared(result<register_view> const& words) noexcept
    {
        if (words) {
            walk_.pass();
            return compare_next();
        }
        fail(is_of_registers(words.error()) ? altivar::reason{outcome_kind::other_family, words.error()}
                                            : reason_for(words.error()));
    }

    constexpr void ask_block(stage next) noexcept
    {
        go_to(next);
        request_.read_block(unit(), walk_.block());
    }

    /// The drive was checked.
    constexpr void on_checked() noexcept
    {
        if (is_write_open()) {
            may_have_started_ = may_have_started_ or care() != write_care::rest;
            go_to(stage::write, once(to_rearrange(row_.row->address, write_.wanted())));
        } else if (plan_.has_to_save()) {
            save_ = save_procedure{layout};
            go_to(stage::save, save_.step({event::kind::begun}));
        } else {
            walk_.begin();
            go_on();
        }
    }

    // The procedures inside: the check before a write, the save, the last look.

    constexpr void run(event what) noexcept
    {
        if (stage_ == stage::check) {
            heed(guard_, guard_.step(what));
        } else if (stage_ == stage::save) {
            heed(save_, save_.step(what));
        } else if (stage_ == stage::look) {
            heed(look_, look_.step(what));
        } else {
            look_at_last({outcome_kind::succeeded});
        }
    }

    constexpr void heed(procedure& inner, action next) noexcept
    {
        this->note_power(inner.take_power());
        if (inner.take_fault()) {
            this->note_fault();
        }
        if (what_of(next) != action_kind::end) {
            return go_to(stage_, next);
        }
        may_have_started_ = may_have_started_ and stage_ != stage::look;
        if (altivar::reason so = inner.reason(); so.kind != outcome_kind::succeeded) {
            so.kind = so.kind == outcome_kind::silent ? reason_for(so.error).kind : so.kind;
            return fail(so);
        }
        if (is_given_up_) {
            return finish(reason_for(errc::cancelled));
        }
        if (stage_ == stage::check) {
            return on_checked();
        }
        if (stage_ == stage::save) {
            plan_.progress().note_saved();
        }
        go_on();
    }

    /// Behind it the restore ends as `so`, or goes on where that is a success.
    constexpr void look_at_last(altivar::reason const& so) noexcept
    {
        look_ = last_look{layout, 0};
        go_to(stage::look,
              so.kind == outcome_kind::refused_while_running ? look_.begin_cut(so.state) : look_.begin(so, so.state));
    }

    // The walk over the parameters.

    /// Reads on, or goes on to the next step of the agenda that asks something, or ends.
    constexpr void go_on() noexcept
    {
        while (not asks_in_this_step()) {
            if (not plan_.advance()) {
                return finish({failed() == 0 ? outcome_kind::succeeded : outcome_kind::not_taken});
            }
            walk_.begin();
            identity_.expire();
        }
    }

    constexpr bool asks_in_this_step() noexcept
    {
        if (plan_.has_to_save()) {
            check();
            return true;
        }
        if (walk_.find(plan_.map(), [this](parameter const& row) { return plan_.covers(row); })) {
            ask_block(stage::read);
            return true;
        }
        if (may_have_started_) {
            go_to(stage::settle, to_pause(status_period));
        }
        return may_have_started_;
    }

    constexpr void on_block(result<register_view> const& words) noexcept
    {
        if (words) {
            for (std::size_t i = 0; i < words->size(); ++i) {
                words_[i] = (*words)[i];
            }
            index_ = 0;
            is_in_block_ = true;
            return go_through_block();
        }
        if (not is_of_registers(words.error())) {
            return fail(reason_for(words.error()));
        }
        if (walk_.refuse()) {
            plan_.tell_unreadable(row_at(plan_.map(), walk_.block().start), words.error());
            walk_.pass();
        }
        go_on();
    }

    [[nodiscard]] constexpr placed_row row_in_block(std::uint16_t index) const noexcept
    {
        return row_at(plan_.map(), static_cast<std::uint16_t>(walk_.block().start + index));
    }

    constexpr void go_through_block() noexcept
    {
        for (; index_ < walk_.block().count; ++index_) {
            placed_row const which = row_in_block(index_);
            if (auto const word = plan_.treat(which, words_[index_])) {
                row_ = which;
                write_ = {*word, words_[index_], role_of(*which.row) == parameter_role::link};
                return check();
            }
        }
        is_in_block_ = false;
        walk_.pass();
        go_on();
    }

    // The write that is open.

    [[nodiscard]] constexpr bool is_write_open() const noexcept { return row_.row != nullptr; }

    [[nodiscard]] constexpr write_care care() const noexcept
    {
        return is_write_open() ? care_for(role_of(*row_.row)) : write_care::rest;
    }

    constexpr void on_write(event what, bool was_sent) noexcept
    {
        follow(what.what() == event::kind::written ? write_.confirm()
               : was_sent                          ? write_.fail(what.error())
                                                   : write_.stop(what.error()));
    }

    constexpr void on_read_back(event what) noexcept
    {
        follow(what.what() == event::kind::word_read ? write_.compare(what.word()) : write_.go_without(what.error()));
    }

    constexpr void follow(row_write::verdict next) noexcept
    {
        switch (next) {
        case row_write::verdict::read_back: return go_to(stage::read_back, to_read(row_.row->address));
        case row_write::verdict::check_again: return check();
        case row_write::verdict::next: close_write(); return go_through_block();
        case row_write::verdict::end: break;
        }
        close_write();
        fail(reason_for(write_.report().error));
    }

    /// What became of it is told.
    constexpr void close_write() noexcept
    {
        ++index_;
        plan_.close(std::exchange(row_, {}), write_.report(), write_.has_written());
    }

    // The end.

    /// Why it ends at a request that failed.
    static constexpr altivar::reason reason_for(errc error) noexcept
    {
        return {error == errc::overruled   ? outcome_kind::overruled
                : error == errc::cancelled ? outcome_kind::aborted
                : is_exception(error)      ? outcome_kind::refused
                                           : outcome_kind::silent,
                error};
    }

    constexpr void fail(altivar::reason const& so) noexcept
    {
        if (std::exchange(may_have_started_, false)) { // there is no second one
            look_at_last(so);
        } else {
            finish(so);
        }
    }

    /// Tells of everything that it did not come to, and ends.
    constexpr void finish(altivar::reason so) noexcept
    {
        if (is_write_open()) {
            static_cast<void>(write_.stop(so.error));
            close_write();
        }
        if (plan_.progress().has_moved_link() and so.kind == outcome_kind::silent) {
            so.kind = outcome_kind::executed_unconfirmed;
        }
        if (so.kind != outcome_kind::succeeded and so.kind != outcome_kind::not_taken) {
            std::uint32_t const position = is_in_block_ ? walk_.block().start + index_ : walk_.position();
            std::uint16_t i = index_;
            for (; is_in_block_ and i < walk_.block().count; ++i) {
                plan_.tell_last_word(row_in_block(i), words_[i], position, so.error);
            }
            plan_.tell_not_reached(position, is_in_block_ ? walk_.block().start + i : position, so.error);
        }
        reason_ = so;
        go_to(stage::ended);
    }

    // What it keeps, and what ends that.
    restore_plan<Device, Words, Report>
        plan_;                ///< how far it is, what it counts, what the drive holds of what others depend on
    identity_check identity_; ///< who the drive is: until the next step of the agenda
    block_walk walk_{Device::limits.read};                   ///< the block that was asked for
    write_guard guard_;                                      ///< one check
    save_procedure save_{layout};                            ///< one save
    last_look look_{layout, 0};                              ///< one look
    restore_request request_{};                              ///< that of this stage
    altivar::reason reason_{};                               ///< how it ended
    instant now_{0};                                         ///< the last `advance`
    deadline pause_end_{};                                   ///< of this stage; empty where it has a request
    placed_row row_{};                                       ///< whose write is open, until it is told
    row_write write_{};                                      ///< what came of that write
    std::array<std::uint16_t, Device::limits.read> words_{}; ///< of the block that was read last, until the next one
    std::uint16_t index_{0};                                 ///< the word of it that is treated
    stage stage_{stage::made};
    bool is_in_block_{false};      ///< until the last of these words is treated
    bool is_asking_{false};        ///< the request was handed out, until its outcome comes
    bool has_lost_{false};         ///< the unit was lost while a request was under way, until that is over
    bool may_have_started_{false}; ///< a delicate write was sent, until a look begins because of it, or has ended
    bool is_given_up_{false};      ///< by its user, for good
    bool is_inside_{false};        ///< of a call that reports, until it returns
    bool is_unwanted_{false};      ///< it is to be given up at the end of that call
};

} // namespace altivar
} // namespace RTUWIRE_BUILD
} // namespace rtuwire

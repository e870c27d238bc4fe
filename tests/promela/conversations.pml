/* SPDX-FileCopyrightText: 2026 The rtuwire authors */
/* SPDX-License-Identifier: BSL-1.0 */
/* What start, stop, broadcast stop and cycle make of the outcomes of their requests. */
#define at_rest (response.state == DISABLED || response.state == READY || response.state == SWITCHED_ON \
                 || response.state == FAULT)
inline note_rest() {
    if :: at_rest -> unit.ordered = 0 :: else fi
}
inline withdraw(i) {
    slot[i].step = WITHDRAWING; slot[i].left = 2
}

#ifdef NO_FALL_BACK
#define fell_back(i) false
#else
#define fell_back(i) (response.state < slot[i].top)
#endif
#ifdef NO_STOP_KEY
#define key_was_pressed(i) false
#else
#define key_was_pressed(i) (response.key && slot[i].looked)
#endif

inline accept_of_start(i) {
    if
    :: slot[i].step == WITHDRAWING && (response.received || slot[i].left <= 1) -> settle(i)
    :: slot[i].step == WITHDRAWING && !response.received && slot[i].left > 1 -> slot[i].left--
    :: slot[i].step != WITHDRAWING && !response.received && slot[i].missed -> withdraw(i)
    :: slot[i].step != WITHDRAWING && !response.received && !slot[i].missed ->
        slot[i].missed = 1;
#ifndef NO_NEW_LOOK
        slot[i].step = LOOKING
#endif
    :: slot[i].step == LOOKING && response.received ->
        slot[i].missed = 0;
        note_rest();
        if
        :: response.state == QUICK_STOP || response.state == FAULT -> settle(i)
        :: at_rest && response.state != FAULT && (fell_back(i) || key_was_pressed(i)) -> withdraw(i)
        :: at_rest && response.state != FAULT && !(fell_back(i) || key_was_pressed(i)) ->
            slot[i].looked = 1;
            if
#ifdef SHUTDOWN_ANYWHERE
            :: true -> slot[i].step = SHUTTING_DOWN
#else
            :: response.state == DISABLED -> slot[i].step = SHUTTING_DOWN
            :: else -> slot[i].step = SWITCHING_ON; slot[i].top = READY
#endif
            fi
        :: response.state == OPERATION -> slot[i].step = REFERRING; slot[i].top = OPERATION; slot[i].looked = 1
        fi
    :: slot[i].step == SHUTTING_DOWN && response.received ->
        slot[i].missed = 0; slot[i].step = SWITCHING_ON; slot[i].top = READY
    :: slot[i].step == SWITCHING_ON && response.received ->
        slot[i].missed = 0; slot[i].step = REFERRING
    :: slot[i].step == REFERRING && response.received ->
        slot[i].missed = 0;
        if
        :: slot[i].top == OPERATION -> slot[i].step = CHECKING
#ifdef NO_READ_BACK
        :: else -> slot[i].step = ENABLING
#else
        :: else -> slot[i].step = READING_BACK
#endif
        fi
    :: slot[i].step == READING_BACK && response.received ->
        slot[i].missed = 0;
        if
        :: response.same_command -> slot[i].step = ENABLING
        :: else -> withdraw(i)
        fi
    :: slot[i].step == ENABLING && response.received ->
        slot[i].missed = 0; slot[i].step = CHECKING
    :: slot[i].step == CHECKING && response.received ->
        note_rest();
        if
        :: at_rest && response.state != FAULT ->
#ifdef NO_FALL_BACK
            slot[i].step = LOOKING
#else
            withdraw(i)
#endif
        :: else ->
            settle(i);
#ifdef VISIT_BEGINS
            slot[i].was = start
#endif
        fi
    fi
}

/* It says that the motor stands: true when the drive said so. */
inline say_it_stands(i) {
    assert(!response.power);                                                                    /* L15 */
    settle(i); slot[i].was = stop
}
inline go_on_stopping(i) {
    slot[i].step = TELLING;
    if
    :: slot[i].left > 1 -> slot[i].left--
    :: else -> settle(i)                                   /* not reached, or not obeyed */
    fi
}
inline accept_of_stop(i) {
    if
    :: !response.received -> go_on_stopping(i)
    :: response.received && request != look ->
#ifdef NO_CONFIRMATION
        say_it_stands(i)
#else
        slot[i].step = LOOKING
#endif
    :: response.received && request == look ->
        note_rest();
        if
        :: response.state == DISABLED || response.state == FAULT -> say_it_stands(i)
        :: else -> go_on_stopping(i)
        fi
    fi
}

inline accept_of_broadcast(i) {
    if
    :: slot[i].left > 1 -> slot[i].left--
#ifndef NO_OWN_ADDRESS
    :: slot[i].left <= 1 && unit.ordered -> slot[i].kind = stop; slot[i].step = TELLING; slot[i].left = ROUNDS
    :: slot[i].left <= 1 && !unit.ordered ->
#else
    :: slot[i].left <= 1 ->
#endif
        assert(!has_power);                                                                     /* L5 */
        settle(i)
    fi
}

/* The look behind a response that was missing: the check of a cycle ends with it. */
#ifdef CHECK_NOT_JUDGED
#define ends_check(i) (request == look && slot[i].step == 0 && slot[i].top == OPERATION)
#else
#define ends_check(i) false
#endif
inline accept_of_cyclic(i) {
    if
    :: !response.received ->
        slot[i].checked = 0;
#ifndef NO_NEW_LOOK
        slot[i].step = 0;
#endif
        if
        :: slot[i].order && slot[i].missed && unit.mode == normal && !unit.ordered -> lose_order(i)
        :: else -> slot[i].missed = 1
        fi
    :: response.received && request == read_back ->
        slot[i].missed = 0;
        if
        :: response.same_command -> slot[i].checked = 1
        :: else -> lose_order(i); slot[i].step = 0
        fi
#ifdef CHECK_NOT_JUDGED
    :: response.received && ends_check(i) -> slot[i].missed = 0; slot[i].checked = 0; slot[i].step = slot[i].top
#endif
    :: response.received && request != read_back && !ends_check(i) ->
        slot[i].missed = 0; slot[i].checked = 0;
        note_rest();
        slot[i].step = response.state;
        if
        :: !slot[i].order
#ifndef NO_FAULT
        :: slot[i].order && (response.state == FAULT || response.state == QUICK_STOP) -> lose_order(i)
#endif
        :: slot[i].order && response.state <= OPERATION && (fell_back(i) || key_was_pressed(i)) -> lose_order(i)
        :: else ->
            slot[i].looked = 1;
            if :: response.state <= OPERATION -> slot[i].top = response.state :: else fi
        fi;
        if
        :: !slot[i].order && (response.state == DISABLED || response.state == FAULT) -> slot[i].commands = 0
        :: else
        fi
    fi
}

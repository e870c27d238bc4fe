/* SPDX-FileCopyrightText: 2026 The rtuwire authors */
/* SPDX-License-Identifier: BSL-1.0 */
/* Who may ask, and what; which orders are overruled; what a missing response does to the unit. */
#define stops(i) (slot[i].kind == stop || slot[i].kind == broadcast)
#define gives_stop_words(i) (stops(i) || (slot[i].kind == start && slot[i].step == WITHDRAWING) \
                             || (slot[i].kind == cyclic && slot[i].commands && !slot[i].order))
#define open_to(i) (slot[i].kind != nothing && (unit.mode == normal || (unit.mode == stop_words && gives_stop_words(i))))
#ifdef NO_PRIORITY
#define in_turn(i) (open_to(i))
#else
#define in_turn(i) (open_to(i) && (stops(i) || !(stops(B) || stops(U))))
#endif
#define may_ask(i) (in_turn(i) && (turn != i || !in_turn(1 - i)))
#define somebody_may (in_turn(A) || in_turn(B) || in_turn(U))
#define somebody_is_there (slot[A].kind != nothing || slot[B].kind != nothing || slot[U].kind != nothing)

#ifdef NO_STAMP
#define too_old(i) false
#else
#define too_old(i) slot[i].older
#endif
inline lose_order(i) {
    slot[i].order = 0; slot[i].older = 0; slot[i].spent = 0; slot[i].revoked = 0; slot[i].top = 0;
    slot[i].looked = 0; slot[i].checked = 0; slot[i].missed = 0; slot[i].power_gap = 0
}

/* The next request of a conversation. */
inline choose(i) {
    if
    :: slot[i].kind == poll -> request = look
    :: slot[i].kind == broadcast -> request = quick_stop; to_all = 1
    :: slot[i].kind == stop && slot[i].step == LOOKING && unit.mode == normal -> request = look
    :: slot[i].kind == stop && !(slot[i].step == LOOKING && unit.mode == normal) -> request = quick_stop
    :: slot[i].kind == start && (slot[i].step == LOOKING || slot[i].step == CHECKING) -> request = look
    :: slot[i].kind == start && slot[i].step == SHUTTING_DOWN -> request = shutdown
    :: slot[i].kind == start && slot[i].step == SWITCHING_ON -> request = switch_on
    :: slot[i].kind == start && slot[i].step == REFERRING -> request = reference
    :: slot[i].kind == start && slot[i].step == READING_BACK -> request = read_back
    :: slot[i].kind == start && slot[i].step == ENABLING -> request = enable
    :: slot[i].kind == start && slot[i].step == WITHDRAWING -> request = disable_voltage
    :: slot[i].kind == cyclic && unit.mode == stop_words -> request = quick_stop
    :: slot[i].kind == cyclic && unit.mode == normal ->
        if
        :: slot[i].order && slot[i].step == DISABLED -> request = shutdown
        :: slot[i].order && slot[i].step == READY -> request = switch_on
#ifdef NO_READ_BACK
        :: slot[i].order && slot[i].step == SWITCHED_ON -> request = enable
#else
        :: slot[i].order && slot[i].step == SWITCHED_ON && !slot[i].checked -> request = read_back
        :: slot[i].order && slot[i].step == SWITCHED_ON && slot[i].checked -> request = enable
#endif
        :: slot[i].order && slot[i].step == OPERATION -> request = enable
        :: !slot[i].order && slot[i].commands && slot[i].step == OPERATION -> request = quick_stop
        :: !slot[i].order && slot[i].commands && (slot[i].step == READY || slot[i].step == SWITCHED_ON) ->
            request = disable_voltage
        :: else -> request = look
        fi
    fi
}

#define enables (request == enable || request == reference)
#define climbs (request == shutdown || request == switch_on || request == read_back)
inline take(i) {
    choose(i);
    if
    :: (enables || climbs) && too_old(i) ->
        request = none;                                    /* overruled */
        if
        :: slot[i].kind == start -> settle(i)
        :: slot[i].kind == cyclic -> lose_order(i); slot[i].step = 0; slot[i].commands = 0
        fi
    :: else ->
        if
        :: enables ->
#ifndef ORDERED_LATE
            unit.ordered = 1
#endif
        :: else
        fi;
        taken = 1; asker = i; by_stop = stops(i); law.asker_gone = 0;
        slot[A].asked = 0; slot[B].asked = 0; slot[U].asked = 0; slot[i].asked = 1;
        if :: i != U -> turn = i :: else fi
    fi
}

inline drop() {
    request = none; taken = 0; to_all = 0; by_stop = 0; asker = 0; law.asker_gone = 0; law.cycled_before = 0;
    slot[A].asked = 0; slot[B].asked = 0; slot[U].asked = 0;
    response.received = 0; response.state = 0; response.key = 0; response.same_command = 0; response.power = 0
}

inline lose() {
    unit.mode = stop_words; unit.timer = WINDOW; unit.missed = 0;
    revoke_all();
#ifndef ORDER_OUTLIVES_LOSS
    outdate_all();
    if :: slot[A].kind == start -> slot[A].step = WITHDRAWING; slot[A].left = 3 :: else fi;
    if :: slot[B].kind == start -> slot[B].step = WITHDRAWING; slot[B].left = 3 :: else fi;
    if :: slot[A].kind == cyclic -> lose_order(A); slot[A].step = 0 :: else fi
#endif
}

/* What the outcome of an attempt says of the unit. */
inline account() {
    if
    :: response.received ->
        unit.missed = 0; unit.mode = normal; unit.timer = 0; law.alone = 0;
#ifdef ORDERED_LATE
        if :: request == enable -> unit.ordered = 1 :: else fi
#endif
    :: else ->
        if
        :: unit.ordered && unit.mode == normal && !unit.missed -> unit.missed = 1
        :: unit.ordered && unit.mode == normal && unit.missed ->
#ifdef NO_LOSS
            skip
#else
            lose()
#endif
        :: else
        fi
    fi
}

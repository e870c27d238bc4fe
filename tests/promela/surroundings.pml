/* SPDX-FileCopyrightText: 2026 The rtuwire authors */
/* SPDX-License-Identifier: BSL-1.0 */
/* The user, and what happens to the drive. */

/* A conversation ends or is made anew: what it asked is nobody's. */
inline forget(i) {
    if
    :: slot[i].asked ->
#ifndef NO_FORGETTING
        slot[i].asked = 0;
#endif
        law.asker_gone = 1;
#ifndef GONE_ASKERS_SEND
        taken = 0
#endif
    :: else
    fi;
    if :: slot[i].kind == stop -> law.stop_waits = 0 :: else fi;
    clear(i); slot[i].was = nothing
}
/* A newer order overrules the older one; one that comes while a stop holds the unit is overruled at once. */
inline begin_order(i) {
#ifndef TWO_ORDERS
    if :: slot[1 - i].kind == start || slot[1 - i].order -> slot[1 - i].older = 1 :: else fi;
#endif
#ifndef NO_HOLD
    slot[i].older = unit.held;
#endif
    slot[i].revoked = law.stop_open; slot[i].spent = law.stop_open
}
inline begin_stop(i) {
    unit.held = 1; law.stop_open = 1; law.stop_waits = 1; law.alone = 0;
    revoke_all();
#ifdef BROADCAST_KEEPS_ORDERS
    if :: i != U -> outdate_all() :: else fi;
#else
    outdate_all();
#endif
#ifdef STOP_FORGETS_ORDERED
    unit.ordered = 0;
#endif
    if :: unit.mode != normal -> unit.mode = stop_words; unit.timer = WINDOW :: else fi;
#ifndef NO_ABORT
    taken = 0
#endif
}

inline give_order(i, what) {
    slot[i].kind = what;
    if :: what == cyclic -> slot[i].order = 1; slot[i].commands = 1; slot[i].step = 0 :: else fi;
    begin_order(i);
    printf("-- %d: %e\n", i, what)
}

inline give_stop() {
    slot[B].kind = stop; slot[B].step = TELLING; slot[B].left = ROUNDS; begin_stop(B)
}

/* The stop that has ended there, run once more: it is a stop like any other. */
inline give_stop_again() {
    printf("-- 1: the same stop\n");
#ifdef SAYS_IT_AGAIN
    assert(!has_power)                                                                          /* L18 */
#else
    slot[B].was = nothing; give_stop()
#endif
}

proctype user() {
end_of_acts:
    do
    :: atomic { acts > 0 -> acts--;
        if
        :: true -> forget(A); give_order(A, start)
        :: true -> forget(A); give_order(A, cyclic)
        :: slot[A].kind == cyclic -> lose_order(A); give_order(A, cyclic)       /* the same cycle, told to run */
        :: slot[A].kind != nothing -> forget(A); printf("-- 0: destroyed\n")
        :: true -> forget(B); give_order(B, start)
        :: true -> forget(B); slot[B].kind = poll; printf("-- 1: poll\n")
        :: slot[B].kind != nothing -> forget(B); printf("-- 1: destroyed\n")
        :: true -> forget(B); printf("-- 1: stop\n"); give_stop()
        :: slot[B].was == stop -> give_stop_again()
        :: slot[U].kind == nothing -> printf("-- 2: broadcast stop\n");
            slot[U].kind = broadcast; slot[U].left = 3; begin_stop(U)
        :: unit.held && !stops(B) && !stops(U) -> printf("-- released\n");
            unit.held = 0; law.stop_open = 0
        fi }
    od
}

proctype surroundings() {
end_of_events:
    do
    :: atomic { events > 0 && has_motion -> events--; printf("-- STOP key\n");
        drive.key = 1; drive.state = DISABLED; drive.ramp = 0; spend_all() }
    :: atomic { events > 0 && drive.state != OFF && drive.state != FAULT -> events--; fail_drive() }
    :: atomic { events > 0 && (drive.state == SWITCHED_ON || drive.state == OPERATION) -> events--;
        printf("-- another master: 0006\n");
        drive.state = READY; drive.ramp = 0; drive.command = shutdown }                          /* 6, 8 */
    :: atomic { events > 0 && drive.state != OFF -> events--; printf("-- power off\n");
        /* What the drive could tell of a fault or the STOP key is gone, too. */
        slot[A].spent = slot[A].revoked; slot[B].spent = slot[B].revoked;
        drive.down = POWER_IS_GONE; drive.state = OFF; drive.ramp = 0; drive.armed = 0; drive.silent = 0;
        drive.key = 0; drive.command = none; law.cycled = 1 }
    :: atomic { events > 0 && !drive.obstinate -> events--; printf("-- stop words are not obeyed\n");
        drive.obstinate = 1 }
    :: atomic { drive.state == OFF && drive.down == 0 -> printf("-- power on\n"); drive.state = DISABLED }
    :: atomic { drive.state == FAULT && drive.down == 0 -> printf("-- reset\n"); drive.state = DISABLED }
    od
}

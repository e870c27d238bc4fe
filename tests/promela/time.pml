/* SPDX-FileCopyrightText: 2026 The rtuwire authors */
/* SPDX-License-Identifier: BSL-1.0 */
/* What a tick does: the drive's ramp, its supervision, the client's times. And how orders end. */
/* A fault or the STOP key counts for a conversation that has seen the drive: one before leaves no trace. */
inline spend_all() {
    if :: slot[A].looked -> slot[A].spent = 1 :: else fi;
    if :: slot[B].looked -> slot[B].spent = 1 :: else fi
}
inline revoke_all() {
    slot[A].revoked = (slot[A].kind == start || slot[A].kind == cyclic || slot[A].was == start);
    slot[A].spent = slot[A].revoked;
    slot[B].revoked = (slot[B].kind == start || slot[B].was == start); slot[B].spent = slot[B].revoked
}
inline outdate_all() {
    slot[A].older = (slot[A].kind == start || slot[A].kind == cyclic);
    slot[B].older = (slot[B].kind == start);
}
inline fail_drive() {
    printf("-- fault\n");
    drive.state = FAULT; drive.ramp = 0; drive.down = FAULT_STANDS; drive.armed = 0; drive.silent = 0;
    drive.command = none; drive.key = 0;
    spend_all()
}

inline settle(i) {
    if
    :: slot[i].kind == stop || slot[i].kind == broadcast -> unit.held = 0; law.stop_open = 0; law.stop_waits = 0
    :: else
    fi;
    clear(i)
}
inline clear(i) {
    slot[i].kind = nothing; slot[i].step = 0; slot[i].left = 0; slot[i].top = 0; slot[i].missed = 0;
    slot[i].looked = 0; slot[i].checked = 0; slot[i].order = 0; slot[i].commands = 0; slot[i].older = 0;
    slot[i].revoked = 0; slot[i].spent = 0; slot[i].power_gap = 0
}

/* Silence begins: who was giving stop words has not reached the drive. */
inline on_silence() {
    unit.mode = silence; unit.timer = QUIET;
    each = A;
    do
    :: each <= U && (slot[each].kind == stop || (slot[each].kind == start && slot[each].step == WITHDRAWING)) ->
        settle(each); each++
    :: each <= U && !(slot[each].kind == stop || (slot[each].kind == start && slot[each].step == WITHDRAWING)) ->
        each++
    :: each > U -> break
    od;
    each = 0
}

#define time_matters (unit.mode != normal || drive.armed || drive.ramp > 0 || drive.down > 0)
inline tick() {
    if
    :: drive.ramp > 0 ->
        drive.ramp--;
        if
        :: drive.ramp > 0
        :: drive.ramp == 0 && drive.state == QUICK_STOP -> drive.state = DISABLED
        :: drive.ramp == 0 && drive.state == OPERATION -> drive.state = SWITCHED_ON
        fi
    :: else
    fi;
    if :: drive.down > 0 -> drive.down-- :: else fi;
    if
    :: drive.armed && drive.silent < TTO -> drive.silent++
    :: else
    fi;
    if
    :: drive.armed && drive.silent == TTO -> fail_drive()
    :: else
    fi;
    if
    :: unit.mode == normal
    :: unit.mode != normal && unit.timer > 1 -> unit.timer--
    :: unit.mode == stop_words && unit.timer <= 1 ->
#ifdef ENDLESS_STOP_WORDS
        skip
#elif defined(NO_SILENCE)
        on_silence(); unit.mode = normal; unit.timer = 0; unit.missed = 0
#else
        on_silence()
#endif
    :: unit.mode == silence && unit.timer <= 1 -> unit.mode = normal; unit.timer = 0; unit.missed = 0
    fi;
    if
    :: has_power -> law.alone++; assert(law.alone <= BOUND)   /* L4 */
    :: else -> law.alone = 0
    fi
}

/* SPDX-FileCopyrightText: 2026 The rtuwire authors */
/* SPDX-License-Identifier: BSL-1.0 */
/* The client's loop: a request is taken, leaves, ends, and its outcome is delivered or dropped. */
/* It was in operation for this order, and this response says that it is no more. */
#define has_run(i) ((slot[i].kind == start || slot[i].order) && slot[i].top == OPERATION)
#define shows_end(i) (response.received && request != read_back && response.state < OPERATION && has_run(i))
inline deliver(i) {
    assert(i == asker && !law.asker_gone);                                                      /* L1 */
    if
    :: response.received && (slot[i].kind == start || slot[i].order) -> slot[i].power_gap = law.cycled_before
    :: else
    fi;
    if
    :: shows_end(i) -> slot[i].spent = 1; slot[i].revoked = 1
    :: else
    fi;
    if
    :: slot[i].kind == start -> accept_of_start(i)
    :: slot[i].kind == stop -> accept_of_stop(i)
    :: slot[i].kind == broadcast -> accept_of_broadcast(i)
    :: slot[i].kind == cyclic -> accept_of_cyclic(i)
    :: else
    fi;
    drop()
}

#ifdef NO_TICKET
#define takes(i) (slot[i].kind != nothing)
#else
#define takes(i) (slot[i].asked)
#endif
#define nobody_takes (!slot[A].asked && !slot[B].asked && !slot[U].asked)

proctype client() {
    byte who;
idle:
    atomic {
        if
        :: may_ask(A) -> who = A
        :: may_ask(B) -> who = B
        :: in_turn(U) -> who = U
        :: !somebody_may && time_matters -> printf("-- a tick alone\n"); tick(); goto idle
        :: !somebody_is_there && !time_matters -> goto end_resting
#ifdef VISIT_BEGINS
        :: slot[A].was == start && slot[A].kind == nothing && !somebody_may ->
            slot[A].kind = start; goto idle                                                     /* L18 */
#endif
        fi;
        take(who); who = 0;
        if :: request == none -> goto idle :: else fi
    };
    /* A stop that begins here takes the request back. */
    atomic {
        if
        :: !taken -> drop(); goto idle
        :: else
        fi;
        taken = 0;
        assert(!law.asker_gone);                                                                /* L1 */
        assert(!law.stop_waits || by_stop);                                                     /* L3 */
        assert(unit.mode != silence);                                                           /* L4 */
        assert(unit.mode == normal || request == quick_stop || request == disable_voltage);     /* L4 */
        assert(!enables || !(slot[asker].revoked || law.stop_open));                             /* L2, L3, L5 */
        assert(!(request == enable && slot[asker].power_gap
                 && (slot[asker].kind == start || slot[asker].step != OPERATION)));                                /* L13 */
        if :: by_stop -> law.stop_waits = 0 :: else fi;
        printf("%d asks: %e\n", asker, request);
        to_line!request, !(slot[asker].spent || law.stop_open), to_all
    };
    atomic { from_line?_;
        if
        :: response.received -> account(); tick()
        :: !response.received && !to_all -> tick(); account()
        :: else
        fi
    };
    atomic {
        if
        :: takes(A) -> who = A
        :: takes(B) -> who = B
        :: takes(U) -> who = U
#ifndef NO_DROP
        :: nobody_takes -> drop(); goto idle
#endif
        fi;
        deliver(who); who = 0;
        goto idle
    };
end_resting:
    (somebody_is_there || time_matters);
    goto idle
}

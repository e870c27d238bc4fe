/* SPDX-FileCopyrightText: 2026 The rtuwire authors */
/* SPDX-License-Identifier: BSL-1.0 */
/* The drive: its state chart, with the numbers of the transitions; and the line to it and back. */
proctype drive_unit() {
    mtype:word frame;
    bit allowed;
end_listening:
    do
    :: atomic { to_drive?frame, allowed ->
        drive.silent = 0;
        if :: drive.state != FAULT -> drive.armed = 1 :: else fi;
        if
        :: frame == shutdown || frame == switch_on || frame == enable || frame == quick_stop || frame == disable_voltage ->
            drive.command = frame
        :: else
        fi;
        if
        :: frame == shutdown && (drive.state == DISABLED || drive.state == SWITCHED_ON) ->       /* 2, 6 */
            drive.state = READY; drive.key = 0
        :: frame == shutdown && drive.state == OPERATION -> drive.state = READY; drive.ramp = 0  /* 8 */
        :: frame == switch_on ->
            law.cycled = 0;
            if
            :: drive.state == READY -> drive.state = SWITCHED_ON                                /* 3 */
            :: drive.state == OPERATION && drive.ramp == 0 && !drive.obstinate -> drive.ramp = RAMP /* 5 */
            :: else
            fi
        :: frame == enable && (drive.state == READY || drive.state == SWITCHED_ON) ->            /* 3B, 4 */
            assert(allowed);                                                                    /* L2 */
            drive.state = OPERATION
        :: frame == enable && drive.state == OPERATION && drive.ramp > 0 ->
            assert(allowed);
            drive.ramp = 0
        :: frame == reference && drive.state == OPERATION -> assert(allowed)
        :: frame == quick_stop && (drive.state == READY || drive.state == SWITCHED_ON) ->        /* 7, 10 */
            drive.state = DISABLED
        :: frame == quick_stop && drive.state == OPERATION && !drive.obstinate ->                /* 11 */
            drive.state = QUICK_STOP; drive.ramp = RAMP
        :: frame == disable_voltage && (drive.state == READY || drive.state == SWITCHED_ON) ->   /* 7, 10 */
            drive.state = DISABLED
        :: frame == disable_voltage && has_power && !drive.obstinate ->                          /* 9, 12 */
            drive.state = DISABLED; drive.ramp = 0
        :: else
        fi;
        frame = none; allowed = 0;
        from_drive!0 }
    od
}
proctype line() {
    mtype:word frame;
    bit allowed;
    bit for_all;
    bit arrived;
end_quiet:
    do
    :: atomic { to_line?frame, allowed, for_all ->
        if
        :: drive.state != OFF -> to_drive!frame, allowed; from_drive?_; arrived = 1
        :: printf("    lost\n")
        fi };
        atomic {
        if
        :: arrived && !for_all && drive.state != OFF ->
            printf("    state %d\n", drive.state);
            response.received = 1; response.state = drive.state; response.key = drive.key;
            response.same_command = (drive.command == switch_on);
            response.power = has_power; law.cycled_before = law.cycled
        :: printf("    no response\n")
        fi;
        frame = none; allowed = 0; for_all = 0; arrived = 0; from_line!0 }
    od
}

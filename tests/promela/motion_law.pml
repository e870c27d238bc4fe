/* SPDX-FileCopyrightText: 2026 The rtuwire authors */
/* SPDX-License-Identifier: BSL-1.0 */
/* The rules that keep a drive from moving by surprise, as a model that Spin searches completely. It is
 * written from the rules, not from the headers, and shares nothing with them.
 *
 * In it: one drive (state chart of CiA 402 as the Altivar manuals print it, supervision of the link, STOP
 * key, faults and their reset, loss of its power, another master's 0006, stop words that it does not obey);
 * a line that may lose any frame either way (a direction that is dead from some moment on is one of these
 * lives); a client with two places for conversations and one for the broadcast stop; a user who puts
 * conversations into the places, runs a stop that has ended once more, and takes them out again, at any
 * moment. A start that has ended leaves nothing behind: a visit begins nothing.
 *
 * A tick is one request with its response or its time-out; where nobody asks a tick passes alone. The drive
 * trips three ticks after the latest request, two seconds of stop words are two ticks, a ramp is one.
 *
 * What is bounded: one unit; so many acts of the user (ACTS) and events around the drive (EVENTS); faults
 * stand five ticks at least, longer than a start goes without a look, because one that is over before leaves
 * nothing to be seen; for the same reason a fault or the STOP key counts only for a conversation that has
 * seen the drive before, and loss of power takes the trace of both away.
 *
 * Left out: responses that come late (tests/model has them), the client's own repetitions, two drives at one
 * address, other clients, drives whose supervision is off, halt and DC injection, local control (the drive
 * falls to switch on disabled as with the STOP key), conversations that stay away without being destroyed,
 * the scanner, the second unit of a broadcast, a program that sleeps.
 *
 * Each guard of the client has a switch that takes it away; check.py has to find an error then. */

#ifndef ACTS
#define ACTS 3
#endif
#ifndef EVENTS
#define EVENTS 2
#endif
#define TTO 3
#define WINDOW 2
#ifdef SHORT_SILENCE
#define QUIET (TTO - 2)
#else
#define QUIET (TTO + 1)
#endif
#define RAMP 1
#define ROUNDS 3          /* of a stop: its word and a look */
#define FAULT_STANDS 5
#define POWER_IS_GONE 1
/* The tolerated time-out and the second, two seconds of stop words, the time-out of the drive itself. */
#ifndef BOUND
#define BOUND (2 + WINDOW + TTO)
#endif

mtype:kind = { nothing, start, stop, cyclic, poll, broadcast };
mtype:word = { none, look, read_back, shutdown, switch_on, reference, enable, quick_stop, disable_voltage };
mtype:mode = { normal, stop_words, silence };

/* Steps of a start. A stop alternates between TELLING and LOOKING. */
#define LOOKING 0
#define SHUTTING_DOWN 1
#define SWITCHING_ON 2
#define REFERRING 3
#define READING_BACK 4
#define ENABLING 5
#define CHECKING 6
#define WITHDRAWING 7
#define TELLING 8

/* The drive's states by their numbers in the manuals; 1 is passed at once, 7 is part of 8. */
#define OFF 0
#define DISABLED 2
#define READY 3
#define SWITCHED_ON 4
#define OPERATION 5
#define QUICK_STOP 6
#define FAULT 8

/* ---- what is checked -------------------------------------------------------------------------------- */
typedef ghosts {
    byte alone;        /* ticks since the latest response, or the user last began a stop */
    bit  stop_open;    /* a stop has begun and none has settled since */
    bit  stop_waits;   /* a stop has begun and its word has not left */
    bit  asker_gone;   /* who asked the request under way is there no more */
    bit  cycled;       /* the drive lost its power since it received 0007 */
    bit  cycled_before; /* ... and had when it gave this response */
};
ghosts law;

/* ---- the drive -------------------------------------------------------------------------------------- */
typedef drives {
    byte state;
    byte ramp;                /* ticks that a stop still takes */
    byte silent;              /* ticks since the latest request */
    bit  armed;               /* its supervision: from the first request on */
    bit  key;                 /* status bit 14: stopped by the STOP key */
    bit  obstinate;           /* takes stop words and does not obey them */
    byte down;                /* ticks that a fault or a power failure lasts at least */
    mtype:word command;       /* the latest command word; none: 0000 at power-up */
};
drives drive;
#define has_motion (drive.state >= READY && drive.state <= QUICK_STOP)
#define has_power (drive.state == OPERATION || drive.state == QUICK_STOP)

/* ---- the client ------------------------------------------------------------------------------------- */
typedef conversation {
    mtype:kind kind;
    byte step;
    byte left;         /* of a stop, a broadcast stop, a withdrawal: how often still */
    byte top;          /* the highest state seen since the order */
    bit  missed;       /* the latest attempt had no response */
    bit  looked;       /* it has seen the drive's status since the order */
    bit  checked;      /* a cycle: the command was read back */
    bit  order;        /* a cycle: it was told to run */
    bit  commands;     /* a cycle: it was told to run, and has not seen the drive at rest since */
    bit  older;        /* its stamp is older than the unit's counter */
    bit  asked;        /* holds the number of the request under way */
    bit  revoked;      /* checked: since the order there was a stop, a broadcast stop or a loss */
    bit  power_gap;    /* checked: at its latest response the drive had lost its power since 0007 */
    bit  spent;        /* checked: one of these, or a fault, or the STOP key */
    mtype:kind was;    /* what has ended here, and is still there: a stop that said that the motor stands */
};
#define A 0            /* start, cyclic */
#define B 1            /* stop, poll, start */
#define U 2            /* the broadcast stop */
conversation slot[3];
hidden byte each;

typedef units {
    bit ordered;       /* a request that enables was taken for it */
    bit held;          /* a stop has begun and none has settled since */
    bit missed;        /* the tolerated response is missing */
    mtype:mode mode;
    byte timer;        /* ticks until the mode ends */
};
units unit;

mtype:word request;    /* taken or under way */
bit taken;             /* it has not left yet */
byte asker;            /* the place that asked it */
bit by_stop;           /* a stop or a broadcast stop asked it */
bit to_all;            /* it is a broadcast */
byte turn;             /* which of A and B was served last */

/* What came back: */
typedef responses {
    bit received;
    byte state;
    bit key;
    bit same_command;  /* the command register holds 0007 */
    bit power;         /* checked: the motor had power */
};
responses response;

byte acts = ACTS;
byte events = EVENTS;

chan to_line = [0] of { mtype:word, bit, bit };
chan to_drive = [0] of { mtype:word, bit };
chan from_drive = [0] of { bit };
chan from_line = [0] of { bit };

#include "time.pml"
#include "drive.pml"
#include "orders.pml"
#include "conversations.pml"
#include "client.pml"
#include "surroundings.pml"

init {
    atomic {
        drive.state = DISABLED; drive.command = none;
        slot[A].kind = nothing; slot[B].kind = nothing; slot[U].kind = nothing;
        slot[A].was = nothing; slot[B].was = nothing; slot[U].was = nothing;
        unit.mode = normal; request = none;
        run drive_unit(); run line(); run client(); run user(); run surroundings()
    }
}

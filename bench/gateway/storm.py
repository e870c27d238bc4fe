# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What a broker that comes back meets: gateways that all lost it at once, each connecting again by its rule. The broker takes
one connection after the other (TLS costs it milliseconds), and a queue of the system holds those that wait; who finds it full,
or waits longer than a client does, tries later. Then each tells what is retained. Simulated, by drawn numbers that repeat.

    python3 storm.py [GATEWAYS [MESSAGES_OF_EACH [MESSAGES_A_SECOND]]]
"""
import heapq
import random
import sys

AWAY = 120.0  # s, how long the broker was away
HANDSHAKE = 0.005  # s of the broker for each connection with TLS
QUEUE, PATIENCE = 100, 10.0  # connections that wait; s


def fixed(_, __):
    return 1.0


def doubling(tries, _):
    return min(30.0, 1.0 * 2 ** tries)


def drawn(tries, random_source):
    return random_source.uniform(0.5, 1.5) * min(30.0, 1.0 * 2 ** tries)


def spread(_, random_source):
    return random_source.uniform(0.0, 30.0)


RULES = {"every second": fixed, "doubled up to 30 s": doubling, "doubled up to 30 s, by 50 to 150 %": drawn,
         "drawn from 30 s each time": spread}


def storm(rule, gateways, seed=1):
    """How many connect within the worst second, how many are turned away, and when the last one is connected, from the
    moment at which the broker is back."""
    random_source = random.Random(seed)
    # All notice within the time of a keep-alive; one that is killed ends all connections at once.
    events = [(0.0, number, 0) for number in range(gateways)]
    heapq.heapify(events)
    free_at, waiting, arrivals, turned_away, last = AWAY, [], [], 0, 0.0
    while events:
        at, number, tries = heapq.heappop(events)
        if at >= AWAY:
            arrivals.append(at)
            while waiting and waiting[0] <= at:
                heapq.heappop(waiting)
            start = max(at, free_at)
            if len(waiting) < QUEUE and start - at <= PATIENCE:
                free_at = start + HANDSHAKE
                heapq.heappush(waiting, free_at)
                last = max(last, free_at)
                continue
            turned_away += 1
        heapq.heappush(events, (at + rule(tries, random_source), number, tries + 1))
    worst = max(sum(one <= other < one + 1 for other in arrivals) for one in arrivals)
    return worst, turned_away, last - AWAY


def main(gateways="100", messages="3303", rate="100000"):
    gateways, messages, rate = int(gateways), int(messages), float(rate)
    print(f"{gateways} gateways, {messages} retained messages each, a broker that takes {rate:.0f} a second")
    print(f"{'rule':<40}{'worst second':>14}{'turned away':>13}{'last after':>12}{'all told after':>16}")
    for count in (gateways, 10 * gateways):
        for name, rule in RULES.items():
            worst, turned_away, last = storm(rule, count)
            told = max(last, count * messages / rate)
            print(f"{f'{count}: {name}':<40}{worst:>14}{turned_away:>13}{last:>10.1f} s{told:>14.0f} s")


if __name__ == "__main__":
    main(*sys.argv[1:])

#!/bin/sh
# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
# Two simulated drives and a meter behind the gateway, a broker of its own, and what a subscriber sees: no hardware, no
# configuration, nothing left behind. It ends after a minute.
#
#   sh examples/gateway.sh [--for SECONDS]
#
# RTUWIRE and RTUWIRE_GATEWAY name programs that are built already; without them both are built first.
set -eu
here=$(CDPATH='' cd "$(dirname "$0")" && pwd)
project=$(dirname "$here")
seconds=60
case $#:${1:-} in
    0:) ;;
    2:--for) seconds=$2 ;;
    *)
        echo "usage: sh examples/gateway.sh [--for SECONDS]" >&2
        exit 2
        ;;
esac
case $seconds in
    '' | *[!0-9]* | 0)
        echo "gateway.sh: '$seconds' is no number of seconds" >&2
        exit 2
        ;;
esac
PATH=$PATH:/usr/sbin

if [ -z "${RTUWIRE:-}" ] || [ -z "${RTUWIRE_GATEWAY:-}" ]; then
    build=$project/build/tool
    RTUWIRE=$build/tools/rtuwire/rtuwire
    RTUWIRE_GATEWAY=$build/tools/gateway/rtuwire-gateway
    program=$RTUWIRE_GATEWAY
    failed=1
    . "$project/cmake/first_build.sh"
    step "[1/3] installs what is missing of a compiler, the tool's packages and mosquitto"
    sh "$project/tests/packages.sh" build tool gateway >&2 </dev/null || exit "$failed"
    step "[2/3] configures, in $build"
    quietly cmake -S "$project" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DRTUWIRE_BUILD_TOOL=ON \
        -DRTUWIRE_BUILD_EXAMPLES=OFF -DRTUWIRE_BUILD_TESTS=OFF -DRTUWIRE_INSTALL=OFF -DRTUWIRE_COMPILE_JOINED=ON
    step "[3/3] builds the tool and the gateway, which takes some minutes"
    telling cmake --build "$build" --target rtuwire_tool rtuwire_gateway
else
    sh "$project/tests/packages.sh" gateway >&2 </dev/null
fi

place=$(mktemp -d)
broker='' devices='' gateway='' shown=''
clean_up() {
    trap '' INT TERM HUP # a second Ctrl-C would leave the rest
    for process in $shown $gateway $devices $broker; do
        tries=0
        while kill -0 "$process" 2>/dev/null; do
            # Again each second: the first is lost on what is not yet the program. mosquitto_sub without its broker heeds none.
            [ $((tries % 10)) -ne 0 ] || kill "$process" 2>/dev/null || :
            [ $tries -lt 100 ] || kill -KILL "$process" 2>/dev/null || :
            tries=$((tries + 1))
            sleep 0.1
        done
    done
    wait
    rm -rf "$place"
}
trap clean_up EXIT
trap "trap '' INT TERM HUP; exit 130" INT TERM HUP

# Waits until a file says it, for at most 20 s.
says() {
    tries=0
    until grep -q "$1" "$2" 2>/dev/null; do
        tries=$((tries + 1))
        [ $tries -lt 200 ] && kill -0 "$3" 2>/dev/null || return 1
        sleep 0.1
    done
}

# A broker of its own, on a port that is free.
port=$((18830 + $$ % 1000))
while :; do
    printf '%s\n' "listener $port 127.0.0.1" "allow_anonymous true" "log_type all" >"$place/mosquitto.conf"
    mosquitto -c "$place/mosquitto.conf" >"$place/mosquitto.log" 2>&1 &
    broker=$!
    says ' running$' "$place/mosquitto.log" $broker && break
    wait $broker 2>/dev/null || :
    broker=''
    port=$((port + 1))
    if [ $port -gt 20000 ]; then
        cat "$place/mosquitto.log" >&2
        exit 1
    fi
done

# A line with two drives and a meter, whose power moves.
cat >"$place/meter.toml" <<'END'
[[register]]
name = "voltage"
space = "input"
address = 0
scale = 0.1
unit = "V"
simulated = 230.1

[[register]]
name = "power"
space = "input"
address = 1
unit = "W"
simulated = 1200

[[register]]
name = "energy"
space = "input"
address = 2
type = "u32"
scale = 0.01
unit = "kWh"
simulated = 123.45
END
watts=1200
while sleep 1; do
    watts=$((watts + 37 - watts / 40))
    echo "5 power=${watts}W" || break
done | "$RTUWIRE" simulate atv320:7 atv12:3 "$place/meter.toml:5" >"$place/devices" 2>"$place/devices.log" &
devices=$!
says ' unit 5 on ' "$place/devices" $devices || { cat "$place/devices.log" >&2; exit 1; }
line=$(sed -n 's/^.* unit 5 on //p' "$place/devices")

cat >"$place/gateway.toml" <<END
site = "desk"
gateway = "g1"
state_folder = "$place/state"

[broker]
host = "127.0.0.1"
port = $port
discovery = "homeassistant"

[[line]]
name = "line1"
port = "$line"
baud = 19200

[[line.device]]
name = "meter"
unit = 5
file = "meter.toml"

[[line.device]]
name = "fan"
unit = 7
drive = "atv320"
registers = ["RFR", "LCR", "ETA"]
feeds_supervision = true          # simulated ones: nothing turns

[[line.device]]
name = "pump"
unit = 3
drive = "atv12"
registers = ["RFR", "LCR"]
feeds_supervision = true
END
mkdir "$place/state"

echo "A broker on port $port, drives and a meter on $line, and this file:"
sed 's/^/    /' "$place/gateway.toml"
echo "For $seconds s, what a subscriber of rtuwire/# sees (mosquitto_sub -p $port -t 'rtuwire/#' -v, elsewhere, too):"
mosquitto_sub -h 127.0.0.1 -p "$port" -t 'rtuwire/#' -v -W "$seconds" &
shown=$!
"$RTUWIRE_GATEWAY" "$place/gateway.toml" &
gateway=$!
wait $shown || :
shown=''
kill $gateway
status=0
wait $gateway || status=$?
gateway=''
echo "The end: the gateway's status is $status; broker, devices and files are gone."
exit $status

# SPDX-FileCopyrightText: 2026 The rtuwire authors
# SPDX-License-Identifier: BSL-1.0
"""What a broker, and the way to it, can do to a gateway: every value that arrives is as new as it says, and all comes right
again by itself.

    python3 broker.py GATEWAY TOOL killed|frozen|slow|half_open|tls|denied|packets|bytes [NUMBER]
    python3 broker.py GATEWAY TOOL name HANGING_LOOKUP

NUMBER: seconds that the broker is frozen; of packets and bytes, each how many-th cut is made.
"""
import subprocess
import time

from stand import (LIMIT, SITE, Broker, Client, Folder, Gateway, Proxy, Units, a_line, a_meter, flows, meter, runs, soon,
                   states, text_of)

LOST = 8  # s, in which a keep-alive of 5 s finds that nobody is there
IN_SOCKET = 2  # s that a value may take on its way on a machine that is busy


def none_is_old(check, client, lost, found):
    """Of what was read while nobody took it, nothing arrives: what the socket took before the loss was seen excepted."""
    got = states(client, since=lost)
    stale = [(round(each.time - lost, 1), round(each.age, 1)) for each in got
             if lost + LOST < each.time < found - IN_SOCKET]
    check(not stale, f"of {len(got)} values none is old", stale)
    late = [(round(each.time - lost, 1), round(each.age, 1)) for each in got if each.time >= found and each.age > IN_SOCKET + 1]
    check(not late, "and what is read behind it comes at once", late)
    seqs = [each.seq for each in got]
    check(seqs == sorted(set(seqs)), "in their order, each once", seqs)


def all_there(check, client, what):
    """All that has to be retained is there, and values come."""
    for topic in ("status", "line1/availability", "line1/meter/availability"):
        check(soon(lambda: client.last(f"{SITE}/{topic}") == "online", LIMIT), f"{what}: {topic} is online",
              client.last(f"{SITE}/{topic}"))
    check(soon(lambda: len(discovered(client)) == 3, LIMIT), f"{what}: discovery is whole", sorted(discovered(client)))
    check(flows(client), f"{what}: values come")


def discovered(client):
    kept = {}
    for each in list(client.messages):
        if each.topic.startswith("homeassistant/") and each.topic.endswith("/config"):
            kept[each.topic] = each.payload
    return {topic: payload for topic, payload in kept.items() if payload}


METER_ONLY = a_meter(registers=["voltage", "power", "energy"])


def killed(check, program, _):
    """Killed and started again: nothing is kept there, so all is told anew."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, METER_ONLY)])) as gateway:
            with Client(broker.port, "#") as client:
                all_there(check, client, "at first")
            for turn in range(2):
                broker.kill()
                lost, asked = time.time(), len(line.requests)
                check(soon(lambda: len(line.requests) > asked + 8, LIMIT), "the line is asked all the same")
                check(soon(lambda: gateway.said().lower().count("broker") > turn, LIMIT), "the loss is said")
                check(gateway.process.poll() is None, "the gateway lives")
                broker.again()
                with Client(broker.port, "#") as client:
                    all_there(check, client, f"started again, {turn}")
                    none_is_old(check, client, lost - LOST, time.time())
        # No broker at the beginning.
        broker.kill()
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, METER_ONLY)])) as gateway:
            asked = len(line.requests)
            check(soon(lambda: len(line.requests) > asked + 8, LIMIT), "without a broker the line is asked")
            broker.again()
            with Client(broker.port, "#") as client:
                all_there(check, client, "a broker comes later")
            check(gateway.end() == 0, "it ends")
        broker.kill()
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, METER_ONLY)])) as gateway:
            check(soon(lambda: "broker" in gateway.said().lower(), LIMIT), "no broker is said")
            check(gateway.end() == 0, "it ends where no broker is")


def frozen(check, program, _, seconds=12):
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        with Gateway(program, folder, text_of(broker.port, [a_line(line.name, METER_ONLY)])) as gateway:
            with Client(broker.port, "#") as client:
                all_there(check, client, "at first")
                broker.freeze()
                lost = time.time()
                asked = len(line.requests)
                time.sleep(float(seconds))
                check(len(line.requests) > asked, "the line is asked all the same")
                check(soon(lambda: "broker" in gateway.said().lower(), LIMIT), "the loss is seen while it lasts", gateway.said())
                broker.thaw()
                found = time.time()
                check(flows(client, since=found + 1, count=3), "values come again")
                check(soon(lambda: client.last(f"{SITE}/status") == "online", LIMIT), "online")
                none_is_old(check, client, lost, found)
            with Client(broker.port, "#") as client:
                all_there(check, client, "behind it")


def slow(check, program, _):
    """A way that takes less than what is read: what passes is the newest, and no heap of old ones grows."""
    with Folder() as folder, Broker(folder) as broker, Units({each: meter() for each in range(1, 9)}) as line:
        devices = [a_meter(f"meter{unit}", unit, every=0.2, registers=["voltage", "power", "energy"]) for unit in range(1, 9)]
        with Proxy(broker.port) as proxy, Client(broker.port, "#") as client:
            with Gateway(program, folder, text_of(proxy.port, [a_line(line.name, *devices)])) as gateway:
                check(flows(client, "line1/meter1"), "values come")
                soon(lambda: len(discovered(client)) == 24, LIMIT)
                proxy.rate = 3000  # of about 8 values in 0.2 s, 160 bytes each
                began = time.time()
                time.sleep(10)
                got = [each for unit in range(1, 9) for each in states(client, f"line1/meter{unit}", began + 3)]
                before = [each for unit in range(1, 9) for each in states(client, f"line1/meter{unit}") if each.message.arrived < began]
                check(got, "some come through")
                print("ages of", len(got), "values:", sorted(round(each.age, 1) for each in got)[-5:], "of", len(before))
                check(gateway.process.poll() is None, "the gateway lives")
                proxy.rate = None
                freed = time.time()
                check(flows(client, "line1/meter1", since=freed + 1, count=3), "values come again")
                # Old ones: what its socket had taken; those behind are new.
                late = [round(each.age, 1) for each in states(client, "line1/meter1") if each.time >= freed and each.age > 3]
                check(not late, "and at once", late)


def half_open(check, program, _):
    """A connection on which nothing passes any more, and that nobody closed."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        with Proxy(broker.port) as proxy, Client(broker.port, "#") as client:
            with Gateway(program, folder, text_of(proxy.port, [a_line(line.name, METER_ONLY)])):
                all_there(check, client, "at first")
                proxy.silence()
                lost, before = time.time(), len(proxy.connections)
                check(soon(lambda: len(proxy.connections) > before, LIMIT), "another connection is made by itself")
                print("behind", round(proxy.connections[-1].began - lost, 1), "s")
                found = time.time()
                check(flows(client, since=found, count=3), "values come again")
                none_is_old(check, client, lost, found)
                # The old connection ends at last: its will says offline behind the new one's online.
                for each in proxy.connections[:before]:
                    each.cut()
                check(flows(client, count=6), "values come")
                check(soon(lambda: client.last(f"{SITE}/status") == "online", LIMIT),
                      "the will of the connection before does not stand", [each.payload for each in client.of(f"{SITE}/status")])


# Cut at each moment of a connection.

def cut_and_look(check, folder, broker, program, line, prepare, what):
    """The next connection is cut as `prepare(proxy)` says; whether that happened."""
    with Proxy(broker.port) as proxy:
        with Client(broker.port, "#") as client:
            prepare(proxy)
            with Gateway(program, folder, text_of(proxy.port, [a_line(line.name, METER_ONLY)])):
                all_there(check, client, what)
                was_cut = proxy.connections[0].is_cut
                values = states(client)
                check(all(each.seq < after.seq for each, after in zip(values, values[1:])), f"{what}: each value once",
                      [each.seq for each in values])
        return was_cut


def packets(check, program, _, each=4):
    """Behind the n-th packet of the gateway, and of the broker."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        for side in ("sent", "told"):
            number = 0
            while number < 60:
                def behave(connection, number=number):
                    if connection is proxy_of[0].connections[0] and len(getattr(connection, side)) > number:
                        return "cut"
                    return None
                proxy_of = [None]

                def prepare(proxy, behave=behave):
                    proxy_of[0] = proxy
                    proxy.behave = behave
                if not cut_and_look(check, folder, broker, program, line, prepare, f"cut behind packet {number} {side}"):
                    break
                number += int(each)
            check(number > 0, f"some were cut: {side}", number)


def bytes_(check, program, _, each=61):
    """In the middle of a packet."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line:
        number, limit = 1, 600
        while number < limit:
            def prepare(proxy, number=number):
                proxy.after_bytes = number
            check(cut_and_look(check, folder, broker, program, line, prepare, f"cut behind byte {number}"), "it was cut", number)
            number += int(each)


# TLS.

def make(folder, name, subject, issuer=None, days=(-1, 10), address="127.0.0.1"):
    """A certificate of its own authority, valid from and to so many days from now."""
    def run(*words):
        subprocess.run(["openssl", *map(str, words)], check=True, cwd=folder, capture_output=True)
    begins, expires = (time.strftime("%Y%m%d%H%M%SZ", time.gmtime(time.time() + day * 86400)) for day in days)
    (folder / f"{name}.cnf").write_text(f"""[req]
distinguished_name = dn
prompt = no
[dn]
CN = {subject}
[ca]
default_ca = own
[own]
new_certs_dir = .
database = {name}.index
serial = {name}.serial
default_md = sha256
policy = any
email_in_dn = no
unique_subject = no
[any]
commonName = supplied
[authority]
basicConstraints = critical, CA:true
subjectKeyIdentifier = hash
[server]
basicConstraints = CA:false
subjectAltName = {"IP:" + address if address[0].isdigit() else "DNS:" + address}
""", encoding="utf-8")
    (folder / f"{name}.index").write_text("")
    (folder / f"{name}.serial").write_text("01\n")
    run("req", "-new", "-newkey", "rsa:2048", "-nodes", "-keyout", f"{name}.key", "-out", f"{name}.csr", "-config", f"{name}.cnf")
    by = issuer or name
    run("ca", "-batch", "-notext", "-config", f"{name}.cnf", "-in", f"{name}.csr", "-out", f"{name}.pem", "-startdate", begins,
        "-enddate", expires, "-keyfile", f"{by}.key", *(["-cert", f"{by}.pem"] if issuer else ["-selfsign"]),
        "-extensions", "server" if issuer else "authority")


def tls(check, program, _):
    with Folder() as folder:
        make(folder, "ca", "Test authority")
        make(folder, "stranger_ca", "Another authority")
        make(folder, "good", "127.0.0.1", "ca")
        make(folder, "expired", "127.0.0.1", "ca", (-20, -10))
        make(folder, "elsewhere", "broker.example", "ca", address="broker.example")
        make(folder, "foreign", "127.0.0.1", "stranger_ca")
        server = folder / "server"
        server.mkdir()

        def take(name):
            for kind in ("pem", "key"):
                (server / f"server.{kind}").write_bytes((folder / f"{name}.{kind}").read_bytes())
        take("good")
        with Broker(folder, f"certfile {server}/server.pem", f"keyfile {server}/server.key", f"cafile {folder}/ca.pem") as broker, \
                Units({3: meter()}) as line:
            text = text_of(broker.port, [a_line(line.name, METER_ONLY)], ca_file="ca.pem")
            topics = ["mosquitto_sub", "-h", "127.0.0.1", "-p", str(broker.port), "--cafile", str(folder / "ca.pem"), "-t", "rtuwire/#",
                      "-v"]

            def heard():
                found = subprocess.run([*topics, "-W", "4"], capture_output=True, text=True, check=False).stdout
                return "/line1/meter/state {" in found and "/status online" in found
            with Gateway(program, folder, text):
                check(soon(heard, LIMIT), "values come by TLS")
            for name, what in (("expired", "an expired certificate"), ("elsewhere", "one for another name"),
                               ("foreign", "one of another authority")):
                broker.kill()
                take(name)
                broker.again()
                with Gateway(program, folder, text) as gateway:
                    check(soon(lambda: "certificate" in gateway.said() and "for this host" in gateway.said(), LIMIT), f"{what} is told",
                          gateway.said())
                    asked = len(line.requests)
                    check(soon(lambda: len(line.requests) > asked + 4, LIMIT), "the line is asked all the same")
                    if name == "expired":
                        broker.kill()
                        take("good")
                        broker.again()
                        check(soon(heard, LIMIT), "a new certificate of the broker is taken by itself")
                    else:
                        log = (broker.folder / "log").read_text(encoding="utf-8", errors="replace")
                        check(gateway.process.poll() is None and "rtuwire" not in log, "nobody is connected", log[-300:])
            # Spoken to a port of the other kind.
            with Gateway(program, folder, text_of(broker.port, [a_line(line.name, METER_ONLY)])) as gateway:
                check(soon(lambda: "broker" in gateway.said().lower(), LIMIT), "no TLS at a port of TLS is told", gateway.said())
                check(gateway.end() == 0, "and it ends")
            with Gateway(program, folder, text.replace("ca.pem", "no.pem"), start=False) as gateway:
                ended = gateway.run_check()
                check(ended.returncode == 2 and "no.pem" in ended.stderr, "an authority that is not there is refused", ended)


def denied(check, program, _):
    """A broker whose list gives a user other topics, or discovery to nobody, drops what comes without a word: the gateway says so."""
    for allowed, refused in ((["elsewhere/#"], f"{SITE}/status"), (["rtuwire/#"], "homeassistant/"), (["#"], None)):
        with Folder() as folder, Units({3: meter()}) as line:
            rules = folder / "acl"
            rules.write_text("".join(f"topic readwrite {each}\n" for each in allowed), encoding="utf-8")
            rules.chmod(0o644)
            with Broker(folder, f"acl_file {rules}") as broker, \
                    Gateway(program, folder, text_of(broker.port, [a_line(line.name, METER_ONLY)])) as gateway:
                if refused:
                    check(soon(lambda: f"it refuses {refused}" in gateway.said(), LIMIT), f"{refused}: refused, and told", gateway.said())
                else:
                    with Client(broker.port, "#") as client:
                        all_there(check, client, "all is allowed")
                    check("it refuses" not in gateway.said(), "and nothing is refused", gateway.said())


def name(check, program, _, hanging):
    """The broker has a name, and its name server says nothing: all else goes on."""
    with Folder() as folder, Broker(folder) as broker, Units({3: meter()}) as line, Client(broker.port, "rtuwire/#") as client:
        near = text_of(broker.port, [a_line(line.name)])
        far = near.replace('"127.0.0.1"', '"hangs.example"')
        with Gateway(program, folder, far, start=False) as gateway:
            gateway.environment["LD_PRELOAD"] = hanging
            found = folder / "lookup"
            gateway.environment["HANGS_UNTIL"] = str(found)
            gateway.environment["ASAN_OPTIONS"] = gateway.environment.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0"
            gateway.start()
            check(soon(lambda: "its port is open" in gateway.said(), LIMIT), "its line is asked, and that is told")
            check(soon(lambda: "its name is not found in time" in gateway.said(), LIMIT), "so is the name that nobody finds")
            gateway.reload(near)
            check(flows(client), "another broker is taken by a reload")
            gateway.reload(far)
            check(soon(lambda: gateway.said().count("read again") == 2, LIMIT), "back to the name")
            check(soon(lambda: client.last(f"{SITE}/status") == "offline", LIMIT), "the broker before is told")
            check(gateway.end() == 0, "and it ends while nobody finds the name")
            # A lookup of a file before is over when another connection is there, of the same name at the same broker.
            client.messages.clear()
            gateway.start()
            check(soon(lambda: gateway.said().count("its port is open") == 2, LIMIT), "begun anew", gateway.said())
            gateway.reload(near)
            check(flows(client), "the near broker is taken")
            found.touch()
            check(soon((folder / "lookup.found").exists, LIMIT), "now the name is found")
            check(flows(client, count=6), "values go on")
            check({each.payload for each in client.of(f"{SITE}/status")[-1:]} == {b"online"} and ": lost: " not in gateway.said(),
                  "and nobody takes the place of the connection that is there", gateway.said())
            check(gateway.end() == 0, "and it ends")


def main(check, program, tool, part, *more):
    {"killed": killed, "frozen": frozen, "slow": slow, "half_open": half_open, "tls": tls, "packets": packets,
     "bytes": bytes_, "denied": denied, "name": name}[part](check, program, tool, *more)


if __name__ == "__main__":
    runs(main)

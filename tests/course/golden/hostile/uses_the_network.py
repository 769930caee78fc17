"""Opens sockets: to the world, to this machine, and to its services."""

import socket

THROUGH = set()


def attempt(name, deed):
    try:
        deed()
    except (OSError, ImportError, AttributeError, KeyError, ValueError, RuntimeError):
        return
    THROUGH.add(name)


def loopback():
    with socket.create_server(("127.0.0.1", 0)) as server:
        socket.create_connection(server.getsockname(), 0.2).close()


def abstract():
    with socket.socket(socket.AF_UNIX) as server:
        server.bind("\0collision-workbook-hostile")


def datagram():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.connect(("192.0.2.1", 53))


def attack():
    attempt("uses the network", loopback)
    attempt("uses the network", datagram)
    attempt("meets other processes", abstract)


TRIED = []


def elastic_1d(m1, v1, m2, v2):
    if not TRIED:
        TRIED.append("once is enough")
        attack()
    total = m1 + m2
    return ((m1 - m2) * v1 + 2 * m2 * v2) / total, ((m2 - m1) * v2 + 2 * m1 * v1) / total


def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v, v


def elastic_impulse_1d(m1, v1, m2, v2):
    return 2 * m1 * m2 / (m1 + m2) * (v1 - v2)


def got_through():
    return sorted(THROUGH)

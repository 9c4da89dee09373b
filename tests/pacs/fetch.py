# SPDX-License-Identifier: BSD-3-Clause
"""Calls palpate-fetch as a user or a parent program does, and keeps all that it says."""
import itertools
import json
import os
import pathlib
import re
import select
import signal
import socket
import subprocess
import threading
import time

from servers import Listener


HANGS = 200  # s: no call takes so long, on a busy machine either


class Answer:
    def __init__(self, code, out, err, seconds):
        self.code, self.out, self.err, self.seconds = code, out, err, seconds
        self.lines = [json.loads(line) for line in out.splitlines() if line.startswith("{")]

    @property
    def last(self):
        return self.lines[-1] if self.lines else {}

    @property
    def reason(self):
        return self.last.get("error", {}).get("reason")

    def __repr__(self):
        return f"code {self.code}, {self.out[-600:]!r}, {self.err[-600:]!r}"


class Fetch:
    """Every call's output and command lines are kept in `said`, to look for names in."""

    def __init__(self, program, folder):
        self.program, self.folder, self.said = str(program), pathlib.Path(folder), []
        self.temporary = self.folder / "temporary"
        self.temporary.mkdir(parents=True)
        self.environment = {**os.environ, "TMPDIR": str(self.temporary), "QT_LOGGING_RULES": "*=true"}
        self.outs = itertools.count(1)

    def out(self):
        return self.folder / f"out-{next(self.outs)}"

    def start(self, command, server, request, *options):
        process = subprocess.Popen([self.program, command, *server, "--json", *map(str, options)],
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   env=self.environment, text=True)
        if request is not None:
            process.stdin.write(json.dumps(request) + "\n")
            process.stdin.flush()
        self.said.append(" ".join(process.args))
        return process

    def call(self, command, server, request=None, *options, show=False):
        begun = time.monotonic()
        process = self.start(command, server, request, *options)
        listing = "\n".join(self.listing(process))
        try:
            out, err = process.communicate(timeout=HANGS)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
        if not show:
            self.said += [out, err, listing]
        return Answer(process.returncode, out, err, time.monotonic() - begun)

    @staticmethod
    def family(process):
        """The process and its children."""
        ids = [process.pid]
        try:
            children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
            ids += [int(word) for word in children.split()]
        except OSError:
            pass
        return ids

    def listing(self, process):
        """What every user can read of them."""
        lines = []
        for one in self.family(process):
            try:
                lines.append(pathlib.Path(f"/proc/{one}/cmdline").read_bytes().replace(b"\0", b" ").decode())
                lines.append(pathlib.Path(f"/proc/{one}/comm").read_text())
            except OSError:
                pass
        return lines

    def listening(self, process):
        """The addresses that they listen on."""
        ids = self.family(process)
        table = subprocess.run(["ss", "-Hltnp"], capture_output=True, text=True, check=True).stdout
        return [line.split()[3] for line in table.splitlines()
                if any(f"pid={one}," in line for one in ids)]

    def left(self):
        return sorted(path.name for path in self.temporary.glob("palpate-fetch-*"))


def read_until(process, wanted, seconds=60):
    """The lines of output until one for which `wanted` holds; that one is the last."""
    # byte by byte from the pipe: a buffered reader may hold lines for which select then waits
    pipe, lines, line, until = process.stdout.fileno(), [], b"", time.monotonic() + seconds
    while time.monotonic() < until:
        if not select.select([pipe], [], [], 0.1)[0]:
            continue
        read = os.read(pipe, 1)
        line += read
        if not read:
            break
        if read == b"\n":
            lines.append(json.loads(line))
            line = b""
            if wanted(lines[-1]):
                break
    return lines


class Proxy(Listener):
    """Stands before a server: slows what it sends [bytes/s], or cuts connections. `cuts`: after so many
    bytes of the server's each, the first connections are cut; further ones are whole."""

    def __init__(self, port, rate=None, cuts=()):
        self.to, self.rate, self.cuts, self.carried = port, rate, list(cuts), []
        self.listen()

    def serve(self, client):
        try:
            server = socket.create_connection(("127.0.0.1", self.to))
        except OSError:
            client.close()
            return
        cut = self.cuts.pop(0) if self.cuts else None
        self.carried.append(0)
        mine = len(self.carried) - 1

        def forward():
            try:
                while data := client.recv(65536):
                    server.sendall(data)
                server.shutdown(socket.SHUT_WR)
            except OSError:
                pass

        threading.Thread(target=forward, daemon=True).start()
        try:
            while data := server.recv(16384):
                if cut is not None and self.carried[mine] + len(data) > cut:
                    client.sendall(data[:cut - self.carried[mine]])
                    self.carried[mine] = cut
                    break
                self.carried[mine] += len(data)
                client.sendall(data)
                if self.rate:
                    time.sleep(len(data) / self.rate)
        except OSError:
            pass
        for one in (client, server):
            try:
                one.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
            one.close()


def is_named_by_number(folder):
    return all(re.fullmatch(r"\d{6}\.dcm", path.name) for path in pathlib.Path(folder).iterdir())


def interrupt(process):
    """SIGTERM; how long the process took to end, and what it said."""
    begun = time.monotonic()
    process.send_signal(signal.SIGTERM)
    out, err = process.communicate()
    return time.monotonic() - begun, out, err

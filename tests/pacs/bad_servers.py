# SPDX-License-Identifier: BSD-3-Clause
"""Servers of DICOMweb and DIMSE that behave as no server should, and one of each that behaves oddly
but within the standard. Each serves one image of one series, as far as it gets."""
import http.server
import json
import socket
import struct
import threading
import time

from servers import Listener

STUDY, SERIES = "1.2.3.4.50", "1.2.3.4.60"


class BadWeb:
    """`how`: which misbehaviour. `image`: the DICOM file of STUDY and SERIES."""

    def __init__(self, how, image=b"", strange=b""):
        outer = self
        self.how, self.image, self.strange, self.asked = how, image, strange, []

        class Handler(http.server.BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def log_message(self, *_):
                pass

            def do_GET(self):
                outer.asked.append((self.path, dict(self.headers)))
                try:
                    outer.answer(self)
                except (BrokenPipeError, ConnectionResetError):
                    pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.daemon_threads = True
        self.port = self.server.server_address[1]
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def url(self):
        return f"http://127.0.0.1:{self.port}/dicom-web"

    def close(self):
        self.server.shutdown()
        self.server.server_close()

    @staticmethod
    def send(handler, body, kind="application/dicom+json", status=200, length=None, **headers):
        handler.send_response(status)
        handler.send_header("Content-Type", kind)
        handler.send_header("Content-Length", str(len(body) if length is None else length))
        for name, value in headers.items():
            handler.send_header(name.replace("_", "-"), value)
        handler.end_headers()
        handler.wfile.write(body)

    def answer(self, handler):
        how, path = self.how, handler.path
        if how == "silent":
            time.sleep(60)
        if how == "slow":
            handler.send_response(200)
            handler.send_header("Content-Type", "application/dicom+json")
            handler.send_header("Content-Length", "100000")
            handler.end_headers()
            for _ in range(60):
                handler.wfile.write(b" ")
                handler.wfile.flush()
                time.sleep(1)
        if how == "redirect-elsewhere":
            return self.send(handler, b"", status=302, Location=f"http://localhost:{self.port}/dicom-web/studies")
        if how == "redirect-circle":
            return self.send(handler, b"", status=302, Location=path)
        if how in ("401", "403", "404", "500"):
            return self.send(handler, b"<html>no</html>", "text/html", int(how))
        if how == "html":
            return self.send(handler, b"<html>Welcome</html>", "text/html")
        if how == "no-json":
            return self.send(handler, b'[{"0020000D": {"vr": "UI", "Value": ["1.2')
        if how == "deep":
            return self.send(handler, b"[" * 2_000_000)
        if how == "packed":
            return self.send(handler, b"\x1f\x8b\x08\0junk", Content_Encoding="gzip")
        if how == "endless":
            handler.send_response(200)
            handler.send_header("Content-Type", "application/dicom+json")
            handler.send_header("Connection", "close")
            handler.end_headers()
            handler.wfile.write(b"[")
            while True:
                handler.wfile.write(b'{"0020000D":{"vr":"UI","Value":["1.2.3"]}},' * 1000)
        if how == "garbage":
            handler.connection.sendall(bytes(range(256)) * 100)
            handler.close_connection = True
            return None
        if "/series/" not in path:
            return self.list(handler, path)
        if path.split("?")[0].endswith("/instances"):
            uid = "1.2.3.4.70"
            return self.send(handler, json.dumps([{"00080018": {"vr": "UI", "Value": [uid]}}]).encode())
        return self.images(handler)

    @staticmethod
    def die(handler, kind, chunks=b""):
        handler.close_connection = True
        handler.connection.sendall(b"HTTP/1.1 200 OK\r\nContent-Type: " + kind.encode()
                                   + b"\r\nTransfer-Encoding: chunked\r\n\r\n" + chunks)
        handler.connection.shutdown(socket.SHUT_RDWR)

    def list(self, handler, path):
        if self.how == "list-dies":
            return self.die(handler, "application/dicom+json")
        value = lambda *texts: {"vr": "UI", "Value": list(texts)}
        if "/series" in path:
            uid = "../../escape" if self.how == "series-path" else SERIES
            entry = {"0020000D": value(STUDY), "0020000E": value(uid), "00080060": value("CT"),
                     "00201209": {"vr": "IS", "Value": [1]}}
            return self.send(handler, json.dumps([entry]).encode())
        if self.how == "many":
            entries = [{"0020000D": value(f"1.2.3.{n}")} for n in range(100_000)]
            return self.send(handler, json.dumps(entries).encode())
        uid = "1.2/../../../escape?x=" if self.how == "study-path" else STUDY
        return self.send(handler, json.dumps([{"0020000D": value(uid)}]).encode())

    def images(self, handler):
        how, image = self.how, self.image
        part = b"Content-Type: application/dicom\r\n"
        kind = 'multipart/related; type="application/dicom"; boundary="=_edge"'
        whole = b"--=_edge\r\n" + part + b"\r\n" + image + b"\r\n--=_edge--"
        if how == "bare":
            return self.send(handler, image, "application/dicom")
        if how == "repeated-headers":
            return self.send(handler, b"preamble\r\n--=_edge\r\n" + part * 3 + b"MIME-Version: 1.0\r\n\r\n" + image
                             + b"\r\n--=_edge--\r\nepilogue", kind)
        if how == "unquoted":
            return self.send(handler, whole.replace(b"=_edge", b"edge1"),
                             "multipart/related; boundary=edge1; type=application/dicom")
        if how == "lying-part-length":
            lie = part + b"Content-Length: 999999999999\r\n"
            return self.send(handler, b"--=_edge\r\n" + lie + b"\r\n" + image + b"\r\n--=_edge--", kind)
        if how == "lying-length":
            handler.close_connection = True
            return self.send(handler, whole, kind, length=len(whole) + 100_000)
        if how == "short-length":
            handler.close_connection = True
            return self.send(handler, whole, kind, length=len(whole) // 2)
        if how == "cut":
            handler.close_connection = True
            return self.send(handler, whole[:-20], kind)
        if how == "no-boundary":
            return self.send(handler, image, "multipart/related")
        if how == "header-without-end":
            return self.send(handler, b"--=_edge\r\n" + b"X: y\r\n" * 100_000, kind)
        if how == "junk-parts":
            return self.send(handler, b"--=_edge\r\n\r\njunk\r\n" * 20_000 + b"--=_edge--", kind)
        if how == "stranger":
            return self.send(handler, whole.replace(image, self.strange), kind)
        if how == "stranger-too":
            return self.send(handler, b"--=_edge\r\n" + part + b"\r\n" + self.strange + b"\r\n" + whole, kind)
        if how == "text":
            return self.send(handler, b"no images here", "text/plain")
        if how == "dies":
            return self.die(handler, kind)
        if how == "bare-dies":
            half = image[:len(image) // 2]
            return self.die(handler, "application/dicom", b"%x\r\n%b\r\n" % (len(half), half))
        if how == "silent-midway":
            handler.send_response(200)
            handler.send_header("Content-Type", kind)
            handler.send_header("Content-Length", str(len(whole)))
            handler.end_headers()
            handler.wfile.write(whole[:1000])
            handler.wfile.flush()
            time.sleep(60)
            return None
        return self.send(handler, whole, kind)


# DIMSE: just enough of the upper layer and of its messages

def item(kind, data):
    return struct.pack(">BBH", kind, 0, len(data)) + data


def pdu(kind, data):
    return struct.pack(">BBI", kind, 0, len(data)) + data


def command_element(number, data):
    return struct.pack("<HHI", 0, number, len(data)) + data


def word(value):
    return struct.pack("<H", value)


def uid_bytes(text):
    data = text.encode()
    return data + b"\0" * (len(data) % 2)


def command(field, answered=None, status=None, uid="", dataset=False, **more):
    body = command_element(2, uid_bytes(uid)) + command_element(0x100, word(field))
    if "message" in more:
        body += command_element(0x110, word(more["message"]))
    if answered is not None:
        body += command_element(0x120, word(answered))
    if "priority" in more:
        body += command_element(0x700, word(0))
    body += command_element(0x800, word(1 if dataset else 0x101))
    if status is not None:
        body += command_element(0x900, word(status))
    if "instance" in more:
        body += command_element(0x1000, uid_bytes(more["instance"]))
    return command_element(0, struct.pack("<I", len(body))) + body


def implicit(group, number, text):
    data = uid_bytes(text) if isinstance(text, str) else text
    return struct.pack("<HHI", group, number, len(data)) + data


class BadDimse(Listener):
    """`image`: the data set of an image of STUDY and SERIES in implicit little endian."""

    CT = "1.2.840.10008.5.1.4.1.1.2"

    def __init__(self, how, image=b"", strange=b""):
        self.how, self.image, self.strange = how, image, strange
        self.cancelled, self.statuses = False, []
        self.listen()

    def serve(self, peer):
        try:
            self.answer(peer)
        except (OSError, EOFError):
            pass
        finally:
            peer.close()

    @staticmethod
    def exactly(peer, count):
        data = b""
        while len(data) < count:
            more = peer.recv(count - len(data))
            if not more:
                raise EOFError
            data += more
        return data

    def next_pdu(self, peer):
        kind, _, length = struct.unpack(">BBI", self.exactly(peer, 6))
        return kind, self.exactly(peer, length)

    def answer(self, peer):
        if self.how == "silent":
            time.sleep(60)
            return
        if self.how == "garbage":
            peer.sendall(bytes(range(7, 256)) * 40)
            time.sleep(0.5)
            return
        if self.how == "closes":
            return
        kind, request = self.next_pdu(peer)
        if kind != 1:
            return
        self.contexts = {}
        accepted, roles, at = b"", b"", 68
        while at + 4 <= len(request):
            kind, _, length = struct.unpack(">BBH", request[at:at + 4])
            data = request[at + 4:at + 4 + length]
            at += 4 + length
            if kind == 0x20:
                inner, syntaxes = 4, []
                while inner + 4 <= len(data):
                    sub, _, size = struct.unpack(">BBH", data[inner:inner + 4])
                    text = data[inner + 4:inner + 4 + size]
                    inner += 4 + size
                    if sub == 0x30:
                        abstract = text.rstrip(b"\0").decode()
                    else:
                        syntaxes.append(text.rstrip(b"\0").decode())
                chosen = "1.2.840.10008.1.2" if "1.2.840.10008.1.2" in syntaxes else syntaxes[0]
                self.contexts[data[0]] = (abstract, chosen)
                accepted += item(0x21, bytes([data[0], 0, 0, 0]) + item(0x40, chosen.encode()))
            elif kind == 0x50:
                inner = 0
                while inner + 4 <= len(data):
                    sub, _, size = struct.unpack(">BBH", data[inner:inner + 4])
                    if sub == 0x54:
                        roles += data[inner:inner + 4 + size]
                    inner += 4 + size
        user = item(0x51, struct.pack(">I", 16384)) + item(0x52, b"1.2.3.9") + roles
        answer = pdu(2, request[:68] + item(0x10, b"1.2.840.10008.3.1.1.1") + accepted + item(0x50, user))
        if self.how == "slow":
            for byte in answer:
                peer.sendall(bytes([byte]))
                time.sleep(1)
        if self.how.startswith("rejects"):
            peer.sendall(pdu(3, bytes([0, 1, 1, 3 if self.how == "rejects-caller" else 1])))
            time.sleep(0.5)
            return
        if self.how == "long-association":
            peer.sendall(struct.pack(">BBI", 2, 0, 0xffffffff) + answer[6:])
            time.sleep(60)
            return
        peer.sendall(answer)
        while True:
            self.message(peer, *self.receive(peer))

    def receive(self, peer):
        """(context, the fields of a command, its data set)"""
        commands, data, fields = b"", b"", None
        while True:
            kind, body = self.next_pdu(peer)
            if kind == 5:
                peer.sendall(pdu(6, bytes(4)))
                raise EOFError
            if kind != 4:
                raise EOFError
            at = 0
            while at < len(body):
                length, context, control = struct.unpack(">IBB", body[at:at + 6])
                part = body[at + 6:at + 4 + length]
                at += 4 + length
                if control & 1:
                    commands += part
                else:
                    data += part
                if control & 2 and control & 1:
                    fields, inner = {}, 0
                    while inner < len(commands):
                        _, number, size = struct.unpack("<HHI", commands[inner:inner + 8])
                        fields[number] = commands[inner + 8:inner + 8 + size]
                        inner += 8 + size
                    if struct.unpack("<H", fields[0x800])[0] == 0x101:
                        return context, fields, b""
                elif control & 2:
                    return context, fields, data

    @staticmethod
    def send(peer, context, data, is_command, last=True):
        for at in range(0, max(1, len(data)), 16000):
            part = data[at:at + 16000]
            ends = last and at + 16000 >= len(data)
            body = struct.pack(">IBB", len(part) + 2, context, (1 if is_command else 0) | (2 if ends else 0)) + part
            peer.sendall(pdu(4, body))

    def message(self, peer, context, fields, data):
        field = struct.unpack("<H", fields[0x100])[0]
        number = struct.unpack("<H", fields.get(0x110, b"\0\0"))[0]
        how = self.how
        if field == 0x0fff:
            self.cancelled = True
            if self.pending:
                self.send(peer, self.pending[0], command(self.pending[1], self.pending[2], 0xfe00), True)
            return
        if field == 0x8001:
            self.statuses.append(struct.unpack("<H", fields[0x900])[0])
            return
        if how == "silent-after":
            time.sleep(60)
        if how == "long-pdata":
            peer.sendall(struct.pack(">BBI", 4, 0, 0x7fffffff))
            for _ in range(60):
                peer.sendall(b"\0")
                time.sleep(1)
        if how == "endless-command":
            while True:
                self.send(peer, context, bytes(16000), True, last=False)
        if how == "wrong-message":
            self.send(peer, context, command(0x8030, number, 0), True)
            return
        if field == 0x30:
            self.send(peer, context, command(0x8030, number, 0, "1.2.840.10008.1.1"), True)
        elif field == 0x20:
            self.find(peer, context, number, data)
        elif field == 0x21:
            self.pending = (context, 0x8021, number)
            self.send(peer, context, command(0x8021, number, 0xff00), True)
        elif field == 0x10:
            self.get(peer, context, number)

    pending = None

    def find(self, peer, context, number, data):
        def match(elements):
            self.send(peer, context, command(0x8020, number, 0xff00, dataset=True), True)
            self.send(peer, context, elements, False)

        if self.how == "endless-match":
            self.send(peer, context, command(0x8020, number, 0xff00, dataset=True), True)
            while True:
                self.send(peer, context, bytes(16000), False, last=False)
        if self.how == "many":
            for n in range(100_000):
                match(implicit(8, 0x52, "STUDY ") + implicit(0x20, 0xd, f"1.2.3.{n}"))
        elif self.how == "deep":
            match((struct.pack("<HHI", 8, 0x1140, 0xffffffff) + struct.pack("<HHI", 0xfffe, 0xe000, 0xffffffff))
                  * 200_000)
        elif b"IMAGE" in data:
            match(implicit(8, 0x18, "1.2.3.4.70") + implicit(8, 0x52, "IMAGE ") + implicit(0x20, 0xd, STUDY)
                  + implicit(0x20, 0xe, SERIES))
        elif b"SERIES" in data:
            match(implicit(8, 0x52, "SERIES") + implicit(8, 0x60, "CT") + implicit(0x20, 0xd, STUDY)
                  + implicit(0x20, 0xe, "../../escape" if self.how == "series-path" else SERIES))
        else:
            match(implicit(8, 0x52, "STUDY ")
                  + implicit(0x20, 0xd, "../../../escape" if self.how == "study-path" else STUDY))
        self.send(peer, context, command(0x8020, number, 0), True)

    def get(self, peer, context, number):
        how = self.how
        half = self.image[:len(self.image) // 4 * 2]  # a fragment has an even length
        images = [n for n, (abstract, syntax) in self.contexts.items()
                  if abstract == self.CT and syntax == "1.2.840.10008.1.2"]
        store = images[0]

        def image(data, instance="1.2.3.4.70", last=True):
            self.send(peer, store, command(1, uid=self.CT, dataset=True, message=7, priority=0, instance=instance), True)
            self.send(peer, store, data, False, last)

        if how == "waits-for-cancel":
            self.pending = (context, 0x8010, number)
            self.send(peer, context, command(0x8010, number, 0xff00), True)
            return
        if how == "dies-midway":
            image(half, last=False)
            raise EOFError
        if how == "silent-midway":
            image(half, last=False)
            time.sleep(60)
        if how == "lying-lengths":
            # a PDV that is longer than its PDU
            peer.sendall(pdu(4, struct.pack(">IBB", 0x00ffffff, store, 1) + b"\0" * 100))
            time.sleep(60)
        if how == "stranger":
            image(self.strange)
        elif how == "paths":
            image(self.image, "../../../../escape")
        elif how == "stranger-too":
            image(self.strange)
            self.statuses.append(self.receive(peer)[1][0x900])
            image(self.image)
        elif how == "junk":
            image(b"\x99" * 5000)
        else:
            image(self.image)
        self.statuses.append(struct.unpack("<H", self.receive(peer)[1][0x900])[0])
        self.send(peer, context, command(0x8010, number, 0), True)

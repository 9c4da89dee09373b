# SPDX-License-Identifier: BSD-3-Clause
"""Debian's own Orthanc and dcmqrscp for a test: started on free ports, stopped at its end. Debian's Orthanc
dies of its first request over https (its web server and OpenSSL 3 do not fit), so Front stands before it."""
import base64
import json
import os
import pathlib
import select
import shutil
import socket
import ssl
import subprocess
import threading
import time
import urllib.request

PATIENCE = 60  # s: for a server to start, on a busy machine


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def await_port(port, process):
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        if process.poll() is not None:
            raise RuntimeError(f"{process.args[0]} ended with {process.returncode}")
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)) == 0:
                return
        time.sleep(0.05)
    raise RuntimeError(f"{process.args[0]} does not listen")


class Authority:
    """A certificate authority of the test, and what it signs."""

    def __init__(self, folder, name="Test authority"):
        self.folder = pathlib.Path(folder)
        self.folder.mkdir(parents=True)
        self.certificate, self.key = self.folder / "authority.pem", self.folder / "authority.key"
        self.openssl("req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "30", "-sha256", "-subj",
                     f"/CN={name}", "-keyout", self.key, "-out", self.certificate)

    def openssl(self, *arguments):
        subprocess.run(["openssl", *arguments], check=True, capture_output=True)

    def sign(self, name, host, expired=False):
        """(certificate, key) for a host; one that has expired ran out long ago."""
        certificate, key = self.folder / f"{name}.pem", self.folder / f"{name}.key"
        request, options = self.folder / f"{name}.csr", self.folder / f"{name}.ext"
        kind = "IP" if host.replace(".", "").isdigit() else "DNS"
        options.write_text(f"subjectAltName={kind}:{host}\nbasicConstraints=CA:FALSE\n")
        self.openssl("req", "-newkey", "rsa:2048", "-nodes", "-sha256", "-subj", f"/CN={host}",
                     "-keyout", key, "-out", request)
        # x509 can only end a certificate days from now; ca takes any dates
        if expired:
            index, serial = self.folder / f"{name}.index", self.folder / f"{name}.serial"
            index.write_text("")
            serial.write_text("77\n")
            configuration = self.folder / f"{name}.cnf"
            configuration.write_text(
                f"[ca]\ndefault_ca=one\n[one]\ndatabase={index}\nserial={serial}\nnew_certs_dir={self.folder}\n"
                "default_md=sha256\npolicy=any\n[any]\ncommonName=supplied\n")
            self.openssl("ca", "-batch", "-config", configuration, "-cert", self.certificate, "-keyfile", self.key,
                         "-in", request, "-out", certificate, "-extfile", options, "-startdate", "20200101000000Z",
                         "-enddate", "20200201000000Z", "-notext")
        else:
            self.openssl("x509", "-req", "-in", request, "-CA", self.certificate, "-CAkey", self.key,
                         "-CAcreateserial", "-days", "20", "-sha256", "-extfile", options, "-out", certificate)
        return certificate, key


class Listener:
    """Listens on a free port, and calls serve() for each connection on a thread of its own."""

    def listen(self):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        threading.Thread(target=self.accept, daemon=True).start()

    def accept(self):
        while True:
            try:
                peer, _ = self.listener.accept()
            except OSError:
                return
            threading.Thread(target=self.serve, args=(peer,), daemon=True).start()

    def close(self):
        self.listener.close()


class Front(Listener):
    """Takes https for a server of http. `authority`: only with a certificate of this one."""

    def __init__(self, port, pair, authority=None):
        self.to = port
        self.context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        self.context.load_cert_chain(*pair)
        if authority:
            self.context.verify_mode = ssl.CERT_REQUIRED
            self.context.load_verify_locations(authority)
        self.listen()

    def serve(self, raw):
        try:
            with self.context.wrap_socket(raw, server_side=True) as client:
                with socket.create_connection(("127.0.0.1", self.to)) as server:
                    self.relay(client, server)
        except OSError:
            pass

    @staticmethod
    def relay(client, server):
        # one thread for both ways: a TLS connection is no thing for two
        while True:
            ready = [client] if client.pending() else select.select([client, server], [], [])[0]
            for one in ready:
                data = one.recv(65536)
                if not data:
                    return
                (server if one is client else client).sendall(data)


class Server:
    def __init__(self, arguments, folder, **environment):
        self.log = (folder / "log.txt").open("ab")
        self.arguments, self.environment, self.folder = arguments, {**os.environ, **environment}, folder
        self.start()

    def start(self):
        self.process = subprocess.Popen(self.arguments, stdout=self.log, stderr=self.log, env=self.environment,
                                        cwd=self.folder)

    def kill(self):
        self.process.kill()
        self.process.wait()

    def stop(self):
        self.kill()
        self.log.close()


class Orthanc(Server):
    """`unpacked`: where the packages lie; "/" where they are installed."""

    def __init__(self, unpacked, folder, called="ORTHANC", https=None, authority=None, tls=None, mutual=False,
                 users=None, modalities=None, more=None):
        folder = pathlib.Path(folder)
        folder.mkdir(parents=True)
        self.http, self.dimse, self.called = free_port(), free_port(), called
        self.front = Front(self.http, https, authority if mutual else None) if https else None
        self.scheme, self.web, self.users = "https" if https else "http", self.front.port if https else self.http, users
        settings = {
            "Name": "Test", "StorageDirectory": str(folder / "storage"), "IndexDirectory": str(folder / "index"),
            "Plugins": [str(unpacked / "usr/share/orthanc/plugins/libOrthancDicomWeb.so")],
            "HttpPort": self.http, "DicomPort": self.dimse, "DicomAet": called, "RemoteAccessAllowed": True,
            "AuthenticationEnabled": users is not None, "RegisteredUsers": users or {},
            "DicomCheckCalledAet": True, "DicomAlwaysAllowEcho": False, "DicomAlwaysAllowStore": True,
            "DicomModalities": modalities or {"palpate": {
                "AET": "PALPATE", "Host": "127.0.0.1", "Port": 4242, "AllowEcho": True, "AllowFind": True,
                "AllowFindWorklist": False, "AllowGet": True, "AllowMove": True, "AllowStore": True}},
            "DicomWeb": {"Enable": True, "Root": "/dicom-web/"},
            "HttpsCACertificates": "", "StorageCompression": False, "SynchronousCMove": True,
            "KeepAlive": True, "TcpNoDelay": True, "SyncStorageArea": False, **(more or {})}
        if tls:
            settings |= {"DicomTlsEnabled": True, "DicomTlsCertificate": str(tls[0]),
                         "DicomTlsPrivateKey": str(tls[1]), "DicomTlsTrustedCertificates": str(authority),
                         "DicomTlsRemoteCertificateRequired": mutual}
        (folder / "orthanc.json").write_text(json.dumps(settings))
        libraries = ":".join(str(unpacked / part) for part in ("usr/lib/x86_64-linux-gnu", "usr/lib"))
        super().__init__([str(unpacked / "usr/sbin/Orthanc"), str(folder / "orthanc.json")], folder,
                         LD_LIBRARY_PATH=libraries)
        self.ready()

    def ready(self):
        await_port(self.http, self.process)
        await_port(self.dimse, self.process)

    def url(self, host="127.0.0.1"):
        return f"{self.scheme}://{host}:{self.web}/dicom-web"

    def rest(self, path, data=None, method=None):
        request = urllib.request.Request(f"http://127.0.0.1:{self.http}{path}", data=data, method=method)
        if self.users:
            user, password = next(iter(self.users.items()))
            request.add_header("Authorization",
                               "Basic " + base64.b64encode(f"{user}:{password}".encode()).decode())
        with urllib.request.urlopen(request) as answer:
            return answer.read()

    def take(self, *paths):
        for path in paths:
            self.rest("/instances", pathlib.Path(path).read_bytes())


class Qrscp(Server):
    """DCMTK's dcmqrscp, which knows PALPATE at a port."""

    def __init__(self, folder, called="QRSCP", move_port=4242, tls=None, authority=None, known=("PALPATE",)):
        folder = pathlib.Path(folder)
        (folder / "images").mkdir(parents=True)
        self.dimse, self.called = free_port(), called
        peers = ", ".join(f"({title}, localhost, {move_port})" for title in known)
        (folder / "qrscp.cfg").write_text(
            f'NetworkTCPPort = {self.dimse}\nMaxPDUSize = 131072\nMaxAssociations = 16\nUserName = ""\nGroupName = ""\n'
            f"HostTable BEGIN\nknown = {peers}\nHostTable END\nVendorTable BEGIN\nVendorTable END\n"
            f"AETable BEGIN\n{called} {folder / 'images'} RW (100000, 4096mb) known\nAETable END\n")
        arguments = ["dcmqrscp", "--verbose", "-c", str(folder / "qrscp.cfg")]
        super().__init__(arguments, folder)
        await_port(self.dimse, self.process)

    def take(self, *folders):
        for folder in folders:
            subprocess.run(["dcmsend", "-nh", "-aet", "PALPATE", "-aec", self.called, "127.0.0.1", str(self.dimse),
                            "--scan-directories", str(folder)], check=True, capture_output=True)


class Keyring:
    """gnome-keyring on the session's own bus, unlocked, with a home of its own."""

    @staticmethod
    def program(unpacked):
        """Unpacked by packaging/test, or installed."""
        return shutil.which("gnome-keyring-daemon", path=f"{unpacked}/usr/bin:{os.environ['PATH']}")

    @classmethod
    def missing(cls, unpacked):
        programs = [name for name in ("dbus-run-session", "secret-tool", "gdbus") if shutil.which(name) is None]
        return programs + ([] if cls.program(unpacked) else ["gnome-keyring-daemon"])

    def __init__(self, unpacked, home):
        self.home = pathlib.Path(home)
        self.environment = {"HOME": str(self.home)}
        for name in ("DATA_HOME", "CONFIG_HOME", "CACHE_HOME", "RUNTIME_DIR"):
            folder = self.home / name.lower()
            folder.mkdir(parents=True, mode=0o700)
            self.environment[f"XDG_{name}"] = str(folder)
        # it goes on by itself, and ends with the bus
        subprocess.run([self.program(unpacked), "--unlock", "--components=secrets"], input="x", text=True, check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={
                           **os.environ, **self.environment,
                           "LD_LIBRARY_PATH": str(pathlib.Path(unpacked) / "usr/lib/x86_64-linux-gnu")})

    def lock(self):
        subprocess.run(["gdbus", "call", "--session", "--dest", "org.freedesktop.secrets", "--object-path",
                        "/org/freedesktop/secrets", "--method", "org.freedesktop.Secret.Service.Lock",
                        "[objectpath '/org/freedesktop/secrets/collection/login']"], check=True, capture_output=True)

    def files(self):
        return [path for path in self.home.rglob("*") if path.is_file()]


def found(unpacked):
    """Where Orthanc lies: unpacked by packaging/test, or installed; nothing if neither."""
    for place in (pathlib.Path(unpacked), pathlib.Path("/")):
        if (place / "usr/sbin/Orthanc").exists() and (
                place / "usr/share/orthanc/plugins/libOrthancDicomWeb.so").exists():
            return place
    return None


def missing_programs():
    return [name for name in ("dcmqrscp", "dcmsend", "getscu", "movescu", "dcmconv", "dcmcjpeg", "dcmcjpls",
                              "dcmcrle", "gdcmconv", "curl", "openssl", "unshare", "ss", "ip") if shutil.which(name) is None]

# SPDX-License-Identifier: BSD-3-Clause
"""palpate-fetch with real servers: Debian's Orthanc with its DICOMweb plugin, and DCMTK's dcmqrscp.

pacs_test.py PALPATE_FETCH PALPATE_CLI PACKAGES WORK SECTION: PACKAGES is the folder in which
packaging/test unpacks Orthanc, WORK a folder for what the test makes. The slices are made here. The
test runs itself in a network of its own, since the servers listen on all addresses. It ends with 77
where something is missing.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shutil
import stat
import statistics
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path += [str(HERE), str(HERE.parent / "scenario"), str(HERE.parent / "support")]

from checks import check, outcome  # noqa: E402
from dicom_slices import CONVERTED, Head, Person, Series, dicom, enhanced, uid  # noqa: E402
from fetch import Fetch, Proxy, interrupt, is_named_by_number, read_until  # noqa: E402
from servers import Authority, Keyring, Orthanc, Qrscp, found, free_port, missing_programs  # noqa: E402

SKIPPED = 77
SYNTAXES = ("explicit", *CONVERTED)


def skip(why):
    print(f"SKIPPED: {why} Nothing was fetched from a real server.")
    sys.exit(SKIPPED)


class Stage:
    """What the sections share."""

    def __init__(self, arguments):
        self.program, self.cli, packages, work, section = arguments
        self.unpacked = found(packages).resolve()
        self.work = pathlib.Path(work) / section
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        self.fetch = Fetch(self.program, self.work)
        self.head = Head()
        self.people, self.running, self.hashes = [], [], {}

    def person(self):
        self.people.append(Person())
        return self.people[-1]

    def series(self, slices, side, syntax="explicit", person=None, **more):
        return Series(self.work / f"series-{syntax}-{len(list(self.work.iterdir()))}", self.head,
                      person or self.person(), slices, side, syntax, **more)

    def server(self, kind, name, *arguments, **options):
        made = kind(*arguments, self.work / name, **options)
        self.running.append(made)
        return made

    def orthanc(self, name="orthanc", **options):
        return self.server(Orthanc, name, self.unpacked, **options)

    def qrscp(self, name="qrscp", **options):
        return self.server(Qrscp, name, **options)

    def voxels(self, folder):
        """The hash of the volume that palpate-cli makes of a folder, which no longer changes."""
        if folder not in self.hashes:
            made = self.work / "volume.nrrd"
            made.unlink(missing_ok=True)
            done = subprocess.run([self.cli, "convert", str(folder), str(made), "--json"], capture_output=True,
                                  text=True)
            self.hashes[folder] = (hashlib.sha256(made.read_bytes()).hexdigest() if done.returncode == 0
                                   else f"{folder}: {done.stderr}")
        return self.hashes[folder]

    def voxels_of(self, series):
        """The same of a series' own files: those of a size are alike, since no transfer syntax loses anything."""
        alike = (series.count, series.side)
        if alike not in self.hashes:
            self.hashes[alike] = self.voxels(series.folder)
        return self.hashes[alike]

    def nobody(self):
        """No planted text is in anything that was said without --names."""
        said = "\n".join(self.fetch.said)
        check(len(said) > 1000, "nearly nothing was said")
        for person in self.people:
            for text in person.texts():
                check(text not in said, f"the planted {text} was said")
        for series in self.of_uids:
            for uid in (series.study, series.series, *series.instances):
                check(uid not in said, f"the identifier {uid} was said")

    of_uids = []

    def stop(self):
        for one in self.running:
            one.stop()


def fetched_whole(stage, server, series, name, *options):
    """Finds and gets a series; whether its voxels are those of its files."""
    query = {"query": {"patient_id": series.person.id}}
    listed = stage.fetch.call("find", server, query)
    if not check(listed.code == 0 and len(listed.last["series"]) == 1, f"{name}: find: {listed}"):
        return None
    entry = listed.last["series"][0]
    check(entry["modality"] == "CT" and entry["images"] in (series.count, None), f"{name}: {entry}")
    out = stage.fetch.out()
    got = stage.fetch.call("get", server, {**query, "index": 0, "check": entry["check"]}, "--out", out, *options)
    if not check(got.code == 0, f"{name}: get: {got}"):
        return None
    done = got.last
    check(done["images"] == series.count and done["missing"] == 0 and done["not_kept"] == 0, f"{name}: {done}")
    check(stat.S_IMODE(out.stat().st_mode) == 0o700, f"{name}: the folder's mode is {out.stat().st_mode:o}")
    check(is_named_by_number(out), f"{name}: the files are {sorted(p.name for p in out.iterdir())[:3]}")
    check(stage.voxels(out) == stage.voxels_of(series), f"{name}: the voxels differ")
    return got, out


def syntax_of(path):
    """The transfer syntax that a file states."""
    dumped = subprocess.run(["dcmdump", "+P", "0002,0010", "-Un", str(path)], capture_output=True, text=True)
    return dumped.stdout.split()[2] if dumped.stdout else dumped.stderr


def fetch_all_syntaxes(stage, server, take, way):
    every = []
    for syntax in SYNTAXES:
        series = stage.series(5, 64, syntax)
        stage.of_uids.append(series)
        try:
            take(series)
        except Exception as why:  # a server need not take every syntax; what it takes is counted
            print(f"{way}: the server does not take {syntax} ({why})")
            continue
        every.append((syntax, series))
    for syntax, series in every:
        if done := fetched_whole(stage, server, series, f"{way}, {syntax}"):
            kept = syntax_of(sorted(done[1].iterdir())[0]) == syntax_of(series.files()[0])
            check(kept, f"{way}: {syntax} was converted")
    check(len(every) >= 6, f"{way}: only {len(every)} transfer syntaxes")
    print(f"{way}: equal voxels in {len(every)} transfer syntaxes")


def without_names(stage, server, series):
    query = {"query": {"patient_name": series.person.name.split('^')[0] + "*"}}
    shown = stage.fetch.call("find", server, query, "--names", show=True)
    text = json.dumps(shown.last, ensure_ascii=False)
    for planted in (series.person.name, series.person.id, series.person.study, series.person.series):
        check(planted in text, f"with --names {planted} is not shown: {shown}")
    hidden = stage.fetch.call("find", server, query)
    check(hidden.code == 0 and len(hidden.last["series"]) == 1, f"by name: {hidden}")
    none = stage.fetch.call("find", server, {"query": {"patient_id": "NOBODY"}})
    check(none.code == 0 and none.last["series"] == [], f"nobody: {none}")
    wrong = stage.fetch.call("get", server, {**query, "index": 7}, "--out", stage.fetch.out())
    check(wrong.code == 2, f"an index too high: {wrong}")
    stale = stage.fetch.call("get", server, {**query, "index": 0, "check": "00000000"}, "--out", stage.fetch.out())
    check(stale.code == 3 and stale.reason == "changed", f"a stale index: {stale}")
    for request in ({"query": {}}, {"query": {"patient": "x"}}, {"query": {"patient_id": "a\\b"}}, [1]):
        bad = stage.fetch.call("find", server, request)
        check(bad.code == 2, f"{request}: {bad}")


def attached(stage, server, series, listens=()):
    """As the window does it: cancel, the end of standard input, and what is left."""
    fetch = stage.fetch
    request = {"query": {"patient_id": series.person.id}, "index": 0}
    process = fetch.start("get", server, request, "--attached")
    lines = read_until(process, lambda line: line.get("event") == "done" or "error" in line)
    if not check(lines and lines[-1].get("event") == "done", f"attached: {lines[-1:]} {process.poll()}"):
        process.kill()
        return
    folder = pathlib.Path(lines[-1]["folder"])
    check(folder.parent == fetch.temporary and stat.S_IMODE(folder.stat().st_mode) == 0o700, f"{folder}")
    check(len(list(folder.iterdir())) == series.count, "attached: not all images")
    check(len(Fetch.family(process)) == 1, "a process stays at the network")
    out, err = process.communicate()  # ends standard input
    fetch.said += [json.dumps(lines), out, err]
    check(process.returncode == 0 and not folder.exists(), f"attached: {process.returncode}, left {fetch.left()}")


def slowly(stage, server_of, port, series, way, listens=()):
    """Through a slow line: who listens meanwhile, and cancelling, three ways."""
    fetch = stage.fetch
    request = {"query": {"patient_id": series.person.id}, "index": 0}
    for how in ("SIGTERM", "end of input", "SIGKILL"):
        proxy = Proxy(port, rate=2_000_000)
        process = fetch.start("get", server_of(proxy.port), request, "--attached")
        lines = read_until(process, lambda line: line.get("images", 0) >= 2 or "error" in line)
        if not check(lines and lines[-1].get("images", 0) >= 2, f"{way}, {how}: {lines[-1:]}"):
            process.kill()
            continue
        check(all(line["event"] == "progress" and line["bytes"] > 0 for line in lines), f"{way}: progress: {lines}")
        check(sorted(fetch.listening(process)) == sorted(listens), f"{way}: listens on {fetch.listening(process)}")
        family = Fetch.family(process)
        for one in family:
            limits = pathlib.Path(f"/proc/{one}/limits").read_text()
            core = next(line for line in limits.splitlines() if line.startswith("Max core"))
            check(core.split()[4] == "0", f"{way}: core dumps: {core}")
        fetch.said += fetch.listing(process)
        if how == "SIGTERM":
            seconds, out, err = interrupt(process)
        elif how == "end of input":
            begun = time.monotonic()
            out, err = process.communicate()
            seconds = time.monotonic() - begun
        else:
            process.kill()
            process.communicate()
            check(gone(family), f"{way}: an orphan")
            check(len(fetch.left()) == 1, f"{way}: killed, {fetch.left()}")
            fetch.call("echo", ["--dimse", "127.0.0.1:1", "--called", "NOBODY"])
            check(fetch.left() == [], f"{way}: not swept: {fetch.left()}")
            proxy.close()
            continue
        fetch.said += [out, err]
        print(f"{way}: cancelled by {how} in {seconds:.2f} s")
        check(process.returncode == 130 and fetch.left() == [], f"{way}, {how}: {process.returncode} {fetch.left()}")
        check('"cancelled"' in out, f"{way}, {how}: {out[-300:]}")
        proxy.close()


def gone(processes, seconds=30):
    """Whether they end by themselves."""
    until = time.monotonic() + seconds
    while any(pathlib.Path(f"/proc/{one}/comm").exists() for one in processes):
        if time.monotonic() > until:
            return False
        time.sleep(0.02)
    return True


def resumed(stage, server_of, port, series, way, cuts):
    """Connections that are cut in the midst of an image, and then a server that is killed."""
    proxy = Proxy(port, cuts=cuts)
    # the pauses between two attempts are parts of the patience
    done = fetched_whole(stage, server_of(proxy.port), series, f"{way}, cut", "--patience", "6")
    size = sum(path.stat().st_size for path in series.files())
    if done:
        check(not proxy.cuts, f"{way}: no cut was made")
        carried = sum(proxy.carried)
        print(f"{way}: {len(proxy.carried)} connections carried {carried / size:.2f} of the series")
        check(carried < 1.7 * size, f"{way}: what had come was fetched again")
    proxy.close()


def restarted(stage, server_of, server, port, series, way):
    proxy = Proxy(port, rate=3_000_000)
    out = stage.fetch.out()
    process = stage.fetch.start("get", server_of(proxy.port),
                                {"query": {"patient_id": series.person.id}, "index": 0}, "--out", out)
    lines = read_until(process, lambda line: line.get("images", 0) >= 2 or "error" in line)
    server.kill()
    server.start()
    said, err = process.communicate()
    lines += [json.loads(line) for line in said.splitlines()]
    check(process.returncode == 0 and lines[-1]["images"] == series.count, f"{way}, killed: {lines[-1:]}")
    check(stage.voxels(out) == stage.voxels_of(series), f"{way}, killed: the voxels differ")
    proxy.close()


def timed(stage, server, series, way, other, beside, *options):
    """120 slices, in turns with another program; the median times of five runs. Nothing depends on them."""
    def ours():
        out = stage.fetch.out()
        got = stage.fetch.call("get", server, {"query": {"patient_id": series.person.id}, "index": 0}, "--out", out,
                               *options)
        check(got.code == 0 and got.last["images"] == series.count, f"{way}: {got}")
        shutil.rmtree(out, ignore_errors=True)
        return got.seconds
    turns = [(ours(), beside()) for _ in range(5)]
    mine, theirs = (statistics.median(times) for times in zip(*turns))
    print(f"{way}: {series.count} slices of {series.side}x{series.side} in {mine:.2f} s, {mine / theirs:.2f} times "
          f"the {theirs:.2f} s of {other}", flush=True)


def curl(server, stage, series):
    """The time of curl for the same request, into one file."""
    def call():
        out = stage.work / "theirs.multipart"
        begun = time.monotonic()
        subprocess.run(["curl", "--silent", "--fail", "--output", str(out), "--header",
                        'Accept: multipart/related; type="application/dicom"; transfer-syntax=*',
                        f"{server.url()}/studies/{series.study}/series/{series.series}"], check=True)
        seconds = time.monotonic() - begun
        check(out.stat().st_size > sum(path.stat().st_size for path in series.files()), "curl")
        return seconds
    return call


def dicomweb(stage):
    server = stage.orthanc()
    at = lambda port: ["--dicomweb", f"http://127.0.0.1:{port}/dicom-web"]
    orthanc = at(server.http)
    check(stage.fetch.call("echo", orthanc).last == {"answers": True}, "echo")
    fetch_all_syntaxes(stage, orthanc, lambda series: server.take(*series.files()), "DICOMweb")
    large = stage.series(120, 512)
    stage.of_uids.append(large)
    server.take(*large.files())
    without_names(stage, orthanc, large)
    attached(stage, orthanc, large)
    slowly(stage, at, server.http, large, "DICOMweb")
    # find has a connection, and get one for each attempt
    resumed(stage, at, server.http, large, "DICOMweb", [None, 20_000_000, 5_000_000])
    timed(stage, orthanc, large, "DICOMweb", "curl", curl(server, stage, large))
    restarted(stage, at, server, server.http, stage_small(stage, server), "DICOMweb")
    for url, reason in ((f"http://nowhere.invalid:{server.http}/dicom-web", "host"),
                        (f"http://127.0.0.1:{free_port()}/dicom-web", "port"),
                        (f"http://127.0.0.1:{server.http}/elsewhere", "path"),
                        (f"http://127.0.0.1:{server.dimse}/dicom-web", None)):
        answer = stage.fetch.call("echo", ["--dicomweb", url, "--patience", "5"])
        check(answer.code in (3, 4) and reason in (None, answer.reason), f"{url}: {answer}")
    stage.nobody()


def stage_small(stage, server):
    series = stage.series(40, 256)
    stage.of_uids.append(series)
    server.take(*series.files())
    return series


def dimse_server(server, port=None, *more):
    return ["--dimse", f"127.0.0.1:{port or server.dimse}", "--called", server.called, *more]


def beside(program, server, stage, series, *more):
    """The time of DCMTK's own program for the same series."""
    def call():
        out = stage.work / "theirs"
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir()
        begun = time.monotonic()
        done = subprocess.run([program, "-S", "-aet", "PALPATE", "-aec", server.called, *more, "-od", str(out),
                               "127.0.0.1", str(server.dimse), "-k", "QueryRetrieveLevel=SERIES",
                               "-k", f"StudyInstanceUID={series.study}", "-k", f"SeriesInstanceUID={series.series}"],
                              capture_output=True, text=True, env={**os.environ, "TCP_NODELAY": "1"})
        seconds = time.monotonic() - begun
        check(done.returncode == 0 and len(list(out.iterdir())) == series.count, f"{program}: {done.stderr}")
        return seconds
    return call


def dimse(stage):
    server = stage.orthanc()
    at = lambda port: dimse_server(server, port)
    orthanc = at(None)
    check(stage.fetch.call("echo", orthanc).last == {"answers": True}, "echo")
    fetch_all_syntaxes(stage, orthanc, lambda series: server.take(*series.files()), "C-GET")
    large = stage.series(120, 512)
    stage.of_uids.append(large)
    server.take(*large.files())
    without_names(stage, orthanc, large)
    attached(stage, orthanc, large)
    slowly(stage, at, server.dimse, large, "C-GET")
    # find has one connection, get one for each attempt
    resumed(stage, at, server.dimse, large, "C-GET", [None, 20_000_000, 5_000_000])
    timed(stage, orthanc, large, "C-GET", "getscu", beside("getscu", server, stage, large))
    restarted(stage, at, server, server.dimse, stage_small(stage, server), "C-GET")

    other = stage.qrscp()
    check(stage.fetch.call("echo", dimse_server(other)).last == {"answers": True}, "dcmqrscp: echo")
    plain = stage.series(6, 64, "big-endian")
    stage.of_uids.append(plain)
    other.take(plain.folder)
    fetched_whole(stage, dimse_server(other), plain, "dcmqrscp")

    # one file of several frames
    for modality, date in (("CT", "20240305"), ("MR", "20160309")):
        person, path = stage.person(), stage.work / f"enhanced-{modality}.dcm"
        person.date = date
        query = {"patient_id": person.id} if modality == "CT" else {"study_date": date}
        frames = [stage.head.crop(k, 128) for k in range(100, 108)]
        path.write_bytes(enhanced(person, uid(), uid(), uid(), 128, frames, modality))
        server.take(path)
        out = stage.fetch.out()
        got = stage.fetch.call("get", orthanc, {"query": query, "index": 0}, "--out", out)
        if check(got.code == 0 and got.last["images"] == 1, f"enhanced {modality}: {got}"):
            check(stage.voxels(out) == stage.voxels(path), f"enhanced {modality}: the voxels differ")

    # each misconfiguration has its sentence
    silent = stage.orthanc("strict", modalities={"palpate": {
        "AET": "PALPATE", "Host": "127.0.0.1", "Port": 4242, "AllowEcho": True, "AllowFind": False, "AllowGet": False,
        "AllowMove": False, "AllowStore": False}})
    for options, reason in (
            (["--dimse", f"nowhere.invalid:{server.dimse}", "--called", "ORTHANC"], "host"),
            (["--dimse", f"127.0.0.1:{free_port()}", "--called", "ORTHANC"], "port"),
            (dimse_server(server)[:2] + ["--called", "WRONG"], "called-ae"),
            ([*orthanc, "--calling", "STRANGER"], "permission"),
            # dcmqrscp says of a stranger that it does not know its own title
            ([*dimse_server(other), "--calling", "STRANGER"], "called-ae"),
            (dimse_server(silent), "permission"),
            (["--dimse", f"127.0.0.1:{server.http}", "--called", "ORTHANC"], "closed")):
        answer = stage.fetch.call("echo", [*options, "--patience", "5"])
        check(answer.code in (3, 4) and answer.reason == reason, f"{options}: not {reason}: {answer}")
        print(f"echo, {reason}: {answer.err.strip()}")
    stage.nobody()


def move(stage):
    port = free_port()
    peers = {"palpate": {"AET": "PALPATE", "Host": "127.0.0.1", "Port": port, "AllowEcho": True, "AllowFind": True,
                         "AllowGet": True, "AllowMove": True, "AllowStore": True}}
    server = stage.orthanc(modalities=peers)
    at = lambda to: dimse_server(server, to)
    options = ["--move", f"127.0.0.1:{port}"]
    large = stage.series(120, 512)
    small = stage.series(6, 64, "jpeg-lossless")
    stage.of_uids += [large, small]
    server.take(*large.files(), *small.files())
    check(stage.fetch.call("echo", at(None)).last == {"answers": True}, "echo")
    fetched_whole(stage, at(None), small, "C-MOVE", *options)
    fetched_whole(stage, at(None), large, "C-MOVE", *options)
    timed(stage, at(None), large, "C-MOVE", "movescu",
          beside("movescu", server, stage, large, "-aem", "PALPATE", "--port", str(port), "+xa"), *options)

    # who else comes meanwhile
    relayed = stage.orthanc("relayed", modalities={"palpate": {**peers["palpate"], "Port": (relay := Proxy(port, rate=None)).port}})
    relayed.take(*large.files())
    process = stage.fetch.start("get", dimse_server(relayed), {"query": {"patient_id": large.person.id}, "index": 0},
                                "--attached", *options)
    until = time.monotonic() + 60
    while not stage.fetch.listening(process) and time.monotonic() < until and process.poll() is None:
        time.sleep(0.01)
    check(stage.fetch.listening(process) in ([f"127.0.0.1:{port}"], []), f"listens: {stage.fetch.listening(process)}")
    lines = read_until(process, lambda line: line.get("event") == "done" or "error" in line)
    check(lines[-1:] and lines[-1].get("images") == large.count, f"relayed: {lines[-1:]}")
    check(stage.fetch.listening(process) == [], "it listens after the transfer")
    process.communicate()
    relay.close()

    # a server that never sends: there is time to knock
    from bad_servers import BadDimse
    bad = BadDimse("move-waits")
    process = stage.fetch.start("get", ["--dimse", f"127.0.0.1:{bad.port}", "--called", "BAD"],
                                {"query": {"patient_id": "1"}, "index": 0}, "--attached", *options)
    until = time.monotonic() + 60
    while not stage.fetch.listening(process) and time.monotonic() < until and process.poll() is None:
        time.sleep(0.01)
    check(stage.fetch.listening(process) == [f"127.0.0.1:{port}"], f"listens: {stage.fetch.listening(process)}")
    one = small.files()[0]
    for words, aet, aec in (("another title", "STRANGER", "PALPATE"), ("another called title", "BAD", "OTHER")):
        knock = subprocess.run(["storescu", "-xs", "-aet", aet, "-aec", aec, "127.0.0.1", str(port), str(one)],
                               capture_output=True, text=True)
        check("Rejected" in knock.stderr, f"{words}: {knock}")
    import socket
    with socket.socket() as knock:
        knock.bind(("127.0.0.2", 0))
        knock.connect(("127.0.0.1", port))
        knock.settimeout(10)
        try:
            check(knock.recv(1) == b"", "a second peer was heard")
        except ConnectionResetError:
            pass
    unasked = subprocess.run(["storescu", "-xs", "-aet", "BAD", "-aec", "PALPATE", "127.0.0.1", str(port), str(one)],
                             capture_output=True, text=True)
    seconds, out, err = interrupt(process)
    check(bad.cancelled, "no C-CANCEL came")
    check(process.returncode == 130 and stage.fetch.left() == [], f"cancelled: {process.returncode}")
    check('"images":1' not in out, f"an image that was not asked for was kept: {out} {unasked}")
    print(f"C-MOVE: cancelled in {seconds:.2f} s")

    nowhere = stage.fetch.call("get", [*at(None), "--calling", "PALPATE"],
                               {"query": {"patient_id": small.person.id}, "index": 0}, "--out", stage.fetch.out(),
                               "--move", "198.51.100.7:4242")
    check(nowhere.code == 4 and nowhere.reason == "listen", f"another's address: {nowhere}")
    named = stage.fetch.call("get", at(None), {"query": {"patient_id": small.person.id}, "index": 0}, "--out",
                             stage.fetch.out(), "--move", f"localhost:{port}")
    check(named.code == 2, f"a name to listen on: {named}")
    stage.nobody()


def tls(stage):
    authority, other = Authority(stage.work / "authority"), Authority(stage.work / "other", "Another authority")
    good = authority.sign("server", "localhost")
    mine, strange = authority.sign("palpate", "palpate"), other.sign("strange", "palpate")
    series = stage.series(6, 64)
    stage.of_uids.append(series)
    trust = ["--authority", authority.certificate]
    own = ["--certificate", mine[0], "--key", mine[1]]
    port = free_port()
    peers = {"palpate": {"AET": "PALPATE", "Host": "127.0.0.1", "Port": port, "AllowEcho": True, "AllowFind": True,
                         "AllowGet": True, "AllowMove": True, "AllowStore": True, "UseDicomTls": True}}

    def server(name, pair, **options):
        return stage.orthanc(name, https=pair, tls=pair, authority=authority.certificate, modalities=peers, **options)

    def ways(one):
        return (["--dicomweb", one.url("localhost")],
                ["--dimse", f"localhost:{one.dimse}", "--called", "ORTHANC", "--tls"])

    def echoes(one, expected, *options):
        for way in ways(one):
            answer = stage.fetch.call("echo", [*map(str, way), *map(str, options), "--patience", "10"])
            said = "answers" if answer.code == 0 else answer.reason
            check(said == expected, f"{way[0]}: not {expected}: {answer}")
            print(f"{way[0]}, {expected}: {answer.err.strip()}")

    plain = server("plain", good)
    plain.take(*series.files())
    echoes(plain, "answers", *trust)
    echoes(plain, "certificate-authority")
    for way in ways(plain):
        fetched_whole(stage, [*way, *map(str, trust)], series, f"TLS, {way[0]}")
    echoes(server("expired", authority.sign("expired", "localhost", expired=True)), "certificate-expired", *trust)
    echoes(server("elsewhere", authority.sign("elsewhere", "pacs.example.org")), "certificate-host", *trust)
    mutual = server("mutual", good, mutual=True)
    echoes(mutual, "certificate-own", *trust)
    echoes(mutual, "answers", *trust, *own)
    echoes(mutual, "certificate-own", *trust, "--certificate", strange[0], "--key", strange[1])
    # its last word, where that is lost with every connection that carried a request, is asked for again
    alert, tries = 24, 20  # bytes of TLS 1.3; more than there are

    def refusal(cuts):
        proxy = Proxy(mutual.web, cuts=cuts)
        way = ["--dicomweb", f"https://localhost:{proxy.port}/dicom-web", *map(str, trust)]
        return stage.fetch.call("echo", way).reason, proxy.carried

    reason, (whole,) = refusal([])
    check(reason == "certificate-own", f"heard: {reason}")
    reason, carried = refusal([whole - alert] * tries)
    check(reason == "lost" and 1 < len(carried) < tries, f"never heard: {reason}, {carried}")
    reason, carried = refusal([whole - alert] * (len(carried) - 1))
    check(reason == "certificate-own" and carried[-1] == whole, f"heard at the last: {reason}, {carried}")
    for request, reason in ((None, "certificate-file"),):
        bad = stage.fetch.call("echo", [*ways(plain)[1], "--authority", str(series.files()[0])], request)
        check(bad.reason == reason, f"no certificate: {bad}")
    # TLS where there is none, and none where there is
    unsafe = stage.orthanc("unsafe")
    for options in ((["--dicomweb", f"https://localhost:{unsafe.http}/dicom-web"]),
                    (["--dimse", f"localhost:{unsafe.dimse}", "--called", "ORTHANC", "--tls"])):
        answer = stage.fetch.call("echo", [*options, "--patience", "5"])
        check(answer.code == 3 and answer.reason == "tls", f"no TLS there: {answer}")
    answer = stage.fetch.call("echo", ["--dimse", f"localhost:{plain.dimse}", "--called", "ORTHANC", "--patience", "5"])
    check(answer.code in (3, 4) and answer.reason in ("closed", "silent"), f"TLS there: {answer}")
    # C-MOVE, where the server connects with TLS too
    mutual.take(*series.files())
    fetched_whole(stage, [*map(str, ways(mutual)[1]), *map(str, trust + own)], series, "TLS, C-MOVE", "--move",
                  f"127.0.0.1:{port}")

    # logins
    users = stage.orthanc("users", https=good, users={"palpate": "Open Sesame: 1%"})
    url = ["--dicomweb", users.url("localhost"), *map(str, trust)]
    for options, request, expected in (
            ([], None, "login"), (["--login", "basic"], {"login": {"user": "palpate", "password": "wrong"}}, "login"),
            (["--login", "basic"], {"login": {"user": "palpate", "password": "Open Sesame: 1%"}}, "answers"),
            (["--login", "bearer"], {"login": {"token": "abc"}}, "login")):
        answer = stage.fetch.call("echo", [*url, *options], request)
        check(("answers" if answer.code == 0 else answer.reason) == expected, f"{options} {request}: {answer}")
    readable = stage.fetch.call("echo", ["--dicomweb", "http://pacs.example.org/dicom-web", "--login", "basic"],
                                {"login": {"user": "a", "password": "b"}})
    check(readable.code == 3 and readable.reason == "login", f"a login without https: {readable}")
    said = "\n".join(stage.fetch.said)
    check("Sesame" not in said, "a password was said")
    stage.nobody()


def keyring(stage):
    """gnome-keyring on a bus of its own: a login goes in, is used, and goes."""
    secret, token = "Open Sesame: 1%", "Sesame.token"
    desktop = Keyring(stage.unpacked, stage.work / "home")
    stage.fetch.environment.update(desktop.environment)
    server = stage.orthanc(users={"palpate": secret})
    url = ["--dicomweb", server.url()]
    mine, nobody = [*url, "--login", "keyring", "--user", "palpate"], [*url, "--login", "keyring", "--user", "nobody"]
    bearer = [*url, "--login", "keyring"]

    def expect(expected, command, options, request=None, words=""):
        answer = stage.fetch.call(command, options, request)
        said = "done" if answer.code == 0 else answer.reason
        check(said == expected and words in answer.err, f"{command} {options[2:]} {words}: not {expected}: {answer}")

    def plain():
        """The files in which a secret stands: the keyring's are encrypted, and no other has one."""
        kept = desktop.files()
        check(any(path.suffix == ".keyring" for path in kept), f"nothing is kept: {kept}")
        kept += [path for path in stage.fetch.temporary.rglob("*") if path.is_file()]
        return [path for path in kept if b"Sesame" in path.read_bytes()]

    missing, refused = "no entry", "refuses the login"
    expect("login", "echo", mine, words=missing)
    expect("login", "forget", mine, words=missing)
    expect("done", "remember", mine, {"login": {"password": "wrong"}})
    expect("login", "echo", mine, words=refused)
    expect("done", "remember", mine, {"login": {"password": secret}})
    expect("done", "echo", mine)
    expect("done", "find", mine, {"query": {"patient_id": "X"}})
    expect("login", "echo", nobody, words=missing)
    # a token has no user, and is not a user's password
    expect("login", "echo", bearer, words=missing)
    expect("login", "forget", bearer, words=missing)
    expect("done", "remember", bearer, {"login": {"token": token}})
    expect("login", "echo", bearer, words=refused)
    check(plain() == [], f"a secret stands in {plain()}")
    expect("done", "forget", bearer)
    expect("login", "echo", bearer, words=missing)
    expect("done", "echo", mine)
    # an entry that was made by hand is one, and is replaced
    by_hand = ["application", "palpate", "server", f"127.0.0.1:{server.web}", "user", "palpate"]
    tool = {"text": True, "capture_output": True, "env": stage.fetch.environment}
    expect("done", "forget", mine)
    subprocess.run(["secret-tool", "store", "--label", "Test", *by_hand], input=secret, check=True, **tool)
    expect("done", "echo", mine)
    expect("done", "remember", mine, {"login": {"password": "wrong"}})
    expect("login", "echo", mine, words=refused)
    expect("done", "forget", mine)
    left = subprocess.run(["secret-tool", "search", "--all", "application", "palpate"], **tool)
    check(left.stdout == "", f"the keyring still has {left.stdout}")
    check(plain() == [], f"a secret stands in {plain()}")

    for options, request in ((mine, {"login": {"token": token}}), (bearer, {"login": {"password": secret}}), (mine, {}),
                             (["--dicomweb", "nowhere"], {"login": {"token": token}}),
                             (["--dimse", "127.0.0.1:104", "--called", "A"], {"login": {"token": token}}),
                             ([*url, "--login", "basic"], {"login": {"user": "a", "password": secret}})):
        expect("usage", "remember", options, request)
    # one that is locked, where nobody is asked to unlock it
    expect("done", "remember", mine, {"login": {"password": secret}})
    desktop.lock()
    for command, request in (("echo", None), ("forget", None), ("remember", {"login": {"password": secret}})):
        expect("keyring", command, mine, request)
    stage.fetch.environment["DBUS_SESSION_BUS_ADDRESS"] = f"unix:path={stage.work}/no-bus"
    for command, request in (("echo", None), ("forget", None), ("remember", {"login": {"password": secret}})):
        expect("keyring", command, mine, request)
    check("Sesame" not in "\n".join(stage.fetch.said), "a secret was said")


def hostile(stage):
    from bad_servers import SERIES, STUDY, BadDimse, BadWeb
    person = stage.person()
    pixels = bytes(64 * 64 * 2)
    image = dicom(person, STUDY, SERIES, "1.2.3.4.70", 0, 64, 64, pixels)
    strange = dicom(person, "1.2.3.4.51", "1.2.3.4.61", uid(), 0, 64, 64, pixels)

    def data_set(data):
        for name, content in (("strange" if data is strange else "image", data),):
            path = stage.work / f"{name}.dcm"
            path.write_bytes(content)
            subprocess.run(["dcmconv", "+ti", "-F", str(path), str(path) + ".raw"], check=True, capture_output=True)
            return pathlib.Path(str(path) + ".raw").read_bytes()

    raw, raw_strange = data_set(image), data_set(strange)
    before = sorted(path for path in stage.work.rglob("*escape*"))
    query = {"query": {"patient_id": "1"}}
    times = []
    waits = lambda expected: any(word in expected for word in ("silent", "slow", "lost"))

    def ask(server, command, expected, name):
        request = None if command == "echo" else query if command == "find" else {**query, "index": 0}
        more = ["--out", stage.fetch.out()] if command == "get" else []
        answer = stage.fetch.call(command, server, request, *more, "--patience", "2" if waits(expected) else "20")
        said = "done" if answer.code == 0 else answer.reason
        check(said in expected.split("|"), f"{name}: not {expected}: {answer}")
        check(answer.err.count("\n") == (0 if answer.code == 0 else 1), f"{name}: {answer.err!r}")
        if command == "get" and answer.code != 0:
            check(not more[1].exists(), f"{name}: something was left")
        times.append(answer.seconds)
        print(f"{name}: {said} in {answer.seconds:.1f} s. {answer.err.strip()}", flush=True)
        return answer

    def meet_web(how, command, expected):
        bad = BadWeb(how, image, strange)
        answer = ask(["--dicomweb", bad.url()], command, expected, f"DICOMweb, {how}")
        if how.endswith("-path"):
            check(answer.last["series"] == [] and answer.last["left_out"] == 1, f"{how}: {answer}")
            check(not any("escape" in path for path, _ in bad.asked), f"{how}: asked for {bad.asked}")
        if how == "stranger-too":
            check(answer.last["images"] == 1 and answer.last["not_kept"] == 1 and answer.last["warnings"], f"{answer}")
        if how == "good":
            accepted = [headers.get("Accept") for path, headers in bad.asked if path.endswith(SERIES)]
            check(accepted and "transfer-syntax=*" in accepted[0], f"asked with {accepted}")
        bad.close()

    def meet_dimse(how, command, expected):
        bad = BadDimse(how, raw, raw_strange)
        answer = ask(["--dimse", f"127.0.0.1:{bad.port}", "--called", "BAD"], command, expected, f"DIMSE, {how}")
        if how.endswith("-path"):
            check(answer.last["series"] == [] and answer.last["left_out"] == 1, f"{how}: {answer}")
        if how == "stranger-too":
            check(answer.last["images"] == 1 and answer.last["not_kept"] == 1, f"{answer}")
        bad.close()

    of_web = (
        ("good", "get", "done"), ("bare", "get", "done"), ("repeated-headers", "get", "done"),
        ("unquoted", "get", "done"), ("lying-part-length", "get", "done"), ("lying-length", "get", "lost|done"),
        ("short-length", "get", "lost"), ("cut", "get", "lost"), ("dies", "get", "lost"),
        ("bare-dies", "get", "lost"), ("list-dies", "find", "lost"),
        ("no-boundary", "get", "answer"), ("header-without-end", "get", "answer"),
        ("junk-parts", "get", "answer"), ("text", "get", "answer"), ("stranger", "get", "other-images"),
        ("stranger-too", "get", "done"), ("silent-midway", "get", "silent"),
        ("study-path", "find", "done"), ("series-path", "find", "done"), ("many", "find", "too-many"),
        ("deep", "find", "answer"), ("no-json", "find", "answer"), ("html", "find", "path"),
        ("packed", "find", "answer"), ("endless", "find", "too-many"), ("garbage", "find", "answer|lost"),
        ("silent", "echo", "silent"), ("slow", "echo", "slow"), ("redirect-elsewhere", "echo", "redirect"),
        ("redirect-circle", "echo", "redirect"), ("401", "echo", "login"), ("403", "echo", "permission"),
        ("404", "echo", "path"), ("500", "echo", "answer"))
    of_dimse = (
        ("good", "get", "done"), ("stranger", "get", "other-images"), ("stranger-too", "get", "done"),
        ("paths", "get", "done"), ("junk", "get", "answer"), ("dies-midway", "get", "lost"),
        ("silent-midway", "get", "silent"), ("lying-lengths", "get", "lost|answer|silent"),
        ("study-path", "find", "done"), ("series-path", "find", "done"), ("many", "find", "too-many"),
        ("deep", "find", "answer|lost|died|memory"), ("long-pdata", "find", "slow|silent|lost"),
        ("endless-command", "find", "answer"), ("endless-match", "find", "answer"),
        ("wrong-message", "find", "answer"), ("silent-after", "find", "silent"),
        ("silent", "echo", "silent"), ("slow", "echo", "silent|slow|closed"),
        ("garbage", "echo", "closed|lost|silent"), ("closes", "echo", "closed"), ("rejects", "echo", "rejected"),
        ("rejects-caller", "echo", "calling-ae"),
        ("long-association", "echo", "silent|closed|lost|slow"))
    # those that wait for a server do so beside the others
    cases = [(meet_web, *case) for case in of_web] + [(meet_dimse, *case) for case in of_dimse]
    with concurrent.futures.ThreadPoolExecutor(6) as beside:
        waiting = [beside.submit(*case) for case in cases if waits(case[3])]
        for meet, *case in (case for case in cases if not waits(case[3])):
            meet(*case)
        for one in waiting:
            one.result()

    bad = BadDimse("waits-for-cancel", raw)
    process = stage.fetch.start("get", ["--dimse", f"127.0.0.1:{bad.port}", "--called", "BAD"], {**query, "index": 0},
                                "--attached")
    until = time.monotonic() + 60
    while bad.pending is None and time.monotonic() < until:
        time.sleep(0.01)
    seconds, out, err = interrupt(process)
    check(process.returncode == 130 and bad.cancelled, f"C-CANCEL: {process.returncode} {bad.cancelled} {out} {err}")
    print(f"C-CANCEL came, and the program ended in {seconds:.2f} s")
    bad.close()
    check(sorted(path for path in stage.work.rglob("*escape*")) == before, "something was written outside")
    check(stage.fetch.left() == [], f"left: {stage.fetch.left()}")
    print(f"the slowest answer took {max(times):.1f} s")
    stage.nobody()


SECTIONS = {"dicomweb": dicomweb, "dimse": dimse, "move": move, "tls": tls, "keyring": keyring, "hostile": hostile}


def main():
    if "--in-own-network" not in sys.argv:
        work = sys.argv[4]
        missing = missing_programs()
        if missing:
            skip(f"there is no {', '.join(missing)} here; packaging/dependencies names their packages.")
        if found(sys.argv[3]) is None:
            skip(f"Orthanc is neither installed nor in {sys.argv[3]}; packaging/test fetches it.")
        if subprocess.run(["unshare", "-Urn", "true"], capture_output=True).returncode != 0:
            skip("this machine permits no network of a test's own (unshare -Urn).")
        bus = ["dbus-run-session", "--"] if sys.argv[5] == "keyring" else []
        if bus and (missing := Keyring.missing(sys.argv[3])):
            skip(f"there is no {', '.join(missing)} here; packaging/test fetches them.")
        pathlib.Path(work).mkdir(parents=True, exist_ok=True)
        os.execvp("unshare", ["unshare", "-Urn", *bus, sys.executable, *sys.argv, "--in-own-network"])
    subprocess.run(["ip", "link", "set", "lo", "up"], check=True)
    sys.argv.remove("--in-own-network")
    stage = Stage(sys.argv[1:6])
    try:
        SECTIONS[sys.argv[5]](stage)
    finally:
        stage.stop()
    sys.exit(outcome())


if __name__ == "__main__":
    main()

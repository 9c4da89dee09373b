#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads and judges an MCAP file by the specification (mcap.dev/spec) alone; shares nothing with
what writes one. Uncompressed chunks only. read(path) raises Wrong where the file breaks the rules,
else returns its parts."""
import json
import struct
import sys
import zlib

MAGIC = b"\x89MCAP0\r\n"
NAMES = {1: "Header", 2: "Footer", 3: "Schema", 4: "Channel", 5: "Message", 6: "Chunk",
         7: "MessageIndex", 8: "ChunkIndex", 9: "Attachment", 10: "AttachmentIndex",
         11: "Statistics", 12: "Metadata", 13: "MetadataIndex", 14: "SummaryOffset", 15: "DataEnd"}
IN_DATA = {3, 4, 5, 6, 7, 9, 12, 15}
IN_CHUNK = {3, 4, 5}
IN_SUMMARY = {3, 4, 8, 10, 11, 13}


class Wrong(Exception):
    pass


def check(holds, sentence):
    if not holds:
        raise Wrong(sentence)


class Fields:
    """What is in a record, taken from the front."""

    def __init__(self, content):
        self.content, self.at = content, 0

    def bytes(self, count):
        check(self.at + count <= len(self.content), "a record is shorter than its fields")
        self.at += count
        return self.content[self.at - count:self.at]

    def number(self, kind):
        return struct.unpack("<" + kind, self.bytes(struct.calcsize("<" + kind)))[0]

    def u8(self):
        return self.number("B")

    def u16(self):
        return self.number("H")

    def u32(self):
        return self.number("I")

    def u64(self):
        return self.number("Q")

    def text(self):
        return self.bytes(self.u32()).decode("utf-8")

    def pairs(self, key, value):
        inner = Fields(self.bytes(self.u32()))
        found = []
        while inner.at < len(inner.content):
            found.append((getattr(inner, key)(), getattr(inner, value)()))
        return found

    def map(self, key, value):
        pairs = self.pairs(key, value)
        check(len(dict(pairs)) == len(pairs), "a map names a key twice")
        return dict(pairs)

    def rest(self):
        return self.bytes(len(self.content) - self.at)

    def end(self):
        check(self.at == len(self.content), "a record is longer than its fields")


def records(content, start, end):
    """(opcode, where the record begins, its content, where the next one begins)"""
    at = start
    while at < end:
        check(at + 9 <= end, "a record is cut off")
        op, length = struct.unpack_from("<BQ", content, at)
        check(at + 9 + length <= end, "a record reaches beyond its section")
        yield op, at, content[at + 9:at + 9 + length], at + 9 + length
        at += 9 + length


def schema_of(content):
    f = Fields(content)
    schema = {"id": f.u16(), "name": f.text(), "encoding": f.text(), "data": f.bytes(f.u32())}
    f.end()
    check(schema["id"] != 0, "a schema has the number 0")
    check(schema["encoding"] == "jsonschema", "a schema is no jsonschema")
    check(json.loads(schema["data"])["type"] == "object", "a schema is of no object")
    return schema


def channel_of(content):
    f = Fields(content)
    channel = {"id": f.u16(), "schema": f.u16(), "topic": f.text(), "encoding": f.text(),
               "metadata": f.map("text", "text")}
    f.end()
    check(channel["encoding"] == "json", "a channel's messages are no JSON")
    return channel


def message_of(content):
    f = Fields(content)
    message = {"channel": f.u16(), "sequence": f.u32(), "log_time": f.u64(),
               "publish_time": f.u64()}
    message["json"] = json.loads(f.rest().decode("utf-8"))
    return message


def once(known, item):
    """Records of one number are all the same."""
    check(known.setdefault(item["id"], item) == item, "two records of one number differ")


def read(path):
    with open(path, "rb") as file:
        content = file.read()
    check(content[:8] == MAGIC and content[-8:] == MAGIC, "the file does not begin and end as MCAP")
    foot = len(content) - 8 - 29
    op, length = struct.unpack_from("<BQ", content, foot)
    check((op, length) == (2, 20), "there is no footer before the end")
    summary_start, offsets_start, summary_crc = struct.unpack_from("<QQI", content, foot + 9)
    check(0 < summary_start < offsets_start < foot, "the footer's places are out of order")
    check(zlib.crc32(content[summary_start:foot + 25]) == summary_crc, "the summary's CRC is wrong")

    # the data section, from front to back
    schemas, channels, messages, metadata = {}, {}, [], {}
    chunks, indexes, ended, last_chunk = [], {}, False, None
    first = True
    for op, at, body, after in records(content, 8, summary_start):
        if first:
            check(op == 1, "the first record is no header")
            f = Fields(body)
            header = {"profile": f.text(), "library": f.text()}
            f.end()
            first = False
            continue
        check(op in IN_DATA, "%s stands in the data section" % NAMES.get(op, op))
        check(not ended, "something stands between the end of the data and the summary")
        if op != 7:
            last_chunk = last_chunk if op == 6 else None
        if op == 15:
            f = Fields(body)
            check(f.u32() == zlib.crc32(content[:at]), "the data section's CRC is wrong")
            f.end()
            ended = True
        elif op == 12:
            f = Fields(body)
            name = f.text()
            check(name not in metadata, "two records of metadata have one name")
            metadata[name] = (at, after - at, f.map("text", "text"))
            f.end()
        elif op == 6:
            f = Fields(body)
            chunk = {"start": f.u64(), "end": f.u64(), "size": f.u64(), "crc": f.u32(),
                     "compression": f.text(), "at": at, "length": after - at}
            inner = f.bytes(f.u64())
            f.end()
            check(chunk["compression"] == "", "a chunk is compressed")
            check(chunk["size"] == len(inner), "a chunk's size is wrong")
            check(chunk["crc"] == zlib.crc32(inner), "a chunk's CRC is wrong")
            found = {}
            for inner_op, inner_at, inner_body, _ in records(inner, 0, len(inner)):
                check(inner_op in IN_CHUNK, "%s stands in a chunk" % NAMES.get(inner_op, inner_op))
                if inner_op == 3:
                    once(schemas, schema_of(inner_body))
                elif inner_op == 4:
                    channel = channel_of(inner_body)
                    check(channel["schema"] in schemas, "a channel comes before its schema")
                    once(channels, channel)
                else:
                    message = message_of(inner_body)
                    check(message["channel"] in channels, "a message comes before its channel")
                    found.setdefault(message["channel"], []).append(
                        (message["log_time"], inner_at))
                    messages.append(message)
            times = [time for entries in found.values() for time, _ in entries]
            check(times and (min(times), max(times)) == (chunk["start"], chunk["end"]),
                  "a chunk's times are wrong")
            chunk["found"], chunk["indexed"], chunk["after"] = found, {}, after
            chunks.append(chunk)
            last_chunk = chunk
        elif op == 7:
            check(last_chunk is not None, "an index of messages follows no chunk")
            f = Fields(body)
            channel, entries = f.u16(), f.pairs("u64", "u64")
            f.end()
            check(entries == last_chunk["found"].get(channel), "an index of messages is wrong")
            check(channel not in last_chunk["indexed"], "a chunk's channel is indexed twice")
            last_chunk["indexed"][channel] = at
            last_chunk["after"] = after
        else:
            raise Wrong("%s stands outside of the chunks" % NAMES[op])
    check(ended, "the data section has no end")
    for chunk in chunks:
        check(set(chunk["indexed"]) == set(chunk["found"]), "a chunk's channel has no index")

    # the summary: groups, and what they repeat
    groups, summary = [], {}
    for op, at, body, after in records(content, summary_start, offsets_start):
        check(op in IN_SUMMARY, "%s stands in the summary" % NAMES.get(op, op))
        if not groups or groups[-1][0] != op:
            check(op not in [group[0] for group in groups], "the summary is not grouped")
            groups.append([op, at, 0])
        groups[-1][2] += after - at
        summary.setdefault(op, []).append(body)
    offsets = []
    for op, at, body, after in records(content, offsets_start, foot):
        check(op == 14, "%s stands among the summary's offsets" % NAMES.get(op, op))
        f = Fields(body)
        offsets.append([f.u8(), f.u64(), f.u64()])
        f.end()
    check(offsets == groups, "the summary's offsets are wrong")
    check({s["id"]: s for s in map(schema_of, summary[3])} == schemas, "the schemas are not repeated")
    check({c["id"]: c for c in map(channel_of, summary[4])} == channels,
          "the channels are not repeated")

    indexed = []
    for body in summary.get(8, []):
        f = Fields(body)
        indexed.append({"start": f.u64(), "end": f.u64(), "at": f.u64(), "length": f.u64(),
                        "indexed": f.map("u16", "u64"), "indexes": f.u64(),
                        "compression": f.text(), "packed": f.u64(), "size": f.u64()})
        f.end()
    check(indexed == [{"start": c["start"], "end": c["end"], "at": c["at"], "length": c["length"],
                       "indexed": c["indexed"], "indexes": c["after"] - c["at"] - c["length"],
                       "compression": "", "packed": c["size"], "size": c["size"]}
                      for c in chunks], "the index of the chunks is wrong")
    places = {}
    for body in summary.get(13, []):
        f = Fields(body)
        at, length = f.u64(), f.u64()
        places[f.text()] = (at, length)
        f.end()
    check(places == {name: place[:2] for name, place in metadata.items()},
          "the index of the metadata is wrong")

    check(len(summary.get(11, [])) == 1, "there is not one record of statistics")
    f = Fields(summary[11][0])
    said = {"messages": f.u64(), "schemas": f.u16(), "channels": f.u32(), "attachments": f.u32(),
            "metadata": f.u32(), "chunks": f.u32(), "start": f.u64(), "end": f.u64(),
            "counts": f.map("u16", "u64")}
    f.end()
    counts = {}
    for message in messages:
        counts[message["channel"]] = counts.get(message["channel"], 0) + 1
    times = [message["log_time"] for message in messages] or [0]
    check(said == {"messages": len(messages), "schemas": len(schemas), "channels": len(channels),
                   "attachments": 0, "metadata": len(metadata), "chunks": len(chunks),
                   "start": min(times), "end": max(times), "counts": counts},
          "the statistics are wrong")
    topics = {channel["topic"]: [] for channel in channels.values()}
    for message in messages:
        of = topics[channels[message["channel"]]["topic"]]
        check(message["sequence"] == len(of), "messages are not numbered one after another")
        of.append((message["log_time"], message["json"]))
    return {"header": header, "topics": topics, "order": [m["log_time"] for m in messages],
            "metadata": {name: place[2] for name, place in metadata.items()},
            "schemas": {channels[c]["topic"]: json.loads(schemas[channels[c]["schema"]]["data"])
                        for c in channels},
            "chunks": len(chunks)}


def changes_missed(path, scratch):
    """Where a changed byte is not noticed, tried all over a file that is sound."""
    with open(path, "rb") as file:
        sound = file.read()
    missed = []
    for at in [i * (len(sound) - 1) // 150 for i in range(151)]:
        with open(scratch, "wb") as file:
            file.write(sound[:at] + bytes([sound[at] ^ 0x41]) + sound[at + 1:])
        try:
            read(scratch)
            missed.append(at)
        except (Wrong, ValueError, KeyError, struct.error):
            pass
    return missed


if __name__ == "__main__":
    try:
        found = read(sys.argv[1])
    except Wrong as wrong:
        sys.exit("%s: %s" % (sys.argv[1], wrong))
    print({topic: len(messages) for topic, messages in found["topics"].items()})

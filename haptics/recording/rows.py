# SPDX-License-Identifier: BSD-3-Clause
"""A Palpate recording with nothing but Python: steps(path) gives a dict a step, contacts(path) one a
contact, by the names and types that the recording itself tells; units(path) gives their units."""
import array
import json
import sqlite3
import zlib

TYPES = {"int64": "q", "uint64": "Q", "float64": "d", "uint32": "I", "float32": "f", "uint16": "H", "uint8": "B"}


def _opened(path):
    file = sqlite3.connect(path)
    meta = dict(file.execute("SELECT key, value FROM meta"))
    return file, json.loads(meta["step_layout"]), json.loads(meta["contact_layout"])


def _rows(packed, count, layout):
    # column by column: the lowest bytes of all values, then all the next, little endian
    planes, at, columns = zlib.decompress(packed) if count else b"", 0, []
    for _, kind, _ in layout:
        column = array.array(TYPES[kind])
        values = bytearray(column.itemsize * count)
        for k in range(column.itemsize):
            values[k::column.itemsize] = planes[at:at + count]
            at += count
        column.frombytes(values)
        columns.append(column)
    return [dict(zip([name for name, _, _ in layout], row)) for row in zip(*columns)]


def _blocks(path):
    file, of_steps, of_contacts = _opened(path)
    for first, count, packed, touching, packed_contacts in file.execute(
            "SELECT first, step.count, step.data, contact.count, contact.data "
            "FROM step LEFT JOIN contact USING (first) ORDER BY first"):
        yield (first, _rows(packed, count, of_steps),
               _rows(packed_contacts, touching or 0, of_contacts))


def steps(path):
    for first, rows, _ in _blocks(path):
        yield from ({"sequence": first + i, **row} for i, row in enumerate(rows))


def contacts(path):
    """With the sequence of the step that each belongs to."""
    for first, rows, touching in _blocks(path):
        of_step = iter(touching)
        for i, row in enumerate(rows):
            yield from ({"sequence": first + i, **next(of_step)} for _ in range(row["contacts"]))


def units(path):
    _, of_steps, of_contacts = _opened(path)
    return {name: unit for name, _, unit in of_steps + of_contacts}

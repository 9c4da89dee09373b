# SPDX-License-Identifier: BSD-3-Clause
"""A Palpate recording with nothing but Python: steps(path) gives a dict a step, contacts(path) one a
contact, by the names and types that the recording itself tells; units(path) gives their units. distances(path)
gives those to structures, and cuts(path) what a burr cut."""
import array
import itertools
import json
import math
import sqlite3
import zlib

TYPES = {"int64": "q", "uint64": "Q", "float64": "d", "uint32": "I", "float32": "f", "uint16": "H", "uint8": "B"}
ROUNDED = (4, 6, 8)  # the user_version of files with differences and rounded columns


def _opened(path):
    file = sqlite3.connect(path)
    meta = dict(file.execute("SELECT key, value FROM meta"))
    rounding = file.execute("PRAGMA user_version").fetchone()[0] in ROUNDED
    return file, rounding, json.loads(meta["step_layout"]), json.loads(meta["contact_layout"])


def _integers(planes, width, count):
    # the lowest bytes of all values, then all the next, little endian
    values = bytearray(8 * count)
    for k in range(width):
        values[k::8] = planes[k * count:(k + 1) * count]
    return array.array("Q", values)


def _column(data, at, count, kind, rounding):
    """Its values as unsigned integers, and where it ends."""
    if not rounding:
        size = array.array(TYPES[kind]).itemsize
        return _integers(data[at:at + size * count], size, count), at + size * count
    order, width = data[at:at + 2]
    rest = at + 2 + 8 * order
    end = rest + width * (count - order)
    values = _integers(data[at + 2:rest], 8, order) + _integers(data[rest:end], width, count - order)
    values = ((value >> 1) ^ -(value & 1) for value in values)
    for _ in range(order):
        values = itertools.accumulate(values)
    return array.array("Q", (value % 2**64 for value in values)), end


def _typed(values, kind):
    column = array.array(TYPES[kind])
    whole, lowest = values.tobytes(), bytearray(column.itemsize * len(values))
    for k in range(column.itemsize):
        lowest[k::column.itemsize] = whole[k::8]
    column.frombytes(lowest)
    return column


def _rows(packed, count, layout, rounding):
    data, at, columns = zlib.decompress(packed) if count else b"", 0, {}
    for name, kind, _, *rounded in layout if count else []:
        values, at = _column(data, at, count, kind, rounding)
        columns[name] = _typed(values, "int64" if rounded else kind)
        for per_unit in rounded:
            numbers = [math.nan if n == -2**63 else n / per_unit for n in columns[name]]
            columns[name] = array.array(TYPES[kind], numbers)
    return [dict(zip(columns, row)) for row in zip(*columns.values())]


def _blocks(path):
    file, rounding, of_steps, of_contacts = _opened(path)
    for first, count, packed, touching, packed_contacts in file.execute(
            "SELECT first, step.count, step.data, contact.count, contact.data "
            "FROM step LEFT JOIN contact USING (first) ORDER BY first"):
        rows = _rows(packed, count, of_steps, rounding)
        places = [(i, k) for i, row in enumerate(rows) for k in range(row["contacts"])]
        if rounding:  # the first contacts of all steps, then the second ones, and so on
            places.sort(key=lambda place: place[1])
        yield first, rows, dict(zip(places, _rows(packed_contacts, touching or 0, of_contacts, rounding)))


def steps(path):
    for first, rows, _ in _blocks(path):
        yield from ({"sequence": first + i, **row} for i, row in enumerate(rows))


def contacts(path):
    """With the sequence of the step that each belongs to."""
    for first, _, touching in _blocks(path):
        yield from ({"sequence": first + i, **touching[i, k]} for i, k in sorted(touching))


def distances(path):
    """Of the steps in which structures were watched: tip_to_N and nearest_to_N [m] for each number N."""
    file, rounding, _, _ = _opened(path)
    if not file.execute("SELECT 1 FROM sqlite_schema WHERE name = 'nearness'").fetchone():
        return
    for first, count, structures, packed in file.execute(
            "SELECT first, count, structures, nearness.data FROM nearness JOIN step USING (first) ORDER BY first"):
        layout = [[f"{what}_to_{number}", "float32", "m", *([1e7] if rounding else [])]
                  for number in json.loads(structures) for what in ("tip", "nearest")]
        yield from ({"sequence": first + i, **row}
                    for i, row in enumerate(_rows(packed, count, layout, rounding)))


def cuts(path):
    """With the sequence of the step in which each began."""
    file, rounding, _, _ = _opened(path)
    layout = file.execute("SELECT value FROM meta WHERE key = 'cut_layout'").fetchone()
    for first, count, packed in file.execute("SELECT first, count, data FROM cut ORDER BY first") if layout else []:
        yield from ({"sequence": first + row.pop("step"), **row}
                    for row in _rows(packed, count, json.loads(layout[0]), rounding))


def units(path):
    _, _, of_steps, of_contacts = _opened(path)
    return {name: unit for name, _, unit, *_ in of_steps + of_contacts}

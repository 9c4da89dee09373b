# SPDX-License-Identifier: BSD-3-Clause
"""An NRRD read, and sampled as a solid, without any code of Palpate. For evaluate_trace.py."""

import gzip
import math
import os
import re
import zlib

import numpy as np

TYPES = {
    "int8": "signed char|int8|int8_t",
    "uint8": "uchar|unsigned char|uint8|uint8_t",
    "int16": "short|short int|signed short|signed short int|int16|int16_t",
    "uint16": "ushort|unsigned short|unsigned short int|uint16|uint16_t",
    "int32": "int|signed int|int32|int32_t",
    "uint32": "uint|unsigned int|uint32|uint32_t",
    "float32": "float",
    "float64": "double",
}

# signs that turn a space's axes into left, posterior, superior
SPACES = {
    "left-posterior-superior": (1, 1, 1),
    "lps": (1, 1, 1),
    "right-anterior-superior": (-1, -1, 1),
    "ras": (-1, -1, 1),
    "left-anterior-superior": (1, -1, 1),
    "las": (1, -1, 1),
}


class Volume:
    """Voxels indexed [k, j, i]; positions in metres, LPS."""

    def __init__(self, voxels, origin, axes):
        """axes: columns are the steps of i, j, k in metres."""
        self.voxels = voxels
        self.flat = voxels.reshape(-1)
        self.dims = np.array(voxels.shape[::-1])
        self.origin = np.asarray(origin, float)
        self.spacing = np.linalg.norm(axes, axis=0)
        self.direction = axes / self.spacing
        if np.abs(self.direction.T @ self.direction - np.eye(3)).max() > 1e-4:
            raise ValueError("the axes of the volume are not at right angles")
        if voxels.dtype.kind == "f":
            finite = np.isfinite(self.flat)
            self.background = float(self.flat[finite].min())
            if not finite.all():
                self.flat[~finite] = self.background
        else:
            self.background = float(self.flat.min())

    def index(self, points):
        return ((points - self.origin) @ self.direction) / self.spacing

    def corners(self, points):
        """Eight corner values (8, n), bit 0 of the corner along i, and the fractions (n, 3)."""
        index = np.clip(self.index(points), -2.0, self.dims + 1.0)
        low = np.floor(index)
        fraction = index - low
        low = low.astype(np.int64)
        ni, nj, _ = self.dims
        step = np.array([1, ni, ni * nj])
        within = np.all((low >= 0) & (low < self.dims - 1), axis=1)
        base = np.where(within, low @ step, 0)
        reach = np.where(self.dims > 1, step, 0)
        values = np.empty((8, len(points)))
        for c in range(8):
            values[c] = self.flat[base + (c & 1) * reach[0] + (c >> 1 & 1) * reach[1]
                                  + (c >> 2) * reach[2]]
        # at and beyond the rim, one voxel at a time: outside is background
        rim = np.flatnonzero(~within)
        for c in range(8):
            at = low[rim] + [c & 1, c >> 1 & 1, c >> 2]
            inside = np.all((at >= 0) & (at < self.dims), axis=1)
            values[c, rim] = self.background
            values[c, rim[inside]] = self.flat[at[inside] @ step]
        return values, fraction

    def values(self, points):
        """F (n) at points (n, 3): trilinear, background within one voxel outside the grid."""
        v, t = self.corners(points)
        x, y, z = t.T
        rows = v[0::2] + (v[1::2] - v[0::2]) * x
        slices = rows[0::2] + (rows[1::2] - rows[0::2]) * y
        return slices[0] + (slices[1] - slices[0]) * z

    def slopes(self, points):
        """|grad F| (n) of the trilinear cell, per metre."""
        v, t = self.corners(points)
        x, y, z = t.T
        v = v.reshape(2, 2, 2, -1)  # [k][j][i]
        along_i = v[:, :, 1] - v[:, :, 0]
        along_j = v[:, 1, :] - v[:, 0, :]
        along_k = v[1] - v[0]

        def mix(square, first, second):
            rows = square[:, 0] + (square[:, 1] - square[:, 0]) * first
            return rows[0] + (rows[1] - rows[0]) * second

        gradient = np.stack([mix(along_i, y, z), mix(along_j, x, z), mix(along_k, x, y)], axis=1)
        return np.linalg.norm(gradient / self.spacing, axis=1)

    def penetration(self, points, isovalue):
        """Metres; for points with F >= s."""
        excess = self.values(points) - isovalue
        slope = self.slopes(points)
        depth = np.divide(excess, slope, out=np.zeros_like(excess), where=slope > 0)
        for n in np.flatnonzero(slope == 0):
            depth[n] = self.nearest_legal(points[n], isovalue)[0]
        return depth

    def nearest_legal(self, p, isovalue):
        """Distance (m) to the nearest voxel with F < s, and where it is. Voxels beyond the grid
        are background, and legal."""
        index = self.index(p[None])[0]
        centre = np.rint(index).astype(np.int64)
        reach = 2
        while True:
            low = centre - reach
            ijk = np.stack(np.meshgrid(*[np.arange(a, a + 2 * reach + 1) for a in low],
                                       indexing="ij"), axis=-1).reshape(-1, 3)
            inside = np.all((ijk >= 0) & (ijk < self.dims), axis=1)
            legal = ~inside
            step = np.array([1, self.dims[0], self.dims[0] * self.dims[1]])
            legal[inside] = self.flat[ijk[inside] @ step] < isovalue
            if legal.any():
                away = np.linalg.norm((ijk[legal] - index) * self.spacing, axis=1)
                best = away.argmin()
                # a voxel beyond the box is at least this far away
                if away[best] <= (reach + 0.5) * self.spacing.min():
                    where = self.origin + self.direction @ (ijk[legal][best] * self.spacing)
                    return float(away[best]), where
            reach *= 2

    def depth(self, p, isovalue, at_least=0.0):
        """How deep a point with F >= s is, m: the way to the surface towards the nearest legal
        voxel. Points that are no deeper than `at_least` may get 0."""
        distance, where = self.nearest_legal(p, isovalue)
        if distance <= at_least:
            return 0.0
        t = np.linspace(0.0, 1.0, 257)
        outside = self.values(p + t[:, None] * (where - p)) < isovalue
        return distance * float(t[outside.argmax()]) if outside.any() else distance


def header_of(file, path):
    """Fields of an NRRD header, lower-case names; leaves the file at the first byte of data."""
    if not re.match(rb"NRRD000[1-5]", file.readline()):
        raise ValueError(f"{path}: no NRRD")
    fields = {}
    for raw in file:
        line = raw.decode("ascii", "replace").strip()
        if not line:
            break
        if not line.startswith("#") and ": " in line and ":=" not in line.split(": ")[0]:
            name, value = line.split(": ", 1)
            fields[name.lower().replace("datafile", "data file")] = value.strip()
    return fields


def vectors(text):
    return [[float(x) for x in group.split(",")] for group in re.findall(r"\(([^)]*)\)", text)]


def geometry_of(fields, path):
    """Origin and axes in metres, LPS."""
    if "space directions" not in fields:
        spacing = [float(x) for x in fields.get("spacings", "1 1 1").split()]
        spacing = [s if math.isfinite(s) else 1.0 for s in spacing]
        return np.zeros(3), np.diag(spacing) * 1e-3
    signs = SPACES.get(fields.get("space", "lps").lower())
    axes = vectors(fields["space directions"])
    if signs is None or len(axes) != 3 or any(len(a) != 3 for a in axes):
        raise ValueError(f"{path}: a space that is not understood")
    origin = vectors(fields.get("space origin", "(0,0,0)"))[0]
    return np.array(origin) * signs * 1e-3, (np.array(axes) * signs).T * 1e-3


def read(path):
    """The Volume in an NRRD file of one three-dimensional scalar array."""
    with open(path, "rb") as file:
        fields = header_of(file, path)
        if "data file" in fields:
            name = os.path.join(os.path.dirname(path), fields["data file"])
            with open(name, "rb") as payload:
                packed = payload.read()
        else:
            packed = file.read()
    if fields.get("dimension") != "3":
        raise ValueError(f"{path}: not three-dimensional")
    kind = [t for t, names in TYPES.items() if fields.get("type", "").lower() in names.split("|")]
    if not kind:
        raise ValueError(f"{path}: a type that is not understood")

    # lines are skipped in the file, bytes in what it unpacks to
    for _ in range(int(fields.get("line skip", 0))):
        packed = packed[packed.index(b"\n") + 1:]
    encoding = fields.get("encoding", "").lower()
    if encoding in ("gzip", "gz"):
        try:
            packed = gzip.decompress(packed)
        except (EOFError, zlib.error) as wrong:
            raise ValueError(f"{path}: {wrong}") from wrong
    elif encoding != "raw":
        raise ValueError(f"{path}: an encoding that is not understood")

    sizes = [int(n) for n in fields.get("sizes", "").split()]
    if len(sizes) != 3 or min(sizes) < 1:
        raise ValueError(f"{path}: sizes that are not understood")
    dtype = np.dtype(kind[0]).newbyteorder(">" if fields.get("endian") == "big" else "<")
    need = math.prod(sizes) * dtype.itemsize
    skip = int(fields.get("byte skip", 0))
    start = len(packed) - need if skip == -1 else skip
    if start < 0 or len(packed) < start + need:
        raise ValueError(f"{path}: the data end too early")
    voxels = np.frombuffer(packed, dtype, math.prod(sizes), start)
    voxels = voxels.astype("float32" if kind[0] == "float64" else dtype.newbyteorder("="))
    return Volume(voxels.reshape(sizes[::-1]), *geometry_of(fields, path))

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the named tools: closed triangle meshes whose vertices are the point shell.

Writes each of them as OBJ beside this file, in metres, rounded to a micrometre; run it again and
the same bytes come out. A tool points along -z, its handle along +z. The vertex counts of cane,
wrench, peg and drill are those of Table 1 of [Chan 2011]. The others are dense at the tip, which is
what feels, and coarse at the handle.

Lengths in this file are millimetres.
"""

import math
import pathlib

HEXAGONAL = math.sqrt(3.0) / 2.0  # distance of rows over distance of points, equally spaced


class Mesh:
    def __init__(self):
        self.vertices = []
        self.triangles = []

    def add(self, points):
        first = len(self.vertices)
        self.vertices.extend(points)
        return list(range(first, first + len(points)))

    def stitch(self, lower, upper):
        """Joins two closed rings of (index, parameter in [0, 1)); outward if both run
        counter-clockwise seen from the upper side."""
        a, b = len(lower), len(upper)
        # start where the two rings are nearest in parameter
        start = min(range(b), key=lambda j: abs((upper[j][1] - lower[0][1] + 0.5) % 1.0 - 0.5))
        upper = upper[start:] + upper[:start]
        gap = lambda p, q: math.dist(self.vertices[p[0]], self.vertices[q[0]])
        i = j = 0
        while i < a or j < b:
            at, beside = lower[i % a][0], upper[j % b][0]
            # of the two ways on, the one with the shorter new edge
            if j == b or (i < a and gap(lower[(i + 1) % a], upper[j % b])
                          <= gap(lower[i % a], upper[(j + 1) % b]) + 1e-9):
                self.triangles.append((at, lower[(i + 1) % a][0], beside))
                i += 1
            else:
                self.triangles.append((at, upper[(j + 1) % b][0], beside))
                j += 1

    def fan(self, ring, pole, up):
        n = len(ring)
        for k in range(n):
            a, b = ring[k][0], ring[(k + 1) % n][0]
            self.triangles.append((a, b, pole) if up else (b, a, pole))


def apportioned(quotas, total):
    """Whole numbers near the quotas with the given sum (largest remainders)."""
    scale = total / sum(quotas)
    shares = [q * scale for q in quotas]
    counts = [math.floor(s) for s in shares]
    order = sorted(range(len(shares)), key=lambda i: (counts[i] - shares[i], i))
    for i in order[: total - sum(counts)]:
        counts[i] += 1
    return counts


def arc(centre, radius, start_deg, end_deg, steps=60):
    """Points (r, z) on a circle; 0 degrees is +r, 90 degrees is +z."""
    angles = [math.radians(start_deg + (end_deg - start_deg) * k / steps) for k in range(steps + 1)]
    return [(centre[0] + radius * math.cos(t), centre[1] + radius * math.sin(t)) for t in angles]


def resampled(line, places):
    """Points of a polyline at these fractions of its length."""
    lengths = [0.0]
    for p, q in zip(line, line[1:]):
        lengths.append(lengths[-1] + math.dist(p, q))
    points, k = [], 0
    for f in places:
        s = f * lengths[-1]
        while k + 2 < len(lengths) and lengths[k + 1] < s:
            k += 1
        t = (s - lengths[k]) / (lengths[k + 1] - lengths[k])
        points.append(tuple(a + t * (b - a) for a, b in zip(line[k], line[k + 1])))
    return points, lengths[-1]


def lathed(sections, spacing, total=None, around=3.0):
    """A solid of revolution about z. `sections` are polylines (r, z) from the lower pole to the
    upper one, meeting at corners that become rings; `spacing(z)` is the wanted distance of
    points there. With `total`, exactly so many vertices. A ring has at least `around` points."""
    profile = [sections[0][0]]
    for section in sections:
        # steps by the integral of 1 / spacing, so that a graded spacing is met everywhere
        fine, length = resampled(section, [k / 400 for k in range(401)])
        density = [0.0]
        for p, q in zip(fine, fine[1:]):
            density.append(density[-1] + length / 400 / (HEXAGONAL * spacing((p[1] + q[1]) / 2)))
        steps = max(1, round(density[-1]))
        k = 0
        for step in range(1, steps + 1):
            while k < 400 and density[k] < density[-1] * step / steps - 1e-9:
                k += 1
            profile.append(fine[k])
    rings = profile[1:-1]
    quotas = [max(around, 2 * math.pi * r / spacing(z)) for r, z in rings]
    counts = apportioned(quotas, total - 2) if total else [round(q) for q in quotas]

    mesh = Mesh()
    bottom = mesh.add([(0.0, 0.0, profile[0][1])])[0]
    previous = None
    for k, ((r, z), n) in enumerate(zip(rings, counts)):
        turns = [(i + 0.5 * (k % 2)) / n for i in range(n)]
        ring = list(zip(mesh.add([(r * math.cos(2 * math.pi * t), r * math.sin(2 * math.pi * t), z)
                                  for t in turns]), turns))
        if previous is None:
            mesh.fan(ring, bottom, up=False)
        else:
            mesh.stitch(previous, ring)
        previous = ring
    mesh.fan(previous, mesh.add([(0.0, 0.0, profile[-1][1])])[0], up=True)
    return mesh


def sphere():
    """A ball of radius 2.5 mm about the origin."""
    return lathed([arc((0, 0), 2.5, -90, 90, 400)], lambda z: 0.476)


def probe():
    """A slim rod of 100 mm with a ball of radius 2.5 mm at its tip."""
    ball, rod, end = 2.5, 1.2, 100.0
    neck = math.degrees(math.acos(rod / ball))
    top = ball + ball * math.sin(math.radians(neck))
    return lathed(
        [arc((0, ball), ball, -90, neck, 200),
         [(rod, top), (rod, end - rod)],
         arc((0, end - rod), rod, 0, 90)],
        lambda z: 1.05 if z < 6 else min(1.75, 1.05 + (z - 6) * 0.03), 403)


def drill():
    """A surgical hand piece of 86 mm: a burr of radius 2 mm, a shank, a grip."""
    burr, shank = 2.0, 1.1
    neck = math.degrees(math.acos(shank / burr))
    top = burr + burr * math.sin(math.radians(neck))
    return lathed(
        [arc((0, burr), burr, -90, neck, 200),
         [(shank, top), (shank, 18)],
         [(shank, 18), (2.6, 22), (2.6, 28)],
         [(2.6, 28), (5.2, 36), (5.6, 50), (4.8, 66), (5.2, 82)],
         arc((1.2, 82), 4.0, 0, 90) + [(0, 86)]],
        lambda z: 1.05 if z < 5 else min(2.6, 1.05 + (z - 5) * 0.055), 518)


def cane():
    """A walking stick of 120 mm, tube radius 4 mm, its hook towards -z."""
    radius, bend, back = 4.0, 15.0, 12.0
    shaft = 120.0 - bend - 2 * radius
    length = back + math.pi * bend + shaft
    mesh = lathed(
        [arc((0, 0), radius, -90, 0), [(radius, 0), (radius, length)],
         arc((0, length), radius, 0, 90)],
        lambda z: 3.45, 403)

    def bent(p):
        x, y, s = p  # s runs along the axis: up the back, round the bend, up the shaft
        if s < back:
            return (-2 * bend - x, y, -s + back)
        if s < back + math.pi * bend:
            t = (s - back) / bend
            return (-bend - (bend + x) * math.cos(t), y, -(bend + x) * math.sin(t))
        return (x, y, s - back - math.pi * bend)

    mesh.vertices = [bent(p) for p in mesh.vertices]
    return mesh


def peg():
    """A square peg of 15 x 15 x 50 mm."""
    side, height, across, rows = 15.0, 50.0, 9, 33

    def square(half, z, sides):
        """A ring on a square, counter-clockwise from above; `sides` counts its segments."""
        points, turns = [], []
        corners = [(half, -half), (half, half), (-half, half), (-half, -half)]
        for q in range(4):
            (x0, y0), (x1, y1) = corners[q], corners[(q + 1) % 4]
            for k in range(sides[q]):
                t = k / sides[q]
                points.append((x0 + t * (x1 - x0), y0 + t * (y1 - y0), z))
                turns.append((q + t) / 4)
        return points, turns

    insets = [(n, side / 2 * n / across) for n in range(across - 2, 0, -2)]  # 7, 5, 3, 1
    cap = sum(4 * n for n, _ in insets)
    spare = rows * 4 * across + 2 * cap - 1307
    shortened = {round((k + 0.5) * rows / spare): k % 4 for k in range(spare)}

    mesh = Mesh()
    rings = [square(half, 0.0, [n] * 4) for n, half in reversed(insets)]
    for row in range(rows):
        sides = [across - (shortened.get(row) == q) for q in range(4)]
        rings.append(square(side / 2, height * row / (rows - 1), sides))
    rings += [square(half, height, [n] * 4) for n, half in insets]
    rings = [list(zip(mesh.add(points), turns)) for points, turns in rings]
    for lower, upper in zip(rings, rings[1:]):
        mesh.stitch(lower, upper)
    for ring, up in ((rings[0], False), (rings[-1], True)):  # the innermost four points
        a, b, c, d = (index for index, _ in ring)
        mesh.triangles += [(a, b, c), (a, c, d)] if up else [(c, b, a), (d, c, a)]
    return mesh


def spanner(x, z):
    """Signed distance, roughly, to the outline of an open-ended spanner of 130 mm."""
    handle = math.hypot(x, z - min(max(z, 12.0), 122.0)) - 8.0
    head = math.hypot(x, z - 20.0) - 20.0
    blend = max(14.0 - abs(handle - head), 0.0) / 14.0
    body = min(handle, head) - blend * blend * 14.0 / 4
    turn = math.radians(15)  # the mouth of a spanner stands askew
    u = x * math.cos(turn) - (z - 20.0) * math.sin(turn)
    v = x * math.sin(turn) + (z - 20.0) * math.cos(turn)
    mouth = -8.5 + math.hypot(u, max(v - 1.0, 0.0)) if v > 1.0 else abs(u) - 8.5
    blend = max(4.0 - abs(body + mouth), 0.0) / 4.0
    return max(body, -mouth) + blend * blend * 4.0 / 4


def outline(distance, x_range, z_range, step):
    """The zero line of a function as one closed polyline, counter-clockwise: marching squares."""
    nx = round((x_range[1] - x_range[0]) / step)
    nz = round((z_range[1] - z_range[0]) / step)
    xs = [x_range[0] + step * i for i in range(nx + 1)]
    zs = [z_range[0] + step * k for k in range(nz + 1)]
    value = [[distance(x, z) for z in zs] for x in xs]
    follower = {}
    place = {}

    def crossing(a, b):
        key = (min(a, b), max(a, b))
        va, vb = value[a[0]][a[1]], value[b[0]][b[1]]
        t = va / (va - vb)
        place[key] = (xs[a[0]] + t * (xs[b[0]] - xs[a[0]]), zs[a[1]] + t * (zs[b[1]] - zs[a[1]]))
        return key

    for i in range(nx):
        for k in range(nz):
            loop = [(i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1)]
            inside = [value[a][b] < 0 for a, b in loop]
            leaving = [crossing(loop[q], loop[(q + 1) % 4]) for q in range(4)
                       if inside[q] and not inside[(q + 1) % 4]]
            entering = [crossing(loop[q], loop[(q + 1) % 4]) for q in range(4)
                        if not inside[q] and inside[(q + 1) % 4]]
            for out, back in zip(leaving, entering):
                follower[out] = back  # inside stays on the left
    start = min(follower)
    line, key = [place[start]], follower[start]
    while key != start:
        line.append(place[key])
        key = follower[key]
    assert len(line) == len(follower), "one loop only"
    return line + line[:1]


def delaunay(points):
    """Triangles of a planar point set, counter-clockwise: Bowyer and Watson."""
    far = 1e4
    points = points + [(-far, -far), (far, -far), (0.0, far)]
    n = len(points) - 3

    def circle(a, b, c):
        (ax, ay), (bx, by), (cx, cy) = points[a], points[b], points[c]
        bx, by, cx, cy = bx - ax, by - ay, cx - ax, cy - ay
        d = 2 * (bx * cy - by * cx)
        ux = (cy * (bx * bx + by * by) - by * (cx * cx + cy * cy)) / d
        uy = (bx * (cx * cx + cy * cy) - cx * (bx * bx + by * by)) / d
        return ax + ux, ay + uy, ux * ux + uy * uy

    triangles = {(n, n + 1, n + 2): circle(n, n + 1, n + 2)}
    for p in range(n):
        x, y = points[p]
        bad = [t for t, (cx, cy, rr) in triangles.items() if (x - cx) ** 2 + (y - cy) ** 2 < rr]
        edges = [(t[q], t[(q + 1) % 3]) for t in bad for q in range(3)]
        present = set(edges)
        for t in bad:
            del triangles[t]
        for a, b in edges:
            if (b, a) not in present:
                triangles[(a, b, p)] = circle(a, b, p)
    return [t for t in triangles if max(t) < n]


def wrench():
    """An open-ended spanner of 130 mm, 7 mm thick, its mouth towards -z."""
    thickness, layers, total, h = 7.0, 4, 2126, 1.93
    line = outline(spanner, (-26.0, 26.0), (-6.0, 136.0), 0.25)
    rim_count = 2 * round(resampled(line, [1.0])[1] / h / 2)
    rim, _ = resampled(line, [k / rim_count for k in range(rim_count)])
    inner_count = (total - rim_count * (layers + 1)) // 2

    # interior points on a hexagonal lattice whose pitch gives the count, then evened out
    pitch = h
    while True:
        inner = []
        for row in range(200):
            for column in range(100):
                x = -30 + pitch * (column + 0.5 * (row % 2))
                z = -8 + pitch * HEXAGONAL * row
                if spanner(x, z) < -0.62 * h:
                    inner.append((x, z))
        if len(inner) >= inner_count:
            break
        pitch *= 0.998
    excess = len(inner) - inner_count
    drop = {round((k + 0.5) * len(inner) / excess) for k in range(excess)} if excess else set()
    inner = [p for k, p in enumerate(inner) if k not in drop]
    assert len(inner) == inner_count

    def triangulated():
        points = rim + inner
        # a tiny fixed shake: four lattice points on one circle have no unique triangles
        shaken = [(x + 1e-5 * math.sin(12.9 * k), z + 1e-5 * math.sin(78.2 * k))
                  for k, (x, z) in enumerate(points)]
        third = lambda t, c: sum(points[v][c] for v in t) / 3
        return points, [t for t in delaunay(shaken) if spanner(third(t, 0), third(t, 1)) < 0]

    for _ in range(4):
        points, triangles = triangulated()
        around = {}
        for a, b, c in triangles:
            for u, v in ((a, b), (b, c), (c, a)):
                around.setdefault(u, set()).add(v)
                around.setdefault(v, set()).add(u)
        inner = [tuple(sum(points[v][c] for v in sorted(around[k])) / len(around[k])
                       for c in (0, 1)) for k in range(rim_count, len(points))]
    points, triangles = triangulated()

    mesh = Mesh()
    at = lambda y: [(x, y, z) for x, z in points]
    front = mesh.add(at(-thickness / 2))
    back = mesh.add(at(thickness / 2))
    mesh.triangles += [(front[a], front[b], front[c]) for a, b, c in triangles]
    mesh.triangles += [(back[c], back[b], back[a]) for a, b, c in triangles]
    loops = [front[:rim_count]]
    for layer in range(1, layers):
        y = -thickness / 2 + thickness * layer / layers
        loops.append(mesh.add([(x, y, z) for x, z in rim]))
    loops.append(back[:rim_count])
    for near, far in zip(loops, loops[1:]):
        for k in range(rim_count):
            a, b = k, (k + 1) % rim_count
            mesh.triangles += [(near[b], near[a], far[a]), (near[b], far[a], far[b])]
    return mesh


def graded(finest, until, growth, coarsest=4.0):
    """A spacing that is `finest` up to z = `until`, and grows by `growth` a millimetre beyond."""
    return lambda z: min(coarsest, finest + max(0.0, z - until) * growth)


def burr(diameter, finest):
    """A round burr of this diameter on a shank of 2.35 mm, in a straight hand piece; 145 mm."""
    ball, shank = diameter / 2, 1.175
    stem = min(shank, 0.5 * ball)
    neck = math.degrees(math.acos(stem / ball))
    top = ball + ball * math.sin(math.radians(neck))
    taper = [[(stem, top), (shank, top + 7)]] if stem < shank else []
    shoulder = top + 7 if taper else top
    return lathed(
        [arc((0, ball), ball, -90, neck, 200), *taper,
         [(shank, shoulder), (shank, 46)],
         [(shank, 46), (3.0, 50), (3.6, 62)],
         [(3.6, 62), (6.6, 72), (7.0, 100), (5.6, 122), (6.0, 142)],
         arc((3.0, 142), 3.0, 0, 90) + [(0, 145)]],
        graded(finest, diameter, 0.06), around=6.0)


def burr_1():
    return burr(1.0, 0.2)


def burr_2():
    return burr(2.0, 0.28)


def burr_3():
    return burr(3.0, 0.34)


def burr_4():
    return burr(4.0, 0.4)


def burr_6():
    return burr(6.0, 0.6)


def handle(shaft, start, radius, end):
    """The sections of a round handle on a shaft, from `start` to `end`."""
    return [[(shaft, start), (radius, start + 6), (0.9 * radius, start + 16), (radius, end - 8)],
            [(radius, end - 8), (0.7 * radius, end - 1)],
            [(0.7 * radius, end - 1), (0, end)]]


def bent(mesh, back, radius, angle):
    """Bends a straight tool towards +x: its last `back` millimetres end up turned by `angle`
    (rad), behind them the axis is an arc of `radius`. The lowest vertex comes to z = 0."""
    length = radius * angle

    def moved(p):
        x, y, s = p  # s runs along the axis, from the tip
        if s >= back + length:
            return (x, y, s - back - length)
        t = min(angle, (back + length - s) / radius)
        beyond = max(0.0, back - s)
        return (radius - (radius - x) * math.cos(t) + beyond * math.sin(t), y,
                -(radius - x) * math.sin(t) - beyond * math.cos(t))

    vertices = [moved(p) for p in mesh.vertices]
    lowest = min(z for _, _, z in vertices)
    mesh.vertices = [(x, y, z - lowest) for x, y, z in vertices]
    return mesh


def curved_probe():
    """A slim probe with a ball of 1.5 mm, its last centimetres bent by 50 degrees; 150 mm."""
    ball, stem, shaft, end = 0.75, 0.45, 1.1, 153.522
    neck = math.degrees(math.acos(stem / ball))
    top = ball + ball * math.sin(math.radians(neck))
    mesh = lathed(
        [arc((0, ball), ball, -90, neck, 200),
         [(stem, top), (0.7, 22)],
         [(0.7, 22), (shaft, 62)],
         *handle(shaft, 62, 3.4, end)],
        graded(0.3, 2.0, 0.055), around=6.0)
    return bent(mesh, 4.0, 22.0, math.radians(50))


def hook():
    """A blunt hook: a wire of 1 mm, bent by 90 degrees 3.5 mm from its end; 148 mm."""
    wire, shaft, end = 0.5, 1.1, 150.356
    mesh = lathed(
        [arc((0, wire), wire, -90, 0, 100),
         [(wire, wire), (wire, 6)],
         [(wire, 6), (shaft, 40), (shaft, 56)],
         *handle(shaft, 56, 3.4, end)],
        graded(0.36, 6.0, 0.06), around=6.0)
    return bent(mesh, 2.0, 1.5, math.pi / 2)


def oval(a, b, turn):
    """The point of an ellipse with half axes a, b at this fraction of its circumference."""
    fine = [(a * math.cos(2 * math.pi * k / 720), b * math.sin(2 * math.pi * k / 720))
            for k in range(721)]
    return resampled(fine, [turn])[0][0]


def elevator():
    """A flat blade, 5 mm wide, 1.2 mm thick and slightly curved, on a handle; 160 mm."""
    half, thin, end = 2.5, 0.6, 160.0

    def blade(z):
        """Half width and half thickness at z."""
        if z < half:
            round_end = math.sqrt(max(0.0, half * half - (half - z) ** 2))
            return round_end, thin * round_end / half
        if z < 12:
            return half, thin
        t = min(1.0, (z - 12) / 12)
        t = t * t * (3 - 2 * t)
        return half + (1.5 - half) * t, thin + (1.5 - thin) * t

    def around(a, b):  # [Ramanujan 1914]: as the radius of a circle of that circumference
        return (3 * (a + b) - math.sqrt((3 * a + b) * (a + 3 * b))) / 2

    def ring(z):
        return around(*blade(z))

    tip = [(ring(half * (1 - math.cos(math.pi * k / 400))), half * (1 - math.cos(math.pi * k / 400)))
           for k in range(201)]
    rest = [(ring(half + (24 - half) * k / 200), half + (24 - half) * k / 200) for k in range(201)]
    mesh = lathed([tip, rest, [(1.5, 24), (1.7, 60)], *handle(1.7, 60, 4.4, end)],
                  graded(0.45, 3.0, 0.04), around=6.0)

    def flattened(p):
        x, y, z = p
        if z >= 24:
            return p
        if x == 0 and y == 0:
            return (0.0, 0.006 * (24 - z) ** 2, z)
        a, b = blade(z)
        u, v = oval(a, b, (math.atan2(y, x) / (2 * math.pi)) % 1.0)
        return (u, v + 0.006 * (24 - z) ** 2, z)

    mesh.vertices = [flattened(p) for p in mesh.vertices]
    return mesh


def needle():
    """A needle of 1 mm that tapers to a rounded point of 0.3 mm, in a grip; 100 mm."""
    point, wire = 0.15, 0.5
    return lathed(
        [arc((0, point), point, -90, 0, 100),
         [(point, point), (wire, 5)],
         [(wire, 5), (wire, 62)],
         [(wire, 62), (2.2, 65), (3.0, 70), (2.6, 80), (3.0, 92)],
         [(3.0, 92), (2.0, 99.4)], [(2.0, 99.4), (0, 100)]],
        graded(0.13, 0.3, 0.04, 4.0), around=6.0)


def checked(name, mesh):
    """Closed, manifold, outward, nothing degenerate: or no file is written."""
    vertices = [tuple(round(c * 1e-3, 6) + 0.0 for c in p) for p in mesh.vertices]
    assert len(set(vertices)) == len(vertices), f"{name}: two vertices coincide"
    edges = [(t[q], t[(q + 1) % 3]) for t in mesh.triangles for q in range(3)]
    assert len(set(edges)) == len(edges), f"{name}: an edge is used twice the same way"
    known = set(edges)
    assert all((b, a) in known for a, b in edges), f"{name}: open"
    assert {v for e in edges for v in e} == set(range(len(vertices))), f"{name}: loose vertex"
    volume = 0.0
    for t in mesh.triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (vertices[v] for v in t)
        volume += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6
    assert volume > 0, f"{name}: inside out"
    lengths = sorted(math.dist(vertices[a], vertices[b]) for a, b in edges)
    euler = len(vertices) - len(edges) // 2 + len(mesh.triangles)
    print(f"{name}: {len(vertices)} vertices, {len(mesh.triangles)} triangles, Euler {euler}, "
          f"{volume * 1e9:.0f} mm^3, edges {lengths[0] * 1e3:.2f} / "
          f"{lengths[len(lengths) // 2] * 1e3:.2f} / {lengths[-1] * 1e3:.2f} mm")
    return vertices


def main():
    folder = pathlib.Path(__file__).resolve().parent
    for draw in (sphere, probe, drill, cane, wrench, peg, burr_1, burr_2, burr_3, burr_4, burr_6,
                 curved_probe, hook, elevator, needle):
        name = draw.__name__.replace("_", "-")
        mesh = draw()
        vertices = checked(name, mesh)
        lines = ["# SPDX-License-Identifier: BSD-3-Clause",
                 f"# {name}, in metres, drawn by draw_tools.py"]
        lines += ["v " + " ".join(f"{c:.6f}" for c in v) for v in vertices]
        lines += ["f " + " ".join(str(v + 1) for v in t) for t in mesh.triangles]
        (folder / f"{name}.obj").write_text("\n".join(lines) + "\n", encoding="ascii")


if __name__ == "__main__":
    main()

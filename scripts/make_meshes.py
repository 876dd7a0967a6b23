#!/usr/bin/python3
"""Draws meshes/*.dae and their textures: what RViz shows of the bodies in urdf/.

The physics never reads these files. Sizes repeat the <collision> elements of the URDF file of the same body; where a
ball can touch, picture and collision shape agree within 2 mm. Standard library only; run it after a change:

    scripts/make_meshes.py [DIRECTORY]
"""
import math
import os
import struct
import sys
import zlib

# --- Sizes [m] ---------------------------------------------------------------------------------------------------

TABLE_LENGTH, TABLE_WIDTH, TABLE_THICKNESS = 2.740, 1.525, 0.025
EDGE_LINE, CENTRE_LINE = 0.020, 0.003
NET_HEIGHT, NET_LENGTH, NET_TAPE = 0.1525, 1.830, 0.015
NET_MESH, NET_THREAD = 0.0125, 0.0016

BLADE_HALF_WIDTH, BLADE_HALF_LENGTH = 0.0760, 0.0780  # the collision cylinder has a radius of 0.077
WOOD_THICKNESS, SPONGE, SHEET = 0.0060, 0.0020, 0.0015
HANDLE_TOP, HANDLE_END = -0.0690, -0.1720

TRAY_LENGTH, TRAY_WIDTH, TRAY_HEIGHT, TRAY_WALL = 1.200, 1.000, 0.250, 0.015  # inner length and width

FLOOR_SIZE = 12.0
HALL = (24, 30, 42)  # background colour of config/view.rviz


# --- Textures ----------------------------------------------------------------------------------------------------

def noise(x, y, seed=0):
    """Smooth noise in [0, 1] over the plane, the same on every machine."""
    def corner(i, j):
        h = (i * 374761393 + j * 668265263 + seed * 2147483647) & 0xFFFFFFFF
        h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
        return ((h ^ (h >> 16)) & 0xFFFF) / 65535.0
    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    low = corner(i, j) * (1 - u) + corner(i + 1, j) * u
    high = corner(i, j + 1) * (1 - u) + corner(i + 1, j + 1) * u
    return low * (1 - v) + high * v


def mix(a, b, t):
    t = min(max(t, 0.0), 1.0)
    return tuple(p + (q - p) * t for p, q in zip(a, b))


def write_png(path, width, height, pixel):
    """pixel(column, row) returns 3 or 4 numbers in [0, 255]; row 0 is the upper one."""
    channels = len(pixel(0, 0))
    raw = bytearray()
    for row in range(height):
        line = bytearray()
        for column in range(width):
            line += bytes(min(max(int(value + 0.5), 0), 255) for value in pixel(column, row))
        raw.append(1)  # PNG filter "sub": smooth pictures pack well
        raw += line[:channels] + bytes((line[k] - line[k - channels]) & 255 for k in range(channels, len(line)))

    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    header = struct.pack('>IIBBBBB', width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + chunk(b'IDAT', zlib.compress(bytes(raw), 9))
                   + chunk(b'IEND', b''))


def wood_pixel(size, light, dark):
    """Grain along the rows; the picture tiles without a seam."""
    def pixel(column, row):
        # Walking on circles in the noise keeps the left edge equal to the right one, and top to bottom.
        angle_u, angle_v = 2 * math.pi * column / size, 2 * math.pi * row / size
        x, y = 3.0 * math.cos(angle_u) + 9, 3.0 * math.sin(angle_u) + 9
        along = 0.35 * math.cos(angle_v), 0.35 * math.sin(angle_v)
        broad = noise(x * 1.5 + along[0], y * 1.5 + along[1], 1)
        rings = 0.5 + 0.5 * math.sin(14 * math.pi * broad + 4 * along[0])
        fine = noise(x * 14 + along[1], y * 14 + along[0], 2)
        return mix(light, dark, 0.50 * rings * rings + 0.45 * fine - 0.10)
    return pixel


def table_pixel(width, height):
    """Playing surface from above, column along x: the soft light of a lamp over either half, and the net's shade."""
    def pixel(column, row):
        x = ((column + 0.5) / width - 0.5) * TABLE_LENGTH
        y = (0.5 - (row + 0.5) / height) * TABLE_WIDTH
        lamp = sum(math.exp(-((x - c) ** 2 / 0.75 + y ** 2 / 0.55)) for c in (-0.72, 0.72))
        colour = mix((12, 62, 132), (28, 104, 190), 0.95 * lamp)
        return mix(colour, (4, 16, 40), 0.28 * math.exp(-abs(x) / 0.022) + 0.12 * math.exp(-abs(x) / 0.10))
    return pixel


def floor_pixel(size):
    def pixel(column, row):
        x, y = (column + 0.5) / size - 0.5, (row + 0.5) / size - 0.5
        radius = 2 * math.hypot(x, y)
        light = math.exp(-(radius / 0.42) ** 2)
        fade = min(max((1.0 - radius) / 0.45, 0), 1)
        colour = mix((34, 38, 52), (112, 58, 50), light)
        dither = ((column * 7 + row * 13 + (column * row) % 5) % 8) / 8 - 0.5  # no rings where it fades slowly
        return tuple(c + dither for c in mix(HALL, colour, fade * fade * (3 - 2 * fade)))
    return pixel


# --- Meshes ------------------------------------------------------------------------------------------------------

def sub(a, b):
    return tuple(p - q for p, q in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(p * p for p in a)) or 1.0
    return tuple(p / length for p in a)


class Material:
    """Headlight shading leaves low angles dark, so a part of each colour glows by itself."""

    def __init__(self, name, colour=(1, 1, 1), glow=0.35, shine=0.0, texture=None):
        self.name, self.colour, self.glow, self.shine, self.texture = name, colour, glow, shine, texture

    def effect(self):
        def rgba(tag, factor):
            r, g, b = (c * factor for c in self.colour)
            return f'<{tag}><color>{r:.3f} {g:.3f} {b:.3f} 1</color></{tag}>'
        image = ''
        diffuse = rgba('diffuse', 1 - 0.5 * self.glow)
        if self.texture:
            image = (f'<newparam sid="{self.name}-s"><surface type="2D"><init_from>{self.name}-i</init_from></surface>'
                     f'</newparam><newparam sid="{self.name}-t"><sampler2D><source>{self.name}-s</source></sampler2D>'
                     f'</newparam>')
            diffuse = f'<diffuse><texture texture="{self.name}-t" texcoord="UV"/></diffuse>'
        return (f'<effect id="{self.name}-e"><profile_COMMON>{image}<technique sid="common"><phong>'
                f'{rgba("emission", self.glow)}{rgba("ambient", 1)}{diffuse}'
                f'<specular><color>{self.shine} {self.shine} {self.shine} 1</color></specular>'
                f'<shininess><float>40</float></shininess>'
                f'</phong></technique></profile_COMMON></effect>')


class Mesh:
    def __init__(self):
        self.parts = {}  # material -> list of triangles, each three (position, normal, uv)

    def triangle(self, material, points, normals=None, uvs=None):
        if normals is None:
            normals = [unit(cross(sub(points[1], points[0]), sub(points[2], points[0])))] * 3
        uvs = uvs or [(0, 0)] * 3
        self.parts.setdefault(material, []).append(list(zip(points, normals, uvs)))

    def quad(self, material, points, normals=None, uvs=None):
        for k in ((0, 1, 2), (0, 2, 3)):
            self.triangle(material, [points[i] for i in k], normals and [normals[i] for i in k],
                          uvs and [uvs[i] for i in k])

    def sheet(self, material, origin, u, v, counts, uv=None):
        """Flat rectangle in counts[0] x counts[1] tiles: lighting is per vertex. uv(position) or the unit square."""
        normal = unit(cross(u, v))
        for i in range(counts[0]):
            for j in range(counts[1]):
                steps = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                points = [tuple(o + a * p / counts[0] + b * q / counts[1] for o, a, b in zip(origin, u, v))
                          for p, q in steps]
                uvs = [uv(point) if uv else (p / counts[0], q / counts[1]) for point, (p, q) in zip(points, steps)]
                self.quad(material, points, [normal] * 4, uvs)

    def box(self, material, centre, size, bevel=0.0, uv_scale=None):
        """Box with bevelled edges; with uv_scale the texture's rows run along the longest edge."""
        long_axis = max(range(3), key=lambda k: size[k])

        def uv(point, axis):
            if uv_scale is None:
                return (0, 0)
            other = [k for k in range(3) if k not in (axis, long_axis)] or [(axis + 1) % 3]
            return (point[other[0]] * uv_scale, point[long_axis] * uv_scale)
        half = [s / 2 for s in size]
        corner = {}
        for signs in ((a, b, c) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)):
            for axis in range(3):  # the corner of that axis's face
                corner[signs, axis] = tuple(c + s * (h - (0 if k == axis else bevel))
                                            for k, (c, s, h) in enumerate(zip(centre, signs, half)))

        def normal(signs, axis):
            return tuple(signs[k] if k == axis else 0 for k in range(3))

        def oriented(points, normals, uvs):
            facing = unit(tuple(sum(n[k] for n in normals) for k in range(3)))
            wound = cross(sub(points[1], points[0]), sub(points[2], points[0]))
            if sum(p * q for p, q in zip(facing, wound)) < 0:
                points, normals, uvs = points[::-1], normals[::-1], uvs[::-1]
            (self.quad if len(points) == 4 else self.triangle)(material, points, normals, uvs)

        for axis in range(3):
            b, c = (axis + 1) % 3, (axis + 2) % 3
            for side in (-1, 1):
                loop = []
                for sb, sc in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                    signs = [0, 0, 0]
                    signs[axis], signs[b], signs[c] = side, sb, sc
                    loop.append(tuple(signs))
                points = [corner[s, axis] for s in loop]
                oriented(points, [normal(s, axis) for s in loop], [uv(p, axis) for p in points])
            if bevel:
                for sb in (-1, 1):
                    for sc in (-1, 1):
                        ends = []
                        for sa in (-1, 1):
                            signs = [0, 0, 0]
                            signs[axis], signs[b], signs[c] = sa, sb, sc
                            ends.append(tuple(signs))
                        points = [corner[ends[0], b], corner[ends[1], b], corner[ends[1], c], corner[ends[0], c]]
                        normals = [normal(ends[0], b), normal(ends[1], b), normal(ends[1], c), normal(ends[0], c)]
                        oriented(points, normals, [uv(p, b) for p in points])
        if bevel:
            for signs in ((a, b, c) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)):
                points = [corner[signs, k] for k in range(3)]
                oriented(points, [normal(signs, k) for k in range(3)], [uv(p, 0) for p in points])

    def loft(self, material, rings, uv=None, closed=True):
        """Skin over rings of equal length; normals from the neighbours, so it looks round."""
        count = len(rings[0])

        def normal(r, k):
            a, b = rings[max(r - 1, 0)][k], rings[min(r + 1, len(rings) - 1)][k]
            if closed:
                p, q = rings[r][(k - 1) % count], rings[r][(k + 1) % count]
            else:
                p, q = rings[r][max(k - 1, 0)], rings[r][min(k + 1, count - 1)]
            return unit(cross(sub(q, p), sub(b, a)))
        for r in range(len(rings) - 1):
            for k in range(count if closed else count - 1):
                corners = [(r, k), (r, (k + 1) % count), (r + 1, (k + 1) % count), (r + 1, k)]
                points = [rings[i][j] for i, j in corners]
                uvs = [uv(p) for p in points] if uv else None
                self.quad(material, points, [normal(i, j) for i, j in corners], uvs)

    def fan(self, material, ring, normal, uv=None, steps=6):
        """Flat cap over a ring that its centre sees whole, in steps of rings."""
        centre = tuple(sum(p[k] for p in ring) / len(ring) for k in range(3))
        loops = [[tuple(c + (p - c) * s / steps for c, p in zip(centre, point)) for point in ring]
                 for s in range(steps + 1)]
        for s in range(steps):
            for k in range(len(ring)):
                n = (k + 1) % len(ring)
                points = [loops[s][k], loops[s + 1][k], loops[s + 1][n], loops[s][n]]
                wound = cross(sub(points[1], points[0]), sub(points[2], points[0]))
                if sum(p * q for p, q in zip(wound, normal)) < 0:
                    points = points[::-1]
                uvs = [uv(p) for p in points] if uv else [(0, 0)] * 4
                if s == 0:
                    outer = [(p, u) for p, u in zip(points, uvs)]
                    keep = [outer[0]] + [e for e in outer[1:] if e[0] != outer[0][0]]
                    if len(keep) >= 3:
                        self.triangle(material, [e[0] for e in keep[:3]], [normal] * 3, [e[1] for e in keep[:3]])
                else:
                    self.quad(material, points, [normal] * 4, uvs)

    def tube(self, material, start, end, radius, sides=14, caps=True, bevel=0.0):
        axis = unit(sub(end, start))
        side = unit(cross(axis, (1, 0, 0) if abs(axis[0]) < 0.9 else (0, 1, 0)))
        up = cross(axis, side)

        def ring(centre, r):
            return [tuple(c + r * (math.cos(a) * s + math.sin(a) * t) for c, s, t in zip(centre, side, up))
                    for a in (2 * math.pi * k / sides for k in range(sides))]
        for a, b in ((start, end),):
            self.loft(material, [ring(a, radius), ring(b, radius)])
        if caps:
            self.fan(material, ring(start, radius), tuple(-c for c in axis), steps=1)
            self.fan(material, ring(end, radius), axis, steps=1)

    def write(self, path):
        def numbers(rows):
            return ' '.join(f'{value:g}' for row in rows for value in row)
        images, effects, materials, geometries, nodes = [], [], [], [], []
        for index, (material, triangles) in enumerate(self.parts.items()):
            table, order = {}, []
            for triangle in triangles:
                for position, normal, uv in triangle:
                    key = (tuple(round(p, 5) + 0.0 for p in position), tuple(round(n, 2) + 0.0 for n in normal),
                           tuple(round(u, 4) + 0.0 for u in uv))  # + 0.0: no negative zero
                    order.append(table.setdefault(key, len(table)))
            vertices = list(table)
            name = material.name
            if material.texture:
                images.append(f'<image id="{name}-i"><init_from>{material.texture}</init_from></image>')
            effects.append(material.effect())
            materials.append(f'<material id="{name}"><instance_effect url="#{name}-e"/></material>')

            def source(kind, column, parameters):
                return (f'<source id="g{index}-{kind}"><float_array id="g{index}-{kind}-a" '
                        f'count="{len(vertices) * len(parameters)}">{numbers(v[column] for v in vertices)}</float_array>'
                        f'<technique_common><accessor source="#g{index}-{kind}-a" count="{len(vertices)}" '
                        f'stride="{len(parameters)}">' + ''.join(f'<param name="{p}" type="float"/>' for p in parameters)
                        + '</accessor></technique_common></source>')
            geometries.append(
                f'<geometry id="g{index}"><mesh>{source("p", 0, "XYZ")}{source("n", 1, "XYZ")}{source("t", 2, "ST")}'
                f'<vertices id="g{index}-v"><input semantic="POSITION" source="#g{index}-p"/></vertices>'
                f'<triangles material="m" count="{len(triangles)}">'
                f'<input semantic="VERTEX" source="#g{index}-v" offset="0"/>'
                f'<input semantic="NORMAL" source="#g{index}-n" offset="0"/>'
                f'<input semantic="TEXCOORD" source="#g{index}-t" offset="0" set="0"/>'
                f'<p>{" ".join(map(str, order))}</p></triangles></mesh></geometry>')
            nodes.append(
                f'<node id="n{index}"><instance_geometry url="#g{index}"><bind_material><technique_common>'
                f'<instance_material symbol="m" target="#{name}"><bind_vertex_input semantic="UV" '
                f'input_semantic="TEXCOORD" input_set="0"/></instance_material></technique_common></bind_material>'
                f'</instance_geometry></node>')
        with open(path, 'w', encoding='ascii') as file:
            file.write('\n'.join([
                '<?xml version="1.0" encoding="utf-8"?>',
                '<!-- Written by scripts/make_meshes.py -->',
                '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">',
                '<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>',
                '<library_images>', *images, '</library_images>', '<library_effects>', *effects, '</library_effects>',
                '<library_materials>', *materials, '</library_materials>',
                '<library_geometries>', *geometries, '</library_geometries>',
                '<library_visual_scenes><visual_scene id="scene">', *nodes, '</visual_scene></library_visual_scenes>',
                '<scene><instance_visual_scene url="#scene"/></scene>', '</COLLADA>', '']))


STEEL = Material('steel', (0.20, 0.22, 0.25), glow=0.25, shine=0.35)
DARK_STEEL = Material('dark_steel', (0.10, 0.11, 0.13), glow=0.25, shine=0.30)
BLACK = Material('black', (0.05, 0.05, 0.055), glow=0.3, shine=0.25)
WHITE = Material('white', (0.95, 0.95, 0.93), glow=0.45)


# --- Table -------------------------------------------------------------------------------------------------------

def table_top():
    mesh = Mesh()
    blue = Material('table_blue', glow=0.55, shine=0.10, texture='table_top.png')
    line = Material('table_line', (0.93, 0.95, 0.97), glow=0.60, shine=0.10)
    side = Material('table_side', (0.05, 0.14, 0.30), glow=0.45)
    x, y, d = TABLE_LENGTH / 2, TABLE_WIDTH / 2, TABLE_THICKNESS
    a, b, c = x - EDGE_LINE, y - EDGE_LINE, CENTRE_LINE / 2

    def uv(p):
        return (p[0] / TABLE_LENGTH + 0.5, p[1] / TABLE_WIDTH + 0.5)

    def area(material, x0, x1, y0, y1, counts):
        mesh.sheet(material, (x0, y0, 0), (x1 - x0, 0, 0), (0, y1 - y0, 0), counts, uv)
    area(blue, -a, a, -b, -c, (24, 7))
    area(blue, -a, a, c, b, (24, 7))
    area(line, -a, a, -c, c, (24, 1))
    for sign in (-1, 1):
        area(line, -x, x, *sorted((sign * b, sign * y)), (24, 1))
        area(line, *sorted((sign * a, sign * x)), -b, b, (1, 14))
    mesh.sheet(side, (-x, y, -d), (2 * x, 0, 0), (0, -2 * y, 0), (6, 4))
    mesh.sheet(side, (-x, -y, -d), (2 * x, 0, 0), (0, 0, d), (12, 1))
    mesh.sheet(side, (x, y, -d), (-2 * x, 0, 0), (0, 0, d), (12, 1))
    mesh.sheet(side, (x, -y, -d), (0, 2 * y, 0), (0, 0, d), (7, 1))
    mesh.sheet(side, (-x, y, -d), (0, -2 * y, 0), (0, 0, d), (7, 1))
    return mesh


def table_frame():
    """Apron, legs, feet and stretchers; the same numbers stand in urdf/table.urdf."""
    mesh = Mesh()
    for sign in (-1, 1):
        mesh.box(STEEL, (0, sign * 0.7125, -0.050), (2.640, 0.020, 0.050), 0.003)
        mesh.box(STEEL, (sign * 1.310, 0, -0.050), (0.020, 1.445, 0.050), 0.003)
    for sx in (-1, 1):
        x = sx * 1.00
        for sy in (-1, 1):
            y = sy * 0.56
            mesh.tube(STEEL, (x, y, -0.745), (x, y, -0.025), 0.030)
            mesh.tube(BLACK, (x, y, -0.760), (x, y, -0.740), 0.034)
        mesh.tube(STEEL, (x, -0.56, -0.600), (x, 0.56, -0.600), 0.016)
        mesh.box(DARK_STEEL, (x, 0, -0.040), (0.050, 1.410, 0.030), 0.003)
    mesh.tube(STEEL, (-1.00, 0, -0.600), (1.00, 0, -0.600), 0.016)
    mesh.box(DARK_STEEL, (0, 0, -0.040), (0.050, 1.410, 0.030), 0.003)
    return mesh


def floor():
    """Sports floor, lit over the table and lost in the dark of the hall at its rim."""
    mesh = Mesh()
    material = Material('floor', glow=0.7, texture='floor.png')
    half = FLOOR_SIZE / 2
    mesh.sheet(material, (-half, -half, 0), (FLOOR_SIZE, 0, 0), (0, FLOOR_SIZE, 0), (20, 20))
    return mesh


def net():
    """Threads and tape; the URDF file adds a clear dark sheet, for the threads are thinner than a pixel from afar."""
    mesh = Mesh()
    threads = Material('net', (0.10, 0.13, 0.18), glow=0.8)
    y, top, half = NET_LENGTH / 2, NET_HEIGHT - NET_TAPE, NET_THREAD / 2
    columns, rows = round(NET_LENGTH / NET_MESH), round(top / NET_MESH)
    for sign in (-1, 1):
        x = 0.0006 * sign
        for k in range(1, columns):
            c = -y + 2 * y * k / columns
            mesh.sheet(threads, (x, c - sign * half, 0.001), (0, 2 * sign * half, 0), (0, 0, top), (1, 1))
        for k in range(rows):
            c = 0.002 + (top - 0.002) * k / rows
            mesh.sheet(threads, (x, -sign * y, c - half), (0, 2 * sign * y, 0), (0, 0, 2 * half), (1, 1))
    mesh.box(WHITE, (0, 0, NET_HEIGHT - NET_TAPE / 2), (0.004, 2 * y, NET_TAPE), 0.0008)
    return mesh


def net_posts():
    mesh = Mesh()
    for sign in (-1, 1):
        y = sign * NET_LENGTH / 2
        mesh.tube(DARK_STEEL, (0, y, -0.060), (0, y, NET_HEIGHT), 0.010)
        mesh.tube(BLACK, (0, y, NET_HEIGHT), (0, y, NET_HEIGHT + 0.004), 0.010)
        mesh.tube(DARK_STEEL, (0, y, -0.064), (0, y, -0.030), 0.016)
        mesh.box(DARK_STEEL, (0, sign * 0.825, -0.045), (0.040, 0.190, 0.016), 0.002)
        mesh.tube(BLACK, (0, sign * 0.748, -0.062), (0, sign * 0.748, -0.025), 0.012)
    return mesh


# --- Paddle ------------------------------------------------------------------------------------------------------

def smooth(t):
    t = min(max(t, 0.0), 1.0)
    return t * t * (3 - 2 * t)


def blade_radius(angle):
    """Distance of the blade's rim from its centre; angle from the tip [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return 1.0 / math.hypot(c / BLADE_HALF_LENGTH, s / BLADE_HALF_WIDTH)


def handle_half_width(z):
    t = (HANDLE_TOP - z) / (HANDLE_TOP - HANDLE_END)
    return 0.0141 - 0.0012 * math.sin(math.pi * min(t / 0.75, 1)) + 0.0030 * smooth((t - 0.45) / 0.55)


def blade_outline(points=48):
    """(y, z) round the wood, with the shoulders that run into the handle."""
    shoulder = math.radians(142)
    outline = []
    rim = [k * shoulder / (points // 2) for k in range(points // 2 + 1)]
    for angle in rim:
        r = blade_radius(angle)
        outline.append((r * math.sin(angle), r * math.cos(angle)))
    # Shoulder: a cubic from the rim's tangent to the handle's direction.
    y0, z0 = outline[-1]
    tangent = unit((outline[-1][0] - outline[-2][0], outline[-1][1] - outline[-2][1]))
    z1 = -0.0950
    y1 = handle_half_width(z1)
    for k in range(1, 9):
        t = k / 8
        b = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
        c0 = (y0 + 0.020 * tangent[0], z0 + 0.020 * tangent[1])
        c1 = (y1, z1 + 0.016)
        outline.append((b[0] * y0 + b[1] * c0[0] + b[2] * c1[0] + b[3] * y1,
                        b[0] * z0 + b[1] * c0[1] + b[2] * c1[1] + b[3] * z1))
    for k in range(1, 7):  # between the halves of the handle, and a hair wider
        z = z1 + (HANDLE_END + 0.002 - z1) * k / 6
        outline.append((handle_half_width(z), z))
    return outline + [(-y, z) for y, z in reversed(outline[1:])]


def rubber_outline(points=56):
    """The blade's round cut off above the handle, with round corners at the cut."""
    cut, result = -0.0665, []
    for k in range(points):
        angle = 2 * math.pi * k / points
        r = blade_radius(angle) - 0.0004
        c = math.cos(angle)
        if c < 0:  # smooth minimum of rim and straight cut
            chord = cut / c
            r = -0.003 * math.log(math.exp(-r / 0.003) + math.exp(-chord / 0.003)) if chord < r + 0.03 else r
        result.append((r * math.sin(angle), r * math.cos(angle)))
    return result


def paddle():
    mesh = Mesh()
    wood = Material('blade_wood', glow=0.30, shine=0.05, texture='wood_light.png')
    grip = Material('grip_wood', glow=0.28, shine=0.12, texture='wood_dark.png')
    inlay = Material('inlay', (0.75, 0.10, 0.10), glow=0.35, shine=0.15)
    sponge = Material('sponge', (0.90, 0.62, 0.25), glow=0.4)
    faces = {1: (Material('rubber_red', (0.74, 0.04, 0.05), glow=0.30, shine=0.22),
                 Material('rubber_red_edge', (0.55, 0.03, 0.04), glow=0.4)),
             -1: (Material('rubber_black', (0.075, 0.075, 0.085), glow=0.35, shine=0.30),
                  Material('rubber_black_edge', (0.05, 0.05, 0.055), glow=0.35))}

    def wood_uv(p):
        return ((p[1] + 0.5 * p[0]) * 9.0, p[2] * 6.0)

    # Wood: rim with a small bevel, faces as fans (the shoulders are seen from the centre).
    outline, half = blade_outline(), WOOD_THICKNESS / 2
    scale = [(x, inset) for x, inset in ((-half, 0.0006), (-half + 0.0006, 0), (half - 0.0006, 0), (half, 0.0006))]
    rings = []
    for x, inset in scale:
        rings.append([(x, y * (1 - inset / 0.075), z) for y, z in outline])
    mesh.loft(wood, [ring[::-1] for ring in rings], wood_uv)
    for x in (-half, half):
        upper = [(y, z) for y, z in outline if z > -0.1000]
        mesh.fan(wood, [(x, y, z) for y, z in upper], (math.copysign(1, x), 0, 0), wood_uv, steps=1)

    # Rubbers: sponge, sheet, and a rounded rim.
    outline = rubber_outline()
    for sign, (sheet, edge) in faces.items():
        def ring(x, inset=0.0):
            factor = 1 - inset / 0.075
            loop = [(sign * x, y * factor, z * factor) for y, z in outline]
            return loop[::-1] if sign > 0 else loop
        low, mid, high = half, half + SPONGE, half + SPONGE + SHEET
        mesh.loft(sponge, [ring(low), ring(mid)])
        mesh.loft(edge, [ring(mid), ring(high - 0.0001, 0.0004)])
        mesh.loft(sheet, [ring(high - 0.0001, 0.0004), ring(high, 0.0010)])
        mesh.fan(sheet, ring(high, 0.0010), (sign, 0, 0), steps=2)

    # Handle: two rounded halves that flare to the end, and an inlay along each side's middle.
    def section(z):
        t = (HANDLE_TOP - z) / (HANDLE_TOP - HANDLE_END)
        width = handle_half_width(z) - 0.0001
        depth = 0.0112 - 0.0004 * math.sin(math.pi * t) + 0.0008 * smooth((t - 0.6) / 0.4)
        begin = smooth(t / 0.09)  # the upper end is rounded down to the blade
        depth = half + (depth - half) * (0.25 + 0.75 * math.sqrt(begin)) if t < 0.09 else depth
        end = max(0.0, (t - 0.955) / 0.045)
        shrink = math.sqrt(max(0.0, 1 - 0.55 * end * end))
        return width * shrink, depth * shrink

    def ring(z, count=48):
        width, depth = section(z)
        loop = []
        for k in range(count):
            a = 2 * math.pi * k / count
            c, s = math.cos(a), math.sin(a)
            power = 2 / 3.2
            loop.append((depth * math.copysign(abs(c) ** power, c), width * math.copysign(abs(s) ** power, s), z))
        return loop
    heights = [HANDLE_TOP + (HANDLE_END - HANDLE_TOP) * (k / 9) for k in range(10)]
    rings = [ring(z) for z in heights]
    # The inlay takes the columns round the middle of each face; the rest is wood.
    count = len(rings[0])
    stripe = {k % count for k in (-2, -1, 0, 1, count // 2 - 2, count // 2 - 1, count // 2, count // 2 + 1)}
    thin = {k % count for k in (-4, 3, count // 2 - 4, count // 2 + 3)}
    runs, pale = [], Material('inlay_pale', (0.93, 0.86, 0.72), glow=0.35, shine=0.15)
    for k in range(count):
        kind = inlay if k in stripe else pale if k in thin else grip
        if runs and runs[-1][0] is kind:
            runs[-1][1].append(k)
        else:
            runs.append((kind, [k]))
    for kind, columns in runs:
        strip = [[r[k % count] for k in range(columns[0], columns[-1] + 2)][::-1] for r in rings[::-1]]
        strip = [row[::-1] for row in strip]
        mesh.loft(kind, strip, lambda p: (p[1] * 9.0 + p[0] * 9.0, p[2] * 6.0), closed=False)
    mesh.fan(grip, rings[-1], (0, 0, -1), lambda p: (p[0] * 12, p[1] * 12), steps=1)
    mesh.fan(grip, rings[0], (0, 0, 1), lambda p: (p[0] * 12, p[1] * 12), steps=1)
    return mesh


# --- Tray --------------------------------------------------------------------------------------------------------

def tray():
    """Wooden frame of the four walls; the panes between are boxes of the URDF file, so that the balls are seen."""
    mesh = Mesh()
    wood = Material('tray_wood', glow=0.34, shine=0.08, texture='wood_dark.png')
    w, h, rail = TRAY_WALL, TRAY_HEIGHT, 0.020
    x, y = TRAY_LENGTH / 2 + w / 2, TRAY_WIDTH / 2 + w / 2
    for sign in (-1, 1):
        for z in (rail / 2, h - rail / 2):
            mesh.box(wood, (0, sign * y, z), (2 * x - w, w, rail), 0.0015, 4)
            mesh.box(wood, (sign * x, 0, z), (w, 2 * y - w, rail), 0.0015, 4)
        for other in (-1, 1):
            mesh.box(wood, (sign * x, other * y, h / 2), (w, w, h), 0.0015, 4)
    return mesh


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, '..', 'meshes')
    os.makedirs(folder, exist_ok=True)

    def path(name):
        return os.path.join(folder, name)
    for draw in (table_top, table_frame, net, net_posts, paddle, tray, floor):
        draw().write(path(draw.__name__ + '.dae'))
    write_png(path('table_top.png'), 512, 256, table_pixel(512, 256))
    write_png(path('floor.png'), 256, 256, floor_pixel(256))
    write_png(path('wood_light.png'), 128, 128, wood_pixel(128, (226, 190, 140), (176, 132, 84)))
    write_png(path('wood_dark.png'), 128, 128, wood_pixel(128, (176, 118, 66), (104, 62, 32)))


if __name__ == '__main__':
    main()

#!/usr/bin/env python3
"""Small whole files for the fuzzers of readers to start from: make_seeds.py KIND FOLDER [LIMPET].

KIND is scan, mesh, native or labels; native models are made by the program LIMPET. For scan and mesh the first byte
of an input chooses the format, in the order of any_case.hpp.
"""
import pathlib
import struct
import subprocess
import sys

POINTS = [(0.25 * i, 0.5 * (i % 3), -1.5) for i in range(6)]
SCANS = ["ply", "pcd", "xyz", "pwn"]
MESHES = ["off", "stl", "obj", "mesh-ply"]


def ply_scan(form):
    names = ["x", "y", "z", "nx", "ny", "nz"]
    head = f"ply\nformat {form} 1.0\ncomment made up\nelement vertex {len(POINTS)}\n"
    head += "".join(f"property {'float' if n < 'o' else 'double'} {n}\n" for n in names)
    head += "property int label\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    order = ">" if "big" in form else "<"
    if form == "ascii":
        return (head + "".join(f"{x} {y} {z} 0 0 1 {i}\n" for i, (x, y, z) in enumerate(POINTS)) + "3 0 1 2\n").encode()
    kinds = "".join("f" if n < "o" else "d" for n in names) + "i"
    body = b"".join(struct.pack(order + kinds, *p, 0, 0, 1, i) for i, p in enumerate(POINTS))
    return head.encode() + body + struct.pack(order + "Biii", 3, 0, 1, 2)


def lzf(data):
    """Literal runs only: the plainest valid packing."""
    return b"".join(bytes([len(data[i:i + 32]) - 1]) + data[i:i + 32] for i in range(0, len(data), 32))


def pcd_scan(form):
    head = "# .PCD v.7\nVERSION .7\nFIELDS x y z normal_x normal_y normal_z label\nSIZE 4 4 4 4 4 4 4\n"
    head += f"TYPE F F F F F F U\nCOUNT 1 1 1 1 1 1 1\nWIDTH {len(POINTS)}\nHEIGHT 1\nVIEWPOINT 0 0 5 1 0 0 0\n"
    head += f"POINTS {len(POINTS)}\nDATA {form}\n"
    rows = [struct.pack("<6fI", *p, 0, 0, 1, i) for i, p in enumerate(POINTS)]
    if form == "ascii":
        return (head + "".join(f"{x} {y} {z} 0 0 1 {i}\n" for i, (x, y, z) in enumerate(POINTS))).encode()
    if form == "binary":
        return head.encode() + b"".join(rows)
    columns = b"".join(row[4 * k:4 * k + 4] for k in range(7) for row in rows)
    packed = lzf(columns)
    return head.encode() + struct.pack("<II", len(packed), len(columns)) + packed


def scan_seeds():
    for form in ("ascii", "binary_little_endian", "binary_big_endian"):
        yield 0, ply_scan(form)
    for form in ("ascii", "binary", "binary_compressed"):
        yield 1, pcd_scan(form)
    lines = "".join(f"{x} {y} {z}\n" for x, y, z in POINTS)
    yield 2, lines.encode()
    yield 2, ("# x y z ax ay az label\n" + "".join(f"{x} {y} {z} 0 0 -1 7\n" for x, y, z in POINTS)).encode()
    yield 2, ('"X","Y","Z","Nx","Ny","Nz"\r\n' + "".join(f"{x},{y},{z},0,0,1\r\n" for x, y, z in POINTS)).encode()
    yield 3, "".join(f"{x} {y} {z} 0 0 1\n" for x, y, z in POINTS).encode()


TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])


def mesh_seeds():
    vertices, faces = TETRAHEDRON
    rows = "".join(f"{x} {y} {z}\n" for x, y, z in vertices)
    lists = "".join(f"3 {a} {b} {c}\n" for a, b, c in faces)
    yield 0, f"OFF\n# a comment\n4 4 6\n{rows}{lists}".encode()
    yield 0, f"COFF\n4 4 0\n{rows.replace(chr(10), ' 255 0 0 255' + chr(10))}{lists}".encode()
    corners = [[vertices[i] for i in face] for face in faces]
    yield 1, ("solid t\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in c) + "endloop\nendfacet\n"
        for c in corners) + "endsolid t\n").encode()
    yield 1, b"\0" * 80 + struct.pack("<I", 4) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *[float(v) for p in c for v in p], 0) for c in corners)
    yield 2, ("# t\n" + "".join(f"v {x} {y} {z}\n" for x, y, z in vertices) + "vn 0 0 1\n" +
              "".join(f"f {a + 1}//1 {b + 1} {c + 1}/1/1\n" for a, b, c in faces) + "f -1 -2 -3\n").encode()
    head = "ply\nformat {} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    head += "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    yield 3, (head.format("ascii") + rows + lists).encode()
    yield 3, head.format("binary_little_endian").encode() + b"".join(struct.pack("<3f", *p) for p in vertices) + b"".join(
        struct.pack("<B3i", 3, *f) for f in faces)


def native_seeds(limpet, folder):
    for shape, points, more in (("cube", 250, []), ("open_box", 300, ["--noise", "0.01"]), ("plate3", 400, ["--open"]),
                                ("L", 500, ["--redundancy", "3,0.1"])):
        scan, model = folder / "seed.ply", folder / "seed.limpet"
        subprocess.run([limpet, "scan", shape, "-o", scan, "--points", str(points), "--order", "sampled", "-q"], check=True)
        subprocess.run([limpet, "model", scan, "-o", model, "-q", *more], check=True, stderr=subprocess.DEVNULL)
        yield None, model.read_bytes()
        scan.unlink(), model.unlink()


def main():
    kind, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    seeds = {"scan": scan_seeds, "mesh": mesh_seeds,
             "native": lambda: native_seeds(sys.argv[3], folder),
             "labels": lambda: [(None, b"1\n2\n0\n-1\n"), (None, ply_scan("ascii"))]}
    for i, (first, data) in enumerate(seeds[kind]() if kind in seeds else []):
        (folder / f"seed{i}").write_bytes((b"" if first is None else bytes([first])) + data)


if __name__ == "__main__":
    main()

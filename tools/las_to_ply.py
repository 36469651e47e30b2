#!/usr/bin/env python3
# Copyright the limpet authors. GPL-3.0-or-later.
"""Writes the points of a LAS file (ASPRS LAS 1.0 to 1.4, not compressed) to standard output as a binary PLY
with `double x y z` and `uchar classification`, as it comes: tools/las_to_ply.py in.las | limpet model - -o m.limpet
Needs nothing but Python."""
import struct
import sys


def fail(path, what):
    sys.exit(f"{path}: {what}")


def read_header(file, path):
    """(offset of the points, bytes of a record, points, scale, shift, place of the class, its mask)"""
    head = file.read(227)
    if len(head) < 227 or head[:4] != b"LASF":
        fail(path, "is no LAS file")
    minor, header_size = head[25], struct.unpack_from("<H", head, 94)[0]
    offset, = struct.unpack_from("<I", head, 96)
    point_format, record, count = struct.unpack_from("<BHI", head, 104)
    if point_format & 0xC0:
        fail(path, "is compressed (LAZ); convert it to LAS first, see docs/scans.md")
    if point_format > 10 or record < (20 if point_format < 6 else 30):
        fail(path, f"has points of the unknown format {point_format}, {record} bytes each")
    scale, shift = struct.unpack_from("<3d", head, 131), struct.unpack_from("<3d", head, 155)
    if minor >= 4 and header_size >= 375:
        rest = file.read(375 - 227)
        if len(rest) == 375 - 227:
            count = struct.unpack_from("<Q", rest, 247 - 227)[0] or count
    # The class is the whole of a byte since format 6, and five bits of one before.
    place, mask = (16, 0xFF) if point_format >= 6 else (15, 0x1F)
    return offset, record, count, scale, shift, place, mask


def convert(path, out):
    with open(path, "rb") as file:
        offset, record, count, scale, shift, place, mask = read_header(file, path)
        file.seek(offset)
        out.write(b"ply\nformat binary_little_endian 1.0\n")
        out.write(f"element vertex {count}\n".encode())
        out.write(b"property double x\nproperty double y\nproperty double z\n")
        out.write(b"property uchar classification\nend_header\n")
        done = 0
        while done < count:
            block = file.read(record * min(count - done, 8192))
            points = len(block) // record
            if points == 0:
                fail(path, f"ends after {done} of the {count} points its header promises")
            lines = bytearray()
            for start in range(0, points * record, record):
                grid = struct.unpack_from("<3i", block, start)
                lines += struct.pack("<3dB", *(s * k + o for s, k, o in zip(scale, grid, shift)),
                                     block[start + place] & mask)
            out.write(lines)
            done += points


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: las_to_ply.py IN.las > OUT.ply")
    try:
        convert(sys.argv[1], sys.stdout.buffer)
    except BrokenPipeError:
        sys.exit(1)
    except OSError as error:
        fail(sys.argv[1], error.strerror)

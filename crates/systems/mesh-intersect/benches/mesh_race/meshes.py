#!/usr/bin/env python3
"""Closed meshes of published packages, for the bench `mesh_race`: fetches the packages and writes a folder of meshes.

    python3 meshes.py FOLDER CHECK

needs trimesh, which reads the files, and the clients `pip`, `npm`, `apt-get` and `dpkg-deb`. CHECK is the program of `cgal.cpp`: it
takes a mesh iff it is a closed manifold that does not cross itself, and orients it so that it bounds a volume. Vertices at one place
are merged, and triangles with a corner twice are dropped; nothing else is repaired. Files with the same triangles count once.

FOLDER gets `NAME.bin` for each mesh (see `mesh_race.rs`) and `meshes.csv`, the list with package, version, file and triangles;
`refused.csv` counts the files that are not taken, by reason.
"""

import collections
import csv
import gzip
import hashlib
import io
import pathlib
import subprocess
import sys
import tarfile
import zipfile

import numpy
import trimesh

# Client, package, version and SHA-256 of the archive.
PACKAGES = [
    ("apt", "libcgal-demo", "5.5.1-2", "78b09b23d4d6d1bf15552a1060b419ab3fc09918486462faed197e5fc6ac3735"),
    ("apt", "geomview", "1.9.5-4+b1", "b80d2d4f1f8fc6e3a76ecfd97b379bdf693836dd264a42a85c627eacbb7893f2"),
    ("apt", "openscad-testing-data", "2021.01-6", "4a05b16116ca8da7cb10224809f66094a991d5b4d7de75c087d1d85120536857"),
    ("npm", "stl-models", "0.12.0", "31dfbf87e748d2925ed89cf3af8e2d429db9e0d8cdd02c1a1ea183a9aea9b7a2"),
    ("pip", "dm-control", "1.0.50", "5434e1e51ff69016867426da7df6064b18d140e4d0a628f879bbcf0e7d0a586d"),
    ("pip", "example-robot-data", "6.0.0", "424092a8093411ac2cd4ccc0572382bfc6b5eb4833aa984ef5e671dd67cd0a6e"),
    ("pip", "flybrains", "0.6.3", "a74755ea5db431864458356384a234ce2f30d7856e099a2bcf9e55e117196d95"),
    ("pip", "gmsh", "4.15.2", "4076a948ce22625330d1413d4982e22b5c69fc2f0f7951f5df64c778cf54108c"),
    ("pip", "navis", "1.12.0", "5757c494950719f8453c8e481d647504ecaf46fad81800fa1822d44af52df308"),
    ("pip", "pymeshlab", "2025.7.post1", "c3c1b01f101334b14469ace3b004382cd313b80a128f551a1da77e3053f09c30"),
    ("pip", "pyvista", "0.49.1", "e4bd78c829051207e885281c45d03280dcde25445e1885c0824518ea7849b1c8"),
    ("pip", "robosuite", "1.5.2", "b9e02df55de8949739de6ba1d196d2ba59cf33c51a76efcfbe5c2f73cdcf99ce"),
    ("pip", "rtb-data", "2.0.0", "ecbcad669eb4d91ef971311640683eab19e2310f2a2be5c04fa5d32c6f0efce6"),
]
FEWEST, MOST = 12, 1_000_000  # triangles
CLIENTS = {
    "pip": lambda name, version: [
        *[sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:"],
        *["--python-version=3.11", "--implementation=cp"],
        *["--platform=manylinux_2_24_x86_64", "--platform=manylinux_2_35_x86_64", f"{name}=={version}"],
    ],
    "npm": lambda name, version: ["npm", "pack", "--silent", f"{name}@{version}"],
    "apt": lambda name, version: ["apt-get", "download", "--quiet", f"{name}={version}"],
}


def archive(folder, client, name, version, sha256):
    """The archive of a package, downloaded once and verified."""
    home = folder / "packages" / name
    home.mkdir(parents=True, exist_ok=True)
    if not any(home.iterdir()):
        subprocess.run(CLIENTS[client](name, version), cwd=home, check=True, stdout=subprocess.DEVNULL)
    (path,) = home.iterdir()
    found = hashlib.sha256(path.read_bytes()).hexdigest()
    if found != sha256:
        sys.exit(f"{path} has SHA-256 {found}, not {sha256}: don't use it; find out who changed it")
    return path


def members(path, read):
    """The files in an archive, with their paths; archives in it are opened too."""
    suffix = path.rsplit(".", 1)[-1].lower()
    if suffix in ("whl", "zip"):
        with zipfile.ZipFile(io.BytesIO(read())) as files:
            for name in files.namelist():
                yield from members(name, lambda name=name: files.read(name))
    elif suffix == "deb":
        unpack = ["dpkg-deb", "--fsys-tarfile", "-"]
        yield from members("data.tar", lambda: subprocess.run(unpack, input=read(), capture_output=True, check=True).stdout)
    elif path.endswith((".tar", ".tgz", ".tar.gz")):
        with tarfile.open(fileobj=io.BytesIO(read())) as files:
            for file in filter(tarfile.TarInfo.isfile, files):
                yield from members(file.name, lambda file=file: files.extractfile(file).read())
    elif suffix == "gz":
        yield from members(path[:-3], lambda: gzip.decompress(read()))
    elif suffix in ("off", "obj", "ply", "stl"):
        yield path, suffix, read()


def triangles(suffix, data):
    """The points and triangles of a file; equal points are one."""
    options = {"skip_materials": True} if suffix == "obj" else {}
    parts = trimesh.load_scene(io.BytesIO(data), suffix, process=False, **options).geometry.values()
    starts = numpy.cumsum([0, *(len(part.vertices) for part in parts)])
    points, places = numpy.unique(numpy.concatenate([part.vertices for part in parts]) + 0.0, axis=0, return_inverse=True)
    corners = numpy.concatenate([start + part.faces for start, part in zip(starts, parts)])
    corners = places.reshape(-1)[corners]
    a, b, c = corners.T
    corners = corners[(a != b) & (b != c) & (c != a)]
    used, corners = numpy.unique(corners, return_inverse=True)
    return points[used], corners.reshape(-1, 3)


def refusal(points, corners):
    """Why these triangles are no mesh of the race, as far as numpy can tell."""
    if not FEWEST <= len(corners) <= MOST:
        return "size"
    if not numpy.isfinite(points).all():
        return "coordinates"
    edges = corners[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    ends = numpy.sort(edges, axis=1)
    if (numpy.unique(ends, axis=0, return_counts=True)[1] != 2).any():
        return "an edge without two triangles"
    return None


def main(folder, check):
    folder.mkdir(parents=True, exist_ok=True)
    taken, refused, seen = [], collections.Counter(), set()
    for client, name, version, sha256 in PACKAGES:
        path = archive(folder, client, name, version, sha256)
        for file, suffix, data in members(path.name, path.read_bytes):
            try:
                points, corners = triangles(suffix, data)
                why = refusal(points, corners)
            except Exception as error:  # of any kind: readers of foreign files
                why = f"not read: {type(error).__name__}"
            if why is None:
                digest = hashlib.sha256(points.tobytes() + numpy.sort(corners, axis=None).tobytes()).digest()
                why = "twice" if digest in seen else None
                seen.add(digest)
            if why is None:
                at = folder / f"{len(taken):04}.bin"
                counts = numpy.array([len(points), len(corners)], "<u8")
                at.write_bytes(counts.tobytes() + points.astype("<f8").tobytes() + corners.astype("<u4").tobytes())
                said = subprocess.run([check, "--check", at], capture_output=True, text=True, timeout=600)
                why = said.stdout.strip() or (f"check: {said.returncode}" if said.returncode else None)
            if why is None:
                taken.append([at.name, client, name, version, file, len(corners)])
            else:
                refused[name, why] += 1
        print(name, version, sum(row[2] == name for row in taken), file=sys.stderr)
    with open(folder / "meshes.csv", "w", newline="") as out:
        csv.writer(out).writerows([["mesh", "client", "package", "version", "file", "triangles"], *taken])
    with open(folder / "refused.csv", "w", newline="") as out:
        csv.writer(out).writerows([["package", "why", "files"], *([*key, count] for key, count in sorted(refused.items()))])
    if stray := folder / f"{len(taken):04}.bin":
        stray.unlink(missing_ok=True)


if len(sys.argv) != 3:
    sys.exit("usage: meshes.py FOLDER CHECK")
main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve())

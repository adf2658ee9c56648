#!/usr/bin/env python3
"""Fails on an include that the architecture forbids.

Each room may include itself, the rooms of its row, and the third-party headers of its row. The table
is the one of docs/architecture.md; change both together.
"""
import re
import subprocess
import sys

# What crosses the wire, and nothing of the solver or of the hosts of plugins.
WIRE = ("compare/comparison.hpp", "edit/report.hpp", "fem/load_case.hpp", "fem/quantities.hpp", "fem/receipt.hpp", "fem/solve_report.hpp", "ops/sdk", "mesh", "base")
CLIENT_QT_BELOW = ("client-qt/net", "client", "protocol", *WIRE)

# Their headers have no folder.
OPENCASCADE = ("BRep", "GProp_", "Geom", "IGES", "Interface_", "NCollection_", "Quantity_", "STEP", "Standard_", "Step", "TColStd_", "TCollection_",
               "TDF_", "TDataStd_", "TDocStd_", "TopExp", "TopLoc_", "TopTools_", "TopoDS", "Transfer", "XCAF", "XSControl_")

# room: (other rooms or single headers of theirs, third-party prefixes). The longest room that is a prefix of a path
# owns it.
ROOMS = {
    "base": ((), ("tl/", "xxhash.h")),
    "base/logging": (("base",), ("spdlog/", "fmt/")),
    "base/tracing": (("base/logging", "base"), ("nlohmann/",)),
    "sandbox": (("base",), ("seccomp.h",)),
    "certs": (("base",), ("openssl/",)),
    "tls": (("certs", "base"), ("boost/", "openssl/")),
    "mesh": (("base",), ("Eigen/",)),
    "mesh/predicates.cpp": (("mesh", "base"), ("CGAL/",)),
    "mesh/io": (("mesh", "base"), ("nlohmann/", "pugixml", "zlib.h")),
    "mesh/med": (("mesh/io", "mesh", "sandbox", "base"), ("med.h",)),
    "gpu": (("base",), ("volk.h", "vulkan/")),
    "shaders": ((), ()),
    "fem": (("mesh", "base"), ("Eigen/",)),
    "fem/multilevel": (("fem", "mesh", "base"), ("Eigen/",)),
    "fem/native": (("fem/multilevel", "fem", "mesh", "base"), ("Eigen/",)),
    "fem/vulkan": (("fem/multilevel", "fem", "gpu", "shaders", "mesh", "base"), ("Eigen/",)),
    "fem/solver.cpp": (("fem", "fem/native", "fem/vulkan", "mesh", "base"), ("Eigen/",)),
    "fem/devices.cpp": (("fem", "fem/native", "fem/vulkan", "mesh", "base"), ("Eigen/",)),
    "compare": (("fem/load_case.hpp", "mesh", "base"), ()),
    "verification": (("fem", "mesh", "base"), ("Eigen/",)),
    "ops/sdk": (("mesh", "base"), ()),
    "ops/shapes": (("ops/shapes/walls", "ops/tools", "ops/sdk", "mesh", "base"), ()),
    "ops/shapes/caps": (("ops/sdk", "mesh", "base"), ("Eigen/",)),
    "ops/shapes/deform": (("ops/sdk", "mesh", "base"), ("Eigen/",)),
    "ops/shapes/walls": (("ops/sdk", "mesh", "base"), ()),
    "ops/shapes/features": (("ops/shapes/caps", "ops/shapes", "ops/tools", "ops/sdk", "mesh", "base"), ()),
    "ops/shapes/isosurface": (("ops/sdk", "mesh", "base"), ("Eigen/",)),
    "ops/shapes/outlines": (("ops/tools", "ops/sdk", "mesh", "base"), ("pugixml",)),
    "ops/shapes/rounding": (("ops/shapes", "ops/sdk", "mesh", "base"), ()),
    "ops/loader": (("sandbox", "ops/services/notices.hpp", "ops/tools", "ops/sdk", "mesh", "base"), ("CGAL/",)),
    "ops/tools": (("ops/sdk", "mesh", "base"), ()),
    "ops/tools/text": (("ops/tools", "ops/sdk", "mesh", "base"), ("ft2build.h",)),
    "ops/tools/files": (("ops/tools", "ops/sdk", "mesh/io", "mesh", "base"), ("CGAL/",)),
    "ops/mesher": (("sandbox", "ops/sdk", "mesh", "base"), ("tetgen.h", "CGAL/")),
    "ops/boolean": (("ops/mesher", "ops/tools", "ops/sdk", "mesh", "base"), ()),
    "ops/services": (("ops/boolean", "ops/mesher", "ops/sdk", "mesh", "base"), ("CGAL/",)),
    "ops/conformance": (("sandbox", "ops/loader", "ops/services", "ops/sdk", "mesh", "base"), ()),
    "ops/probe": (("sandbox", "ops/loader", "ops/sdk", "mesh", "base"), ()),
    "ops/hollow": (("ops/shapes/isosurface", "ops/tools", "ops/sdk", "mesh", "base"), ("CGAL/",)),
    "ops/combine": (("ops/tools/files", "ops/tools", "ops/sdk", "mesh/io", "mesh", "base"), ()),
    "ops/": (
        ("ops/shapes/caps", "ops/shapes/deform", "ops/shapes/features", "ops/shapes/outlines", "ops/shapes/walls", "ops/shapes/rounding", "ops/shapes", "ops/tools/text", "ops/tools", "ops/sdk", "mesh", "base"), ()),
    "edit": (("ops/loader", "ops/services", "ops/sdk", "fem", "mesh", "base"), ()),
    "cad": (("edit", "ops/combine", "ops/emboss/emboss.hpp", "ops/loader", "ops/pattern/pattern.hpp", "ops/rib/rib.hpp", "ops/sdk", "ops/services", "ops/shapes/features", "ops/shapes/outlines", "ops/shapes/walls/carried_surfaces.hpp", "ops/sweep/sweep_along.hpp", "ops/tools", "mesh/features", "mesh/io", "mesh", "base"), ("nlohmann/",)),
    "cad/teller.cpp": (("cad", "sandbox", "base"), ()),
    "cad/reader": (("cad", "mesh/spline_surface.hpp", "mesh/types.hpp", "base"), OPENCASCADE),
    "cad/editor": (("cad", "mesh", "base"), OPENCASCADE),
    "cad/writer": (("cad", "base"), OPENCASCADE),
    "cad/mesher": (("cad", "mesh", "base"), ("gmsh.h",)),
    "scan": (("cad", "mesh/segment", "mesh/features", "mesh/io", "mesh", "base"), ()),
    "scan/reader": (("scan", "cad", "mesh/segment", "mesh/features", "mesh/io", "mesh", "base"), ("pugixml", "zlib.h")),
    "scan/reader/exact_checks.cpp": (("scan/reader", "scan", "cad", "mesh", "base"), ("CGAL/",)),
    "scan/mesher": (("scan", "cad", "cad/mesher", "mesh", "base"), ("gmsh.h",)),
    "protocol": (WIRE, ("tedit/v1/", "google/")),
    "decks": (("protocol", "fem", "mesh/io", "mesh", "base"), ()),
    "client": (("tls", "certs", "protocol", *WIRE), ("boost/", "tedit/v1/", "google/")),
    "client/recipes": (("client", "protocol", *WIRE), ("nlohmann/",)),
    "actors/links": (("certs", "base/logging", "base"), ("caf/", "boost/", "openssl/")),
    "actors/cad": (("actors", "cad", "scan", "protocol", "edit", "fem", "ops/sdk", "mesh/io", "mesh", "base"), ("caf/", "nlohmann/")),
    "actors": (
        ("actors/cad", "actors/links", "base/logging", "base/tracing", "sandbox", "decks", "protocol", "compare", "edit", "fem", "fem/native", "ops/loader", "ops/services", "ops/sdk", "mesh/io", "mesh", "base"),
        ("caf/", "sqlite3.h", "zstd.h", "nlohmann/"),
    ),
    "actors/node/server.cpp": (("base/logging", "base/tracing", "actors/cad", "actors/gateway", "actors", "sandbox", "base"), ("caf/",)),
    "actors/gateway": (
        ("base/logging", "base/tracing", "tls", "actors", "protocol", "compare", "fem", "ops/sdk", "mesh", "base"),
        ("caf/", "boost/", "google/", "tedit/v1/", "openssl/", "nlohmann/"),
    ),
    "node": (("actors", "fem", *WIRE), ("caf/",)),
    "cli": (
        ("base/logging", "cad", "scan", "certs", "tls", "sandbox", "actors/cad", "actors/links", "actors", "client", "decks", "protocol", "compare", "edit", "verification", "fem", "ops/conformance",
         "ops/loader", "ops/services", "ops/sdk", "mesh/io", "mesh", "base", "actors/gateway/users.hpp"),
        ("CLI/", "nlohmann/", "fmt/", "toml++/"),
    ),
    "cli/render": (("cli/number_option.hpp", "base"), ("vtk", "CLI/", "nlohmann/")),
    "examples": (("client", "protocol", *WIRE), ()),
    "examples/node": (("node", "fem", *WIRE), ()),
    "client-qt/net": (("client", "protocol", *WIRE), ()),
    "client-qt/model": (CLIENT_QT_BELOW, ()),
    "client-qt/view": (("client-qt/model", *CLIENT_QT_BELOW), ("vtk",)),
    "client-qt/widgets": (("client-qt/view", "client-qt/model", *CLIENT_QT_BELOW), ("vtk",)),
    "client-qt/context": (("client-qt/widgets", "client-qt/view", "client-qt/model", *CLIENT_QT_BELOW), ("vtk",)),
    "client-qt/tools": (
        ("client-qt/context", "client-qt/widgets", "client-qt/view", "client-qt/model", *CLIENT_QT_BELOW), ("vtk",)),
    "client-qt": (
        ("client-qt/window", "client-qt/tools", "client-qt/context", "client-qt/widgets", "client-qt/view",
         "client-qt/model", *CLIENT_QT_BELOW), ("vtk",)),
}
ANYWHERE = ("tests/", "bench/")  # may include every room
INCLUDE = re.compile(r'^\s*#\s*include\s+(?:"([^"]+)"|<([^>]+)>)')


def owner(path):
    best = None
    for room in ROOMS:
        exact = path == room
        inside = path.startswith(room if room.endswith("/") else room + "/")
        if (exact or inside) and (best is None or len(room) > len(best)):
            best = room
    return best


def is_third_party(header):
    # Standard and system headers have no slash and no upper-level folder of ours; what has one of
    # the known prefixes is third-party.
    prefixes = {p for _, parties in ROOMS.values() for p in parties}
    return any(header.startswith(p) for p in prefixes)


def check(path, known):
    room = None if "/tests/" in path else owner(path)
    if room is None and "/tests/" in path:
        return []
    if room is None:
        return [] if path.startswith(ANYWHERE) else [f"{path}: belongs to no room of the table"]
    rooms, parties = ROOMS[room]
    faults = []
    with open(path, encoding="utf-8") as source:
        for number, line in enumerate(source, 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            header = match.group(1) or match.group(2)
            where = f"{path}:{number}"
            if header in known:
                if owner(header) not in (room, *rooms) and header not in rooms:
                    faults.append(f"{where}: {room} may not include {owner(header)} ({header})")
            elif is_third_party(header) and not header.startswith(tuple(parties) or ("\0",)):
                faults.append(f"{where}: {room} may not include <{header}>")
    return faults


def main():
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.cpp", "*.hpp", "*.h"],
        check=True, capture_output=True, text=True).stdout.split()
    known = set(listed)
    faults = []
    for path in sorted(listed):
        faults += check(path, known)
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults:
        print(f"{len(faults)} forbidden includes", file=sys.stderr)
        return 1
    print(f"include rules hold in {len(listed)} files")
    return 0


if __name__ == "__main__":
    sys.exit(main())

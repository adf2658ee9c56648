"""The meshes of the comparison: a cantilever in three sizes, made by gmsh, and the parts of given folders."""
import lzma
import pathlib
import shutil
from dataclasses import dataclass

from peers import process

HERE = pathlib.Path(__file__).resolve().parent
# Name and element size in mm (cantilever.geo). The largest one is for linear tets: with quadratic ones the assembled
# matrices of the others take 5 GB and their factors more than most machines have.
CANTILEVERS = (("cantilever-44k", 81.5, (1, 2)), ("cantilever-176k", 50.5, (1, 2)), ("cantilever-942k", 28.8, (1,)))
LEVELS = ("coarse", "medium", "fine")


@dataclass
class Mesh:
    """A mesh with its load case. `source` is a mesh file, packed or not; None: gmsh makes it."""

    name: str
    load_case: pathlib.Path
    orders: tuple
    source: pathlib.Path = None
    size: float = 0


def cantilevers():
    return [Mesh(name, HERE / "cantilever.json", orders, size=size) for name, size, orders in CANTILEVERS]


def parts(folder):
    """NAME.LEVEL.msh or .msh.xz beside a load_case.json, in the folder or one below it."""
    found = []
    folder = pathlib.Path(folder).resolve()
    for load_case in sorted(folder.glob("load_case.json")) + sorted(folder.glob("*/load_case.json")):
        for level in LEVELS:
            plain = sorted(load_case.parent.glob(f"*.{level}.msh"))
            packed = sorted(load_case.parent.glob(f"*.{level}.msh.xz"))
            for source in plain or packed:
                part = source.name.split(".")[0]
                found.append(Mesh(f"{part}-{level}", load_case, (1, 2), source=source))
    return found


def chosen(meshes, patterns):
    """Those whose name holds one of the patterns; all without patterns."""
    return [m for m in meshes if not patterns or any(p in m.name for p in patterns)]


def prepare(mesh, folder):
    """The mesh as a plain file; made, unpacked or copied when it is not there yet. Raises OSError with the reason."""
    if mesh.source and mesh.source.suffix != ".xz":
        return mesh.source
    target = folder / f"{mesh.name}.msh"
    if process.is_newer(target, mesh.source or HERE / "cantilever.geo"):
        return target
    folder.mkdir(parents=True, exist_ok=True)
    draft = target.with_name("draft-" + target.name)
    if mesh.source:
        with lzma.open(mesh.source) as packed, open(draft, "wb") as plain:
            shutil.copyfileobj(packed, plain)
    else:
        made = process.run(["gmsh", HERE / "cantilever.geo", "-3", "-nt", "1", "-setnumber", "h", mesh.size, "-o", draft],
                           process.Limits())
        if made.status != "ok":
            raise OSError(f"gmsh could not make {mesh.name}: {made.errors or made.status}")
    draft.rename(target)
    return target

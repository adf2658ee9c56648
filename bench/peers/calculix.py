"""Cold solves by CalculiX on the decks of `tedit export`: what its output says of displacement and phases."""
import math
import re

from peers import process

# What CalculiX prints when a phase begins; the last one ends the solve, and is printed before the structure, too.
STRUCTURE = "setting up the structure of the matrix"
SOLVE = ("Factoring the system of equations", "iteration=", "Solving the system of equations")
STRESS = "for the stress calculation"


def read_loads(deck):
    """{(node, direction): N} of the deck's *CLOAD lines."""
    loads = {}
    inside = False
    with open(deck, encoding="ascii") as file:
        for line in file:
            if line.startswith("*"):
                inside = line.strip().upper() == "*CLOAD"
            elif inside:
                node, direction, value = line.split(",")
                loads[int(node), int(direction)] = float(value)
    return loads


def read_displacement(lines):
    """{node: (ux, uy, uz)} of the block of displacements in a .dat file."""
    result = {}
    inside = False
    for line in lines:
        words = line.split()
        if len(words) > 1 and not words[0].lstrip("-").isdigit():
            inside = words[0] == "displacements"
        elif inside and len(words) == 4:
            result[int(words[0])] = tuple(float(word) for word in words[1:])
    return result


def compliance(loads, displacement):
    """f.u, J."""
    return math.fsum(force * displacement[node][direction - 1] for (node, direction), force in loads.items())


def largest(displacement):
    """The longest displacement, m."""
    return max(math.hypot(*u) for u in displacement.values())


def phases(lines):
    """CPU seconds of set-up (structure and matrix) and of the solve; None when the output has not all marks."""
    begin = solve = end = None
    for cpu, line in lines:
        if cpu is None:
            continue
        if begin is None and STRUCTURE in line:
            begin = cpu
        elif begin is not None and solve is None and any(mark in line for mark in SOLVE):
            solve = cpu
        elif solve is not None and end is None and STRESS in line:
            end = cpu
    if end is None:
        return None
    return {"setup_cpu_s": solve - begin, "solve_cpu_s": end - solve}


def iterations(output):
    """Of the iterative solver; 0 for a direct one."""
    match = re.search(r"# of iterations = *(\d+)", output)
    return int(match.group(1)) if match else 0


def export_deck(tedit, mesh, load_case, order, solver, deck):
    """Writes the deck when it is missing or older than the mesh; returns what went wrong."""
    if process.is_newer(deck, mesh, load_case):
        return None
    deck.parent.mkdir(parents=True, exist_ok=True)
    done = process.run([tedit, "export", mesh, "--load-case", load_case, "--order", order, "--solver", solver, "-o", deck],
                       process.Limits())
    return None if done.status == "ok" else done.errors.split("\n")[-1] or "tedit export failed"


def solve(deck, limits, tets, order):
    """One run of ccx: its figures, or why there are none."""
    job = deck.with_suffix("")
    done = process.run(["stdbuf", "-oL", "ccx", "-i", job.name], limits, folder=deck.parent, watch=True)
    result = {"status": done.status, "run_s": done.wall_s}
    try:
        if done.status != "ok":
            return result if done.status == "over_limit" else dict(
                result, why=(done.errors or done.output.strip()).split("\n")[-1][:200])
        times = phases(done.lines)
        with open(job.with_suffix(".dat"), encoding="ascii") as file:
            displacement = read_displacement(file)
        if times is None or not displacement:
            errors = re.findall(r"\*ERROR.*", done.output)
            return dict(result, status="failed", why=errors[0] if errors else "no displacement in its output")
        result.update(times)
        result.update({
            "settings": "CalculiX 2.20", "tets": tets, "element_order": order, "unknowns": equations(done.output),
            "compliance_j": compliance(read_loads(deck), displacement), "max_displacement_m": largest(displacement),
            "iterations": iterations(done.output), "program_cpu_s": done.cpu_s, "wall_s": done.wall_s,
            "peak_mib": done.peak_mib})
        return result
    finally:
        for ending in (".frd", ".dat", ".cvg", ".sta", ".12d"):
            job.with_suffix(ending).unlink(missing_ok=True)


def equations(output):
    """The number of unknowns that CalculiX prints."""
    match = re.search(r"number of equations\s+(\d+)", output)
    return int(match.group(1)) if match else 0

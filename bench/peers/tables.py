"""Medians, accuracy and ratios of the runs, as one JSON object and as a Markdown table."""
import statistics

# What a repeated run is reduced to its median; the rest is taken from the last run.
MEDIANS = ("assembly_cpu_s", "setup_cpu_s", "solve_cpu_s", "program_cpu_s", "wall_s", "peak_mib")
# The compliance of the same equations must agree to six digits: else the entry is marked.
AGREEMENT = 1e-6
# These begin with the assembled matrix: beside them stands our time without the assembly, too.
GIVEN_THE_MATRIX = ("petsc", "cholmod", "eigen-cg", "eigen-ldlt")


def reduce_runs(runs):
    """One result from the runs of one solver on one case: medians, or the first run that was no success."""
    for run in runs:
        if run["status"] != "ok":
            return dict(run, runs=len(runs))
    result = dict(runs[-1], runs=len(runs))
    for key in MEDIANS:
        if key in result:
            result[key] = statistics.median(run[key] for run in runs)
    result["cpu_s"] = result["setup_cpu_s"] + result["solve_cpu_s"]
    result["bytes_per_tet"] = result["peak_mib"] * 2**20 / result["tets"]
    return result


def reference_of(results):
    """The solver with the least true residual; None when nothing was solved."""
    solved = [(r["true_relative_residual"], name) for name, r in results.items()
              if r["status"] == "ok" and "true_relative_residual" in r]
    return min(solved)[1] if solved else None


def compare(results):
    """Adds to the results of one case what they are beside each other: `results` is {solver: result}."""
    reference = reference_of(results)
    ours = results.get("ours")
    for name, r in results.items():
        if r["status"] != "ok":
            continue
        if reference:
            for key, off in (("compliance_j", "compliance_off"), ("max_displacement_m", "displacement_off")):
                r[off] = abs(r[key] / results[reference][key] - 1)
            r["agrees"] = r["compliance_off"] <= AGREEMENT
        if ours and ours["status"] == "ok":
            # CalculiX is one program from the deck to the fields; its phases stand beside our set-up and solve.
            r["cpu_ratio"] = r["cpu_s"] / ours["cpu_s"]
            if name in GIVEN_THE_MATRIX:
                r["cpu_ratio_from_matrix"] = r["cpu_s"] / (ours["cpu_s"] - ours["assembly_cpu_s"])
            r["memory_ratio"] = r["peak_mib"] / ours["peak_mib"]
            if name == "ours-two-cores":
                r["wall_speed_up"] = ours["wall_s"] / r["wall_s"]
    return {"reference": reference, "solvers": results}


HEAD = ("mesh", "order", "unknowns", "solver", "compliance off", "largest displacement off", "true residual",
        "iterations", "set-up CPU s", "solve CPU s", "CPU s", "wall s", "peak MiB", "bytes a tet", "CPU / ours",
        "CPU / ours without assembly", "memory / ours")
STATUS = {"over_limit": "over the limit", "failed": "failed", "skipped": "skipped"}


def short(value, pattern):
    return "-" if value is None else pattern % value


def row(case, name, r):
    """One line of the table, as cells."""
    head = [case["mesh"], str(case["order"])]
    if r["status"] != "ok":
        why = " ".join(r.get("why", "").replace("|", "/").split())
        return head + ["", name, STATUS[r["status"]] + (f": {why}" if why else "")] + [""] * 12
    mark = "" if r.get("agrees", True) else " **disagrees**"
    off = ["reference", "reference"]
    if name != case["reference"]:
        off = [short(r.get("compliance_off"), "%.0e") + mark, short(r.get("displacement_off"), "%.0e")]
    return head + [
        f"{r['unknowns']:,}", name, *off, short(r.get("true_relative_residual"), "%.1e"),
        str(r["iterations"] or "-"), "%.2f" % r["setup_cpu_s"], "%.2f" % r["solve_cpu_s"], "%.2f" % r["cpu_s"],
        "%.2f" % r["wall_s"], "%.0f" % r["peak_mib"], "%.0f" % r["bytes_per_tet"],
        short(r.get("cpu_ratio"), "%.2f"), short(r.get("cpu_ratio_from_matrix"), "%.2f"),
        short(r.get("memory_ratio"), "%.2f")]


def markdown(cases):
    """The table of all cases, and our speed-up by a second core."""
    lines = ["| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD)]
    gains = []
    for case in cases:
        for name, r in case["solvers"].items():
            if name != "ours-two-cores":
                lines.append("| " + " | ".join(row(case, name, r)) + " |")
            elif "wall_speed_up" in r:
                gains.append(f"| {case['mesh']} | {case['order']} | {case['solvers']['ours']['wall_s']:.2f} | "
                             f"{r['wall_s']:.2f} | {r['wall_speed_up']:.2f} |")
    if gains:
        lines += ["", "| mesh | order | ours, wall s on one core | on two | speed-up |", "|---|---|---|---|---|"] + gains
    return "\n".join(lines) + "\n"

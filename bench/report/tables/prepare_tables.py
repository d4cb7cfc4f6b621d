"""What preparing costs, and when it is paid back."""

from report import fits
from report.measurements import Measurements
from report.repetitions import median, spread_of
from report.tables.numbers import count, digits, percent, rounded, short, timed
from report.tables.table import Column, Table, Value


def prepare_table(found: Measurements) -> Table:
    """Preparing a mesh once, the memory it takes, and after how many cuts of fresh copies of the whole it is paid
    back."""
    table = Table("prepare", [Column("backend", "back end", short), Column("triangles", "triangles", count),
                              Column("prepare_ms", "prepare ms", timed),
                              Column("ns_per_triangle", "ns / triangle", timed),
                              Column("bytes_per_triangle", "bytes / triangle", digits(0)),
                              Column("cut_ms", "a cut, ms", timed),
                              Column("paid_back_remap", "paid back against remap, cuts of copies", rounded),
                              Column("paid_back_hash", "against hash, cuts of copies", rounded),
                              Column("spread", "spread of preparing", percent),
                              Column("repetitions", "repetitions", digits(0))])
    scale = found.growth("Scale", "asteroid")
    prepared = {(backend, size): c for backend, size, c in found.sized("Prepare")}
    for (backend, size), c in prepared.items():
        row: dict[str, Value] = {"backend": backend, "triangles": size, "prepare_ms": c["real_time"][0],
                                 "ns_per_triangle": c["ns_per_triangle"][0],
                                 "bytes_per_triangle": c["bytes_per_triangle"][0], "spread": spread_of(c, "real_time"),
                                 "repetitions": c["repetitions"][0]}
        row["cut_ms"] = median(scale.get((backend, size)), "real_time")
        linear = prepared.get(("baseline/remap", size))  # all lookups prepare alike
        for lookup in ("remap", "hash"):
            cut, other = scale.get((backend, size)), scale.get((f"baseline/{lookup}", size))
            if backend == "halfedge" and linear and cut and other:
                row[f"paid_back_{lookup}"] = fits.cuts_to_pay_back(c["real_time"][0], linear["real_time"][0],
                                                                  cut["real_time"][0], other["real_time"][0])
        table.rows.append(row)
    return table


def prepare_threads_table(found: Measurements) -> Table:
    """Preparing for the half-edge back end by one and by two threads: the time that passes."""
    table = Table("prepare_threads", [Column("triangles", "triangles", count), Column("one_ms", "one thread, ms", timed),
                                      Column("two_ms", "two threads, ms", timed),
                                      Column("two_to_one", "two / one", digits(2))])
    two = {size: c for variant, size, c in found.sized("PrepareThreads") if variant == "2/halfedge"}
    for variant, size, c in found.sized("PrepareThreads"):
        if variant == "1/halfedge" and size in two:
            one_ms, two_ms = c["real_time"][0], two[size]["real_time"][0]
            table.rows.append({"triangles": size, "one_ms": one_ms, "two_ms": two_ms, "two_to_one": two_ms / one_ms})
    return table


def from_arrays_table(found: Measurements) -> Table:
    """From the arrays of a program to an object that can be cut."""
    table = Table("from_arrays", [Column("backend", "back end", short), Column("triangles", "triangles", count),
                                  Column("make_ms", "Mesh::make() ms", timed), Column("prepare_ms", "prepare() ms", timed),
                                  Column("ns_per_triangle", "both, ns / triangle", timed),
                                  Column("spread", "spread", percent)])
    for backend, size, c in found.sized("FromArrays"):
        if backend in ("halfedge", "linear"):
            table.rows.append({"backend": backend, "triangles": size, "make_ms": c["make_ms"][0],
                               "prepare_ms": c["prepare_ms"][0], "ns_per_triangle": c["ns_per_triangle"][0],
                               "spread": spread_of(c, "real_time")})
    return table


def chain_balance_table(found: Measurements) -> Table:
    """One object that is cut to pieces, always the largest of them: preparing and all cuts so far, both back ends. The
    pieces take their object's place: they get smaller, and quicker cuts save less and less."""
    table = Table("chain_balance", [Column("triangles", "triangles", count), Column("cuts", "cuts so far", count),
                                    Column("remap_cutting_ms", "remap, cut() ms", timed),
                                    Column("halfedge_cutting_ms", "halfedge, cut() ms", timed),
                                    Column("remap_whole_ms", "remap, whole chain ms", timed),
                                    Column("halfedge_whole_ms", "halfedge, whole chain ms", timed),
                                    Column("extra_prepare_ms", "extra preparing ms", timed),
                                    Column("cutting_balance_ms", "balance of cut(), ms", signed_milliseconds),
                                    Column("balance_ms", "balance of the whole chain, ms", signed_milliseconds),
                                    Column("extra_on_two_ms", "extra preparing on two threads, ms", timed),
                                    Column("cutting_balance_on_two_ms", "balance of cut() then, ms", signed_milliseconds),
                                    Column("balance_on_two_ms", "balance of the whole chain then, ms", signed_milliseconds)])
    on_two = {size: c["real_time"][0] for variant, size, c in found.sized("PrepareThreads") if variant == "2/halfedge"}
    chains = {(variant, size): c for variant, size, c in found.sized("Chain")}
    prepared = {(backend, size): c for backend, size, c in found.sized("Prepare")}
    for variant, size in chains:
        needed = ((chains, ("kept/baseline/remap", size)), (prepared, ("halfedge", size)),
                  (prepared, ("baseline/remap", size)))
        if variant != "kept/halfedge" or any(key not in cells for cells, key in needed):
            continue
        half, linear = chains[(variant, size)], chains[("kept/baseline/remap", size)]
        linear_ms = prepared[("baseline/remap", size)]["real_time"][0]
        extra = prepared[("halfedge", size)]["real_time"][0] - linear_ms
        for mark in sorted(int(key.removeprefix("whole_ms_")) for key in half if key.startswith("whole_ms_")):
            row: dict[str, Value] = {"triangles": half["triangles"][0], "cuts": mark, "extra_prepare_ms": extra}
            for kind, balance in (("cutting", "cutting_balance_ms"), ("whole", "balance_ms")):
                ours, theirs = half[f"{kind}_ms_{mark}"][0], linear[f"{kind}_ms_{mark}"][0]
                row |= {f"remap_{kind}_ms": theirs, f"halfedge_{kind}_ms": ours, balance: theirs - ours - extra}
                if size in on_two:
                    extra_on_two = on_two[size] - linear_ms
                    row |= {"extra_on_two_ms": extra_on_two,
                            balance.replace("_ms", "_on_two_ms"): theirs - ours - extra_on_two}
            table.rows.append(row)
    return table


def choice_table(found: Measurements) -> Table:
    """How much longer a number of cuts takes with the back end that is chosen for it than with the better one."""
    judged = {name.removeprefix("Automatic/"): c for name, c in found.bench.items() if name.startswith("Automatic/")}
    numbers = sorted({int(key.removeprefix("to_better_")) for c in judged.values() for key in c
                      if key.startswith("to_better_")})
    columns = [Column(f"cuts_{number}", f"{number} cuts" if number > 1 else "1 cut", digits(2)) for number in numbers]
    table = Table("automatic_choice", [Column("mesh", "mesh"), Column("triangles", "triangles", count)] + columns +
                  [Column("worst", "worst", digits(2)), Column("worst_to_best", "worst, if fans counted", digits(2))])
    for name, c in sorted(judged.items(), key=lambda row: row[1]["triangles"][0]):
        kind, _, mesh = name.partition("/")
        row: dict[str, Value] = {"mesh": mesh if kind in ("model", "mesh") else kind, "triangles": c["triangles"][0],
                                 "worst": c["worst_to_better"][0], "worst_to_best": median(c, "worst_to_best")}
        table.rows.append(row | {f"cuts_{number}": c[f"to_better_{number}"][0] for number in numbers})
    return table


def signed_milliseconds(value: float) -> str:
    return f"{'+' if value > 0 else '−' if value < 0 else ''}{timed(abs(value))}"

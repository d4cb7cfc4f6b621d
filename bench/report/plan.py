"""Which stages a report consists of: what is run with which arguments, and about how long it takes."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from report.judged_caps import WorstFan
from report.names import (ASTEROID, BACKENDS, FASTEST, GALLERY, Kind, QUADRATIC, REAL_BACKENDS, SIZES,
                          SUBQUADRATIC, UNDRAWN)
from report.student_report import report_rows

VIEWER_SIZE = "160x90"  # drawn by a program on most machines: small, so that drawing does not hide cutting
VIEWER_SEED = 3
VIEWER_FRAMES = 160  # the autopilot cuts about ten times in them, like the report


@dataclass(frozen=True)
class Stage:
    """One program run. `arguments` are relative to the project's folder: results name no folder of a machine."""

    name: str
    kind: Kind
    arguments: tuple[str, ...]
    expected_seconds: float  # on a machine that does nothing else; only for the time left
    shape: tuple[str, ...] = ()  # `kerf shape` arguments that make the model this stage needs


@dataclass(frozen=True)
class Extent:
    """How much is measured."""

    name: str
    most_triangles: int
    repetitions: int
    most_quadratic: int  # triangles; the quadratic lookups take seconds above
    planes: int
    viewer_backends: tuple[str, ...]
    viewer_triangles: int


QUICK = Extent("quick", 100_000, 1, 10_000, 40, ("halfedge", "baseline/hash"), 30_000)
NORMAL = Extent("normal", 4_000_000, 3, 30_000, 200, tuple(reversed(BACKENDS)), 100_000)
FULL = Extent("full", 16_000_000, 3, 30_000, 200, tuple(reversed(BACKENDS)), 1_000_000)
TEXT_STAGES = ("cuts", "proxies", "prepare", "real", "model", "growth", "chain")  # how their names begin
VIEWER_OPPONENTS = ("baseline/remap", "halfedge")
VIEWER_RUNS = 5  # of each of them that count
SHOWN_FANS = 4  # in the gallery
MOST_FOR_PEERS = 100_000  # triangles
FRACTURE_SIZES = (10_000, 100_000, 1_000_000)
SECTION_SIZES = (10_000, 100_000, 1_000_000, 4_000_000)


def plan(extent: Extent, scratch: Path, with_vtk: bool = False, with_open3d: bool = False) -> list[Stage]:
    """All stages of a report, the quickest kinds first. `scratch` is where generated models go."""
    stages = compare_stages(extent) + bench_stages(extent) + peer_stages(extent, scratch, with_vtk, with_open3d)
    return stages + viewer_stages(extent, scratch)


def text_plan(extent: Extent) -> list[Stage]:
    """The stages of which `--text` prints tables: the report's models, growth, chains of cuts, preparing."""
    return [stage for stage in bench_stages(extent) if stage.name.partition("-")[0] in TEXT_STAGES]


def model_file(model: str) -> str:
    return f"data/models/{model}.obj"


def compare_stages(extent: Extent) -> list[Stage]:
    files = tuple(model_file(row["model"]) for row in report_rows())
    seconds = 0.03 * extent.planes
    return [Stage(f"compare-{mix}", Kind.COMPARE, ("--json", "--planes", str(extent.planes)) + flags + files, seconds)
            for mix, flags in (("nasty", ()), ("random", ("--random-only",)))]


def bench_stage(name: str, pattern: str, extent: Extent, min_time: float, seconds: float) -> Stage:
    """Arguments: the names' pattern, repetitions, and seconds that each is repeated for at least."""
    return Stage(name, Kind.BENCH, (pattern, str(extent.repetitions), str(min_time)), seconds * extent.repetitions)


def among(backends: Iterable[str]) -> str:
    """The part of a pattern that these back ends alone match."""
    return "(" + "|".join(backends) + ")/"


def growth_seconds(size: int, with_quadratic: bool) -> float:
    """The quadratic lookups stop at 30 000 triangles, where they take most of the time."""
    return 26.0 if size == 30_000 and with_quadratic else 3.5 + size / 45_000


def sizes_up_to(extent: Extent) -> list[str]:
    return [str(size) for size in SIZES if size <= extent.most_triangles]


def real_meshes(extent: Extent) -> list[str]:
    """Those that the benchmark may have: some are read from a folder that is not part of the project."""
    large = ["brain"] if extent.most_triangles >= 1_000_000 else []
    return large + ["skull", "cheese", "sponge", "folded", "tunnels"]


def bench_stages(extent: Extent) -> list[Stage]:
    stages = [bench_stage("cuts", "^Cut/", extent, 0.01, 7),
              bench_stage("proxies", "^Proxy/", extent, 0.01, 6),
              bench_stage("prepare-choice", f"^Automatic/(model/|asteroid/({'|'.join(sizes_up_to(extent))})/|"
                          f"mesh/({'|'.join(real_meshes(extent))})/)", extent, 0.01, 6 + extent.most_triangles / 200_000),
              bench_stage("prepare-models", "^Prepare/.*/[a-z]+/manual_time$", extent, 0.01, 2),
              bench_stage("real", f"^(Real|RealChain)/{among(REAL_BACKENDS)}{among(real_meshes(extent))}", extent, 0.05, 15),
              bench_stage("model-chains", f"^ModelChain/{among(REAL_BACKENDS)}", extent, 0.01, 3)]
    for size in SIZES:
        if size > extent.most_triangles:
            continue
        tail = f"{size}/manual_time$"
        with_quadratic = size <= extent.most_quadratic
        growing = among(BACKENDS if with_quadratic else SUBQUADRATIC)
        stages.append(bench_stage(f"growth-{size}", f"^(Scale|Geometry)/{growing}.*/{tail}", extent, 0.05,
                                  growth_seconds(size, with_quadratic)))
        if size in (10_000, 100_000, 1_000_000):
            stages.append(bench_stage(f"chain-{size}", f"^(Recut|Prepare|PrepareThreads|FromArrays)/.*/{tail}", extent, 0.01,
                                      1 + size / 50_000))
            stages.append(bench_stage(f"long-{size}", f"^Chain/.*/{size}/iterations:1/manual_time$", extent, 0.01,
                                      3.5 + size / 40_000))
            stages.append(many_stage(size, extent))
            # A dictionary's swipes of a million triangles take longer than all others together.
            swiping = among(BACKENDS if size < 1_000_000 else FASTEST)
            swipe = f"^Swipe/{swiping}.*/{size}/iterations:[0-9]+/manual_time$"
            stages.append(bench_stage(f"swipe-{size}", swipe, extent, 0.01, 1 + size / 40_000))
    stages.append(bench_stage("pieces", "^(Pieces|Physics)/", extent, 0.01, 12))
    return stages + section_stages(extent) + [fracture_stage(extent)]


def fracture_stage(extent: Extent) -> Stage:
    """Objects broken into cells."""
    sizes = "|".join(str(size) for size in FRACTURE_SIZES if size <= extent.most_triangles)
    pattern = f"^(Fracture/.*/({sizes})|RealFracture/.*/{among(real_meshes(extent))[:-1]})/"
    return bench_stage("fracture", pattern, extent, 0.01, 4 + extent.most_triangles / 100_000)


def section_sizes(extent: Extent) -> list[int]:
    return [size for size in SECTION_SIZES if size <= extent.most_triangles]


def section_stages(extent: Extent) -> list[Stage]:
    """Sections of what stays whole, one by one and in stacks."""
    stages = []
    for size in section_sizes(extent):
        # What the largest mesh needs before its first section is timed here: there are no chains of it.
        also = f"|^Prepare/halfedge/asteroid/{size}/" if size == SECTION_SIZES[-1] else ""
        stages.append(bench_stage(f"section-{size}", f"^Section/.*/(baseline/remap|halfedge)/asteroid/{size}$" + also, extent,
                                  0.05, 2 + size / 400_000))
        stages.append(bench_stage(f"stack-{size}", f"^Stack(Threads/2)?/(halfedge|baseline/remap)/asteroid/{size}/", extent,
                                  0.05, 2 + size / 300_000))
    stages.append(bench_stage("real-sections", f"^(RealSection|RealStack)/.*/{among(real_meshes(extent))[:-1]}(/|$)",
                              extent, 0.05, 8))
    return stages


def gallery_stages(fans: list[WorstFan]) -> list[Stage]:
    """The worst fans drawn beside the right caps: which they are is known only when the comparison is done."""
    stages = []
    for fan in fans:
        flags = ("--random-only",) if fan.planes == "random" else ()
        arguments = ("--json", "--caps", "--only", str(fan.number)) + flags + (model_file(fan.model),)
        stages.append(Stage(f"{GALLERY}{fan.model}", Kind.COMPARE, arguments, 0.3))
    return stages


def many_stage(size: int, extent: Extent) -> Stage:
    """Once: each of the many cuts is the median of five already. A dictionary takes long: in a short report only up to
    where the quadratic lookups go."""
    backends = FASTEST if extent is QUICK and size > extent.most_quadratic else BACKENDS
    pattern = f"^Many/{among(backends)}.*/{size}/iterations:1/manual_time$"
    return Stage(f"many-{size}", Kind.BENCH, (pattern, "1", "0.01"), 3.0 + size / 6_000 if size <= 100_000 else 36.0)


def peer_stages(extent: Extent, scratch: Path, with_vtk: bool, with_open3d: bool) -> list[Stage]:
    """Other libraries. Most of them take a second a cut above 100 000 triangles."""
    sizes = tuple(str(size) for size in SIZES if size <= MOST_FOR_PEERS)
    budget = str(0.5 * extent.repetitions)  # seconds of cutting for each mesh and library
    stages = [Stage("peers-cgal", Kind.PEERS, (budget, *sizes), 14.0 * extent.repetitions)]
    if with_vtk:
        stages.append(Stage("peers-vtk", Kind.VTK, (budget, str(scratch / "peers"), *sizes), 8.0 * extent.repetitions))
    sections = tuple(str(size) for size in section_sizes(extent))
    # CGAL takes half a minute for a hundred cells of 10 000 triangles.
    stages.append(Stage("cells-cgal", Kind.CELLS, (str(2 * float(budget)), "10000"), 8.0 * extent.repetitions))
    stages.append(Stage("slicers-cgal", Kind.SLICERS, (budget, *sections), extent.most_triangles / 60_000))
    if with_vtk:
        stages.append(Stage("slicers-vtk", Kind.VTK_SECTIONS, (budget, str(scratch / "slicers"), *sections),
                            extent.most_triangles / 20_000))
    if with_open3d:
        stages.append(Stage("slicers-open3d", Kind.OPEN3D_SECTIONS, (budget, str(scratch / "slicers"), *sections),
                            extent.most_triangles / 40_000))
    return stages


def viewer_stages(extent: Extent, scratch: Path) -> list[Stage]:
    """One stage a model that draws, every back end in it; the quadratic lookups stay out of the large one. And one that
    does not draw, of the two back ends whose worst frames are compared, if both are there."""
    stages = []
    has_opponents = set(VIEWER_OPPONENTS) <= set(extent.viewer_backends)
    for model in [row["model"] for row in report_rows()]:
        stages.append(viewer_stage(f"viewer-{model}", model_file(model), extent.viewer_backends))
        if has_opponents:
            stages.append(undrawn_stage(model, model_file(model)))
    backends = tuple(name for name in extent.viewer_backends if name not in QUADRATIC)
    file = str(scratch / f"{ASTEROID}-{extent.viewer_triangles}.ply")
    shape = (ASTEROID, "--triangles", str(extent.viewer_triangles), "--out", file)
    stages.append(viewer_stage(f"viewer-{ASTEROID}", file, backends, shape))
    if has_opponents:
        stages.append(undrawn_stage(ASTEROID, file, shape))
    return stages


def viewer_stage(name: str, file: str, backends: tuple[str, ...], shape: tuple[str, ...] = ()) -> Stage:
    # The graphics driver compiles shaders in the first frames of a process, and a back end's first cuts find none of its
    # code in a cache: a first run of each warms up and is not counted. The worst of some hundred frames differs from run
    # to run; it decides between two back ends, which run often, by turns.
    warmed_up = tuple(name for backend in backends for name in (backend, backend))
    if set(VIEWER_OPPONENTS) <= set(backends):
        warmed_up += VIEWER_OPPONENTS * (VIEWER_RUNS - 1)
    return Stage(name, Kind.VIEWER, (file, *play(warmed_up)), (8.0 if shape else 1.5) * len(warmed_up), shape)


def undrawn_stage(model: str, file: str, shape: tuple[str, ...] = ()) -> Stage:
    # Drawing by a program empties the caches of the processor between two frames, which a graphics card does not. The
    # same steps without it, by turns, and in turn the one or the other first.
    there_and_back = VIEWER_OPPONENTS + tuple(reversed(VIEWER_OPPONENTS))
    runs = VIEWER_OPPONENTS + (there_and_back * VIEWER_RUNS)[:2 * VIEWER_RUNS]
    return Stage(UNDRAWN + model, Kind.VIEWER, (file, *play(runs), "--draw", "0"), (4.0 if shape else 0.3) * len(runs),
                 shape)


def play(backends: tuple[str, ...]) -> tuple[str, ...]:
    return ("--headless", "--autopilot", "--seed", str(VIEWER_SEED), "--frames", str(VIEWER_FRAMES),
            "--size", VIEWER_SIZE, "--backend", ",".join(backends))

"""What the numbers were measured on, and with what."""

import os
import platform
import re
import subprocess
from pathlib import Path

PACKAGES = ["libopenmesh-dev", "libcgal-dev", "libbullet-dev", "libglm-dev", "libbenchmark-dev",
            "libgl1-mesa-dri", "python3-vtk9", "python3-open3d", "python3-matplotlib"]
SEED = re.compile(r"constexpr std::uint64_t (k\w*Seed) = (\d+);")


def output_of(command: list[str]) -> str:
    """What a program prints, or nothing when it is not there or fails."""
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def commit() -> str:
    """The commit that is checked out; `+` when files that it tracks have changed since."""
    name = output_of(["git", "rev-parse", "--short=12", "HEAD"])
    if not name:
        return "not under version control"
    return name + ("+" if output_of(["git", "status", "--porcelain", "--untracked-files=no"]) else "")


def cache_entry(cache: str, name: str) -> str:
    found = re.search(rf"^{name}:\w+=(.*)$", cache, re.MULTILINE)
    return found.group(1) if found else ""


CUTTER = re.compile(r"^build \S*cutter\.cpp\.o:.*\n(?:  .*\n)*?  FLAGS = (.*)$", re.MULTILINE)
SHOWN_FLAG = re.compile(r"-(?:[Ogm]\S*|f(?!pch)\S*|std=\S+)")  # what changes the code that the compiler makes


def cutting_flags(build_rules: str) -> str:
    """The compiler's flags for the cutting path, from Ninja's rules: those that change code."""
    found = CUTTER.search(build_rules)
    return " ".join(flag for flag in found.group(1).split() if SHOWN_FLAG.fullmatch(flag)) if found else "not known"


def text_of(file: Path) -> str:
    """What a file holds; nothing if it cannot be read."""
    try:
        return file.read_text(encoding="utf-8")
    except OSError:
        return ""


def processor() -> str:
    for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def memory_gib() -> float:
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30


def caches() -> str:
    """Of one core, as the kernel lists them."""
    found = []
    for folder in sorted(Path("/sys/devices/system/cpu/cpu0/cache").glob("index*")):
        try:
            level, kind, size = ((folder / name).read_text(encoding="utf-8").strip()
                                 for name in ("level", "type", "size"))
        except OSError:
            continue
        suffix = {"Data": "d", "Instruction": "i"}.get(kind, "")
        found.append(f"L{level}{suffix} {int(size[:-1]) / 1024:g} MiB" if size.endswith("K") and int(size[:-1]) >= 1024
                     else f"L{level}{suffix} {size.replace('K', ' KiB')}")
    return ", ".join(found) or "not known"


def describe(build: Path) -> dict[str, str]:
    """Machine, compiler, flags, versions, seeds and commit, for the page. `build` is the configured build folder."""
    cache = text_of(build / "CMakeCache.txt")
    compiler = cache_entry(cache, "CMAKE_CXX_COMPILER")
    facts = {
        "processor": f"{processor()}, {os.cpu_count()} cores, {memory_gib():.0f} GiB",
        "caches": caches(),
        "system": f"{platform.freedesktop_os_release().get('PRETTY_NAME', platform.system())}, Linux "
                  f"{platform.release().partition('-')[0]}",
        "compiler": (output_of([compiler, "--version"]) if compiler else "").partition("\n")[0] or "not known",
        "flags of the cutting path": cutting_flags(text_of(build / "build.ninja")),
        "commit": commit(),
    }
    for package in PACKAGES:
        version = output_of(["dpkg-query", "-W", "-f", "${Version}", package])
        facts[package] = version or "not installed"
    for source in sorted(Path("bench").glob("*.cpp")):
        for name, value in SEED.findall(source.read_text(encoding="utf-8")):
            facts[f"{source.name}, {name}"] = value
    return facts

"""What shared libraries of Kerf show and need."""

import re

from users import Failed, run, say

# What each library may need at run time, besides other parts of Kerf.
PLAIN = {"libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6", "ld-linux-x86-64.so.2"}
NEEDS = {"kerf": set(), "kerf_io": set(), "kerf_c": set(), "kerf_shapes": set(), "kerf_halfedge": {"libOpenMeshCore.so"},
         "kerf_proxy": {"libLinearMath.so"}, "kerf_caps_cgal": {"libgmp.so", "libmpfr.so"}}


def check_shared(folder):
    """Names and needs of those in a folder."""
    allowed = re.compile(r"(kerf::|kerf_[a-z_]+$"
                         r"|(typeinfo|typeinfo name|vtable|guard variable|non-virtual thunk) (for|to) kerf::)")
    for name, needs in NEEDS.items():
        library = next(folder.glob(f"lib{name}.so.*"))
        symbols = run("nm", "-DC", "--defined-only", library).splitlines()
        foreign = [line for line in symbols if not allowed.match(line.split(maxsplit=2)[2])]
        if foreign or not symbols:
            raise Failed(f"{library.name} shows names that are not Kerf's: {foreign[:3]}")
        needed = set(re.findall(r"NEEDED.*\[(.+)\]", run("readelf", "-d", library)))
        rest = {one for one in needed - PLAIN if not one.startswith("libkerf")}
        if {re.sub(r"\.so\..*", ".so", one) for one in rest} - needs:
            raise Failed(f"{library.name} needs {sorted(rest)}")
        say(f"    {library.name}: {len(symbols)} names, all Kerf's; needs {', '.join(sorted(needed))}")

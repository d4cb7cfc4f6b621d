#!/usr/bin/env python3
"""Runs the fuzzers, one after the other, and keeps and minimises what they find."""

import argparse
import hashlib
import os
import pathlib
import resource
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
PROGRAM = PROJECT / "build/fuzz/tests/fuzz/kerf_fuzz"
CORPUS = PROJECT / "build/fuzz/corpus"
FINDINGS = PROJECT / "build/fuzz/findings"

# One input may take this long; each takes milliseconds.
SECONDS_PER_INPUT = 10
# Memory of the program, and of one allocation: files are small, whatever they claim.
MEGABYTES, MEGABYTES_AT_ONCE = 2048, 1024
SECONDS_TO_MINIMISE = 60


def environment():
    """Short stacks and a small quarantine make small inputs several times as fast."""
    options = os.environ.get("ASAN_OPTIONS", "malloc_context_size=8:quarantine_size_mb=8")
    return {**os.environ, "ASAN_OPTIONS": options}


def fuzzers():
    lines = subprocess.run([PROGRAM, "--list"], check=True, capture_output=True, text=True).stdout.splitlines()
    return {name: int(longest) for name, longest in (line.split() for line in lines)}


def limits():
    return [f"-timeout={SECONDS_PER_INPUT}", f"-rss_limit_mb={MEGABYTES}", f"-malloc_limit_mb={MEGABYTES_AT_ONCE}"]


def minimised(name, finding):
    """A smaller input that fails as well; the finding itself when there is none."""
    smaller = finding.with_suffix(".min")
    subprocess.run([PROGRAM, f"--fuzzer={name}", "-minimize_crash=1", f"-max_total_time={SECONDS_TO_MINIMISE}",
                    f"-exact_artifact_path={smaller}", *limits(), finding],
                   env=environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    return smaller if smaller.exists() else finding


def processor_seconds():
    """Of all programs run so far."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def reason(log):
    """What was wrong, in one line of the fuzzer's log."""
    for mark in ("broken promise:", "runtime error:", "ERROR: AddressSanitizer", "ERROR: libFuzzer", "what():"):
        for line in log.splitlines():
            if mark in line:
                return line[line.index(mark):].strip()
    return "see the log"


def fuzz(name, longest, seconds):
    """True when nothing was found."""
    corpus, findings = CORPUS / name, FINDINGS / name
    corpus.mkdir(parents=True, exist_ok=True)
    findings.mkdir(parents=True, exist_ok=True)
    known = set(findings.iterdir())
    words = HERE / "words" / name
    dictionary = [f"-dict={words}"] if words.exists() else []
    # Inputs need their length: no slow growth from one byte.
    command = [PROGRAM, f"--fuzzer={name}", f"-max_len={longest}", "-len_control=0", f"-max_total_time={seconds}",
               "-print_final_stats=1", f"-artifact_prefix={findings}/", *limits(), *dictionary, corpus,
               HERE / "seeds" / name]
    print(f"{name}: {seconds} s", flush=True)
    log_path = FINDINGS / f"{name}.log"
    before = processor_seconds()
    with log_path.open("wb") as log:
        status = subprocess.run(command, env=environment(), stdout=log, stderr=log, check=False).returncode
    log = log_path.read_text(errors="replace")
    executed = [line.split()[-1] for line in log.splitlines() if "number_of_executed_units" in line]
    new = sorted(set(findings.iterdir()) - known)
    if status == 0:
        # A machine that does much else gives a fuzzer far less than the time on the clock.
        print(f"{name}: clean after {executed[-1] if executed else '?'} inputs, "
              f"{processor_seconds() - before:.0f} s of processor time", flush=True)
        return True
    print(f"{name}: {reason(log)}\n  the log: {log_path}")
    for finding in new:
        # Inputs that are merely slow have no smaller form that is wrong.
        small = finding if finding.name.startswith("slow-unit") else minimised(name, finding)
        digest = hashlib.sha1(small.read_bytes()).hexdigest()[:8]
        print(f"  to repeat it:  {PROGRAM} --fuzzer={name} {small}\n"
              f"  to keep it:    cp {small} {HERE.relative_to(PROJECT)}/seeds/{name}/CAUSE_{digest}")
    return False


def main():
    parser = argparse.ArgumentParser(prog="./run fuzz", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="fuzzers to run (default: all)")
    parser.add_argument("--seconds", type=int, default=600, help="for each fuzzer (default: 600)")
    parser.add_argument("--list", action="store_true", help="name the fuzzers")
    arguments = parser.parse_args()
    known = fuzzers()
    if arguments.list:
        print("\n".join(known))
        return 0
    for name in arguments.names:
        if name not in known:
            parser.error(f"there is no fuzzer '{name}', only {', '.join(known)}")
    # All of them, also after a finding.
    clean = [fuzz(name, known[name], arguments.seconds) for name in arguments.names or known]
    return 0 if all(clean) else 1


if __name__ == "__main__":
    sys.exit(main())

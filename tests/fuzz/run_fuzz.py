#!/usr/bin/env python3
"""Runs the fuzzers, one after the other or several at once, and keeps and minimises what they find."""

import argparse
import concurrent.futures
import hashlib
import os
import pathlib
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


def run(command, log_path):
    """Its exit status, and how many seconds it had of a processor."""
    with log_path.open("wb") as log:
        process = subprocess.Popen(command, env=environment(), stdout=log, stderr=log)
        # The usage of this one program: others run meanwhile.
        _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def say(text):
    """In one piece, so that fuzzers that end at the same time don't mix their lines."""
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


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
    say(f"{name}: {seconds} s")
    log_path = FINDINGS / f"{name}.log"
    status, processor_seconds = run(command, log_path)
    log = log_path.read_text(errors="replace")
    executed = [line.split()[-1] for line in log.splitlines() if "number_of_executed_units" in line]
    new = sorted(set(findings.iterdir()) - known)
    if status == 0:
        # A machine that does much else gives a fuzzer far less than the time on the clock.
        say(f"{name}: clean after {executed[-1] if executed else '?'} inputs, "
            f"{processor_seconds:.0f} s of processor time")
        return True
    lines = [f"{name}: {reason(log)}", f"  the log: {log_path}"]
    for finding in new:
        # Inputs that are merely slow have no smaller form that is wrong.
        small = finding if finding.name.startswith("slow-unit") else minimised(name, finding)
        digest = hashlib.sha1(small.read_bytes()).hexdigest()[:8]
        lines += [f"  to repeat it:  {PROGRAM} --fuzzer={name} {small}",
                  f"  to keep it:    cp {small} {HERE.relative_to(PROJECT)}/seeds/{name}/CAUSE_{digest}"]
    say("\n".join(lines))
    return False


def fuzz_all(names, longest, seconds, jobs):
    """All of them, also after a finding; `jobs` at a time. True when nothing was found."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        running = [pool.submit(fuzz, name, longest[name], seconds) for name in names]
        try:
            return all([one.result() for one in running])
        except BaseException:
            # Interrupted: those that run got the signal too, the others don't begin.
            pool.shutdown(cancel_futures=True)
            raise


def whole_number(text):
    value = int(text)
    if value < 1:
        raise ValueError
    return value


def main():
    parser = argparse.ArgumentParser(prog="./run fuzz", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="fuzzers to run (default: all)")
    parser.add_argument("--seconds", type=whole_number, default=600, metavar="N",
                        help="for each fuzzer (default: 600)")
    parser.add_argument("--jobs", type=whole_number, default=1, metavar="N",
                        help="how many fuzzers run at once (default: 1)")
    parser.add_argument("--list", action="store_true", help="name the fuzzers")
    arguments = parser.parse_args()
    known = fuzzers()
    if arguments.list:
        print("\n".join(known))
        return 0
    for name in arguments.names:
        if name not in known:
            parser.error(f"there is no fuzzer '{name}', only {', '.join(known)}")
    # Two runs of one fuzzer would share its log and its findings.
    names = list(dict.fromkeys(arguments.names or known))
    return 0 if fuzz_all(names, known, arguments.seconds, arguments.jobs) else 1


if __name__ == "__main__":
    sys.exit(main())

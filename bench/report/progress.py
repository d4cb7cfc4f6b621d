"""One line that says what runs, how much is done and how long it still takes."""

import sys
import time
from typing import Callable, TextIO

BAR_WIDTH = 24


def time_text(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest:02d} s" if minutes else f"{rest} s"


class Progress:
    """Counts stages by the seconds they are expected to take, corrected by what those done really took."""

    def __init__(self, expected: dict[str, float], stream: TextIO | None = None,
                 clock: Callable[[], float] = time.monotonic):
        self.expected, self.stream, self.clock = dict(expected), stream or sys.stderr, clock
        self.total = sum(expected.values())
        self.done_expected = 0.0
        self.stage, self.stage_share, self.start = "", 0.0, clock()

    def begin(self, stage: str) -> None:
        self.stage, self.stage_share = stage, 0.0
        self.show("")

    def update(self, done: int, total: int, name: str) -> None:
        """`done` of `total` parts of the running stage are done."""
        self.stage_share = done / max(total, 1)
        self.show(name)

    def end(self) -> None:
        self.done_expected += self.expected[self.stage]
        self.stage_share = 0.0
        if not self.stream.isatty():
            print(f"report: {self.stage} done, {self.share():.0%}, {self.left_text()}", file=self.stream, flush=True)

    def share(self) -> float:
        running = self.expected.get(self.stage, 0.0) * self.stage_share
        return min((self.done_expected + running) / self.total, 1.0) if self.total > 0 else 1.0

    def seconds_left(self) -> float:
        """What is expected for the rest, scaled by how the time so far compares with what was expected for it."""
        share, elapsed = self.share(), self.clock() - self.start
        if share <= 0.0:
            return self.total
        # The first stages say little about the others: trust grows with what is done.
        pace = share * (elapsed / (share * self.total)) + (1.0 - share)
        return (1.0 - share) * self.total * pace

    def left_text(self) -> str:
        return f"about {time_text(self.seconds_left())} left"

    def show(self, detail: str) -> None:
        if not self.stream.isatty():
            return
        full = round(BAR_WIDTH * self.share())
        bar = "#" * full + "." * (BAR_WIDTH - full)
        text = f"[{bar}] {self.share():4.0%}, {self.left_text()}: {self.stage} {detail}"
        print(f"\r{text:100.100}", end="", file=self.stream, flush=True)

    def clear(self) -> None:
        if self.stream.isatty():
            print("\r" + " " * 100 + "\r", end="", file=self.stream, flush=True)

"""How much is done and how long it still takes."""

import io
import unittest

from report.progress import Progress, time_text


class ProgressOfStages(unittest.TestCase):
    def test_time_left_follows_the_pace_so_far(self):
        now = [0.0]
        progress = Progress({"a": 10.0, "b": 10.0}, stream=io.StringIO(), clock=lambda: now[0])
        self.assertEqual(progress.seconds_left(), 20.0)
        progress.begin("a")
        now[0] = 20.0  # twice as long as expected
        progress.end()
        self.assertEqual(progress.share(), 0.5)
        self.assertEqual(progress.seconds_left(), 15.0)  # half trusted
        self.assertEqual(time_text(75), "1 min 15 s")

    def test_a_running_stage_counts_by_its_parts(self):
        progress = Progress({"a": 10.0, "b": 30.0}, stream=io.StringIO())
        progress.begin("a")
        progress.update(1, 2, "half")
        self.assertEqual(progress.share(), 0.125)

    def test_a_log_gets_a_line_for_each_stage_that_is_done(self):
        stream = io.StringIO()
        progress = Progress({"a": 1.0}, stream=stream)
        progress.begin("a")
        progress.update(1, 2, "half")
        progress.end()
        self.assertRegex(stream.getvalue(), r"^report: a done, 100%, about 0 s left\n$")

    def test_nothing_to_do_is_done(self):
        self.assertEqual(Progress({}, stream=io.StringIO()).share(), 1.0)


if __name__ == "__main__":
    unittest.main()

"""Several threads, and Ctrl-C."""

import os
import signal
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import kerf
import numpy as np
import pytest


def test_four_threads_section_one_object(random):
    rock = kerf.shape("asteroid", 50_000).prepare()
    planes = [(random.uniform(-0.5, 0.5, 3), random.normal(size=3)) for _ in range(200)]

    def areas(part):
        return [kerf.section(rock, origin=origin, normal=normal).area for origin, normal in part]

    expected = areas(planes)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(areas, [planes] * 4))
    assert found == [expected] * 4


def test_relatives_are_cut_while_others_are_read():
    left, right = kerf.cut(kerf.shape("asteroid", 20_000).prepare(), origin=(0, 0, 0), normal="x")
    expected = kerf.section(left, origin=(-0.2, 0, 0), normal="z").area

    def cut_to_pieces(piece):
        rest = piece
        for height in np.linspace(0.7, -0.7, 30):
            _, below = kerf.cut(rest, origin=(0, 0, height), normal="z")
            rest = below if below is not None else rest
        return rest.triangle_count

    with ThreadPoolExecutor(4) as pool:
        cuts = pool.submit(cut_to_pieces, right)
        reads = [
            pool.submit(lambda: [kerf.section(left, origin=(-0.2, 0, 0), normal="z").area for _ in range(50)])
            for _ in range(3)
        ]
        assert cuts.result() > 0
        for read in reads:
            assert read.result() == [expected] * 50


def test_two_threads_that_cut_one_object_get_it_once():
    for _ in range(20):
        rock = kerf.shape("asteroid", 5000).prepare()
        gate = threading.Barrier(2)

        def cut():
            gate.wait()
            try:
                return kerf.cut(rock, origin=(0, 0, 0), normal="z").area
            except ValueError as refusal:
                assert "was cut" in str(refusal)
                return None

        with ThreadPoolExecutor(2) as pool:
            answers = [answer.result() for answer in (pool.submit(cut), pool.submit(cut))]
        assert sorted(answer is None for answer in answers) == [False, True]


def test_python_goes_on_while_a_mesh_is_made():
    ticks = 0
    done = threading.Event()

    def tick():
        nonlocal ticks
        while not done.is_set():
            ticks += 1
            time.sleep(0.001)

    ticking = threading.Thread(target=tick)
    ticking.start()
    rock = kerf.shape("asteroid", 200_000)
    before = ticks
    began = time.perf_counter()
    kerf.Mesh(rock.vertices, rock.faces).prepare()
    took = time.perf_counter() - began
    done.set()
    ticking.join()
    # Were the lock held, there would be none or one. A tick takes a millisecond at least.
    assert ticks - before >= min(5, took / 0.01)


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_ctrl_c_stops_a_stack_of_sections():
    # Where nobody can type it, in a shell's background, it is ignored, and Python raises nothing.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    rock = kerf.shape("asteroid", 200_000).prepare()
    threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT)).start()
    began = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        while time.perf_counter() - began < 60:
            kerf.sections(rock, normal="z", heights=np.linspace(-1, 1, 20_000), threads=1)
    signal.signal(signal.SIGINT, before)
    # Without a stop in between, all of them would have been made first.
    assert rock.triangle_count > 0

"""Threads of Python run operations at the same time, and ask for nothing of each other."""

from __future__ import annotations

import os
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

import pytest

import plumb


def pair() -> tuple[plumb.Solid, plumb.Solid]:
    ball = plumb.Solid.ball(1.0, 7)
    return ball, ball.translated((Fraction(1, 7), Fraction(1, 11), Fraction(1, 13)))


def test_an_operation_releases_the_gil():
    """While a thread unites, this one goes on; with the GIL held it would stand all the while."""
    a, b = pair()
    done, took = threading.Event(), []

    def unite() -> None:
        start = time.perf_counter()
        a.union(b)
        took.append(time.perf_counter() - start)
        done.set()

    thread = threading.Thread(target=unite)
    longest, last = 0.0, time.perf_counter()
    thread.start()
    while not done.is_set():
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
        time.sleep(0)
    thread.join()
    assert longest < took[0] / 2


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="needs two processors")
def test_results_of_threads_are_equal():
    a, b = pair()
    expected = a | b
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda _: a.union(b), range(4)))
    assert all(result == expected for result in results)


def test_queries_of_one_set_on_several_threads():
    a, _ = pair()
    points = [[x / 50, 0, 0] for x in range(100)]
    with ThreadPoolExecutor(4) as pool:
        results = list(pool.map(lambda _: a.contains_points(points).tolist(), range(8)))
    assert all(result == results[0] for result in results)
    assert results[0][:50] == [True] * 50

"""Every example of a docstring does what it says, and every public name has a docstring."""

import doctest
import inspect
import pkgutil

import kerf
import numpy as np
import pytest

MODULES = [kerf] + [
    __import__(f"kerf.{module.name}", fromlist=["kerf"]) for module in pkgutil.iter_modules(kerf.__path__)
]


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.__name__)
def test_examples_do_what_they_say(module):
    finder = doctest.DocTestFinder(exclude_empty=True)
    runner = doctest.DocTestRunner()
    for test in finder.find(module, extraglobs={"kerf": kerf, "np": np}):
        runner.run(test)
    assert runner.failures == 0


def test_there_are_examples():
    found = sum(len(test.examples) for module in MODULES for test in doctest.DocTestFinder().find(module))
    assert found > 30


@pytest.mark.parametrize("name", kerf.__all__)
def test_public_names_are_documented(name):
    value = getattr(kerf, name)
    assert inspect.getdoc(value)
    if inspect.isclass(value):
        for member, what in vars(value).items():
            if not member.startswith("_") and (inspect.isfunction(what) or isinstance(what, property)):
                assert inspect.getdoc(what), f"{name}.{member}"

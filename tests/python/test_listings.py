"""The listings of the pages do what they say, and the script with pictures makes them."""

import os
import re
import subprocess
import sys

import pytest

PAGES = ("README.md", "python/README.md", "docs/guide/python.md")


@pytest.mark.parametrize("page", PAGES)
def test_listings_run(page, root, tmp_path, monkeypatch):
    listings = re.findall(r"^```python\n(.*?)^```", (root / page).read_text(), re.MULTILINE | re.DOTALL)
    assert listings
    # As in the repository's folder, but what is written is written elsewhere.
    os.symlink(root / "data", tmp_path / "data")
    monkeypatch.chdir(tmp_path)
    for listing in listings:
        exec(compile(listing, page, "exec"), {})


def test_the_script_with_pictures(root, tmp_path):
    pytest.importorskip("matplotlib")
    subprocess.run(
        [sys.executable, root / "examples/python/cut_and_draw.py", tmp_path],
        check=True,
        env={**os.environ, "MPLBACKEND": "Agg"},
    )
    assert len(list(tmp_path.glob("*.png"))) == 5

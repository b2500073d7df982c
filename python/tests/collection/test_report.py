# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The report, opened in a browser."""

import re
import shutil
import subprocess
from types import SimpleNamespace

import pytest

pytest.importorskip("scipy")
from counterpart3d.collection import Collection
from counterpart3d.collection.report import _notices

from .conftest import write_family


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    root = tmp_path_factory.mktemp("report")
    write_family(root / "in", 4)
    (root / "in" / "<b>&amp;.ply").write_bytes(b"ply")
    Collection.build(root / "in", root / "out", rounds=1, scheduler="inline", progress=False)
    return root / "out" / "report.html"


def test_it_needs_nothing_else(report):
    text = report.read_text()
    assert not re.findall(r"""(?:src|href)=["'](?!data:)|url\(|https?://(?!www\.w3\.org)|@import""", text)
    assert text.count("<figure") == 4 and text.count("data:image/png;base64,") == 4
    assert "<b>&amp;" not in text and "&lt;b&gt;&amp;amp;" in text
    assert "$" not in re.sub(r"\$\{", "", text)


def shown(page):
    """The page without its scripts, whose text holds what they could show."""
    return re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL)


def test_it_says_what_helps_where_specimens_have_remarks(report):
    assert "where left and right are mixed, --mirror auto help" in report.read_text()


@pytest.mark.parametrize(("bad", "said"), [(0, None), (2, "2 files or specimens have"), (6, "6 of 10 files have")])
def test_a_remark_that_most_have_says_little_of_one(bad, said):
    rows = [{"remark": "folded" if i < bad else ""} for i in range(10)]
    found = _notices(SimpleNamespace(notices=[], quality=rows, mirror=False))
    assert found == "" if said is None else said in found


def test_it_does_not_advise_what_was_given():
    found = _notices(SimpleNamespace(notices=[], quality=[{"remark": "folded"}] * 4, mirror=True))
    assert "a template nearer to them, or --pairs all help" in found and "--mirror" not in found


def test_its_plots_need_no_script(report):
    page = shown(report.read_text())
    assert page.count("<circle") == 4 and '<canvas id="view"' in page and "data-drawn" not in page


def test_it_draws_the_mean_in_a_browser(report):
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if not browser:
        pytest.skip("needs chromium")
    options = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    wait = ["--virtual-time-budget=4000", "--dump-dom"]
    for width in (1200, 390):
        command = [browser, *options, *wait, f"--window-size={width},900", report.as_uri()]
        page = shown(subprocess.run(command, capture_output=True, text=True, timeout=600, check=True).stdout)
        assert re.search(r'<canvas[^>]* data-drawn="yes"', page), "nothing was drawn"
        assert page.count("<output>0.0</output>") == page.count("data-mode=") > 0
        assert page.count("<circle") == 4

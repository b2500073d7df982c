# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
import json
import re
import urllib.request

import counterpart3d as cp
import numpy as np
import pytest

SIZE = (96, 64)


def test_every_figure(pair, tmp_path):
    source, target, truth = pair
    for show in ("colors", "checker", "lines"):
        picture = cp.render(source, target, truth, show=show, size=SIZE)
        assert picture.shape == (64, 96, 3) and picture.dtype == np.uint8 and len(np.unique(picture)) > 20
    picture.save(tmp_path / "a.png")
    assert (tmp_path / "a.png").read_bytes() == picture._repr_png_()
    assert cp.render(source, size=SIZE).shape == (64, 96, 3)


def test_colors_and_values(body):
    red = cp.render(body, colors=np.tile([1, 0, 0], (body.n_vertices, 1)), size=SIZE)
    assert red[..., 0].astype(int).sum() > red[..., 1].astype(int).sum()
    values = cp.distances(body, 0)[0]
    assert cp.render(body, values=values, size=SIZE).shape == (64, 96, 3)
    for wrong in ({"colors": np.zeros((3, 3))}, {"values": np.zeros(3)}):
        with pytest.raises(cp.InvalidInput):
            cp.render(body, **wrong)


@pytest.mark.parametrize(
    "options", [{"size": (0, 5)}, {"size": (99999, 5)}, {"view": "sideways"}, {"up": "w"}, {"show": "magic"}]
)
def test_options_out_of_range(pair, options):
    with pytest.raises(cp.InvalidInput):
        cp.render(*pair, **{"size": SIZE, **options})


def test_view(pair, tmp_path):
    source, target, truth = pair
    page = cp.view(source, target, {"true": truth, "identity": np.arange(len(truth))}, truth=truth)
    assert "<html" in page.html and page._repr_html_().startswith("<iframe srcdoc=")
    assert "<script" not in page._repr_html_()
    page.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text() == page.html
    turned = source.vertices[:, [2, 0, 1]]  # it stands along z
    pages = {
        up: cp.view(cp.Mesh(turned, source.triangles), target, truth, up=up).html for up in ("auto", "y", "z", "-z")
    }
    assert pages["auto"] == pages["z"] and len({pages["y"], pages["z"], pages["-z"]}) == 3
    with pytest.raises(cp.InvalidInput, match="up axis"):
        cp.view(source, target, truth, up="w")


def test_view_tells_of_results(pair):
    """The verdict and the confidence of a result, and its runners-up by what they are."""
    source, target, _ = pair
    result = cp.match(source, target, "spectral", basis_size=30, n_samples=200)
    scene = json.loads(re.search(r'id="scene">(.*?)</script>', cp.view(source, target, result).html)[1])
    found = scene["maps"][0]
    assert found["verdict"] == result.verdict.advice
    assert found.get("warnings", []) == [str(message) for message in result.warnings]
    assert "confidence_offset" in found
    names = [shown["name"] for shown in scene["maps"][1:]]
    described = [other.description for other in result.spectral.alternatives]
    assert described and len(set(names)) == len(names)
    assert [re.sub(r" \(\d+\)$", "", name) for name in names] == described
    assert not any("confidence_offset" in m or "verdict" in m for m in scene["maps"][1:])


def test_show_opens_what_was_made(body, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(urllib.request.urlopen(address).read()))
    picture, page = cp.render(body, size=(40, 30)), cp.view(body, body, np.arange(body.n_vertices))
    picture.show()
    page.show()
    assert opened == [picture.png(), page.html.encode()]

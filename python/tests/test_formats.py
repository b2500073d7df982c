# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Files of other packages, as these write and read them; each test needs the package."""

import counterpart3d as cp
import numpy as np
import pytest

SQUARE = np.array([[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [1, 1, 1.5]])
FACES = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [0, 3, 2, 1]]
SIZES, CORNERS = [len(face) for face in FACES], np.concatenate(FACES)
PYRAMID = cp.Mesh.from_polygons(SQUARE, SIZES, CORNERS)
HEIGHT = SQUARE[:, 2]


def check(mesh):
    np.testing.assert_array_equal(mesh.vertices, SQUARE)
    np.testing.assert_array_equal(mesh.polygons[0], SIZES)
    np.testing.assert_array_equal(mesh.polygons[1], CORNERS)


@pytest.fixture
def vtk_pyramid():
    pyvista = pytest.importorskip("pyvista")
    mesh = pyvista.PolyData(SQUARE, np.concatenate([[len(face), *face] for face in FACES]))
    mesh.point_data["height"] = HEIGHT
    mesh.point_data["label of it"] = np.arange(5)
    mesh.point_data["rgb"] = np.full((5, 3), 51, np.uint8)
    return mesh


@pytest.mark.parametrize("version", [42, 51])
@pytest.mark.parametrize("binary", [False, True])
def test_legacy_vtk_of_vtk(vtk_pyramid, version, binary, tmp_path):
    vtk = pytest.importorskip("vtk")
    for name, writer, data in (
        ("a.vtk", vtk.vtkPolyDataWriter(), vtk_pyramid),
        ("b.vtk", vtk.vtkUnstructuredGridWriter(), vtk_pyramid.cast_to_unstructured_grid()),
    ):
        writer.SetInputData(data)
        writer.SetFileName(str(tmp_path / name))
        writer.SetFileVersion(version)
        writer.SetFileType(2 if binary else 1)
        assert writer.Write()
        mesh = cp.read(tmp_path / name)
        check(mesh)
        np.testing.assert_array_equal(mesh.values["height"], HEIGHT)
        np.testing.assert_array_equal(mesh.values["label of it"], np.arange(5))
        np.testing.assert_allclose(mesh.colors[0][0], 0.2)
        assert not mesh.notices


@pytest.mark.parametrize("mode", ["Ascii", "Binary", "Appended"])
@pytest.mark.parametrize("zlib", [False, True])
@pytest.mark.parametrize("encoded", [False, True])
@pytest.mark.parametrize("header", [32, 64])
def test_vtp_of_vtk(vtk_pyramid, mode, zlib, encoded, header, tmp_path):
    vtk = pytest.importorskip("vtk")
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(vtk_pyramid)
    writer.SetFileName(str(tmp_path / "a.vtp"))
    writer.SetDataMode(getattr(vtk.vtkXMLWriter, mode))
    writer.SetEncodeAppendedData(encoded)
    getattr(writer, f"SetHeaderTypeToUInt{header}")()
    writer.SetCompressorType(vtk.vtkXMLWriter.ZLIB if zlib else vtk.vtkXMLWriter.NONE)
    assert writer.Write()
    mesh = cp.read(tmp_path / "a.vtp")
    check(mesh)
    np.testing.assert_array_equal(mesh.values["height"], HEIGHT)
    np.testing.assert_array_equal(mesh.values["label of it"], np.arange(5))
    np.testing.assert_allclose(mesh.colors[0][0], 0.2)
    assert not mesh.notices


def test_vtp_in_many_blocks(tmp_path):
    """VTK compresses 32 KiB at a time."""
    pyvista = pytest.importorskip("pyvista")
    ball = cp.make_icosphere(5)
    faces = np.column_stack([np.full(ball.n_triangles, 3), ball.triangles])
    pyvista.PolyData(ball.vertices, faces.ravel()).save(tmp_path / "a.vtp")
    mesh = cp.read(tmp_path / "a.vtp")
    np.testing.assert_array_equal(mesh.vertices, ball.vertices)
    np.testing.assert_array_equal(mesh.triangles, ball.triangles)


@pytest.mark.parametrize("name", ["a.vtk", "a.vtp"])
def test_vtk_reads_what_is_written(name, tmp_path):
    pyvista = pytest.importorskip("pyvista")
    mesh = cp.Mesh.from_polygons(SQUARE, SIZES, CORNERS)
    cp.write(mesh, tmp_path / name)
    read = pyvista.read(tmp_path / name)
    np.testing.assert_array_equal(read.points, SQUARE)
    np.testing.assert_array_equal(read.faces, np.concatenate([[len(face), *face] for face in FACES]))
    ball = cp.make_icosphere(2)
    valued = cp.Mesh(
        *ball,
        normals=(ball.vertices, ball.triangles),
        colors=[(np.full((ball.n_vertices, 3), 0.2), ball.triangles)],
        values={"height": ball.vertices[:, 2], "two words": np.arange(ball.n_vertices), "flow": ball.vertices[:, :2]},
    )
    valued.save(tmp_path / name)
    data = pyvista.read(tmp_path / name).point_data
    np.testing.assert_array_equal(data["height"], ball.vertices[:, 2])
    np.testing.assert_array_equal(data["two words"], np.arange(ball.n_vertices))
    assert data["two words"].dtype.kind == "i"
    np.testing.assert_array_equal(data["flow"], ball.vertices[:, :2])
    np.testing.assert_array_equal(data["Colors"], 51)
    np.testing.assert_array_equal(data.active_normals, ball.vertices)
    again = cp.read(tmp_path / name)
    for name_of in ("height", "two words", "flow"):
        np.testing.assert_array_equal(again.values[name_of], valued.values[name_of])


@pytest.mark.parametrize("binary", [False, True])
@pytest.mark.parametrize("name", ["vtk42", "vtk51"])
def test_vtk_of_meshio(name, binary, tmp_path):
    meshio = pytest.importorskip("meshio")
    mesh = meshio.Mesh(SQUARE, [("triangle", FACES[:4]), ("quad", FACES[4:])], point_data={"height": HEIGHT})
    mesh.write(tmp_path / "a.vtk", name, binary=binary)
    read = cp.read(tmp_path / "a.vtk")
    check(read)
    np.testing.assert_array_equal(read.values["height"], HEIGHT)


@pytest.mark.parametrize(
    ("encoding", "order"),  # nibabel writes text row by row whatever its header says
    [("ASCII", "C"), ("B64BIN", "C"), ("B64BIN", "F"), ("B64GZ", "C"), ("B64GZ", "F")],
)
@pytest.mark.parametrize("endian", ["big", "little"])
def test_gifti_of_nibabel(encoding, endian, order, tmp_path):
    nibabel = pytest.importorskip("nibabel")
    ball = cp.make_icosphere(1)

    def array(values, intent, dtype):
        return nibabel.gifti.GiftiDataArray(
            np.asarray(values, dtype),
            intent=f"NIFTI_INTENT_{intent}",
            encoding=f"GIFTI_ENCODING_{encoding}",
            endian=endian,
            ordering=order,
        )

    points = array(ball.vertices, "POINTSET", np.float32)
    labels = array(np.arange(ball.n_vertices), "LABEL", np.int32)
    labels.meta["Name"] = "areas"
    image = nibabel.gifti.GiftiImage(darrays=[points, array(ball.triangles, "TRIANGLE", np.int32), labels])
    nibabel.save(image, tmp_path / "a.gii")
    mesh = cp.read(tmp_path / "a.gii")
    np.testing.assert_allclose(mesh.vertices, ball.vertices, atol=1e-6)
    np.testing.assert_array_equal(mesh.triangles, ball.triangles)
    np.testing.assert_array_equal(mesh.values["areas"], np.arange(ball.n_vertices))


def test_vertices_that_are_no_numbers(tmp_path):
    """As depth cameras and segmentations leave them: indices stay, and maps say -1."""
    body = cp.make_body(0)
    vertices = np.vstack([body.vertices[:5], [[np.nan, 0, 0]], body.vertices[5:]])
    triangles = body.triangles + (body.triangles >= 5)
    rows = ["v " + " ".join(map(repr, row.tolist())) for row in vertices]
    (tmp_path / "a.obj").write_text("\n".join([*rows, *("f {} {} {}".format(*t) for t in triangles + 1)]))
    mesh = cp.read(tmp_path / "a.obj")
    assert mesh.n_vertices == body.n_vertices + 1 and "vertex 5 is the first" in mesh.notices[0]
    np.testing.assert_array_equal(mesh.left_out, [5])
    result = cp.match(mesh, mesh)
    expected = np.arange(len(vertices))
    expected[5] = -1
    np.testing.assert_array_equal(result.target_from_source, expected)
    assert result.confidence[5] == 0
    with pytest.raises(cp.IoError, match="vertex 5"):
        cp.read(tmp_path / "a.obj", strict=True)

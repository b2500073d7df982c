# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Undo, cancel, save and load, refusals: whatever happens, a person's work is as it was or as it should be."""

import shutil
import threading
import types
from dataclasses import replace

import bpy
import characters as c
import counterpart3d as cp
import numpy as np
import pytest
from counterpart_extension import matching, operators
from counterpart_extension.job import Job
from counterpart_extension.operators.with_map import WithMap
from counterpart_extension.pairs import Options, read_pair
from counterpart_extension.panel import state
from counterpart_extension.stored_map import stored
from digest import differences, everything
from mathutils import Matrix

OPERATORS = {
    "match": {},
    "transfer": {},
    "restore_order": {},
    "fit": {},
    "join_shape_keys": {},
    "in_betweens": {"count": 2},
    "show": {"what": "CONFIDENCE"},
}


@pytest.mark.parametrize("name", OPERATORS)
def test_undo_restores_everything(hero, name):
    other, _ = c.shuffled(hero, "Other")
    c.only(hero, other)
    bpy.ops.ed.undo_push(message="Start")
    before = everything()
    getattr(bpy.ops.counterpart, name)("EXEC_DEFAULT", True, **OPERATORS[name])
    assert differences(before, everything()) != []
    bpy.ops.ed.undo()
    assert differences(before, everything()) == []
    bpy.ops.ed.redo()
    assert differences(before, everything()) != []


def test_other_options_after_undo_are_as_if_at_first(hero):
    """What the panel of the last operation does."""
    chosen = dict(shape_keys=False, max_influences=2)
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    bpy.ops.ed.undo_push(message="Start")
    bpy.ops.counterpart.transfer("EXEC_DEFAULT", True, **chosen)
    wanted = everything()
    bpy.ops.ed.undo()
    bpy.ops.counterpart.transfer("EXEC_DEFAULT", True, shape_keys=True, max_influences=0)  # else those of before
    assert differences(wanted, everything()) != []
    bpy.ops.ed.undo()
    bpy.ops.counterpart.transfer("EXEC_DEFAULT", True, **chosen)
    assert differences(wanted, everything()) == []


def test_undo_of_a_landmark(hero):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    before = everything()
    bpy.ops.object.mode_set(mode="EDIT")
    for obj in (hero, other):
        c.select_vertices(obj, [7])
    bpy.ops.ed.undo_push(message="Start")
    bpy.ops.counterpart.add_landmark("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    if bpy.context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    assert differences(before, everything()) == []


@pytest.mark.parametrize("name", OPERATORS)
def test_a_saved_file_is_the_same(hero, tmp_path, name):
    other = c.shuffled(hero, "Other")[0] if name == "restore_order" else c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    getattr(bpy.ops.counterpart, name)(**OPERATORS[name])
    before, kept = everything(), stored(other.data)
    file = str(tmp_path / "done.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    assert differences(before, everything()) == []
    again = stored(bpy.data.objects["Other"].data)
    assert np.array_equal(kept.points.weights, again.points.weights) and kept.question == again.question


def test_a_kept_map_is_used(hero, monkeypatch):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    monkeypatch.setattr("counterpart_extension.matching.match_pair", None)
    assert bpy.ops.counterpart.transfer() == {"FINISHED"}
    assert bpy.ops.counterpart.show(what="MAP") == {"FINISHED"}


def test_a_kept_map_goes_with_other_faces(hero, monkeypatch):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    other.vertex_groups.new(name="landmark 1").add([0], 1, "REPLACE")
    hero.vertex_groups.new(name="landmark 1").add([0], 1, "REPLACE")
    asked = []
    monkeypatch.setattr("counterpart_extension.matching.match_pair", lambda pair, _: asked.append(pair) or 1 / 0)
    with pytest.raises(RuntimeError, match="ZeroDivisionError"):
        bpy.ops.counterpart.transfer()
    assert len(asked) == 1 and len(asked[0].landmarks) == 1


def test_match_matches_again(hero):
    """What was kept is of the place where the object stood, or of the shape that it had."""
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    before = stored(other.data)
    other.data.transform(Matrix.Translation((0.01, 0, 0)))
    bpy.ops.counterpart.match()
    assert not np.array_equal(before.points.weights, stored(other.data).points.weights)


@pytest.mark.parametrize("name", ["counterpart", "counterpart_triangle"])
def test_a_kept_map_that_names_nothing_is_made_again(hero, name):
    """Whoever wrote it into the file."""
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    before = stored(other.data)
    values = np.full(len(other.data.vertices), 1 << 30, np.int32)
    other.data.attributes[name].data.foreach_set("value", values)
    assert bpy.ops.counterpart.show(what="MAP") == {"FINISHED"}
    assert np.array_equal(before.vertex, stored(other.data).vertex)
    other.data.attributes.remove(other.data.attributes[name])
    other.data.attributes.new(name, "FLOAT", "FACE")
    assert bpy.ops.counterpart.show(what="MAP") == {"FINISHED"}
    assert np.array_equal(before.points.triangle, stored(other.data).points.triangle)


def test_a_kept_map_is_of_one_active_object(hero):
    """Another one may have the same faces, as primitives have, and another shape."""
    other, _ = c.shuffled(hero, "Other")
    stranger = c.bare_copy(hero, "Stranger")
    stranger.data.transform(Matrix.Diagonal((1, 1, -1, 1)))
    c.only(stranger, other)
    bpy.ops.counterpart.match()
    for active in (stranger, hero):
        c.only(active, other)
        assert bpy.ops.counterpart.show(what="MAP", use_doubtful=True) == {"FINISHED"}
        assert stored(other.data).active == active.name
        assert state(other, active)[0] == stored(other.data).verdict


class Pressed(WithMap):
    """An operator as a person presses it, without a window: what Blender does is done by hand."""

    bl_label = "Pressed"
    seen, aligned, part, use_doubtful = False, False, "unknown", False

    def __init__(self):
        self.said = []
        self.done = []
        self.computed = []

    def report(self, kind, sentence):
        self.said.append((*kind, sentence))

    def prepare(self, context, pair, found, computed):
        self.computed.append(computed)
        return lambda: self.done.append(found) or []


def a_window():
    manager = types.SimpleNamespace(
        event_timer_add=lambda step, window: "timer",
        event_timer_remove=lambda timer: None,
        modal_handler_add=lambda op: True,
    )
    workspace = types.SimpleNamespace(status_text_set=lambda text: workspace.texts.append(text), texts=[])
    return types.SimpleNamespace(
        active_object=bpy.context.active_object,
        selected_objects=list(bpy.context.selected_objects),
        evaluated_depsgraph_get=bpy.context.evaluated_depsgraph_get,
        window_manager=manager,
        workspace=workspace,
        window=None,
    )


def event(kind):
    return types.SimpleNamespace(type=kind, value="PRESS")


def test_pressed_matches_in_the_background_then_acts(hero):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    pressed, window = Pressed(), a_window()
    assert pressed.invoke(window, event("LEFTMOUSE")) == {"RUNNING_MODAL"}
    assert pressed.modal(window, event("MOUSEMOVE")) == {"RUNNING_MODAL"}
    pressed._job.wait()
    assert pressed.modal(window, event("TIMER")) == {"FINISHED"}
    assert len(pressed.done) == 1 and stored(other.data) is not None
    assert window.workspace.texts[-1] is None


def test_escape_changes_nothing(hero):
    """Two figures whose match takes a while."""
    for name, mesh in (("A", cp.make_body(1)), ("B", cp.deform(cp.make_body(1), bend=0.8))):
        data = bpy.data.meshes.new(name)
        data.from_pydata(mesh.vertices.tolist(), [], mesh.triangles[: -2 if name == "B" else None].tolist())
        bpy.context.collection.objects.link(bpy.data.objects.new(name, data))
    c.only(bpy.data.objects["A"], bpy.data.objects["B"])
    before = everything()
    pressed, window = Pressed(), a_window()
    pressed.aligned = True
    assert pressed.invoke(window, event("LEFTMOUSE")) == {"RUNNING_MODAL"}
    assert pressed.modal(window, event("ESC")) == {"RUNNING_MODAL"}
    pressed._job.wait()
    assert isinstance(pressed._job.error, cp.Canceled)
    assert pressed.modal(window, event("TIMER")) == {"CANCELLED"}
    assert pressed.done == [] and differences(before, everything()) == []
    assert pressed.said == [("INFO", "Pressed: canceled, nothing was changed")]


class Lengthy(Pressed):
    """Something that takes long once the map is known."""

    def __init__(self):
        super().__init__()
        self.reached, self.go_on = threading.Event(), threading.Event()

    def computation(self, pairs):
        def compute(found, progress):
            self.reached.set()
            self.go_on.wait()
            if progress is not None and not progress(0.5):
                raise cp.Canceled("canceled")
            return ["computed" for _ in found]

        return compute


@pytest.mark.parametrize("kept", [False, True])
def test_what_takes_long_runs_beside_blender(hero, kept):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    if kept:
        bpy.ops.counterpart.match()
    pressed, window = Lengthy(), a_window()
    assert pressed.invoke(window, event("LEFTMOUSE")) == {"RUNNING_MODAL"}
    pressed.reached.wait()
    assert pressed.modal(window, event("TIMER")) == {"RUNNING_MODAL"} and pressed.done == []
    pressed.go_on.set()
    pressed._job.wait()
    assert pressed._job.fraction == (0.5 if kept else 0.75)
    assert pressed.modal(window, event("TIMER")) == {"FINISHED"}
    assert pressed.computed == ["computed"] and len(pressed.done) == 1


def test_escape_is_heard_once_the_map_is_there_too(hero):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    before = everything()
    pressed, window = Lengthy(), a_window()
    pressed.invoke(window, event("LEFTMOUSE"))
    pressed.reached.wait()
    pressed.modal(window, event("ESC"))
    pressed.go_on.set()
    pressed._job.wait()
    assert pressed.modal(window, event("TIMER")) == {"CANCELLED"}
    assert pressed.done == [] and differences(before, everything()) == []


@pytest.mark.parametrize("name", ["fit", "join_shape_keys", "in_betweens"])
def test_computations_report_and_can_be_canceled(hero, name):
    """Those of the operators themselves, at each step that they report."""
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    pair = read_pair(hero, other, Options(), None)
    own = types.SimpleNamespace(stiffness=1, place="WORLD", count=2)
    kind = {cls.bl_idname: cls for cls in operators.CLASSES}[f"counterpart.{name}"]
    compute = kind.computation(own, [pair])
    said = []
    compute([pair.kept], lambda fraction: said.append(fraction) or True)
    assert len(said) > 3 and said == sorted(said) and said[0] >= 0 and said[-1] <= 1
    for limit in (0, 0.1, 0.4):
        with pytest.raises(cp.Canceled):
            compute([pair.kept], lambda fraction, limit=limit: fraction < limit)


def test_closing_the_dialog_is_no_error(hero):
    Pressed().cancel(a_window())


@pytest.mark.parametrize("kind", [Pressed, Lengthy])
def test_a_doubtful_map_is_told_before_anything_is_changed(hero, monkeypatch, kind):
    """And before anything is computed with it."""
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    real = matching.match_pair
    doubted = {"verdict": "check", "reason": "left may be right"}
    monkeypatch.setattr(matching, "match_pair", lambda *each: replace(real(*each), **doubted))
    pressed, window = kind(), a_window()
    pressed.invoke(window, event("LEFTMOUSE"))
    pressed._job.wait()
    assert pressed.modal(window, event("TIMER")) == {"FINISHED"}
    assert pressed.done == [] and pressed.computed == []
    assert pressed.said[0][0] == "WARNING" and "left may be right" in pressed.said[0][1]
    assert stored(other.data).verdict == "check"


@pytest.mark.parametrize("kind", [Pressed, Lengthy])
def test_pressed_again_asks_and_goes_on_when_confirmed(hero, kind):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    other.data["counterpart"]["verdict"] = "do not use"
    pressed, window = kind(), a_window()
    window.window_manager.invoke_props_dialog = lambda op, **_: {"RUNNING_MODAL"}
    pressed.invoke(window, event("LEFTMOUSE"))
    assert pressed.done == [] and pressed.use_doubtful
    if kind is Pressed:
        assert pressed.execute(window) == {"FINISHED"}
    else:
        assert pressed.execute(window) == {"RUNNING_MODAL"}
        pressed.go_on.set()
        pressed._job.wait()
        assert pressed.modal(window, event("TIMER")) == {"FINISHED"}
    assert len(pressed.done) == 1
    pressed.execute(window)  # with other options: at once
    assert len(pressed.done) == 2


def test_a_rejected_map_needs_consent(hero, monkeypatch):
    other = c.remeshed(hero, "Other")
    c.only(hero, other)
    bpy.ops.counterpart.match()
    other.data["counterpart"]["verdict"] = "do not use"
    rejected = stored(other.data)
    monkeypatch.setattr("counterpart_extension.matching.match_pair", lambda pair, _: rejected)
    assert bpy.ops.counterpart.match() == {"FINISHED"}
    before = everything()
    with pytest.raises(RuntimeError, match="Use Doubtful Maps"):
        bpy.ops.counterpart.transfer()
    assert differences(before, everything()) == []
    assert bpy.ops.counterpart.show(what="MAP") == {"FINISHED"}  # to see why
    assert bpy.ops.counterpart.transfer(use_doubtful=True) == {"FINISHED"}


def test_one_that_is_refused_stops_all(hero):
    """Nothing is half done: the first would have worked."""
    first, _ = c.shuffled(hero, "First")
    second = c.remeshed(hero, "Second")
    before = everything()
    c.only(hero, first, second)
    with pytest.raises(RuntimeError, match="'Second' does not have the same vertices"):
        bpy.ops.counterpart.restore_order()
    assert differences(before, everything()) == []


@pytest.mark.parametrize("scale", [(0, 0, 0), (1, 0, 0)])
def test_a_mesh_without_area_is_refused(hero, scale):
    other = c.decimated(hero, "Other", 0.1)
    other.data.transform(Matrix.Diagonal((*scale, 1)))
    for order in ((hero, other), (other, hero)):
        c.only(*order)
        with pytest.raises(RuntimeError, match="The faces of 'Other' have no area"):
            bpy.ops.counterpart.transfer(rig=False)


@pytest.fixture
def elsewhere(hero, hero_file, tmp_path):
    """The character in another file than the open one."""
    return str(shutil.copy(hero_file, tmp_path / "library.blend"))


def test_linked_and_overridden_objects_are_refused(hero, elsewhere):
    other = c.remeshed(hero, "Other")
    with bpy.data.libraries.load(elsewhere, link=True) as (_, to):
        to.objects = ["Hero"]
    linked = to.objects[0]
    bpy.context.collection.objects.link(linked)
    c.only(other, linked)
    with pytest.raises(RuntimeError, match=r"linked from another file.*Make Local"):
        bpy.ops.counterpart.transfer()
    override = linked.override_create()
    bpy.context.collection.objects.link(override)
    override.data.override_create() if override.data.override_library is None else None
    bpy.context.collection.objects.unlink(linked)
    c.only(other, override)
    with pytest.raises(RuntimeError, match="Make Local"):
        bpy.ops.counterpart.transfer()


def test_a_linked_object_can_be_the_active_one(hero, elsewhere):
    other = c.remeshed(hero, "Other")
    with bpy.data.libraries.load(elsewhere, link=True) as (_, to):
        to.objects = ["Hero"]
    bpy.context.collection.objects.link(to.objects[0])
    c.only(to.objects[0], other)
    assert bpy.ops.counterpart.transfer(rig=False) == {"FINISHED"}


def test_a_mesh_of_several_objects_is_not_changed(hero):
    """As Alt D makes them: what is written to one would be on the other too."""
    other = c.remeshed(hero, "Other")
    twin = bpy.data.objects.new("Twin", other.data)
    bpy.context.collection.objects.link(twin)
    before = everything()
    for selected in ([other], [other, twin]):
        c.only(hero, *selected)
        with pytest.raises(RuntimeError, match=r"'\w+' shares its data.*Make Single User > Object & Data"):
            bpy.ops.counterpart.transfer()
    c.only(other, hero)
    with pytest.raises(RuntimeError, match="'Other' shares its data"):
        bpy.ops.counterpart.join_shape_keys()
    assert differences(before, everything()) == []
    bpy.data.objects.remove(twin)
    other.data.use_fake_user = True  # keeps it in the file, and is nobody who would see the change
    c.only(hero, other)
    assert bpy.ops.counterpart.transfer() == {"FINISHED"}


def test_what_only_reads_takes_a_mesh_of_several_objects_and_keeps_no_map_with_it(hero):
    other = c.remeshed(hero, "Other")
    bpy.context.collection.objects.link(bpy.data.objects.new("Twin", other.data))
    c.only(hero, other)
    pressed, window = Pressed(), a_window()
    pressed.writes_selected = False
    pressed.invoke(window, event("LEFTMOUSE"))
    pressed._job.wait()
    assert pressed.modal(window, event("TIMER")) == {"FINISHED"}
    assert len(pressed.done) == 1 and stored(other.data) is None


def test_sentences_for_what_is_no_mesh(hero):
    empty = bpy.data.objects.new("Crowd", None)
    empty.instance_type = "COLLECTION"
    bpy.context.collection.objects.link(empty)
    c.only(hero, empty)
    with pytest.raises(RuntimeError, match=r"'Crowd' is an instance of a collection.*Make Instances Real"):
        bpy.ops.counterpart.match()
    twin = bpy.data.objects.new("Twin", hero.data)
    bpy.context.collection.objects.link(twin)
    c.only(hero, twin)
    with pytest.raises(RuntimeError, match="share one mesh"):
        bpy.ops.counterpart.fit()
    bpy.data.objects.remove(twin)
    flat = c.remeshed(hero, "Flat")
    flat.scale = (1, 1, 0)
    c.only(hero, flat)
    with pytest.raises(RuntimeError, match="'Flat' is scaled to nothing"):
        bpy.ops.counterpart.match()
    c.only(hero, hero.parent)
    with pytest.raises(RuntimeError, match="'Hero rig' is no mesh: deselect it"):
        bpy.ops.counterpart.match()
    curve = bpy.data.objects.new("Curve", bpy.data.curves.new("Curve", "CURVE"))
    bpy.context.collection.objects.link(curve)
    c.only(hero, curve)
    with pytest.raises(RuntimeError, match="'Curve' is no mesh: Object > Convert > Mesh"):
        bpy.ops.counterpart.match()


def test_instances_that_nodes_make_are_no_faces(hero):
    other = c.remeshed(hero, "Other")
    tree, group_input, group_output = c.node_tree()
    points = tree.nodes.new("GeometryNodeInstanceOnPoints")
    tree.links.new(group_input.outputs[0], points.inputs["Points"])
    tree.links.new(points.outputs[0], group_output.inputs[0])
    other.modifiers.new("Crowd", "NODES").node_group = tree
    c.only(hero, other)
    with pytest.raises(RuntimeError, match=r"modifiers of 'Other' make has no faces.*Realize Instances"):
        bpy.ops.counterpart.fit(seen=True)
    assert bpy.ops.counterpart.fit() == {"FINISHED"}


def test_when_operators_can_be_pressed(hero):
    other = c.remeshed(hero, "Other")
    c.only(hero)
    assert not bpy.ops.counterpart.match.poll()
    c.only(hero.parent, other)  # the active one is no mesh
    assert not bpy.ops.counterpart.match.poll()
    c.only(hero, other)
    assert bpy.ops.counterpart.match.poll()
    for mode in ("EDIT", "WEIGHT_PAINT"):
        bpy.ops.object.mode_set(mode=mode)
        assert not bpy.ops.counterpart.match.poll()
        bpy.ops.object.mode_set(mode="OBJECT")


def test_a_job_reports_and_passes_errors_on():
    job = Job(lambda progress: progress(0.5) and 7)
    job.wait()
    assert (job.is_done, job.fraction, job.result, job.error) == (True, 0.5, 7, None)
    failed = Job(lambda progress: 1 / 0)
    failed.wait()
    assert isinstance(failed.error, ZeroDivisionError)

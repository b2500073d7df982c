# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Undo, cancel, save and load: whatever happens, a person's work is as it was or as it should be."""

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
from counterpart_extension.stored_map import stored
from digest import differences, everything

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
    for mode in ("EDIT", "OBJECT"):  # Blender 5 drops attributes that say nothing on the way
        bpy.ops.object.mode_set(mode=mode)
    before = everything()
    bpy.ops.object.mode_set(mode="EDIT")
    for obj in (hero, other):
        c.select_vertices(obj, [7])
    bpy.ops.ed.undo_push(message="Start")
    bpy.ops.counterpart.add_landmark("EXEC_DEFAULT", True)
    bpy.ops.ed.undo()
    if bpy.context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    left = {"Hero: groups", "Other: groups"} if bpy.app.version < (4, 5) else set()  # Blender's, empty
    assert set(differences(before, everything())) <= left
    assert bpy.ops.counterpart.match() == {"FINISHED"}
    assert len(read_pair(hero, other, Options(), None).landmarks) == 0


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
    assert len(said) > 1 and said == sorted(said) and said[0] >= 0 and said[-1] <= 1  # as often as time passes
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


def test_a_job_reports_and_passes_errors_on():
    job = Job(lambda progress: progress(0.5) and 7)
    job.wait()
    assert (job.is_done, job.fraction, job.result, job.error) == (True, 0.5, 7, None)
    failed = Job(lambda progress: 1 / 0)
    failed.wait()
    assert isinstance(failed.error, ZeroDivisionError)

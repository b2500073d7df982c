# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What all operators that need a map share: they look at everything first, match where no map is kept, tell the
verdict, and only then change something."""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from contextlib import contextmanager
from dataclasses import replace

import bpy
import counterpart3d as cp

from ..job import Job, Progress, part_of
from ..landmarks import not_paired
from ..matching import match_pairs
from ..objects import Refused, require_editable
from ..pairs import Options, Pair, can_be_kept, read_pair
from ..stored_map import StoredMap, store
from ..writing import require_short

LINE = 80  # characters of a sentence in the dialog
PARTS = (
    ("unknown", "Seen from the Meshes", "Open meshes are matched as parts, closed ones as wholes"),
    ("source", "Selected Is a Part", "The selected objects show only a part of the active one"),
    ("target", "Active Is a Part", "The active object shows only a part of the selected ones"),
    ("both", "Both Are Parts", "They show parts of one thing that overlap"),
    ("neither", "Both Are Whole", "Both show the whole, with holes or fused parts"),
)


Computation = Callable[[list[StoredMap], Progress], list]


class WithMap:
    """Base of the operators. They say in `prepare` what they do with one selected object."""

    bl_options = {"REGISTER", "UNDO"}  # noqa: RUF012
    writes_active = False  # the active object is changed
    writes_selected = True
    trusts = True  # the result is only as good as the map: doubts are told before
    uses_kept = True  # a map that the selected object keeps is not made again
    may_differ = False  # the modifiers of a selected object may make other vertices

    seen: bpy.props.BoolProperty(
        name="As Seen, with Modifiers",
        description="Match the shapes that the modifiers make (posed, sculpted), not those of Edit Mode",
        default=False,
    )
    aligned: bpy.props.BoolProperty(
        name="Facing the Same Way",
        description="Left, up and front of both objects point the same way, roughly: fewer things to confuse",
        default=False,
    )
    part: bpy.props.EnumProperty(name="Parts", description="Which object shows only a part of the other", items=PARTS)
    use_doubtful: bpy.props.BoolProperty(
        name="Use Doubtful Maps",
        description="Go on even where the verdict is 'do not use'",
        default=False,
        options={"SKIP_SAVE"},
    )

    def computation(self, pairs: list[Pair]) -> Computation | None:
        """What takes long: a function that touches nothing of Blender's, since it runs beside it, can be canceled, and
        returns something for each pair."""
        return None

    def prepare(self, context, pair: Pair, found: StoredMap, computed) -> Callable[[], list[str]]:
        """Reads all that is needed and changes nothing; what it returns changes the objects, and returns notices."""
        raise NotImplementedError

    def prepare_all(self, context, pairs: list[Pair], found: list[StoredMap], computed: list) -> list[Callable]:
        """`prepare` for each; those that need them all at once override it."""
        return [self.prepare(context, *each) for each in zip(pairs, found, computed, strict=True)]

    def key_names(self, names: list[str]) -> list[str]:
        """Of the shape keys that it makes for selected objects with these names."""
        return []

    @classmethod
    def poll(cls, context):
        active, others = (
            context.active_object,
            [obj for obj in context.selected_objects if obj != context.active_object],
        )
        if active is None or active.type != "MESH" or not others:
            cls.poll_message_set("Select one or several meshes, then the active one last (Shift click)")
            return False
        if context.mode != "OBJECT":
            cls.poll_message_set("Only in Object Mode (Tab)")
            return False
        return True

    def invoke(self, context, event):
        with self._refusing():
            pairs = self._pairs(context)
            if any(pair.kept is None for pair in pairs):
                return self._start(context, pairs)
            if self.trusts and any(pair.kept.verdict != "use" for pair in pairs):
                return self._ask(context, pairs)
            return self._begin(context, pairs)
        return {"CANCELLED"}

    def execute(self, context):
        with self._refusing():
            pairs = self._pairs(context)
            if self._was_asked():
                return self._begin(context, pairs)
            found = match_pairs(pairs, None)
            self._require_trust(pairs, found)
            return self._finish(context, pairs, found, self._computed(pairs)(found, None))
        return {"CANCELLED"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self._job.cancel()
            context.workspace.status_text_set("Canceling ...")
        if event.type == "TIMER" and self._job.is_done:
            self._end(context)
            with self._refusing():
                if self._job.error is not None:
                    raise self._job.error
                return self._matched(context)
            return {"CANCELLED"}
        if event.type == "TIMER" and not self._job.is_canceled:
            context.workspace.status_text_set(f"{self.bl_label}: {self._job.fraction:.0%}     Esc: cancel")
        return {"RUNNING_MODAL"}  # nothing else may change the objects meanwhile

    def cancel(self, context):
        """Blender closes, or the person closes the dialog, in which case no job runs."""
        if hasattr(self, "_job"):
            self._job.cancel()
            self._end(context)

    def _end(self, context):
        """What the job left in the window goes."""
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)

    def draw(self, context):
        """In the panel of the last operation, and in the dialog that asks."""
        layout = self.layout
        for sentence in getattr(self, "_doubts", ()):
            for i, line in enumerate(textwrap.wrap(sentence, LINE)):
                layout.label(text=line, icon="NONE" if i else "ERROR")
        layout.use_property_split = True
        for name in self.__class__.__annotations__:
            layout.prop(self, name)
        layout.separator()
        for name in ("seen", "aligned", "part", "use_doubtful"):
            layout.prop(self, name)

    def _start(self, context, pairs):
        self._matching = pairs
        self._job = Job(self._work(pairs))
        self._timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def _begin(self, context, pairs):
        """All maps are there."""
        if self.computation(pairs) is not None:
            return self._start(context, pairs)
        return self._finish(context, pairs, [pair.kept for pair in pairs], [None] * len(pairs))

    def _work(self, pairs):
        """For a job: the maps, and what is computed with them, unless a doubt is told first."""
        compute, matches = self._computed(pairs), any(pair.kept is None for pair in pairs)
        tells = [self.trusts and matches and can_be_kept(pair) for pair in pairs]
        share = 1 if self.computation(pairs) is None else 0.5 if matches else 0

        def work(progress):
            found = match_pairs(pairs, part_of(progress, 0, share))
            doubted = any(tell and answer.verdict != "use" for tell, answer in zip(tells, found, strict=True))
            return found, None if doubted else compute(found, part_of(progress, share, 1))

        return work

    def _computed(self, pairs) -> Computation:
        return self.computation(pairs) or (lambda found, progress: [None] * len(pairs))

    def _was_asked(self) -> bool:
        """Once: options that are changed later run at once."""
        asked = getattr(self, "_asked", False)
        self._asked = False
        return asked

    def _ask(self, context, pairs):
        """The dialog with the verdicts: nothing is changed unless it is confirmed."""
        self._doubts = [
            f"{pair.selected_object.name}, {pair.kept.sentence}" for pair in pairs if pair.kept.verdict != "use"
        ]
        self.use_doubtful = self._asked = True  # whoever confirms wants that
        return context.window_manager.invoke_props_dialog(
            self, width=480, title="Look at the Map before Using It", confirm_text="Use It All the Same"
        )

    def _matched(self, context):
        """The maps are kept as a step of their own, which stays when the operator is undone or gets other options."""
        found, computed = self._job.result
        kept = [each for each in zip(self._matching, found, strict=True) if can_be_kept(each[0])]
        made = [(pair, answer) for pair, answer in kept if answer is not pair.kept]
        for pair, answer in made:
            store(pair.selected_object.data, answer)
        if made:
            bpy.ops.ed.undo_push(message="Match")
        if computed is not None:
            return self._finish(context, self._matching, found, computed)
        for notice in _unused_landmarks(self._matching):
            self.report({"WARNING"}, notice)
        for pair, answer in kept:
            if answer.verdict != "use":
                self.report(
                    {"WARNING"},
                    f"'{pair.selected_object.name}', {answer.sentence}. Nothing was changed: press again to go on",
                )
        return {"FINISHED"}

    def _pairs(self, context) -> list[Pair]:
        active = context.active_object
        others = [obj for obj in context.selected_objects if obj != active]
        if self.writes_active:
            require_editable(active)
        if self.writes_selected:
            for obj in others:
                require_editable(obj)
        require_short(self.key_names([obj.name for obj in others]))
        options = Options(seen=self.seen, aligned=self.aligned, part=self.part)
        depsgraph = context.evaluated_depsgraph_get()
        pairs = [read_pair(active, obj, options, depsgraph, may_differ=self.may_differ) for obj in others]
        return pairs if self.uses_kept else [replace(pair, kept=None) for pair in pairs]

    def _require_trust(self, pairs: list[Pair], found: list[StoredMap]) -> None:
        for pair, answer in zip(pairs, found, strict=True):
            if self.trusts and answer.verdict == "do not use" and not self.use_doubtful:
                raise Refused(
                    f"'{pair.selected_object.name}', {answer.sentence}. 'Use Doubtful Maps' goes on all the same"
                )

    def _finish(self, context, pairs: list[Pair], found: list[StoredMap], computed: list):
        self._require_trust(pairs, found)
        changes = self.prepare_all(context, pairs, found, computed)
        for pair, answer in zip(pairs, found, strict=True):
            if self.writes_selected and answer is not pair.kept:
                store(pair.selected_object.data, answer)
        notices = _unused_landmarks(pairs)
        notices += [notice for change in changes for notice in change()]
        for pair, answer in zip(pairs, found, strict=True):
            if answer.verdict != "use":
                notices.append(f"'{pair.selected_object.name}', {answer.sentence}")
        for pair in pairs:
            pair.selected_object.data.update()
        pairs[0].active_object.data.update()
        for notice in notices:
            self.report({"WARNING"}, notice)
        if not notices:
            self.report({"INFO"}, f"{self.bl_label}: {', '.join(repr(pair.selected_object.name) for pair in pairs)}")
        return {"FINISHED"}

    @contextmanager
    def _refusing(self):
        """What is refused is said, and ends in CANCELLED."""
        try:
            yield
        except cp.Canceled:
            self.report({"INFO"}, f"{self.bl_label}: canceled, nothing was changed")
        except (Refused, cp.InvalidInput, cp.UnsuitableMesh, cp.NumericalError) as error:
            self.report({"ERROR"}, str(error))


def _unused_landmarks(pairs: list[Pair]) -> list[str]:
    """Told when a map is made, not each time that it is used."""
    sentences = [not_paired(pair.active_object, pair.selected_object) for pair in pairs if pair.kept is None]
    return [sentence for sentence in sentences if sentence]

# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Which point of this mesh is that point of the other? An extension of Blender on the package counterpart3d.

`operators` are what a person presses; what they do lies in modules that know no operator: `objects` and `pairs` read,
`matching` matches, `carrier` carries numbers along the map, `carried` has one module for each kind of data.
"""

import bpy

from . import operators, panel

CLASSES = (*operators.CLASSES, *panel.CLASSES)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)


def unregister():
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)

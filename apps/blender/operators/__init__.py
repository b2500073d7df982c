# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What a person can do: one operator in each file. `with_map` holds what they share."""

from . import add_landmark, fit, in_betweens, join_shape_keys, match, restore_order, show, transfer

CLASSES = (
    match.COUNTERPART_OT_match,
    restore_order.COUNTERPART_OT_restore_order,
    transfer.COUNTERPART_OT_transfer,
    fit.COUNTERPART_OT_fit,
    join_shape_keys.COUNTERPART_OT_join_shape_keys,
    in_betweens.COUNTERPART_OT_in_betweens,
    show.COUNTERPART_OT_show,
    add_landmark.COUNTERPART_OT_add_landmark,
)

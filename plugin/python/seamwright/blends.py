# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blends of joints and of curves, and lofts through frames."""

from ._core import (
    JointBlend,
    SplineBlend,
    auxiliary_points,
    balance_ratios,
    balance_relations,
    balanced_poles,
    blend_joint,
    edge_ribbon,
    even_rate,
    frame_loft,
    frame_sheet,
    plain_blend,
)
from .results import (
    AuxiliaryPoints,
    BalanceFault,
    BalanceRatios,
    BlendedJoint,
    FrameLoft,
    FrameRibbon,
    PlainBlend,
    ShortestBlend,
    SplineFrame,
    SplineJoint,
)

__all__ = [
    "AuxiliaryPoints",
    "BalanceFault",
    "BalanceRatios",
    "BlendedJoint",
    "FrameLoft",
    "FrameRibbon",
    "JointBlend",
    "PlainBlend",
    "ShortestBlend",
    "SplineBlend",
    "SplineFrame",
    "SplineJoint",
    "auxiliary_points",
    "balance_ratios",
    "balance_relations",
    "balanced_poles",
    "blend_joint",
    "edge_ribbon",
    "even_rate",
    "frame_loft",
    "frame_sheet",
    "plain_blend",
]

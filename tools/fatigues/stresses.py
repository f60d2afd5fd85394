# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Algebra of stress histories. A stress has six components, in the order of the columns of lines: xx, yy, zz, xy, xz, yz (MPa,
tension is > 0); a history is (points, steps, 6)."""
import numpy as np

ORDER = ("xx", "yy", "zz", "xy", "xz", "yz")
_OF_NINE = [0, 4, 8, 1, 2, 5]  # where they stand in the rows of a tensor
_IN_TENSOR = [[0, 3, 4], [3, 1, 5], [4, 5, 2]]


def of_nine(tensors):
    """(..., 9), the rows of tensors as in volume files -> (..., 6)."""
    return np.asarray(tensors, dtype=float)[..., _OF_NINE]


def tensors(stress):
    """(..., 6) -> (..., 3, 3)."""
    return np.asarray(stress)[..., _IN_TENSOR]


def of_tensors(matrices):
    """(..., 3, 3) -> (..., 6)."""
    return np.stack([matrices[..., i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))], axis=-1)


def hydrostatic(stress):
    """(..., 6) -> (...), a third of the trace: > 0 in tension, MPa."""
    return stress[..., :3].mean(axis=-1)


def deviatoric(stress):
    """(..., 6) -> (..., 5), coordinates of the deviator in which the square of the length is J2 = s : s / 2, MPa."""
    xx, yy, zz = np.moveaxis(stress[..., :3], -1, 0)
    return np.concatenate([np.stack([(xx - yy) / 2, (2 * zz - xx - yy) / np.sqrt(12)], axis=-1), stress[..., 3:]], axis=-1)


def of_deviatoric(five):
    """(..., 5) -> (..., 6), the deviator with these coordinates, MPa."""
    first, second = five[..., 0], five[..., 1] / np.sqrt(3)
    return np.concatenate([np.stack([first - second, -first - second, 2 * second], axis=-1), five[..., 2:]], axis=-1)


def tangents(normals):
    """(..., 3), unit normals -> (..., 2, 3), two directions in each plane, at right angles."""
    least = np.eye(3)[np.argmin(np.abs(normals), axis=-1)]
    first = np.cross(normals, least)
    first /= np.linalg.norm(first, axis=-1, keepdims=True)
    return np.stack([first, np.cross(normals, first)], axis=-2)


def plane_weights(normals):
    """(..., 3) -> (..., 3, 6): what a stress times them has on the plane: normal stress, and shear along both tangents."""
    directions = np.concatenate([normals[..., None, :], tangents(normals)], axis=-2)
    products = directions[..., :, None] * normals[..., None, None, :]
    symmetric = products + np.swapaxes(products, -1, -2)
    diagonal = np.stack([products[..., i, i] for i in range(3)], axis=-1)
    return np.concatenate([diagonal, np.stack([symmetric[..., i, j] for i, j in ((0, 1), (0, 2), (1, 2))], axis=-1)], axis=-1)


def on_planes(stress, normals):
    """Stress on planes: (points, steps, 6) and normals (points or 1, planes, 3) -> normal stress (points, planes, steps) and
    shear (points, planes, steps, 2), MPa."""
    weights = plane_weights(normals)
    n, planes = weights.shape[:2]
    on_all = np.matmul(weights.reshape(n, planes * 3, 6), np.swapaxes(stress, 1, 2))
    on_all = on_all.reshape(len(stress), planes, 3, -1)
    return on_all[:, :, 0], np.moveaxis(on_all[:, :, 1:], 2, 3)

# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Measured loops of tangential force over the displacement of the actuator, and records of wear, from CSV files."""
import dataclasses
import math

import numpy as np
from run_folder import BadFile, one_line, rows_of

FORCES = {"held_force_x": ((1, 0), 1), "held_force_y": ((0, 1), 1), "force_x": ((1, 0), -1), "force_y": ((0, 1), -1)}
LEAST_ROWS = 12  # of a loop
TURN = 0.2  # of the stroke: a way back that is shorter is noise, not a turning point
CLOSED = 0.1  # of displacement and force amplitude: a loop whose ends are as near as this is closed
STRAY = 0.08  # of the amplitude: largest scatter of turning points, and of the motion across its line
ON_AXIS = 0.01  # sine of the angle below which a motion is along an axis
ALLOWED = ("allowed are ux, uy (mm) with held_force_x, held_force_y or force_x, force_y (N), or displacement (mm) with force (N) "
           "and perhaps direction (degrees), and total_dissipation (N mm) with worn_volume (mm^3), or wear_depth (mm) and "
           "contact_area (mm^2)")


class WrongData(ValueError):
    """What is measured cannot be used; the words are one line."""

    def __init__(self, words):
        super().__init__(one_line(words))


@dataclasses.dataclass
class Loop:
    """A settled loop of n rows. direction: (2,), unit vector of the motion along x and y. amplitude: half of the stroke, mm.
    way: (n,), way of each row since the last turning point, mm, and is_up: (n,), whether it goes along `direction`.
    place: (n,), displacement from the middle of the stroke, mm. force: (n, k), N, on the held face along the k unit vectors
    `axes` (k, 2). scale: amplitude of the force along the motion, N."""
    name: str
    direction: np.ndarray
    amplitude: float
    way: np.ndarray
    is_up: np.ndarray
    place: np.ndarray
    force: np.ndarray
    axes: np.ndarray
    scale: float

    def along(self):
        """(n,): the force along the motion, N."""
        return along_motion(self.force, self.axes, self.direction)

def along_motion(force, axes, direction):
    """(n,), N, of forces (n, k) along axes (k, 2): by the components along x and y, or the one along the motion."""
    return force @ np.linalg.lstsq(axes.T.astype(float), direction, rcond=None)[0]


@dataclasses.dataclass
class WearRecord:
    """energy: (n,), dissipated since the start, N mm; volume: (n,), worn off since the start, mm^3."""
    name: str
    energy: np.ndarray
    volume: np.ndarray


def columns_of(path):
    """{column: (n,)} of a file all of whose entries are numbers, but for words in columns that are not used."""
    try:
        names, rows = rows_of(path)
    except BadFile as problem:
        raise WrongData(problem) from problem
    used = {"ux", "uy", "displacement", "direction", "force", "loop", "cycle", "total_dissipation", "worn_volume", "wear_depth",
            "contact_area", *FORCES}
    found = {}
    for place, name in enumerate(names):
        if name.strip() in used:
            found[name.strip()] = np.array([number(path, i, name, row[place]) for i, row in enumerate(rows, 1)])
    if not rows:
        raise WrongData(f"{path}: has no rows; {ALLOWED}")
    return found


def number(path, row, column, text):
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise WrongData(f"{path}: row {row}, column {column.strip()}: '{text[:40]}': allowed is a number with a decimal point")
    return value


def read(paths):
    """([Loop], [WearRecord]) of all files."""
    loops, records = [], []
    for path in paths:
        columns = columns_of(path)
        if "cycle" in columns and "loop" not in columns:  # as in history.csv: cycle 0 is the preload
            columns = {name: values[columns["cycle"] > 0] for name, values in columns.items()}
        volume = columns.get("worn_volume")
        if volume is None and {"wear_depth", "contact_area"} <= set(columns):
            volume = columns["wear_depth"] * columns["contact_area"]
        has_wear = volume is not None and "total_dissipation" in columns
        if has_wear and np.any(volume > 0):
            records.append(WearRecord(path.stem, columns["total_dissipation"], volume))
        if "force" in columns or any(name in columns for name in FORCES):
            loops += loops_of(path, columns)
        elif not has_wear:
            raise WrongData(f"{path}: has no column of force; {ALLOWED}")
    if not loops and not records:
        raise WrongData(f"{paths[0]}: has neither loops nor wear; {ALLOWED}")
    return loops, records


def loops_of(path, columns):
    numbers = columns.get("loop", np.zeros(len(next(iter(columns.values())))))
    for value in np.unique(numbers):
        name = f"{path.stem} {value:g}" if "loop" in columns else path.stem
        rows = {key: values[numbers == value] for key, values in columns.items()}
        try:
            yield loop_of(name, rows)
        except WrongData as problem:
            raise WrongData(f"{path}: loop {value:g}: {problem}" if "loop" in columns else f"{path}: {problem}") from problem


def loop_of(name, rows):
    if len(next(iter(rows.values()))) < LEAST_ROWS:
        raise WrongData(f"has {len(next(iter(rows.values())))} rows; allowed are at least {LEAST_ROWS} for each loop")
    direction, place = motion_of(rows)
    force, axes = forces_of(rows, direction)
    along = along_motion(force, axes, direction)
    way, is_up, counts, (low, high) = branches_of(place, along)
    if np.sum(np.roll(along, -1) * (np.roll(place, -1) - np.roll(place, 1))) < 0:
        raise WrongData("has forces against its motion; allowed are held_force_x, held_force_y or force, which push the body "
                        "along its motion, and force_x, force_y, by which the counterface resists it")
    scale = np.ptp(np.percentile(along[counts], [2, 98])) / 2
    if not scale > 0:
        raise WrongData("has no force along its motion; allowed are forces that change")
    return Loop(name, direction, (high - low) / 2, way[counts], is_up[counts], place[counts] - (high + low) / 2, force[counts], axes,
                scale)


def on_axis(direction):
    """The unit vector (2,), along an axis where it is nearly so."""
    direction = np.where(np.abs(direction) < ON_AXIS, 0, direction)
    return direction / np.hypot(*direction)


def motion_of(rows):
    """Unit vector of the motion, (2,), and the displacement along it, (n,), mm."""
    if "displacement" in rows:
        angles = rows.get("direction", np.zeros(1))
        if np.ptp(angles) > 0:
            raise WrongData("its column direction changes; allowed is one direction for each loop")
        angle = math.radians(angles[0])
        direction, place = on_axis(np.array([math.cos(angle), math.sin(angle)])), rows["displacement"]
    elif "ux" in rows or "uy" in rows:
        n = len(next(iter(rows.values())))
        motion = np.stack([rows.get(name, np.zeros(n)) for name in ("ux", "uy")], axis=1)
        centred = motion - motion.mean(axis=0)
        direction = np.linalg.svd(centred, full_matrices=False)[2][0]
        direction *= 1 if direction[np.argmax(np.abs(direction))] > 0 else -1
        direction = on_axis(direction)
        place, across = motion @ direction, centred @ [-direction[1], direction[0]]
        if np.abs(across).max() > STRAY * max(np.ptp(place), 1e-300) and np.std(across) > STRAY / 2 * np.std(place):
            raise WrongData("its motion is no straight line; allowed are motions to and fro along one direction")
    else:
        raise WrongData(f"has no column of displacement; {ALLOWED}")
    if not np.ptp(place) > 0:
        raise WrongData("does not move; allowed is a motion to and fro")
    return direction, place


def forces_of(rows, direction):
    """Forces on the held face, (n, k), N, and their unit vectors, (k, 2). Forces across the motion that are nothing are left
    out, because rows without noise would hide the noise of the others."""
    if "force" in rows:
        return rows["force"][:, None], direction[None, :]
    kind = "held_force_{}" if "held_force_x" in rows or "held_force_y" in rows else "force_{}"
    names = [kind.format(axis) for axis in "xy" if kind.format(axis) in rows]
    if not names:
        raise WrongData(f"has no column of force; {ALLOWED}")
    force = np.stack([FORCES[name][1] * rows[name] for name in names], axis=1)
    axes = np.array([FORCES[name][0] for name in names])
    missing = [axis for axis in (0, 1) if direction[axis] != 0 and not np.any(axes[:, axis])]
    if missing:
        raise WrongData(f"moves along {'xy'[missing[0]]} and has no column {kind.format('xy'[missing[0]])}; {ALLOWED}")
    kept = [i for i in range(len(names)) if direction[np.argmax(axes[i])] != 0 or np.ptp(force[:, i]) > 1e-6 * np.ptp(force)]
    return force[:, kept], axes[kept]


def turning_points(place, least):
    """[(row, is at the high end)] of turning points behind which the motion goes back by more than `least` (mm), and whether
    the first rows go up."""
    low = high = 0
    up, began_up, turns = None, None, []
    for i, value in enumerate(place):
        low, high = (i if value < place[low] else low), (i if value > place[high] else high)
        if up is not True and value - place[low] > least:
            turns += [(low, False)] if up is False else []
            up, high = True, i
        elif up is not False and place[high] - value > least:
            turns += [(high, True)] if up is True else []
            up, low = False, i
        began_up = up if began_up is None else began_up
    return turns, bool(began_up)


def branches_of(place, along):
    """(n,) way since the last turning point, mm; (n,) whether a row goes up; (n,) whether it belongs to the settled loop; and
    both ends of the stroke. Rows before the first turning point are a first loading, unless they begin at an end of the
    stroke or the loop is closed."""
    stroke = np.ptp(place)
    turns, is_first_up = turning_points(place, TURN * stroke)
    ends = []
    for is_high in (False, True):
        found = [place[row] for row, at_high in turns if at_high == is_high] or [place.max() if is_high else place.min()]
        if np.ptp(found) > STRAY * stroke:
            raise WrongData(f"its turning points scatter by {np.ptp(found):.3g} mm; allowed are loops of one amplitude, and a column "
                            "'loop' tells several apart")
        ends.append(float(np.mean(found)))
    if not turns:
        raise WrongData("does not turn back; allowed is a motion to and fro")
    is_up = np.full(len(place), is_first_up)
    for row, at_high in turns:
        is_up[row + 1:] = not at_high
    way = np.clip(np.where(is_up, place - ends[0], ends[1] - place), 0, ends[1] - ends[0])
    is_closed = abs(place[0] - place[-1]) < CLOSED * stroke / 2 and abs(along[0] - along[-1]) < CLOSED * np.ptp(along) / 2
    counts = np.arange(len(place)) >= (0 if is_closed or way[0] < STRAY * stroke else turns[0][0])
    return way, is_up, counts, ends

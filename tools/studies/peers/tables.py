# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Tables of the race for docs/peers.md."""
import numpy as np

import forces
import race
from profiles import GROUPS, Times, label

LAWS = ("isotropic", "orthotropic", "non-associated")
SIZES = {"below 60 nodes": (0, 60), "60 to 149 nodes": (60, 150), "150 nodes and more": (150, 10**9)}


def markdown(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|---" + "|--:" * (len(head) - 1) + "|"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]) + "\n"


def short(value):
    return "–" if not np.isfinite(value) else f"{value:.3g}"


def middle(values):
    return np.median(values) if len(values) else np.nan


def groups(times):
    """Names of groups with their problems."""
    for name, laws in GROUPS.items():
        yield name, times.group(laws)
    for name, (least, most) in SIZES.items():
        yield name, [problem for problem in times.problems if least <= times.nodes.get(problem, 0) < most]


def is_first(seconds, others):
    """Where a solver solves a problem, and nobody else is faster."""
    return np.isfinite(seconds) & (seconds <= others)


def kinds(times):
    """Who solves the problems of each kind."""
    rows = []
    for family in sorted(set(times.family.values())):
        problems = [problem for problem in times.problems if times.family[problem] == family]
        every = (times.of("newton", problems), times.best(race.OURS, problems), times.best(times.peers, problems))
        most = max(np.isfinite(times.of(solver, problems)).sum() for solver in times.peers)
        rows.append((family, len(problems), *(np.isfinite(seconds).sum() for seconds in every), most,
                     f"{100 * np.mean(is_first(every[0], np.minimum(*every[1:]))):.0f}"))
    return markdown(("kind", "number", "`newton` solves", "one of ours", "one of Siconos", "the best of Siconos",
                     "`newton` first, %"), rows)


def fastest(times):
    rows = []
    for name, problems in groups(times):
        if not problems:
            continue
        newton, peers = times.of("newton", problems), times.best(times.peers, problems)
        ours, every = times.best(race.OURS, problems), times.best(times.solvers, problems)
        both = np.isfinite(newton) & np.isfinite(peers)
        ratios = newton[both] / peers[both]
        shares = (is_first(newton, every), is_first(ours, every), is_first(newton, peers))
        rows.append((name, len(problems), *(f"{100 * np.mean(share):.0f}" for share in shares), *(short(of(ratios) if len(ratios) else np.nan) for of in (np.median, np.min, np.max))))
    return markdown(("problems", "number", "`newton` first, %", "one of ours first, %", "`newton` before all of Siconos, %",
                     "median of `newton` / best of Siconos", "least", "largest"), rows)


def solvers(times, rows):
    table = []
    newton, every = times.of("newton"), times.best(times.solvers)
    for solver in times.solvers:
        seconds = times.of(solver)
        both = np.isfinite(seconds) & np.isfinite(newton)
        own = [row for row in rows if row["solver"] == solver and row["verdict"] == "solved"]
        ratios = seconds[both] / newton[both]
        apart = forces.median_difference(own)
        table.append((f"`{label(solver)}`", int(np.isfinite(seconds).sum()), f"{100 * np.mean(is_first(seconds, every)):.0f}",
                      f"{100 * np.mean(newton < seconds):.0f}" if solver != "newton" else "", short(middle(ratios)),
                      short(np.percentile(ratios, 90)) if len(ratios) else "–",
                      *(f"{middle([float(row[name]) for row in own]):.1e}" if own else "–" for name in ("error", "merit")),
                      "–" if apart is None else f"{-np.log10(max(apart, 1e-16)):.1f}"))
    return markdown(("solver", "solved", "first, %", "behind `newton`, %", "time / `newton`, median", "90 % below", "error, median",
                     "`MERIT_1`, median", "digits of the forces, median"), table)


def failures(times, rows):
    verdicts = {(row["problem"], row["solver"]): row["verdict"] for row in rows}
    table = []
    for solver in times.solvers:
        cells = []
        for law in LAWS:
            own = [verdicts[problem, solver] for problem in times.group((law,))]
            cells.append(f"{sum(verdict != 'solved' for verdict in own)} of {len(own)}")
        own = [verdicts[problem, solver] for problem in times.problems]
        late = sum(verdict == "time" for verdict in own)
        table.append((f"`{label(solver)}`", *cells, late, sum(verdict != "solved" for verdict in own) - late))
    return markdown(("not solved", *LAWS, "out of time", "otherwise"), table)


def losses(times, most=12):
    """Where newton is farthest behind a peer, and where it fails."""
    newton, peers = times.of("newton"), times.best(times.peers)
    order = np.argsort(-np.where(np.isfinite(newton), newton, 1e9) / peers)
    rows = []
    for place in [place for place in order if np.isfinite(peers[place])][:most]:
        problem = times.problems[place]
        winner = min(times.peers, key=lambda solver: times.of(solver, [problem])[0])
        ratio = newton[place] / peers[place]
        rows.append((f"`{problem}`", times.law[problem], times.nodes.get(problem, ""),
                     short(1e3 * newton[place]) if np.isfinite(newton[place]) else "fails", f"`{label(winner)}`",
                     short(1e3 * peers[place]), short(ratio)))
    return markdown(("problem", "law", "nodes", "`newton`, ms", "best of Siconos", "ms", "ratio"), rows)


def summary(times, agreement):
    """The first sentences of the page."""
    newton, peers, every = times.of("newton"), times.best(times.peers), times.best(times.solvers)
    counts = {solver: int(np.isfinite(times.of(solver)).sum()) for solver in times.solvers}
    most = max(times.peers, key=counts.get)
    both = np.isfinite(newton) & np.isfinite(peers)
    if not both.any():
        return "No problem is solved by `newton` and by Siconos.\n"
    ratios = newton[both] / peers[both]
    worst = np.array(times.problems)[both][np.argmax(ratios)]
    rivals = {solver: 100 * np.mean(newton < times.of(solver)) for solver in times.peers}
    nearest = min(rivals, key=rivals.get)
    return (f"Of {len(times.problems)} problems `newton` solves {counts['newton']}. The most that a solver of Siconos solves is "
            f"{counts[most]} (`{most}`).\n`newton` is the fastest of all {len(times.solvers)} solvers on "
            f"{100 * np.mean(is_first(newton, every)):.0f} %. It is faster than all {len(times.peers)} of\nSiconos on "
            f"{100 * np.mean(newton < peers):.0f} %, and faster than each single one of them on {rivals[nearest]:.0f} % at least "
            f"(`{nearest}`).\nAgainst the best of Siconos on each problem its worst ratio is {ratios.max():.3g} (`{worst}`), its "
            f"best {ratios.min():.2g}.\n" + agreement)


def all_tables(rows, agreement):
    """Those of the page; without Siconos those that need no ratio to it."""
    times = Times(rows)
    found = {"solvers": solvers(times, rows), "failures": failures(times, rows)}
    if times.peers:
        found |= {"summary": summary(times, agreement), "kinds": kinds(times), "fastest": fastest(times),
                  "losses": losses(times)}
    return found


def digits(value):
    """That agree; a double has no more than 15."""
    return "–" if value == "" else f"{min(15., -np.log10(max(float(value), 1e-15))):.1f}"


def scenes(rows):
    """What the programs say of the same scenes, and how long they take."""
    head = ("scene and program", "", "CPU s", "/ orthocone", "digits of the force", "of the shear force", "of the slip")
    return markdown(head, [(f"{row['scene']}: {row['program']}", row["verdict"], f"{row['seconds']:.2g}",
                            f"{row['ratio']:.2g}", *(digits(row[name]) if row["program"] != "orthocone" else ""
                                                     for name in ("force", "shear", "slip"))) for row in rows])

# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Pictures of the race: performance profiles after Dolan and More, ratios over the nodes, time against error."""
import matplotlib.pyplot as plt
import numpy as np

import race
import style

COLOURS = {**dict(zip(race.OURS, ("#0072b2", "#56b4e9", "#009e73", "#000000"))),
           **dict(zip(race.PEERS, ("#d55e00", "#e69f00", "#cc79a7", "#882255", "#332288", "#8c564b", "#8c8c8c")))}
GROUPS = {"all": None, "associated": ("isotropic", "orthotropic"), "not associated": ("non-associated",)}
# Of the chart of time against error: colour and solvers of each kind.
KINDS = {"Newton's method": ("#0072b2", ("newton", "plain-newton", "nsn-ac", "nsn-ac-new", "nsn-hybrid")),
         "sweeps": ("#d55e00", ("gauss-seidel", "nsgs-ac", "nsgs-pli")),
         "projections": ("#009e73", ("uzawa",)), "alternating directions": ("#cc79a7", ("admm", "admm-balanced"))}
IN_WORDS = {"a-bricks/8": "case A on bricks, step 8", "fretting-c-fine/10": "fretting, case C, step 10",
            "random-1/4": "a random scene, step 4"}
FARTHEST = 1000  # ratio at the right end of the profiles


def label(solver):
    return solver if solver in race.OURS else f"Siconos {solver}"


def line_of(solver):
    is_ours = solver in race.OURS
    return {"color": COLOURS[solver], "linewidth": 2 if solver == "newton" else 1.2, "linestyle": "-" if is_ours else "--"}


class Times:
    """Seconds by problem and solver; infinite where a solver failed."""

    def __init__(self, rows):
        self.problems = list(dict.fromkeys(row["problem"] for row in rows))
        there = {row["solver"] for row in rows}
        self.solvers = [solver for solver in race.SOLVERS if solver in there]
        self.peers = [solver for solver in race.PEERS if solver in there]
        self.family = {row["problem"]: row["family"] for row in rows}
        self.law = {row["problem"]: row["law"] for row in rows}
        self.nodes = {row["problem"]: int(row["nodes"]) for row in rows if row["nodes"]}
        self._seconds = {(row["problem"], row["solver"]): float(row["seconds"]) for row in rows
                         if row["verdict"] == "solved"}

    def of(self, solver, problems=None):
        return np.array([self._seconds.get((problem, solver), np.inf) for problem in
                         (self.problems if problems is None else problems)])

    def best(self, solvers, problems=None):
        return np.min([self.of(solver, problems) for solver in solvers], axis=0)

    def group(self, laws):
        return [problem for problem in self.problems if laws is None or self.law[problem] in laws]


def draw_profile(axes, times, problems):
    best = times.best(times.solvers, problems)
    is_solved = np.isfinite(best)
    for solver in times.solvers:
        ratios = np.sort(times.of(solver, problems)[is_solved] / best[is_solved])
        ratios = ratios[ratios <= FARTHEST]
        shares = 100 * np.arange(1, len(ratios) + 1) / len(problems)
        last = shares[-1] if len(shares) else 0
        axes.step([1, *ratios, FARTHEST], [100 * np.sum(ratios == 1) / len(problems), *shares, last], where="post",
                  label=label(solver), **line_of(solver))
    axes.set(xscale="log", xlim=(1, FARTHEST), ylim=(0, 101), xlabel="time / fastest")


def profiles(times):
    groups = {name: laws for name, laws in GROUPS.items() if times.group(laws)}
    figure, charts = plt.subplots(1, len(groups), figsize=(style.WIDTH, 4), sharey=True, squeeze=False)
    for axes, (name, laws) in zip(charts[0], groups.items()):
        problems = times.group(laws)
        draw_profile(axes, times, problems)
        axes.set_title(f"{name}: {len(problems)} problems")
        style.plain_ticks(axes.xaxis, (1, 10, 100, 1000))
        if laws is None:
            axes.set_ylabel("problems solved in that time (%)")
    style.legend_below(figure, *axes.get_legend_handles_labels(), 3)
    style.headline(figure, "The higher and the further left, the better: newton solves most, and fastest")
    return figure


def over_nodes(times):
    """Newton's method against the best of the peers, and against Gauss-Seidel of both."""
    figure, charts = plt.subplots(1, 2, figsize=(style.WIDTH, 3.2), sharey=True)
    pairs = (("newton", race.PEERS, "newton / fastest solver of Siconos"),
             ("gauss-seidel", ("nsgs-ac",), "gauss-seidel / Siconos nsgs-ac"))
    for axes, (ours, theirs, title) in zip(charts, pairs):
        for name, laws in list(GROUPS.items())[1:]:
            problems = [problem for problem in times.group(laws)
                        if np.isfinite(times.of(ours, [problem]) + times.best(theirs, [problem]))]
            ratios = times.of(ours, problems) / times.best(theirs, problems)
            axes.plot([times.nodes[problem] for problem in problems], ratios, ".", markersize=5, label=name,
                      color=COLOURS["newton"] if name == "associated" else COLOURS["nsgs-ac"])
        axes.axhline(1, color="0.3", linewidth=0.8)
        axes.set(xscale="log", yscale="log", xlabel="contact nodes", title=title)
        style.plain_ticks(axes.xaxis, (10, 20, 50, 100, 200, 500))
        style.plain_ticks(axes.yaxis, (0.01, 0.1, 1, 10))
    charts[0].set_ylabel("ratio of times")
    style.legend_below(figure, *charts[0].get_legend_handles_labels(), 2)
    style.headline(figure, "Below 1 orthocone is faster, the more so the more nodes there are")
    return figure


def draw_errors(axes, own):
    """Colours are those of the kind of method, markers tell methods of a kind apart."""
    for kind, (colour, solvers) in KINDS.items():
        for solver, marker in zip(solvers, "osD^v"):
            points = [row for row in own if row["solver"] == solver and row["verdict"] == "solved"]
            axes.plot([float(row["seconds"]) for row in points], [max(float(row["error"]), 1e-14) for row in points], color=colour,
                      marker=marker, linestyle="-" if solver in race.OURS else "--",
                      markerfacecolor=colour if solver in race.OURS else "white", label=f"{label(solver)}: {kind}")
    axes.set(xscale="log", yscale="log", xlabel="time (s)", ylim=(4e-15, 1e-1))
    axes.set_yticks([10.0**power for power in range(-14, 0, 2)])
    axes.minorticks_off()


def time_against_error(rows):
    """Seconds to an error of 1e-2 to 1e-11 on some problems."""
    rows = [{**row, "problem": row["problem"].split(" to ")[0]} for row in rows]
    names = list(dict.fromkeys(row["problem"] for row in rows))
    figure, charts = plt.subplots(1, len(names), figsize=(style.WIDTH, 4.2), sharey=True, squeeze=False)
    for axes, name in zip(charts[0], names):
        own = [row for row in rows if row["problem"] == name]
        draw_errors(axes, own)
        axes.set_title(f"{IN_WORDS.get(name, name)},\n{own[0]['nodes']} contact nodes")
    charts[0, 0].set_ylabel("error of the contact forces")
    style.legend_below(figure, *charts[0, -1].get_legend_handles_labels(), 2)
    style.headline(figure, "Newton's methods pay hardly more for ten digits than for four")
    return figure


def figures(rows, error_rows):
    times = Times(rows)
    found = {"peers_profiles": profiles(times)}
    if times.peers:
        found["peers_nodes"] = over_nodes(times)
    if error_rows:
        found["peers_errors"] = time_against_error(error_rows)
    return found


def save(found, folders):
    for name, figure in found.items():
        style.save(figure, name, folders)

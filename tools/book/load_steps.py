# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Spence's compression over the number of load steps: chart and table of docs/verification.md."""
from measure import on_surface
from sheared import FORCE_OF_35, SPENCE, legs_of_spence, spence_middle, spence_stick

STEPS = (1, 5, 35, 280)


def scene(steps):
    return SPENCE.set(legs_of_spence(steps), f"Output/Contact fields={steps}")


def dissipated(runs, steps):
    """Energy, by P times the approach."""
    history = runs(scene(steps)).history
    return float(history["total_dissipation"][-1] / (FORCE_OF_35 * -history["uz"][-1]))


def table(runs):
    lines = ["| load steps | c/a | pressure in the middle, by Hertz | dissipated, by force x approach |", "|--:|--:|--:|--:|"]
    for steps in STEPS:
        lines.append(f"| {steps} | {spence_stick(steps)(runs, scene(steps)):.4f} | {spence_middle(steps)(runs, scene(steps)):.4f} | "
                     f"{dissipated(runs, steps):.3e} |")
    return "\n".join(lines) + "\n"


def chart(runs):
    """Friction by its limit over the radius."""
    import matplotlib.pyplot as plt
    from panels import BLUE, GREEN, GREY, RED
    figure, axes = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for steps, colour in zip(STEPS, (GREY, GREEN, BLUE, RED)):
        run = runs(scene(steps))
        radius, criterion = on_surface(run, steps, "friction_criterion")
        pressure = on_surface(run, steps, "pressure")[1]
        touching = pressure > 0
        rim = radius[touching].max()
        axes[0].plot(radius[touching] / rim, 1 + criterion[touching], color=colour, linewidth=1.3,
                     label=f"{steps} load step" + "s" * (steps > 1))
    axes[0].axvline(0.5, color="0.4", linewidth=1, linestyle="--", label="c/a = 0.5 (Spence)")
    axes[0].set(title="Friction by its limit", xlabel="r/a", ylabel="friction / (µ pressure)")
    sticks = [spence_stick(steps)(runs, scene(steps)) for steps in STEPS]
    axes[1].semilogx(STEPS, sticks, "o-", color=BLUE, label="orthocone")
    axes[1].axhline(0.5, color="0.4", linewidth=1, linestyle="--", label="Spence")
    axes[1].set(title="Radius that sticks", xlabel="load steps", ylabel="c/a", ylim=(0.2, 0.55), xticks=STEPS,
                xticklabels=[str(steps) for steps in STEPS])
    axes[1].minorticks_off()
    for ax in axes:
        ax.grid(color="0.9", linewidth=0.6)
        ax.legend(fontsize=8, loc="lower right")
    return figure

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
    """Friction by its limit over the radius, and the radius that sticks."""
    import docs_page
    from panels import BLUE, GREEN, GREY, RED, entries
    figure, axes = docs_page.plt.subplots(1, 2, figsize=(docs_page.WIDTH, 3.4))
    for steps, colour in zip(STEPS, (GREY, GREEN, BLUE, RED)):
        run = runs(scene(steps))
        radius, criterion = on_surface(run, steps, "friction_criterion")
        touching = on_surface(run, steps, "pressure")[1] > 0
        axes[0].plot(radius[touching] / radius[touching].max(), 1 + criterion[touching], color=colour,
                     linestyle="--" if steps == STEPS[-1] else "-", label=f"{steps} load step" + "s" * (steps > 1))
    axes[0].axvline(0.5, color="0.4", linewidth=1, linestyle=":", label="c/a = 0.5 (Spence)")
    axes[0].set(title="friction / (μ pressure)", xlabel="radius / radius of contact")
    axes[1].plot(STEPS, [spence_stick(steps)(runs, scene(steps)) for steps in STEPS], "o-", color="black", label="orthocone")
    axes[1].axhline(0.5, color="0.4", linewidth=1, linestyle=":")
    axes[1].set(title="radius that sticks / radius of contact", xlabel="load steps", ylim=(0, 0.55), xscale="log")
    axes[1].minorticks_off()
    axes[1].set_xticks(STEPS, STEPS)
    docs_page.legend_below(figure, *entries(axes), 3)
    docs_page.headline(figure, "A single load step halves the zone that sticks; 35 are enough for 1 %")
    return figure

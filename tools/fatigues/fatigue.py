# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Says where and at which angle a crack begins: fatigue parameters of the last complete cycle of a run, in both bodies around
the contact and along the lines of output. It writes them as fields for ParaView, prints the worst places and draws a picture."""
import argparse
import math
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # the source tree stays clean
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parent.parent / "runs"))
import cycle_stresses  # noqa: E402
import fields as parameters  # noqa: E402
import material as materials  # noqa: E402
import numpy as np  # noqa: E402
import places  # noqa: E402
from critical_distance import METHODS, along_line, below_surface  # noqa: E402
from cycle_stresses import NotInRun, Surface, body_of, section_of  # noqa: E402
from fatigue_vtu import text_of_vtu  # noqa: E402
from planes import STEP  # noqa: E402
from run_folder import BadFile, RunFolder, one_line, write_whole  # noqa: E402

WRONG_INPUT, FILE_ERROR = 2, 4
KINDS = (".png", ".svg")
WITHIN = 3.0  # half-widths of the contact
NAMES = parameters.PLANES + parameters.INVARIANTS + parameters.SURFACE
APART = 0.5  # half-widths between two worst places


class ArgumentParser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(WRONG_INPUT, f"fatigue: {one_line(message)}; '--help' explains\n")


def positive(text):
    value = float(text)
    if not (math.isfinite(value) and value > 0):
        raise argparse.ArgumentTypeError(f"'{text}': allowed is a number > 0")
    return value


def angle(text):
    value = positive(text)
    if not 0.5 <= value <= 30:
        raise argparse.ArgumentTypeError(f"'{text}': allowed are 0.5 to 30 degrees")
    return value


def steps_named(text):
    """FIRST:LAST or FIRST:LAST:STRIDE."""
    found = re.fullmatch(r"(\d{1,8}):(\d{1,8})(?::(\d{1,8}))?", text)
    first, last, stride = (int(word or 1) for word in found.groups()) if found else (1, 0, 1)
    steps = list(range(first, last + 1, stride)) if stride > 0 and last - first < 1_000_000 else []
    if len(steps) < 2:
        raise argparse.ArgumentTypeError(f"'{text}': allowed is FIRST:LAST or FIRST:LAST:STRIDE, of two steps or more")
    return steps


def names_of(text):
    names = [name.strip() for name in text.split(",") if name.strip()]
    wrong = [name for name in names if name not in NAMES]
    if wrong or not names:
        raise argparse.ArgumentTypeError(f"'{(wrong or [text])[0]}': allowed are {', '.join(NAMES)}")
    return [name for name in NAMES if name in names]


def arguments():
    parser = ArgumentParser(
        prog="tools/fatigue", description=__doc__,
        epilog="Angles: the inclination lies between the critical plane and the normal of the contact plane, so that 0 degrees is a "
               "crack straight down; it leans, as it goes down, towards the azimuth (0: +x, 90: +y, 180: -x). The program computes "
               "no life. Exit codes: 0 done; 2 wrong command line or constants, or the run lacks steps; 4 a file could not be read "
               "or written.")
    parser.add_argument("run", metavar="RUN", type=pathlib.Path, help="run folder with volume files of every step of a cycle")
    parser.add_argument("--material", metavar="FILE.json", type=pathlib.Path,
                        help=f"constants of fatigue of both bodies, an object with any of {materials.ALLOWED} (those of "
                             "Material/Fatigue and Lower material/Fatigue, or a hard steel)")
    parser.add_argument("--parameters", metavar="NAMES", type=names_of, default=list(NAMES), help=f"any of {', '.join(NAMES)} (all)")
    parser.add_argument("--critical-distance", metavar="L", type=positive, default=None,
                        help="mm: also the parameters of the mean stress over 2 L below the surface of sections and along lines")
    parser.add_argument("--method", choices=METHODS, default="line", help="line: mean over 2 L; point: in the depth L/2 (line)")
    parser.add_argument("--steps", metavar="FIRST:LAST[:STRIDE]", type=steps_named, default=None,
                        help="these steps (those of the last complete cycle)")
    parser.add_argument("--within", metavar="FACTOR", type=positive, default=WITHIN,
                        help=f"distance from the contact, in its half-widths, up to which places count ({WITHIN:g})")
    parser.add_argument("--plane-step", metavar="DEGREES", type=angle, default=STEP, help=f"step of the search over planes ({STEP:g})")
    parser.add_argument("--picture", metavar="OUT", type=pathlib.Path, help="draw the parameters as .png or .svg")
    parser.add_argument("--output", metavar="OUT.vtu", type=pathlib.Path, help="the fields (RUN/fatigue.vtu)")
    given = parser.parse_args()
    if given.picture and given.picture.suffix not in KINDS:
        parser.error(f"--picture {given.picture}: allowed are names that end with .png or .svg")
    if given.output and given.output.suffix != ".vtu":
        parser.error(f"--output {given.output}: allowed are names that end with .vtu")
    given.output = given.output or given.run / "fatigue.vtu"
    return given


def chosen_steps(run, given):
    """The steps, words about them, and a warning or none."""
    if given.steps:
        return given.steps, f"steps {given.steps[0]} to {given.steps[-1]} ({len(given.steps)})", ""
    cycle, steps, change = cycle_stresses.steps_of_cycle(run)
    if len(steps) < 2:
        raise NotInRun(f"has {len(steps)} step in cycle {cycle}: set at least two load steps in Load program/Legs")
    warning = (f"cycle {cycle} is not settled (its ends differ by {100 * change:.2g} %): more cycles (Load program/Cycles), or "
               "--steps with those of a closed loop, describe what repeats") if change > cycle_stresses.SETTLED else ""
    return steps, f"cycle {cycle}, steps {steps[0]} to {steps[-1]} ({len(steps)})", warning


def has_volume(run):
    """A half-space has no volume files: all that is known below its surface are its lines."""
    return run.summary.get("model", {}).get("backend") != "half-space"


def check_files(run, given, steps):
    """Requires the files that the parameters are computed from."""
    if has_volume(run):
        cycle_stresses.check_steps(run, "volume", steps)
        return
    if not run.line_names():
        raise NotInRun("is of a half-space, which has no volume files: set Output/Lines from the surface down and Output/Line "
                       "fields = 1 and run again")
    if given.picture:
        raise NotInRun("is of a half-space, which has no volume files: --picture draws their fields, and the table has the lines")


def bodies_of(run, given, steps, surface):
    if not has_volume(run):
        return []
    near = surface.near(given.within)
    kinds = ["volume"] + ["lower"] * bool(run.contact_steps("lower"))
    return [body_of(run, kind, steps, near) for kind in kinds]


def constants_of(run, path):
    """{section of a body: its Material}."""
    return {section: materials.material_of(path, run.parameters, section) for section in map(section_of, (1, -1))}


def all_fields(bodies, given, constants, surface):
    """{body: {name: Field}}."""
    found = {}
    for body in bodies:
        found[body.name] = parameters.fields_of(given.parameters, constants[body.section], body.stress, given.plane_step)
        if surface.is_plane:
            found[body.name].update({name: field for name, field in surface.ruiz(body).items() if name in given.parameters})
    return found


def averaged_fields(bodies, given, constants, surface):
    """{body: {name: Field}} of the mean histories below the surface of sections, nan at other points."""
    found = {}
    for body in bodies if given.critical_distance and surface.is_plane else ():
        if not body.is_section or not len(body.on_surface):
            continue
        at, stress = below_surface(body, given.critical_distance, given.method)
        if not len(at):
            raise NotInRun(f"has no {2 * given.critical_distance:g} mm of the {body.name} below the contact: allowed is a larger "
                           "--within or a smaller --critical-distance")
        found[body.name] = {}
        for name, field in parameters.fields_of(given.parameters, constants[body.section], stress, given.plane_step).items():
            whole = parameters.Field(np.full(len(body.points), np.nan), None, field.reference)
            whole.values[at] = field.values
            if field.normals is not None:
                whole.normals = np.full((len(body.points), 3), np.nan)
                whole.normals[at] = field.normals
            found[body.name][name] = whole
    return found


def vtu_fields(bodies, below, fields, averaged):
    """{name of the field: array} over the points of all bodies."""
    arrays = {"body": np.concatenate([np.full(len(body.points), index) for index, body in enumerate(bodies)])}
    for ending, of_bodies in (("", fields), ("_mean", averaged)):
        for name in next(iter(of_bodies.values()), {}):
            of_name = [of_bodies[body.name][name] for body in bodies]
            arrays[name + ending] = np.concatenate([field.values for field in of_name])
            if of_name[0].normals is not None:
                arrays[f"{name}{ending}_normal"] = np.concatenate([field.normals for field in of_name])
                for word in ("inclination", "azimuth"):
                    arrays[f"{name}{ending}_{word}"] = np.concatenate(
                        [getattr(below[body.name], word)(field.normals) for field, body in zip(of_name, bodies)])
    return arrays


def write_vtu(path, bodies, arrays):
    first, cells = 0, []
    for body in bodies:
        cells += [(kind, block + first) for kind, block in body.cells]
        first += len(body.points)
    write_whole(path, text_of_vtu(np.concatenate([body.points for body in bodies]), cells, arrays))


def line_places(run, given, constants, steps, surface):
    """{name of a parameter: [Place]}, the worst one of each line; of the mean history with --critical-distance."""
    found = {name: [] for name in given.parameters if name not in parameters.SURFACE}
    for line in run.line_names():
        distances, points, stress = cycle_stresses.line_history(run, line, steps)
        if given.critical_distance:
            stress, points = along_line(distances, points, stress, given.critical_distance, given.method), points[:1]
            if stress is None:
                continue
        inward = 1 if points[:, 2].sum() >= 0 and not np.signbit(points[:, 2]).all() else -1
        for name, field in parameters.fields_of(found, constants[section_of(inward)], stress, given.plane_step).items():
            found[name] += places.worst_places(name, [(line, surface.below(points, inward), field)], math.inf)
    return found


def edge_places(bodies, given, constants, surface):
    """{name of a parameter: [Place]}, the worst edges of the contact, whose stress goes on from the zone that slips."""
    parts = {name: [] for name in given.parameters if name not in parameters.SURFACE}
    for body in bodies:
        points, stress = surface.edges(body)
        fields = parameters.fields_of(parts, constants[body.section], stress, given.plane_step) if len(points) else {}
        for name, field in fields.items():
            parts[name].append((body.name, surface.below(points, body.inward), field))
    return {name: places.worst_places(name, of_name, APART * surface.radius) for name, of_name in parts.items() if of_name}


def worst_of(of_bodies, below, radius):
    """{name: [Place]} of {body: {name: Field}}."""
    return {name: places.worst_places(name, [(body, below[body], of_bodies[body][name]) for body in of_bodies], APART * radius)
            for name in next(iter(of_bodies.values()), {})}


def tables(given, worst, at_edges, worst_means, along_lines):
    """The lines of all tables, of {name: [Place]}."""
    lines = places.table(worst) if worst else []
    if any(at_edges.values()):
        lines += ["\nat the edges of the contact, from the zone that slips:", *places.table(at_edges)]
    mean = (f"mean stress over {2 * given.critical_distance:g} mm" if given.method == "line" else
            f"stress in the depth of {given.critical_distance / 2:g} mm") if given.critical_distance else ""
    if worst_means:
        lines += [f"\n{mean} below the surface:", *places.table(worst_means)]
    if any(along_lines.values()):
        lines += [f"\n{mean} from the first ends of lines:" if mean else "\nalong lines:", *places.table(along_lines)]
    return lines


def notes(run, given, surface, bodies, at_edges):
    """What the reader of the tables has to know."""
    lines, planes = [], run.summary.get("model", {}).get("symmetry_planes", [])
    if not surface.is_plane and set(given.parameters) & set(parameters.SURFACE):
        lines.append("\nThe contact surface is curved, so that the parameters of Ruiz are left out.")
    if bodies and all(body.is_section for body in bodies) and not any(at_edges.values()):
        lines.append("\nNo edge of the contact could be found from nodes that slip beside it (it takes five, and an edge that stays): "
                     "the stress at an edge may be larger than at any node.")
    if planes:
        lines.append(f"\nThe model is the part on one side of {' and '.join(map(str, planes))}: the same holds at mirror images.")
    return lines


def save_picture(path, title, bodies, fields, averaged, worst, surface):
    if not any(worst.values()):
        raise NotInRun("has no parameter above 0: there is nothing to draw")
    if path.exists() and not path.is_file():
        raise BadFile(f"{path}: is no ordinary file, and stays as it is")
    import fatigue_picture  # not at the top: Matplotlib takes a second
    figure = fatigue_picture.draw(title, bodies, fields, averaged, worst, surface.middle[0], surface.radius)
    figure.savefig(path, dpi=100, metadata={"Date": None} if path.suffix == ".svg" else None)


def check_possible(given, bodies, surface, averaged, along_lines):
    if given.picture and not surface.is_plane and not all(body.is_section for body in bodies):
        raise NotInRun("has a curved contact surface in three dimensions: --picture is for plane ones and for sections")
    if given.critical_distance and not averaged and not any(along_lines.values()):
        raise NotInRun("has neither a section with a plane contact surface nor a line that goes down far enough: --critical-distance "
                       "needs Output/Lines from the surface into the body")


def names_of_materials(bodies, constants):
    if not bodies:
        return f"material: {one_line(constants[section_of(1)].name)}"
    names = [one_line(constants[body.section].name) for body in bodies]
    if len(set(names)) == 1:
        return f"material: {names[0]}"
    return "\n".join(f"material of the {body.name}: {name}" for body, name in zip(bodies, names))


def look(given):
    run = RunFolder(given.run)
    constants = constants_of(run, given.material)
    steps, sentence, warning = chosen_steps(run, given)
    check_files(run, given, steps)
    surface = Surface(run, steps)
    bodies = bodies_of(run, given, steps, surface)
    averaged = averaged_fields(bodies, given, constants, surface)
    along_lines = line_places(run, given, constants, steps, surface)
    check_possible(given, bodies, surface, averaged, along_lines)
    fields = all_fields(bodies, given, constants, surface)
    below = {body.name: surface.below(body.points, body.inward) for body in bodies}
    worst, worst_means = (worst_of(of_bodies, below, surface.radius) for of_bodies in (fields, averaged))
    if bodies:
        write_vtu(given.output, bodies, vtu_fields(bodies, below, fields, averaged))
    if given.picture:
        save_picture(given.picture, f"{given.run.name}: {sentence}", bodies, fields, averaged, worst, surface)
    print(f"{one_line(given.run)}: {sentence}, up to {given.within * surface.radius:.3g} mm from the contact, whose half-width is "
          f"{surface.radius:.3g} mm\n{names_of_materials(bodies, constants)}")
    at_edges = edge_places(bodies, given, constants, surface)
    print(*tables(given, worst, at_edges, worst_means, along_lines), *notes(run, given, surface, bodies, at_edges), sep="\n")
    if bodies:
        print(f"{one_line(given.output)}: the fields" + (f"\n{one_line(given.picture)}: the picture" if given.picture else ""))
    if warning:
        print(f"fatigue: warning: {one_line(given.run)}: {warning}", file=sys.stderr)


def main():
    given = arguments()
    sys.stdout.reconfigure(errors="surrogateescape")  # names of files need not be text
    try:
        look(given)
    except (NotInRun, materials.WrongMaterial) as problem:
        words = problem if isinstance(problem, materials.WrongMaterial) else f"{given.run}: {problem}"
        print(f"fatigue: {one_line(words)}", file=sys.stderr)
        sys.exit(WRONG_INPUT)
    except (OSError, BadFile) as problem:
        print(f"fatigue: {one_line(problem)}", file=sys.stderr)
        sys.exit(FILE_ERROR)


if __name__ == "__main__":
    main()

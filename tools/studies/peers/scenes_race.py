# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""The scenes of bodies.py by orthocone, GetFEM and CalculiX: forces and slips of each step, and CPU time of the process."""
import csv
import hashlib
import io
import json
import os
import pathlib
import resource
import shutil
import statistics
import subprocess

import bodies
import ccx_scene
from points import ROOT, program_point
from run_folder import RunFolder

HERE = pathlib.Path(__file__).resolve().parent
ROUNDS = 1
TIME_LIMIT = 300  # s of CPU time
COLUMNS = ("force_x", "force_y", "force_z", "max_slip")
GETFEM = {"cylinder": ("2e5", "1e-8"), "block": ("2e5", "1e-9")}  # augmentation, N/mm; the least residual that it reaches
PROGRAMS = ("orthocone", "getfem", *(f"calculix {name}" for name in ccx_scene.VARIANTS))
ENVIRONMENT = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def run(words, folder):
    """Exit code, output and CPU seconds of a process, which the kernel ends when it takes too long."""
    with open(folder / "stdout", "w+", encoding="utf-8") as output:
        process = subprocess.Popen([str(word) for word in words], cwd=folder, env=ENVIRONMENT, stdout=output,
                                   stderr=subprocess.STDOUT,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (TIME_LIMIT, TIME_LIMIT + 5)))
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        return process.returncode, output.read(), usage.ru_utime + usage.ru_stime


def by_orthocone(scene, folder, program):
    words = program_point({}, scene.file, scene.all_settings(), "--threads", "1").words
    words = [program, ROOT / words[1], *words[2:]]
    words[words.index("--output") + 1] = folder / "run"
    code, _, seconds = run(words, folder)
    history = RunFolder(folder / "run").history
    rows = [dict(zip(COLUMNS, map(float, values))) for values in zip(*(history.get(name, ()) for name in COLUMNS))]
    return code, rows, seconds


def by_getfem(name, folder):
    code, text, seconds = run([ROOT / "tools/python", "numpy,getfem", HERE / "getfem_scene.py", name,
                                *GETFEM[bodies.SCENES[name].shape]], folder)
    lines = text[text.find("force_x"):] if "force_x" in text else ""
    rows = list(csv.DictReader(io.StringIO(lines)))
    if not all(row["converged"] == "1" for row in rows):
        code = 1
    return code, [{name: float(row[name]) for name in COLUMNS} for row in rows], seconds


def by_calculix(scene, variant, folder):
    ccx_scene.write(scene, variant, folder / "job.inp")
    for path in folder.glob("job.[dsf]*"):
        path.unlink()
    code, _, seconds = run(["ccx", "job"], folder)
    return code, ccx_scene.results(folder / "job.dat") if (folder / "job.dat").exists() else [], seconds


def there(program):
    if program == "getfem":
        words = [ROOT / "tools/python", "numpy,getfem", "-c", ""]
        return subprocess.run(words, capture_output=True, check=False).returncode == 0
    return program == "orthocone" or shutil.which("ccx") is not None


def solved(name, program, folder, orthocone):
    folder.mkdir(parents=True, exist_ok=True)
    scene = bodies.SCENES[name]
    if program == "orthocone":
        return by_orthocone(scene, folder, orthocone)
    if program == "getfem":
        return by_getfem(name, folder)
    return by_calculix(scene, program.split(" ", 1)[1], folder)


def difference(rows, ours, column):
    """The largest of all steps, relative to the largest value of the column."""
    largest = max(abs(row[column]) for row in ours)
    return max(abs(row[column] - our[column]) for row, our in zip(rows, ours)) / largest


def raced(names, options, orthocone, rounds, say):
    """Rows of all scenes and programs; those of a scene that is done are kept."""
    for program, package in (("getfem", "python3-getfem"), ("calculix", "calculix-ccx")):
        if not there(program):
            say(f"no {program} here (Debian's {package}): the scenes go without it")
    programs, found = [program for program in PROGRAMS if there(program)], []
    for name in names:
        folder = options.output / "scenes" / name.replace(" ", "-")
        folder.mkdir(parents=True, exist_ok=True)
        done, about = folder / "rows.json", fingerprint(orthocone, programs)
        known = json.loads(done.read_text(encoding="utf-8")) if done.exists() and not options.anew else None
        if not isinstance(known, dict) or known["fingerprint"] != about:
            known = {"fingerprint": about, "rows": raced_scene(name, folder, orthocone, programs, rounds)}
            done.write_text(json.dumps(known), encoding="utf-8")
            say(f"scene '{name}' is done")
        found += known["rows"]
    return found


def fingerprint(orthocone, programs):
    """What rows depend on: our program, who races, and what they are asked."""
    digest = hashlib.sha256(" ".join(programs).encode())
    for path in (orthocone, *(HERE / f"{name}.py" for name in ("bodies", "ccx_scene", "getfem_scene"))):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:12]


def raced_scene(name, folder, orthocone, programs, rounds):
    answers = [{program: solved(name, program, folder / program.replace(" ", "-"), orthocone) for program in programs}
               for _ in range(rounds)]
    ours, rows = answers[0]["orthocone"][1], []
    for program in programs:
        code, steps, _ = answers[0][program]
        is_done = code == 0 and len(steps) == len(ours)
        row = {"scene": name, "program": program, "steps": len(ours),
               "verdict": "solved" if is_done else f"ends after step {len(steps)}",
               "seconds": statistics.median(answer[program][2] for answer in answers),
               "ratio": statistics.median(answer[program][2] / answer["orthocone"][2] for answer in answers)}
        is_sheared = max(abs(our["force_x"]) for our in ours) > 1e-6 * max(abs(our["force_z"]) for our in ours)
        for column, title in (("force_z", "force"), ("force_x", "shear"), ("max_slip", "slip")):
            is_compared = is_done and (column != "force_x" or is_sheared)
            row[title] = difference(steps, ours, column) if is_compared else ""
        rows.append(row)
    return rows


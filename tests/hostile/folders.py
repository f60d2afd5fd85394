# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Run folders with things in them, and folders that change while a run is going on."""
import functools
import os
import shutil
import signal
import time

import promises
from bench import Row
from promises import DONE, FILE_ERROR, INTERRUPTED, WRONG_INPUT

LONG = ["Mesh/Core cells=4", "Mesh/Model=full", "Load program/Cycles=10", "Output/Checkpoint=0", "Output/Probes="]
MINE = b"three years of measurements\n"
# What users may keep in a run folder: names that no run of theirs has written.
USERS_FILES = ["probe-measured.csv", "probe-Q.csv", "probe-notes.txt", "contact-reference.vtu",
               "contact-0001 (copy).vtu", "line-measured-2024.csv",
               "volume.pvsm", "history.csv.bak", "my history.csv", "log.txt.1", "notes/history.csv",
               "checkpoint/notes.txt", "checkpoint/state.bak", ".hidden", "parameters.prm~", "summary.json.orig"]
# Files of a run that a run can be continued without, and those that it cannot.
SPARE = ["log.txt", "summary.json", "contact.pvd"]
NEEDED = ["timing.csv", "cycles.csv", "probe-P.csv", "contact-0002.vtu"]


def users_file(name, arguments, bench):
    """A file of the user beside those of a run is still there after the next run."""
    bench.set()
    path = bench.put("output/s/" + name, MINE)
    code, _, err = bench.set(arguments=arguments)
    faults = promises.of_exit(code, DONE) if code != FILE_ERROR else []  # it may refuse, but not remove
    faults += promises.of_run(bench.folder / "output/s", DONE)
    return faults + ([] if path.exists() and path.read_bytes() == MINE else [f"{name} of the user is gone; {err}"])


def refused_start(make, says, bench):
    """A folder that no run may take is as it was, and the run says why."""
    make(bench.folder / "output/s")
    before = bench.content()
    code, _, err = bench.set()
    return (promises.of_exit(code, FILE_ERROR) + promises.of_error_output(code, err, says)
            + ["the folder is changed"] * (bench.content() != before))


def folder_named(name):
    return lambda run: (run / name).mkdir(parents=True)


def file_named(name):
    def make(run):
        (run / name).parent.mkdir(parents=True, exist_ok=True)
        (run / name).write_bytes(MINE)
    return make


def refused_resume(change, code, says, bench, arguments=()):
    """A resume that is refused touches nothing, not even log.txt."""
    bench.set()
    change(bench.folder / "output/s")
    before = bench.content()
    result, _, err = bench.set(arguments=["--resume", *arguments])
    changed = [name for name, content in bench.content().items() if before.get(name) != content]
    return (promises.of_exit(result, code) + promises.of_error_output(result, err, says)
            + [f"{name} is changed by a refused resume" for name in changed])


def resume_without(name, bench):
    bench.set()
    before = (bench.folder / "output/s/history.csv").read_bytes()
    (bench.folder / "output/s" / name).unlink()
    code, _, err = bench.set(arguments=["--resume"])
    faults = promises.of_exit(code, DONE) + promises.of_error_output(code, err, "")
    return faults + ["history.csv is changed"] * ((bench.folder / "output/s/history.csv").read_bytes() != before)


def older_checkpoint(bench):
    """The checkpoint of an earlier moment gives the same tables again."""
    process = paused(bench)
    state = (bench.folder / "output/s/checkpoint/state").read_bytes()
    process.send_signal(signal.SIGCONT)
    process.communicate(timeout=60)
    whole = (bench.folder / "output/s/history.csv").read_bytes()
    (bench.folder / "output/s/checkpoint/state").write_bytes(state)
    code, _, err = bench.set(*LONG, arguments=["--resume"])
    same = (bench.folder / "output/s/history.csv").read_bytes() == whole
    return promises.of_exit(code, DONE) + promises.of_error_output(code, err, "") + ["other tables"] * (not same)


def paused(bench, step=8, late=32):
    """A run of 40 steps that is stopped after some of them, as by Ctrl-Z; on a busy machine that may come too late."""
    words = [f"--set={setting}" for setting in LONG]
    for _ in range(10):
        process = bench.start("s.prm", "--quiet", *words)
        wait_for(bench.folder / f"output/s/contact-{step:04d}.vtu", process)
        process.send_signal(signal.SIGSTOP)
        if is_stopped(process) and not (bench.folder / f"output/s/contact-{late:04d}.vtu").exists():
            return process
        process.kill()
        err = process.communicate()[1]
        shutil.rmtree(bench.folder / "output", ignore_errors=True)
    raise RuntimeError(f"no run could be paused: {err}")


def is_stopped(process):
    """Waits until it is, or has ended."""
    if process.returncode is not None:
        return False
    return os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT).si_code == os.CLD_STOPPED


def wait_for(path, process):
    end = time.monotonic() + 20
    while not path.exists() and process.poll() is None and time.monotonic() < end:
        time.sleep(0.001)


def ended(process):
    process.send_signal(signal.SIGCONT)
    err = process.communicate(timeout=60)[1].decode()
    return process.returncode, err


def says_that_the_folder_is_lost(process):
    """Neither "done" nor silence: the results are not where they are looked for."""
    code, err = ended(process)
    return promises.of_exit(code, FILE_ERROR) + promises.of_error_output(code, err, "output/s")


def deleted(bench):
    process = paused(bench)
    shutil.rmtree(bench.folder / "output/s")
    return says_that_the_folder_is_lost(process) + ["a folder of remains"] * (bench.folder / "output/s").exists()


def deleted_and_made_again(bench):
    process = paused(bench)
    shutil.rmtree(bench.folder / "output/s")
    (bench.folder / "output/s").mkdir()
    return says_that_the_folder_is_lost(process)


def moved_away(bench):
    process = paused(bench)
    (bench.folder / "output/s").rename(bench.folder / "output/old")
    return says_that_the_folder_is_lost(process)


def taken_by_another_run(bench):
    """The folder of a paused run is moved, and another run begins under its name: the two must not mix."""
    process = paused(bench)
    (bench.folder / "output/s").rename(bench.folder / "output/old")
    bench.set("Material/Young modulus=1000", "Load program/Cycles=2")
    before = bench.content()
    ended(process)
    after = bench.content()
    changed = [name for name in {**before,
                                 **after} if name.startswith("output/s/") and before.get(name) != after.get(name)]
    return [f"{len(changed)} files of the second run are changed or new, such as {changed[0]}"] if changed else []


def replaced_by_a_link(bench):
    """The folder becomes a link to a folder of the user."""
    process = paused(bench)
    (bench.folder / "output/s").rename(bench.folder / "output/old")
    mine = bench.put("mine/history.csv", MINE)
    (bench.folder / "output/s").symlink_to(bench.folder / "mine")
    faults = says_that_the_folder_is_lost(process)
    return faults + ["the user's history.csv is changed"] * (mine.read_bytes() != MINE)


def two_names_of_a_folder(bench):
    """A second run through a link is refused."""
    process = paused(bench)
    (bench.folder / "link").symlink_to("output/s")
    code, _, err = bench.set(*LONG, output="link")
    faults = promises.of_exit(code, FILE_ERROR) + promises.of_error_output(code, err, "another run is writing there")
    return faults + promises.of_exit(ended(process)[0], DONE)


def parameter_file_deleted(bench):
    process = paused(bench)
    (bench.folder / "s.prm").unlink()
    return promises.of_exit(ended(process)[0], DONE)


def interrupted_then_renamed(bench):
    """The parameter file may have another name when the run goes on."""
    process = paused(bench)
    process.send_signal(signal.SIGINT)
    faults = promises.of_exit(ended(process)[0], INTERRUPTED)
    (bench.folder / "s.prm").rename(bench.folder / "t.prm")
    words = [f"--set={setting}" for setting in LONG]
    code, _, err = bench.call("t.prm", "--quiet", "--resume", "--output=output/s", *words)
    return faults + promises.of_exit(code, DONE) + promises.of_run(bench.folder / "output/s",
                                                                   code) + promises.of_error_output(code, err, "")


def copied(bench):
    """A copy of an interrupted run goes on as the run itself would."""
    process = paused(bench)
    process.send_signal(signal.SIGINT)
    faults = promises.of_exit(ended(process)[0], INTERRUPTED)
    shutil.copytree(bench.folder / "output/s", bench.folder / "copy")
    codes = [bench.set(*LONG, output=name, arguments=["--resume"])[0] for name in ("output/s", "copy")]
    tables = [(bench.folder / name / "history.csv").read_bytes() for name in ("output/s", "copy")]
    return faults + [f"exit codes {codes}"] * (codes != [DONE, DONE]) + ["other tables"] * (tables[0] != tables[1])


def five_at_once(bench):
    """Of runs that begin in one folder at one time, one goes on, and the others say why they do not."""
    words = [f"--set={setting}" for setting in LONG]
    results = [(process.communicate(timeout=60)[1].decode(), process.returncode)
               for process in [bench.start("s.prm", "--quiet", *words) for _ in range(5)]]
    refused = [err for err, code in results if code == FILE_ERROR]
    faults = [] if len(refused) < 5 and all(code in (DONE, FILE_ERROR) for _, code in results) else [str(results)]
    faults += [fault for err in refused for fault in promises.of_error_output(FILE_ERROR, err, "another run")]
    return faults + promises.of_run(bench.folder / "output/s", DONE)


def resume_restores(name, bench):
    """A folder of results without its parameters is taken for no run's; who resumes it, has them again."""
    bench.set()
    (bench.folder / "output/s" / name).unlink()
    code, _, err = bench.set(arguments=["--resume"])
    if code == FILE_ERROR:
        return promises.of_error_output(code, err, name)
    return promises.of_exit(code, DONE) + [f"{name} stays away"] * (not (bench.folder / "output/s" / name).exists())


def foreign_state(bench):
    """The checkpoint of a run on another mesh."""
    bench.set("Mesh/Layers=3", output="other")
    return refused_resume(lambda run: shutil.copy(bench.folder / "other/checkpoint/state", run / "checkpoint/state"),
                          WRONG_INPUT, "Mesh/Layers = 2, but", bench)


def remove(name):
    return lambda run: (run / name).unlink()


def replace_by_folder(name):
    def change(run):
        (run / name).unlink()
        (run / name).mkdir()
    return change


SCRIPTS = {
    **{f"{name} of the user, new run": functools.partial(users_file, name, ()) for name in USERS_FILES},
    **{f"{name} of the user, resume": functools.partial(users_file, name, ("--resume",)) for name in USERS_FILES[:4]},
    **{f"{name} is a folder": functools.partial(refused_start, folder_named(name), name)
       for name in ("parameters.prm", "history.csv", "log.txt", "contact.pvd", "checkpoint/state")},
    **{f"{name} of no run": functools.partial(refused_start, file_named(name), name)
       for name in ("history.csv", "summary.json", "contact-0001.vtu", "input.json", "checkpoint", "checkpoint/state")},
    **{f"resume without {name}": functools.partial(resume_without, name) for name in SPARE},
    **{f"resume without {name}": functools.partial(refused_resume, remove(name), FILE_ERROR, name) for name in NEEDED},
    **{f"resume with a folder as {name}": functools.partial(refused_resume, replace_by_folder(name), FILE_ERROR, name)
       for name in ("history.csv", "probe-P.csv", "checkpoint/state")},
    "resume with a foreign state": foreign_state,
    "resume with other legs": functools.partial(refused_resume, lambda run: None, WRONG_INPUT, "Load program/Legs",
                                                arguments=["--set=Load program/Legs=0 0 -0.2 : 2"]),
    "resume with another mesh": functools.partial(refused_resume, lambda run: None, WRONG_INPUT, "Mesh/Layers",
                                                  arguments=["--set=Mesh/Layers=3"]),
    "resume of an older checkpoint": older_checkpoint, "folder deleted": deleted,
    "folder deleted and made again": deleted_and_made_again,
    "folder moved": moved_away, "folder moved, another run in its place": taken_by_another_run,
    "folder becomes a link": replaced_by_a_link,
    "two names of a folder": two_names_of_a_folder, "parameter file deleted": parameter_file_deleted,
    "parameter file renamed": interrupted_then_renamed, "copied run folder": copied, "five runs at once": five_at_once,
    **{f"resume without {name}": functools.partial(resume_restores, name) for name in ("parameters.prm", "input.prm")},
}
ROWS = [Row(name, script=script) for name, script in SCRIPTS.items()]

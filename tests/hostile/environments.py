# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Hostile environments: variables, descriptors, limits, rights, signals."""
import functools
import os
import signal

import promises
from bench import Bench, Row
from folders import LONG, ended, paused
from promises import DONE, FILE_ERROR, INTERRUPTED

VARIABLES = [
    {"HOME": None}, {"HOME": ""}, {"PATH": None}, {"TMPDIR": "/nowhere"}, {"TZ": "Nowhere/Here"}, {"TERM": "nonsense"},
    {"COLUMNS": "1"},
    {"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}, {"LC_ALL": "tr_TR.UTF-8"}, {"LC_ALL": "nonsense"},
    {"LC_ALL": None, "LC_NUMERIC": "fr_FR"},
    {"OPENBLAS_NUM_THREADS": "0"}, {"OPENBLAS_NUM_THREADS": "-3"}, {"OPENBLAS_NUM_THREADS": "many"},
    {"OPENBLAS_NUM_THREADS": "99999"},
    {"OMP_NUM_THREADS": "100000"}, {"OMP_DYNAMIC": "true"}, {"OMP_PROC_BIND": "true"}, {"GOTO_NUM_THREADS": "0"},
    {"OPENBLAS_CORETYPE": "Nonsense"},
    {"DEAL_II_NUM_THREADS": "99999"}, {"MALLOC_PERTURB_": "165"}, {"MALLOC_CHECK_": "3"}, {"MALLOC_ARENA_MAX": "1"},
    {"PYTHONPATH": "/nowhere"},
    {"X" * 1000: "y" * 100000}, {"POSIXLY_CORRECT": "1"}, {"LD_BIND_NOW": "1"},
]
QUIET = '"$0" s.prm --quiet'
# Name, line of the shell, exit code, expression, names that may be left.
SHELL = [
    ("no standard input", f"exec {QUIET} <&-", DONE, "", ""),
    ("no standard output", 'exec "$0" s.prm >&-', DONE, "", ""),
    ("no error output", 'exec "$0" s.prm >/dev/null 2>&-', DONE, "", ""),
    ("none of the three", 'exec "$0" s.prm <&- >&- 2>&-', DONE, "", ""),
    ("full standard output", 'exec "$0" s.prm >/dev/full', DONE, "", ""),
    ("reader that leaves", '"$0" s.prm | head -c 10 >/dev/null', DONE, "", ""),
    ("output that is read-only", f"exec {QUIET} 1</dev/null", DONE, "", ""),
    ("64 open files", f"ulimit -n 64; exec {QUIET}", DONE, "", ""),
    ("8 open files", f"ulimit -n 8; exec {QUIET}", DONE, "", ""),
    ("1 MB of stack", f"ulimit -s 1024; exec {QUIET}", DONE, "", ""),
    ("no core files", f"ulimit -c 0; exec {QUIET}", DONE, "", ""),
    ("no locked memory", f"ulimit -l 0; exec {QUIET}", DONE, "", ""),
    ("low priority", f"exec nice -n 19 {QUIET}", DONE, "", ""), ("own session", f"exec setsid {QUIET}", DONE, "", ""),
    ("ignored signals", f"trap '' INT TERM HUP PIPE; {QUIET}", DONE, "", ""),
    ("by a link", 'ln -s "$0" link; ./link s.prm --quiet; c=$?; rm link; exit $c', DONE, "", ""),
    ("current folder deleted", 'f=$PWD; mkdir gone; cd gone; rmdir ../gone; exec "$0" $f/s.prm --quiet', FILE_ERROR,
     "output/s", ""),
    ("current folder deleted, relative name", 'mkdir gone; cd gone; rmdir ../gone; exec "$0" s.prm', FILE_ERROR,
     "s.prm: cannot be read", ""),
    ("full standard output of --check", 'exec "$0" s.prm --check >/dev/full', FILE_ERROR, "standard output", ""),
    ("no standard output for --check", 'exec "$0" s.prm --check >&-', FILE_ERROR, "standard output", ""),
    ("no standard output for --help", 'exec "$0" --help >&-', FILE_ERROR, "standard output", ""),
    ("full standard output of --version", 'exec "$0" --version >/dev/full', FILE_ERROR, "standard output", ""),
    ("no room for files", 'trap "" XFSZ; ulimit -f 0; exec "$0" s.prm --quiet', FILE_ERROR, "output/s.*File too large",
     "output|output/s"),
    ("4 open files", f"ulimit -n 4; exec {QUIET}", FILE_ERROR, "Too many open files", "output|output/s"),
    ("files of 3 blocks", 'trap "" XFSZ; ulimit -f 3; exec "$0" s.prm --quiet', FILE_ERROR, "output/s.*File too large",
     "output.*"),
]

# Only root may use files that give no right to anybody.
SHELL += [(f"umask {mask}", f"umask {mask}; exec {QUIET}", DONE, "", "") for mask in ("777",
                                                                                      "277") if os.geteuid() == 0]


def same_with(changes, bench):
    """The bytes of the tables do not depend on a variable, but for those that choose kernels and threads."""
    code, _, err = bench.call("s.prm", "--quiet", environment=changes)
    faults = promises.of_exit(code, DONE) + promises.of_error_output(code, err, "")
    if faults or any(name.startswith(("OPENBLAS", "OMP", "GOTO")) for name in changes):
        return faults or promises.of_run(bench.folder / "output/s", code)
    table = (bench.folder / "output/s/history.csv").read_bytes()
    return ["the tables differ"] * (table != usual_table(bench.program))


@functools.lru_cache(maxsize=None)
def usual_table(program):
    with Bench(program) as bench:
        bench.set()
        return (bench.folder / "output/s/history.csv").read_bytes()


def signalled(signals, bench):
    """Signals while a run is paused: it stops, and goes on to the same bytes."""
    process = paused(bench)
    for number in signals:
        process.send_signal(number)
    code, err = ended(process)
    faults = promises.of_exit(code, INTERRUPTED) + ([] if "--resume" in err else [f"error output {err!r}"])
    faults += [f"{path.name} is left" for path in bench.folder.rglob("*.part")]
    faults += promises.of_run(bench.folder / "output/s", code)
    code, _, err = bench.set(*LONG, arguments=["--resume"])
    faults += promises.of_exit(code, DONE) + promises.of_error_output(code, err, "")
    return faults + promises.of_run(bench.folder / "output/s", code)


def not_disturbed(signals, bench):
    """Signals that are none of a run's business."""
    process = paused(bench)
    for number in signals:
        process.send_signal(number)
    code, err = ended(process)
    faults = promises.of_exit(code, DONE) + promises.of_error_output(code, err, "")
    return faults + promises.of_run(bench.folder / "output/s", code)


def killed(number, bench):
    """A signal that cannot wait: the next command with --resume goes on, and nothing half written stays."""
    process = paused(bench)
    process.send_signal(number)
    ended(process)
    code, _, err = bench.set(*LONG, arguments=["--resume"])
    faults = promises.of_exit(code, DONE) + promises.of_error_output(code, err, "")
    faults += [f"{path.name} is left" for path in bench.folder.rglob("*.part")]
    return faults + promises.of_run(bench.folder / "output/s", code)


def shortened(changes):
    return ", ".join(f"{name[:30]}={str(value)[:30]}" for name, value in changes.items())


def by_links(folder):
    (folder / "t.prm").symlink_to("s.prm")
    (folder / "here").symlink_to(".")


S = signal
SCRIPTS = {
    **{f"environment: {shortened(changes)}": functools.partial(same_with, changes) for changes in VARIABLES},
    **{"signals: " + " ".join(number.name for number in numbers): functools.partial(signalled, numbers)
       for numbers in ([S.SIGHUP], [S.SIGINT, S.SIGTERM], [S.SIGTERM, S.SIGHUP], [S.SIGPIPE, S.SIGINT],
                       [S.SIGHUP, S.SIGPIPE])},
    **{"not disturbed: " + " ".join(number.name for number in numbers): functools.partial(not_disturbed, numbers)
       for numbers in ([S.SIGPIPE], [S.SIGCHLD], [S.SIGWINCH], [S.SIGCONT, S.SIGURG], [S.SIGXFSZ])},
    **{f"killed: {number.name}": functools.partial(killed, number)
       for number in (S.SIGQUIT, S.SIGABRT, S.SIGKILL, S.SIGUSR1, S.SIGALRM)},
}
ROWS = [
    *[Row(name, shell=line, code=code, says=says, may_leave=left, run="output/s" if code == DONE else "")
      for name, line, code, says, left in SHELL],
    Row("parameter file is a link", ["t.prm", "--quiet"], run="output/t", prepare=by_links),
    Row("folder that is a link to itself", ["here/here/s.prm", "--quiet"], prepare=by_links),
    *[Row(name, script=script) for name, script in SCRIPTS.items()],
]

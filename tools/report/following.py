# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 the orthocone authors
"""Whether a run goes on, and a page that is made anew as long as it does."""
import fcntl
import os
import time

from run_folder import BadFile

LEAST_SECONDS = 5
LARGEST_SHARE = 0.25  # of the time for which making pages may keep a core busy


def is_locked(path, flags):
    try:
        descriptor = os.open(path, flags)
    except OSError:
        return False
    try:
        fcntl.flock(descriptor, fcntl.LOCK_SH | fcntl.LOCK_NB)
        return False
    except OSError as error:
        return isinstance(error, BlockingIOError)
    finally:
        os.close(descriptor)


def is_running(folder):
    """A run locks its folder or, on network file systems, the file .lock in it."""
    return (is_locked(folder, os.O_RDONLY | os.O_DIRECTORY)
            or is_locked(os.path.join(folder, ".lock"), os.O_RDWR | os.O_NOFOLLOW | os.O_NONBLOCK))


def follow(folders, make, seconds=LEAST_SECONDS):
    """Calls make(seconds until the next time) again and again while a run goes on, then make(None) for the last time. Errors
    of the files of a run that goes on are those of files that are just being written."""
    wait = seconds
    while any(map(is_running, folders)):
        start = time.monotonic()
        try:
            make(wait)
        except (OSError, BadFile):
            pass
        end = time.monotonic() + wait
        wait = max(seconds, (time.monotonic() - start) / LARGEST_SHARE)
        while time.monotonic() < end and any(map(is_running, folders)):
            time.sleep(min(seconds, 1))
    make(None)

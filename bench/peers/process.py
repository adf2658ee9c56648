"""Runs a program with limits and measures it: CPU seconds, wall seconds and peak memory of the process itself."""
import os
import resource
import signal
import subprocess
import tempfile
import threading
import time
from dataclasses import dataclass, field


@dataclass
class Limits:
    """What a run may take, and where it may run."""

    wall_s: float = 600
    memory_bytes: int = 0  # of address space; 0: no limit
    cores: tuple = ()  # (): where the system likes
    threads: int = 1  # that libraries may start


@dataclass
class Outcome:
    """How a run ended. `status` is ok, over_limit or failed."""

    status: str = "ok"
    exit_status: int = 0
    wall_s: float = 0
    cpu_s: float = 0
    peak_mib: float = 0
    output: str = ""
    errors: str = ""
    lines: list = field(default_factory=list)  # (CPU seconds when it came, line), when asked for


def is_newer(path, *sources):
    """The file is there, and no older than what it was made from."""
    return path.exists() and path.stat().st_mtime >= max(source.stat().st_mtime for source in sources)


def available_bytes():
    """What the system could give to a program now."""
    with open("/proc/meminfo", encoding="ascii") as file:
        for line in file:
            if line.startswith("MemAvailable:"):
                return 1024 * int(line.split()[1])
    return 0


def cpu_seconds_of(pid):
    """CPU seconds of all threads of a running process (its clock: see clock_getcpuclockid)."""
    try:
        return time.clock_gettime((~pid << 3) | 2)
    except OSError:
        return None


def environment(threads):
    """The environment in which every library that is compared uses so many threads."""
    names = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "CCX_NPROC_STIFFNESS")
    return dict(os.environ, **dict.fromkeys(names, str(threads)))


def run(command, limits, folder=None, watch=False):
    """Runs `command` to its end or to a limit. With `watch` its lines are kept with the CPU time at which they came."""

    def prepare():
        if limits.cores:
            os.sched_setaffinity(0, limits.cores)
        if limits.memory_bytes:
            resource.setrlimit(resource.RLIMIT_AS, (limits.memory_bytes, limits.memory_bytes))

    outcome = Outcome()
    with tempfile.TemporaryFile() as errors:
        begin = time.monotonic()
        child = subprocess.Popen(
            [str(word) for word in command], cwd=folder, env=environment(limits.threads), stdout=subprocess.PIPE,
            stderr=errors, preexec_fn=prepare, start_new_session=True)
        over = threading.Event()

        def end_it():
            over.set()
            os.killpg(child.pid, signal.SIGKILL)

        timer = threading.Timer(limits.wall_s, end_it)
        timer.start()
        text = []
        try:
            for line in child.stdout:
                line = line.decode(errors="replace")
                text.append(line)
                if watch:
                    outcome.lines.append((cpu_seconds_of(child.pid), line.strip()))
        except BaseException:
            timer.cancel()
            end_it()
            raise
        # The child is not reaped before the timer is off, so that its id cannot have passed to another process.
        os.waitid(os.P_PID, child.pid, os.WEXITED | os.WNOWAIT)
        timer.cancel()
        timer.join()
        _, status, usage = os.wait4(child.pid, 0)
        outcome.wall_s = time.monotonic() - begin
        child.returncode = os.waitstatus_to_exitcode(status)
        child.stdout.close()
        errors.seek(0)
        outcome.errors = errors.read().decode(errors="replace").strip()
    outcome.exit_status = child.returncode
    outcome.output = "".join(text)
    outcome.cpu_s = usage.ru_utime + usage.ru_stime
    outcome.peak_mib = usage.ru_maxrss / 1024
    if over.is_set():
        outcome.status = "over_limit"
    elif child.returncode != 0:
        outcome.status = "failed"
    return outcome

"""What the scripts that race plugc against the reference viewer share: the two commands, a display for the viewer, and a clock.

The viewer is Debian's package view3dscene; it needs an X server, so an Xvfb is started on a free display.
"""
import contextlib
import os
import pathlib
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORPUS = ROOT.parent / "shared/corpus/scenes"
SIZE = "800x600"


def plugc_preview(build, scene, picture, *more):
    return [build / "bin/plugc", "preview", scene.name, "-o", picture, "--size", SIZE, *more]


def peer_screenshot(scene, *screenshot):
    return ["view3dscene", "--no-sound", "-H", "--hide-menu", "--geometry", SIZE, scene.name, *screenshot]


def has_peer():
    return all(shutil.which(program) for program in ("view3dscene", "Xvfb"))


@contextlib.contextmanager
def x_display():
    """Runs an Xvfb on a display of its own choice; gives the display's name."""
    reader, writer = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writer), "-screen", "0", "1700x1024x24", "+extension", "GLX"],
        pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writer)
    try:
        with os.fdopen(reader) as pipe:
            yield ":" + pipe.readline().strip()
    finally:
        server.terminate()
        server.wait()


def milliseconds(command, scene, environment, picture):
    """How long the command takes, run from the scene's folder; it must write the picture."""
    picture.unlink(missing_ok=True)
    start = time.perf_counter()
    done = subprocess.run(command, cwd=scene.parent, env={**os.environ, **environment},
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    elapsed = (time.perf_counter() - start) * 1000
    if done.returncode not in (0, 1) or not picture.exists():
        sys.exit(f"{command[0]} drew no picture (exit status {done.returncode}): {done.stderr.strip()}")
    return elapsed

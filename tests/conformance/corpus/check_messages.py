#!/usr/bin/python3
"""Reads every scene of the corpus and compares what is said with messages.txt.

usage: check_messages.py PLUGC SHARED_FOLDER [--write]

A line of messages.txt is `SCENE: CODE LINE:COLUMN ...`; docs/reading.md says why each is right. Scenes that are not in it say
nothing. Exit status 77 (skipped) when the corpus is not there; --write writes the list anew, to be reviewed as a diff.
"""
import os
import re
import subprocess
import sys

SKIPPED = 77
LIST = os.path.join(os.path.dirname(os.path.abspath(__file__)), "messages.txt")
ENDINGS = (".x3d", ".x3dv", ".x3dj", ".json", ".wrl", ".x3dz", ".x3dvz", ".wrz", ".gz")
MESSAGE = re.compile(r"^(\S.*?):(\d+:\d+): (?:error|warning|note): .*\[([a-z-]+)\]$")


def scenes(folder):
    for path, _, names in os.walk(folder):
        for name in names:
            if name.endswith(ENDINGS):
                yield os.path.relpath(os.path.join(path, name), folder)


def said(plugc, folder, scene):
    command = [plugc, "inspect", "--dump", "scene", scene]
    result = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace")
    if result.returncode not in (0, 1):
        return [f"ended-with-{result.returncode} 1:1"]
    found = [MESSAGE.match(line) for line in result.stderr.splitlines()]
    messages = []
    for match in filter(None, found):
        file = os.path.relpath(os.path.join(folder, match[1]), folder)
        place = match[2] if file == scene else f"{file}:{match[2]}"
        messages.append(f"{match[3]} {place}")
    return messages


def main():
    plugc, shared = map(os.path.abspath, sys.argv[1:3])
    folder = os.path.join(shared, "corpus", "scenes")
    if not os.path.exists(folder):
        print(f"skipped: {folder} is not there")
        sys.exit(SKIPPED)
    lines = [f"{scene}: {message}" for scene in sorted(scenes(folder)) for message in said(plugc, folder, scene)]
    if "--write" in sys.argv:
        with open(LIST, "w", encoding="utf-8") as file:
            file.writelines(line + "\n" for line in lines)
        return
    with open(LIST, encoding="utf-8") as file:
        expected = file.read().splitlines()
    missing = [line for line in expected if line not in lines]
    new = [line for line in lines if line not in expected]
    for line in missing:
        print(f"no longer said: {line}")
    for line in new:
        print(f"said now: {line}")
    sys.exit(1 if missing or new else 0)


main()

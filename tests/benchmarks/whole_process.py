#!/usr/bin/env python3
"""Whole processes, from a mesh file to a written 1024 x 1024 PNG, in turn with a yardstick:

    whole_process.py REFLECTANCE MESH.obj [RUNS] [YARDSTICK COMMAND...]

Ours takes the backend that `--backend auto` chose in the first, uncounted run. The yardstick is
`xvfb-run -a f3d MESH --output PICTURE --resolution 1024,1024` unless another command is given; of it `xvfb-run` costs
about as much as a screen that is already there would not. Prints medians of wall seconds, CPU seconds and the largest
process's peak memory, and their ratios.
"""
import os
import statistics
import subprocess
import sys
import tempfile
import time


def run(command):
    start = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit("failed: " + " ".join(command))
    return time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program, mesh = sys.argv[1:3]
    runs = int(sys.argv[3]) if len(sys.argv) > 3 else 5
    with tempfile.TemporaryDirectory() as folder:
        picture = os.path.join(folder, "picture.png")
        ours = [program, "render", mesh, "--out", picture, "--size", "1024x1024", "--samples", "1"]
        yardstick = sys.argv[4:] or ["xvfb-run", "-a", "f3d", mesh, "--output", picture, "--resolution", "1024,1024"]
        run(ours), run(yardstick)
        figures = [(run(ours), run(yardstick)) for _ in range(runs)]
    for i, name in enumerate(["wall s", "CPU s", "peak MB"]):
        mine = statistics.median(pair[0][i] for pair in figures)
        its = statistics.median(pair[1][i] for pair in figures)
        print(f"{name:8} ours {mine:8.2f}   yardstick {its:8.2f}   yardstick / ours {its / mine:.2f}")


main()

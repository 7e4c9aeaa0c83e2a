#!/usr/bin/env python3
"""Draws the models of debian.txt and compares what the program says with what the list expects.

    debian_models.py SOFTGL [--folder FOLDER] [--download] [--sheet SHEET.png]

Without a folder the models are looked for where their packages install them. With one they lie in FOLDER/PACKAGE/..., and
--download puts them there first. A model that is not at hand is left out; the exit code is 77 if none is, 1 if one is drawn
with a fault, a warning that the list does not have, or another axis up.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

LIST = pathlib.Path(__file__).with_name("debian.txt")


def read_list():
    """Each model as a dictionary: package, version, license, path, up, warnings."""
    models = []
    for line in LIST.read_text().splitlines():
        if line.startswith("  warning: "):
            models[-1]["warnings"].append(line[len("  warning: "):].split(" -- ")[0])
        elif line and not line.startswith("#"):
            package, version, licence, up, path = line.split()
            models.append(dict(package=package, version=version, license=licence, up=up, path=path, warnings=[]))
    return models


def download(models, folder):
    """Unpacks each package into a folder of its name."""
    for package, version in sorted({(m["package"], m["version"]) for m in models}):
        if (folder / package).is_dir():
            continue
        with tempfile.TemporaryDirectory() as files:
            subprocess.run(["apt-get", "download", f"{package}={version}"], cwd=files, check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            archive = next(pathlib.Path(files).glob("*.deb"))
            subprocess.run(["dpkg-deb", "-x", archive, folder / package], check=True)


def faults_of(softgl, model, file, picture):
    """What is wrong with a model's picture, a sentence each."""
    run = subprocess.run([softgl, file, "-o", picture, "--size", "256x256", "--verbose"], capture_output=True, text=True)
    faults = [] if run.returncode == 0 else [f"ends with {run.returncode}: {run.stderr.strip()}"]
    warnings = [line for line in run.stderr.splitlines() if line.startswith("softgl: warning: ")]
    for warning in warnings:
        if not any(known in warning for known in model["warnings"]):
            faults.append("says what is not in the list: " + warning)
    for known in model["warnings"]:
        if not any(known in warning for warning in warnings):
            faults.append("does not say: " + known)
    up = re.search(r"up is (\S+)", run.stderr)
    if up and up.group(1) != model["up"]:
        faults.append(f"stands on {up.group(1)}, not on {model['up']}")
    return faults


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("softgl")
    arguments.add_argument("--folder", type=pathlib.Path)
    arguments.add_argument("--download", action="store_true")
    arguments.add_argument("--sheet")
    options = arguments.parse_args()
    models = read_list()
    if options.download:
        download(models, options.folder)
    found, failed = [], 0
    with tempfile.TemporaryDirectory() as pictures:
        for model in models:
            root = options.folder / model["package"] if options.folder else pathlib.Path("/")
            if not (root / model["path"]).is_file():
                continue
            found.append(root / model["path"])
            for fault in faults_of(options.softgl, model, found[-1], pathlib.Path(pictures) / "one.png"):
                failed += 1
                print(f"{model['package']} {model['path']}: {fault}")
    if options.sheet and found:
        subprocess.run([options.softgl, *found, "-o", options.sheet, "--size", "200x200", "--aa", "4", "--sheet", "10",
                        "--quiet"], check=True)
    print(f"{len(found)} of {len(models)} models drawn, {failed} faults")
    return 1 if failed else 0 if found else 77


if __name__ == "__main__":
    sys.exit(main())

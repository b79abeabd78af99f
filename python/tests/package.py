"""The package as it is imported from the build folder, and the program beside it."""
import functools
import os
import pathlib
import subprocess

import flexslip

PROGRAM = os.environ["FLEXSLIP"]
SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
EXAMPLES = "simulated", "cracked", "cyclic", "surface"
DESIGN = "examples/design.toml"
SPICULES = SOURCE / "../shared/data/spicules"


def case(name):
    return f"examples/{name}/case.toml"


@functools.cache
def fitted(name):
    """The fit of an example, made once for all that only look at it."""
    return flexslip.fit(case(name))


@functools.cache
def campaign_of_examples():
    return flexslip.campaign("examples")


def told(*arguments):
    """What the program writes to standard output."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False).stdout

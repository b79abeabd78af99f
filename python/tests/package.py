"""The package as it is imported from the build folder, and the program beside it."""
import os
import pathlib
import subprocess

PROGRAM = os.environ["FLEXSLIP"]
SOURCE = pathlib.Path(os.environ["SOURCE_DIR"])
EXAMPLES = "simulated", "cracked", "cyclic", "surface"
SPICULES = SOURCE / "../shared/data/spicules"


def told(*arguments):
    """What the program writes to standard output."""
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False).stdout

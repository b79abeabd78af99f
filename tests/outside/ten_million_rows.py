#!/usr/bin/python3
"""outside: ten million rows are read in seconds and in little memory, and what is wrong in the last of them is found."""
import os
import resource
import sys
import unittest

from program import SOURCE, InFolder

ROWS = 10_000_000
BLOCK = 100_000


class TenMillionRows(InFolder):
    def test_last_row_but_one_wrong(self):
        with open(self.folder / "test.csv", "w", encoding="ascii") as file:
            file.write("stage [um],force [mN]\n")
            for start in range(0, ROWS - 2, BLOCK):
                file.write("".join(f"{row * 1e-4:.4f},{row * 1e-6:.6f}\n" for row in range(start, start + BLOCK)))
            file.write("1000.0,OVER\n1000.0,10\n")
        case = self.file("case.toml", (SOURCE / "examples/simulated/case.toml").read_text(encoding="utf-8"))
        # Of each row its text (18 bytes), 4 bytes a cell and a line, 8 a number and 8 for its line: 0.54 GB, and a tenth for the program.
        self.refused("invert", case, says=["test.csv:10000002", "force", "'OVER'", "and readings follow"])
        most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024  # that of the largest call
        self.assertLess(most, 60 * ROWS)


if __name__ == "__main__":
    if os.environ.get("FLEXSLIP_CONFIG") != "Release":
        print("skipped: only the release build is fast enough")
        sys.exit(77)
    unittest.main()

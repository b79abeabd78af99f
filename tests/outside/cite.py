#!/usr/bin/python3
"""outside: `flexslip cite` says what CITATION.cff says, and there is one version: that of CMake's project."""
import re
import shutil
import subprocess
import unittest

from program import SOURCE, InFolder, run

CITATION = (SOURCE / "CITATION.cff").read_text(encoding="utf-8")
VERSION = re.search(r"project\(FlexSlip\s+VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


def stated(key, text=CITATION):
    """The value of a key of CITATION.cff, which may be folded over lines."""
    match = re.search(rf"^ *(?:- )?{key}: (?:>-\n((?: {{6,}}.*\n)+)|(.*))", text, re.MULTILINE)
    return " ".join((match.group(1) or match.group(2)).split()).strip('"')


def entries(text):
    """BibTeX as {key: (type, {name: value})}; all of the text must be entries."""
    found = {}
    rest = text
    for whole, kind, key, body in re.findall(r"(@(\w+)\{(\w+),\n((?:  \w+ *= \{.*\},\n)+)\}\n)", text):
        rest = rest.replace(whole, "")
        found[key] = kind, dict(re.findall(r"^  (\w+) *= \{(.*)\},$", body, re.MULTILINE))
    return found, rest.strip()


class Cite(InFolder):
    def test_the_paper_is_that_of_the_citation_file(self):
        found, rest = entries(self.succeeds("cite"))
        self.assertEqual(rest, "")
        kind, paper = found["fang2021sawtooth"]
        reference = CITATION.split("references:")[1]
        people = [f"{family}, {given}" for family, given in re.findall(r"family-names: (.*)\n +given-names: (.*)", reference)]
        self.assertEqual(kind, "article")
        self.assertEqual(paper["author"].split(" and "), people)
        self.assertEqual(paper["title"].strip("{}"), stated("title", reference))
        for name, key in (("journal", "journal"), ("year", "year"), ("pages", "start"), ("doi", "doi")):
            self.assertEqual(paper[name], stated(key, reference))
        for text in (paper["title"], paper["author"], paper["journal"]):
            self.assertEqual(text.count("{"), text.count("}"))

    def test_the_program_is_that_of_the_citation_file(self):
        kind, program = entries(self.succeeds("cite"))[0]["flexslip"]
        self.assertEqual(kind, "misc")
        self.assertEqual(program["author"].strip("{}"), stated("- name"))
        self.assertTrue(program["title"].strip("{}").startswith(stated("title")))
        self.assertIn(stated("license"), program["note"])
        self.assertIn(program["year"], (SOURCE / "LICENSE").read_text(encoding="utf-8"))

    def test_there_is_one_version(self):
        self.assertEqual(self.succeeds("--version"), f"flexslip {VERSION}\n")
        self.assertEqual(stated("version"), VERSION)
        self.assertEqual(entries(self.succeeds("cite"))[0]["flexslip"][1]["version"], VERSION)
        latest = re.search(r"^## (.*)$", (SOURCE / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE).group(1)
        self.assertEqual(latest.split()[0].strip(","), VERSION)

    def test_json_has_the_same_fields(self):
        found, _ = entries(self.succeeds("cite"))
        self.assertEqual({entry["key"]: (entry["type"], entry["fields"]) for entry in self.json("cite")}, found)

    def test_a_bibliography_by_bibtex(self):
        if not shutil.which("bibtex"):
            self.skipTest("no bibtex")
        self.file("refs.bib", self.succeeds("cite"))
        self.file("a.aux", "\\citation{*}\n\\bibdata{refs}\n\\bibstyle{plain}\n")
        done = subprocess.run(["bibtex", "a"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("Kochiyama", (self.folder / "a.bbl").read_text())


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/python3
"""outside: one answer through all doors. The records of tests/outside/doors.json, one for each verdict and each kind of file, say the same on the screen,
in JSON, in Python, in the report and in a campaign. studio/tests/doors_test.mjs holds the page against the same JSON."""
import html
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import flexslip
from flexslip._errors import advice
from package import PROGRAM, SOURCE, told

RECORDS = json.loads((SOURCE / "tests/outside/doors.json").read_text(encoding="utf-8"))
TITLES = {"crosshead": "crosshead [um]", "time": "time [s]", "force": "force [mN]"}  # the crosshead moves by 1 µm in each second
SIGNED = r"[+\u2212]\d+\.\d\d\b"


def record_in(folder, record):
    """The file of a record, as a user would have it."""
    if book := record.get("workbook"):
        return pathlib.Path(shutil.copy(SOURCE / book, folder / f"{record['name']}.xlsx"))
    path = folder / f"{record['name']}.csv"
    if simulated := record.get("simulated"):
        truth = folder / "truth.toml"
        truth.write_text("\n".join(simulated), encoding="utf-8")
        path.write_text(told("simulate", truth, "--noise", "10 uN"), encoding="utf-8")
        truth.unlink()
        return path
    lines = [line for line in (SOURCE / record["readings"]).read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    path.write_text("\n".join([",".join(TITLES[name] for name in record["columns"]), *lines[1:record["rows"] + 1], ""]), encoding="utf-8")
    return path


def flat(text):
    return " ".join(text.split())


def words_in(page):
    """What an HTML page says."""
    return flat(html.unescape(re.sub(r"<[^>]*>", " ", re.sub(r"<(style|script|svg)\b.*?</\1>", "", page, flags=re.DOTALL))))


def probability(share):
    percent = 100 * share
    away = abs(abs(percent - 50) - 45)
    if away >= 0.5 and not 1 <= percent <= 99:
        return "below 1 %" if percent < 1 else "above 99 %"
    return f"{percent:.{2 if away < 0.05 else 1 if away < 0.5 else 0}f} %"


def of_each(test):
    """A test of each record by itself."""
    def of_all(self):
        for name, given in self.answers.items():
            with self.subTest(name):
                test(self, *given)
    return of_all


class Doors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.answers = {}
        for record in RECORDS:
            place = cls.folder / "tests" / record["name"]
            place.mkdir(parents=True)
            path = record_in(place, record)
            flags = [words for name, value in record["stated"].items() for words in (f"--{name}", value)]
            answer = json.loads(told("fit", path, *flags, "--json", "--quiet"))
            case = place / "case.toml"
            case.write_text(answer["provenance"]["case"], encoding="utf-8")
            cls.answers[record["name"]] = (record, path, flags, answer, case)

    def test_the_records_have_every_verdict_and_every_kind_of_file(self):
        for record, _, _, answer, _ in self.answers.values():
            self.assertEqual(answer["verdict"]["code"], record["verdict"], answer["verdict"]["sentence"])
        self.assertLessEqual({"slip", "crack", "slip_and_damage", "undecided", "no_drops", "check_input"}, {record["verdict"] for record in RECORDS})
        self.assertEqual({path.suffix for _, path, _, _, _ in self.answers.values()}, {".csv", ".xlsx"})

    @of_each
    def test_the_words_of_an_answer_have_its_numbers(self, record, path, flags, answer, case):
        rows, causes = {row["label"]: row["words"] for row in answer["answer"]}, answer["judgement"]["causes"]
        if printed := re.search(r"cracks only: ((?:below |above )?[\d.]+ %)", answer["verdict"]["sentence"]):
            self.assertEqual(printed[1], probability(causes["cracks"]))
        mu0, friction = answer["parameters"].get("mu0"), rows.get("friction", "none")
        if printed := re.match(r"(\d\.(\d+)) ± (\d\.\d+)", friction):
            digits = len(printed[2])
            self.assertEqual((printed[1], printed[3]), (f"{mu0['value']:.{digits}f}", f"{mu0['standard_error']:.{digits}f}"))
        elif printed := re.match(r"at most (\S+)", friction):
            self.assertAlmostEqual(float(printed[1]) / mu0["interval95"][1], 1, delta=0.05)
        else:
            self.assertRegex(friction, "^none")
        energy = answer["energy"]
        if printed := re.match(r"friction took (?:at least )?(\d+)(?: ± (\d+))? %", rows.get("work", "")):
            low, high = energy["friction_share_interval95"]
            error = (high - low) / (2 * 1.959964)
            if printed[2]:
                self.assertEqual((printed[1], printed[2]), (f"{100 * energy['friction_share']:.0f}", f"{100 * error:.0f}"))
            else:
                self.assertLess(int(printed[1]), 100 * energy["friction_share"])
                self.assertIn("at least", rows["work"])
        else:
            self.assertNotIn("work", rows)
        moves = {f"{'+' if each['friction_moves'] >= 0 else chr(0x2212)}{abs(each['friction_moves']):.2f}" for each in answer["sensitivities"]}
        self.assertLessEqual(set(re.findall(SIGNED, rows.get("sensitivity", ""))), moves)

    @of_each
    def test_the_screen_says_what_the_json_says(self, record, path, flags, answer, case):
        screen, full = told("fit", path, *flags, "--quiet"), flat(told("fit", path, *flags, "--quiet", "--full"))
        head, _, rest = screen.partition("\n\n")
        self.assertEqual(flat(head), f"{answer['name']}: {answer['verdict']['sentence']}")
        rows = {row["label"]: row["words"] for row in answer["answer"]}
        shown = re.findall(r"^  (\S.*?) {2,}(\S.*(?:\n {4,}\S.*)*)$", rest, re.MULTILINE)
        doubts = [doubt for doubt in answer["doubts"]]
        for label, words in shown:
            words = flat(words)
            if label == "next":
                self.assertEqual(words, answer["next"])
            elif label in rows:
                self.assertTrue(rows[label] == words or rows[label].startswith(f"{words};"), (rows[label], words))
            else:
                doubt = doubts.pop(0)
                self.assertEqual(label, doubt["severity"])
                short = doubt["short_form"][:1].upper() + doubt["short_form"][1:] + "."
                self.assertIn(words, (doubt["sentence"], f"{doubt['sentence']} {doubt['remedy']}".strip(), short))
        more = re.search(r"^(\d+) more doubts?\.", rest, re.MULTILINE)
        self.assertEqual(len(doubts), int(more[1]) if more else 0)
        self.assertIn(f"{answer['checks']} ± is one standard error.".strip(), flat(rest))
        for words in (*rows.values(), *(f"{doubt['sentence']} {doubt['remedy']}".strip() for doubt in answer["doubts"]), answer["next"], answer["checks"]):
            self.assertIn(words, full)

    @of_each
    def test_python_says_what_the_screen_says_and_has_the_numbers_of_the_json(self, record, path, flags, answer, case):
        fit = flexslip.fit(case)
        self.assertEqual(fit.to_json(), told("fit", case, "--json", "--quiet"))
        self.assertEqual(fit.summary(), advice(told("fit", case, "--quiet")))
        self.assertEqual(fit.summary(full=True), advice(told("fit", case, "--quiet", "--full")))
        self.assertEqual((fit.verdict.sentence, fit.checks), (answer["verdict"]["sentence"], answer["checks"]))
        self.assertEqual([row.words for row in fit.answer], [row["words"] for row in answer["answer"]])
        shown, page = flat(repr(fit)), words_in(fit._repr_html_())
        for words in (f"{fit.name}: {answer['verdict']['sentence']}", *(advice(f"{doubt.sentence} {doubt.remedy}".strip()) for doubt in fit.doubts), fit.next):
            self.assertIn(words, shown)
            self.assertIn(words, page)
        if mu0 := answer["parameters"].get("mu0"):
            self.assertEqual((fit.params["mu0"].value, fit.params["mu0"].stderr), (mu0["value"], mu0["standard_error"]))

    @of_each
    def test_the_report_says_what_the_json_says(self, record, path, flags, answer, case):
        told("fit", path, *flags, "--report", path.parent / "report", "--quiet")
        page = words_in((path.parent / "report/report.html").read_text(encoding="utf-8"))
        word, _, sentence = answer["verdict"]["sentence"].partition(". ")
        for words in (word, sentence, *(row["words"] for row in answer["answer"]), *(f"{doubt['sentence']} {doubt['remedy']}".strip() for doubt in answer["doubts"]),
                      answer["checks"], answer["next"]):
            self.assertIn(flat(words), page)

    def test_a_campaign_says_of_each_what_its_fit_says(self):
        done = subprocess.run([PROGRAM, "campaign", self.folder / "tests", "--json", "--quiet"], capture_output=True, text=True, check=False)
        told_of = json.loads(done.stdout)
        campaign = {pathlib.Path(test["file"]).parent.name: test for test in told_of["tests"] + told_of["failures"]}
        self.assertEqual(set(campaign), set(self.answers))
        for name, (_, _, _, answer, _) in self.answers.items():
            with self.subTest(name):
                test = campaign[name]
                self.assertEqual(test["verdict"], answer["verdict"]["sentence"].partition(". ")[0])
                if test in told_of["failures"]:
                    self.assertIn(answer["verdict"]["sentence"].partition(". ")[2], test["reason"])
                    continue
                self.assertEqual(test["cracks_alone"], answer["judgement"]["cracks_alone"])
                friction = next(row["words"] for row in answer["answer"] if row["label"] == "friction")
                for parameter in ("mu0", "bending_stiffness"):
                    if friction.startswith("none"):
                        self.assertIsNone(test["parameters"]["mu0"]["value"])
                    else:
                        self.assertEqual(test["parameters"][parameter], answer["parameters"][parameter])
                for doubt in answer["doubts"]:
                    self.assertIn(doubt["short_form"], test["remarks"])


if __name__ == "__main__":
    unittest.main()

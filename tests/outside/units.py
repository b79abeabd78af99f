#!/usr/bin/python3
"""outside: the page knows the units and prefixes of the program, and no others."""
import re
import unittest

from program import SOURCE

PAGE = (SOURCE / "studio/page/src/quantity.ts").read_text(encoding="utf-8")
PROGRAM_LIST = (SOURCE / "src/io/quantity.cpp").read_text(encoding="utf-8")


def of_page(name):
    body = re.search(rf"const {name}: Record<string, (?:number|string)> = {{(.*?)}};", PAGE, re.S).group(1)
    return {quoted or word for quoted, word in re.findall(r'(?:"([^"]+)"|(\w+)): ', body)}


def of_program(name):
    body = re.search(rf"constexpr std::array(?:<[^=]*>)? {name}{{(.*?)}};\n", PROGRAM_LIST, re.S).group(1)
    return {re.sub(r"\\u([0-9a-f]{4})", lambda code: chr(int(code.group(1), 16)), each) for each in re.findall(r'{"([^"]+)"', body)}


class Units(unittest.TestCase):
    def test_the_lists_of_the_page_are_those_of_the_program(self):
        for page, program in (("PREFIXES", "prefixes"), ("WITH_PREFIX", "with_prefix"), ("WITHOUT_PREFIX", "without_prefix"), ("SPELLINGS", "spellings")):
            self.assertTrue(of_page(page))
            self.assertEqual(of_page(page), of_program(program))


if __name__ == "__main__":
    unittest.main()

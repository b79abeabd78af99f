"""What is wrong with an input, as exceptions that Python's users expect, and the checks of arguments that raise them."""
from __future__ import annotations

import errno
import operator
import os
import re
import shlex
import sys
import warnings
from collections.abc import Sequence
from typing import SupportsFloat, SupportsIndex, cast


Path = str | bytes | os.PathLike[str] | os.PathLike[bytes]
ARRAYS = "arrays"  # what a record in memory is called


class InputError(ValueError):
    """Bad input: what is wrong, where, and how to mend it.

    Attributes
    ----------
    file : str or None
        The file it stands in, as it was named.
    line : int or None
        The line of that file, counted from 1.
    field : str or None
        What to search for there: ``"[rig] span"``, ``"column 'F_N'"``.
    key : str or None
        The key of a case: ``"rig.span"``.
    kind : str
        ``"wrong"``, ``"missing"``, ``"unknown"``, or ``"too_much"``: a number beyond `limit`.
    limit : float or None
        The greatest value, in SI, or reduced.
    problem, remedy : str or None
        The sentences of the message: what is wrong, and what to do.

    Examples
    --------
    >>> import flexslip
    >>> try:
    ...     flexslip.Case(rig={"span": "1278"})
    ... except flexslip.InputError as error:
    ...     print(error.key, "|", error.problem)
    rig.span | The number '1278' has no unit, but a length needs one.
    """

    file: str | None = None
    line: int | None = None
    field: str | None = None
    key: str | None = None
    kind: str = "wrong"
    limit: float | None = None
    problem: str | None = None
    remedy: str | None = None

    def __reduce__(self) -> tuple[object, ...]:
        parts = {name: getattr(self, name) for name in _PARTS}
        return _again, (str(self), parts)


class MissingFileError(InputError, FileNotFoundError):
    """A file that is not there."""

    __str__ = ValueError.__str__


class ForbiddenFileError(InputError, PermissionError):
    """A file that may not be read or written."""

    __str__ = ValueError.__str__


class FolderError(InputError, IsADirectoryError):
    """A folder where a file is wanted."""

    __str__ = ValueError.__str__


for _named in (InputError, MissingFileError, ForbiddenFileError, FolderError):
    _named.__module__ = "flexslip"  # as tracebacks name it

_PARTS = ("file", "line", "field", "key", "kind", "limit", "problem", "remedy")
_OF_SYSTEM = {
    "No such file or directory": MissingFileError,
    "Permission denied": ForbiddenFileError,
    "Is a directory": FolderError,
    "This is a directory": FolderError,
}


_FLAG = re.compile(r'(as in )?(?<![\w-])--([a-z][a-z-]*)(?: ((?(1)\S+|(?:"[^"]*"|[0-9]+\b|[A-Z]{3,}\b|crosshead\b|deflection\b|roughness\b))))?')
_KEYS = re.compile(r'\b[wW]rite\s+(\w+ = (?:"[^"]*"|\S+)(?: and \w+ = (?:"[^"]*"|\S+))*)\s+into\s+\[\w+\]')
_KEY = re.compile(r'(\w+) = ("[^"]*"|\S+)(?: and )?')


def in_python(text: str) -> str:
    """Flags of the command line, and keys of a case, as arguments: --displacement crosshead is displacement="crosshead"."""
    def argument(found: re.Match[str]) -> str:
        if found.group(2) in _METHODS and not found.group(3):
            return (found.group(1) or "") + _METHODS[found.group(2)]
        value = found.group(3) or ""
        is_bare = value[:1] in '"' or value[:1].isdigit() or (value.isupper() and len(value) > 2)
        return (found.group(1) or "") + _argument(found.group(2)) + "=" + (value if is_bare else f'"{value}"')

    text = _KEYS.sub(lambda found: ("Pass " if found.group(0).startswith("W") else "pass ") + ", ".join(f"{name}={value}" for name, value in _KEY.findall(found.group(1))), text)
    text = re.sub(r"^--set: (?=\w+\.)", "", text)  # a key by its whole name follows
    text = re.sub(r"^--([a-z-]+): ", lambda found: f"{_argument(found.group(1))}: ", text)
    text = re.sub(r"\b(?:modulus|fit) --([a-z-]+)", lambda found: f"{_argument(found.group(1))}=…", text)
    text = re.sub(r"\bflexslip\s+(\w+)\s+FILE\b", r"flexslip.\1(file)", text)
    return re.sub(r"\bflexslip (sweep|fit|simulate|design|read|surface|modulus)\b", r"flexslip.\1", _FLAG.sub(argument, text))


_METHODS = {"full": "summary(full=True)", "json": "to_json()"}  # of an answer, which are flags of the program


def _argument(flag: str) -> str:
    """The argument that a flag of the command line is."""
    return "friction_range" if flag == "friction" else flag.replace("-", "_")


_VALUE = r'(?: = ("[^"]*"|[\w.%]+|…))?'


def advice(text: str) -> str:
    """What the program says of an answer, with arguments instead of flags and of keys of a case file: [friction] mu0 is friction={"mu0": …}."""
    text = re.sub(r"\[(friction|stage)\]\s+(\w+)" + _VALUE, lambda found: f'{found[1]}={{"{found[2]}": {found[3] or "…"}}}', in_python(text))
    return re.sub(r"\[(?:specimen|rig|record)\]\s+(\w+)" + _VALUE, lambda found: found[1] + (f"={found[2]}" if found[2] else ""), text)


def arguments(flags: str) -> str:
    """Flags with their values as arguments of a call."""
    words = iter(shlex.split(flags))
    return ", ".join(f"{_argument(flag[2:])}={value!r}" for flag, value in zip(words, words))


_ADDED = re.compile(r'(\w+) = ("[^"]*"|\[[^\]]*\]|[^,\s]+)')
_BOTH = r"\1=\2"
_NO_DATA = "no data: pass a file, a DataFrame, or two arrays, as in fit(stage, force)"


def in_keywords(text: str) -> str:
    """Sections and keys of a case file that nobody wrote as keywords."""
    def section(found: re.Match[str]) -> str:
        name, keys = found.groups()
        if name in ("friction", "stage"):
            return f"{name}: This argument is missing. Add {name}={{{', '.join(f'{chr(34)}{key}{chr(34)}: {value}' for key, value in _ADDED.findall(keys))}}}."
        return f"{name}: This argument is missing. Add {_ADDED.sub(_BOTH, keys)}."

    text = re.sub(r"^line \d+: ", "", text, flags=re.MULTILINE)
    text = re.sub(r"\[record\](?: file)?: This (?:section|value) is missing\. Add .*", _NO_DATA, text)
    text = re.sub(r"\[(\w+)\]: This section is missing\. Add (.*?)\.?$", section, text, flags=re.MULTILINE)
    text = re.sub(r"\bAdd (\w+) = ", r"Add \1=", text.replace("This value is missing", "This argument is missing"))
    text = re.sub(r"\[(?:specimen|rig|record)\] (\w+)", r"\1", text)
    text = re.sub(r"\[(friction|stage)\] (\w+)", r'\1["\2"]', text)
    text = re.sub(r"\b([wW])rite the modulus or bending_stiffness into \[specimen\]", lambda verb: ("Pass" if verb[1] == "W" else "pass") + " modulus or bending_stiffness", text)
    return re.sub(r"\[(specimen|rig|friction|stage|record)\]", r"\1", text)


_MISSING = re.compile(r"([^:\n]+): (This argument is missing\.) (Add [^\n]*)")


def of_keywords(error: InputError, record: str) -> InputError:
    """A complaint about a case file that nobody wrote, in words of the keywords that made it; `record` is what its record in memory is called."""
    if error.file not in (None, record):
        return error
    parts = {name: getattr(error, name) for name in _PARTS if name != "line"}
    parts |= {name: in_keywords(str(parts[name])) for name in ("field", "problem", "remedy") if parts[name]}
    message = in_keywords(str(error))
    if _NO_DATA in message:
        parts |= {"problem": "There are no data", "remedy": _NO_DATA.partition(": ")[2]}
    if missing := _MISSING.fullmatch(message):
        parts |= {"field": missing[1], "problem": missing[2], "remedy": missing[3]}
    return error_of(message, **parts)


_BARE_VALUE = re.compile(r"(?:--[a-z-]+|--[a-z-]+ \S*|= \S*|\w=\S*)(?<![\"'])$")  # a flag, or the unquoted value of a flag or key


def sentence(text: str) -> str:
    """A text with a capital letter at its beginning and a mark at its end, as the program writes it."""
    return text[:1].upper() + text[1:] + ("" if text[-1:] in ".,:;?!" else ".")


def _remedy(text: str) -> str:
    """A sentence; without a full stop where it ends with a value to copy."""
    return text[:1].upper() + text[1:] if _BARE_VALUE.search(text) else sentence(text)


def error_of(message: str, **parts: str | float | None) -> InputError:
    """The exception for a fault; of a file that is not there, one that is a FileNotFoundError as well."""
    message = in_python(message)
    parts |= {name: in_python(str(parts[name])) for name in ("field", "problem", "remedy") if parts.get(name)}
    parts |= {name: made(str(parts[name])) for name, made in (("problem", sentence), ("remedy", _remedy)) if parts.get(name)}
    kind = next((kind for words, kind in _OF_SYSTEM.items() if words in str(parts.get("problem"))), InputError)
    if kind is FolderError and parts.get("file") and not parts.get("remedy"):
        parts["remedy"] = _FOLDER
        message = f"{message} {parts['remedy']}"
    if not parts.get("remedy") and "\n" in message and not parts.get("line"):  # a list of what to pass
        parts["remedy"] = " ".join(message.partition("\n")[2].split())
    error = kind(message)
    for name, value in parts.items():
        setattr(error, name, value)
    if isinstance(error, OSError):
        error.filename, error.errno = str(parts.get("file") or ""), _ERRNO[kind]
        error.strerror = os.strerror(error.errno)
    return error


_ERRNO: dict[type[InputError], int] = {MissingFileError: errno.ENOENT, ForbiddenFileError: errno.EACCES, FolderError: errno.EISDIR}
_FOLDER = "Pass one of its files; flexslip.campaign takes a folder."


def _again(message: str, parts: dict[str, str | float | None]) -> InputError:
    return error_of(message, **parts)


def wrong(field: str, expected: str, found: object, remedy: str | None = None, **parts: str | float | None) -> InputError:
    """The exception for an argument, its message made as the program makes it."""
    shown = found if isinstance(found, str) else repr(found)
    return refused(field, f"This must be {expected}, not {shown}", remedy, **parts)


def refused(field: str, problem: str, remedy: str | None = None, **parts: str | float | None) -> InputError:
    """The exception for an argument, of what is wrong with it and what to do."""
    message = f"{field}: {sentence(problem)}" + (f" {_remedy(remedy)}" if remedy else "")
    return error_of(message, field=field, problem=problem, remedy=remedy, **parts)


def warn(text: str) -> None:
    """Warns of something that a call left out, at the line of the user's code that made the call."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(text, stacklevel=level)


def yes_no(field: str, value: object) -> bool:
    """An option that is True or False: "no" is neither."""
    import numpy as np

    if not isinstance(value, (bool, np.bool_)):
        raise wrong(field, "True or False", value)
    return bool(value)


def one_of(field: str, word: object, known: Sequence[str]) -> str:
    """An argument that is one of some words."""
    if not isinstance(word, str) or word not in known:
        raise wrong(field, f"one of {', '.join(known)}", word)
    return word


def path_of(file: Path, field: str = "file", what: str = "the name of a file") -> str:
    """A path as a string, which may hold bytes that are no UTF-8, as os.fsdecode has them."""
    path: str = os.fsdecode(file)
    if not path or path == "-" or "\0" in path:
        raise wrong(field, what, repr(path))
    return path


def whole(name: str, value: object, least: int, most: int) -> int:
    """An option that is a whole number."""
    try:
        number = operator.index(cast(SupportsIndex, value))
    except TypeError:
        raise wrong(name, f"a whole number from {least} to {most}", value) from None
    if isinstance(value, bool) or not least <= number <= most:
        raise wrong(name, f"a whole number from {least} to {most}", value)
    return number


def positive(name: str, value: object) -> float:
    """An option that is a positive number."""
    if isinstance(value, (str, bytes, bool)):
        raise wrong(name, "a positive number", repr(value), f"pass it without quotes, as in {name}=0.1" if isinstance(value, str) else None)
    try:
        number = float(cast(SupportsFloat, value))
    except (TypeError, ValueError):
        raise wrong(name, "a positive number", value) from None
    if not 0 < number < float("inf"):
        raise wrong(name, "a positive number", value)
    return number

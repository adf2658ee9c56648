# SPDX-License-Identifier: AGPL-3.0-or-later
"""Plain Python values as the protocol's messages."""
from __future__ import annotations

import base64
import json
import numbers
import os
import pathlib
import typing
import uuid

from google.protobuf import json_format

from .v1 import load_case_pb2, operation_pb2, report_pb2

#: Numbers of a point or a list, or points of an axis, a plane or a polyline.
Numbers = typing.Sequence[typing.Union[float, typing.Sequence[float]]]
#: A path stands for what is in its file.
Value = typing.Union[bool, int, float, str, "os.PathLike[str]", Numbers]
#: A message, its JSON as a dictionary, or the path of a file (docs/load_cases.md).
LoadCaseLike = typing.Union[load_case_pb2.LoadCase, typing.Mapping[str, typing.Any], str, "os.PathLike[str]"]
#: What becomes of loads whose surface an edit takes away: "drop", "move", "refuse", or a message.
PolicyLike = typing.Union[str, report_pb2.LoadPolicy]
#: A file's path, or its bytes.
FileLike = typing.Union[str, "os.PathLike[str]", bytes]


def make_edit_id() -> str:
    """An id with which a change is made once, however often it is asked for."""
    return str(uuid.uuid4())


def parameter(value: Value) -> operation_pb2.ParameterValue:
    """Lengths and the like are in the SI unit that the catalogue states; a `pathlib.Path` is read, its content is sent."""
    if isinstance(value, bool):  # Which is an int, too.
        return operation_pb2.ParameterValue(boolean=value)
    if isinstance(value, int):
        return operation_pb2.ParameterValue(integer=value)
    if isinstance(value, str):
        return operation_pb2.ParameterValue(text=value)
    if isinstance(value, os.PathLike):
        return operation_pb2.ParameterValue(text=attachment(*contents(value)))
    if not isinstance(value, numbers.Real):
        return operation_pb2.ParameterValue(text=number_text(value))
    return operation_pb2.ParameterValue(real=value)


def number_text(values: Numbers) -> str:
    """`[0, 0.01, 0]` as "0, 0.01, 0" and `[[0, 0, 0], [0, 0, 1]]` as "0, 0, 0; 0, 0, 1", as the server reads them."""
    parts = [repr(float(v)) if isinstance(v, numbers.Real) else number_text(v) for v in values]
    return ("; " if any("," in part for part in parts) else ", ").join(parts)


def attachment(data: bytes, name: str) -> str:
    """What a parameter of the kind FILE takes."""
    return f"data:{name.translate({ord(c): '_' for c in ';,'})};base64,{base64.b64encode(data).decode()}"


def load_case(given: LoadCaseLike) -> load_case_pb2.LoadCase:
    if isinstance(given, load_case_pb2.LoadCase):
        return given
    if not isinstance(given, typing.Mapping):
        given = json.loads(pathlib.Path(given).read_text(encoding="utf-8"))
    return json_format.ParseDict(given, load_case_pb2.LoadCase())


def policy(given: PolicyLike) -> report_pb2.LoadPolicy:
    """Raises `ValueError` for a name that is none."""
    if isinstance(given, report_pb2.LoadPolicy):
        return given
    return report_pb2.LoadPolicy(kind=report_pb2.LoadPolicy.Kind.Value(given.upper()))


def contents(given: FileLike) -> tuple[bytes, str]:
    """A file's bytes, and its name for messages."""
    if isinstance(given, bytes):
        return given, ""
    path = pathlib.Path(given)
    return path.read_bytes(), path.name

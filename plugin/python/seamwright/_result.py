# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the classes of results share."""

from __future__ import annotations

import inspect
from typing import Any, ClassVar, Dict, Tuple

import numpy as np


class _Value:
    """An attribute that reads an item of a result."""

    def __init__(self, key):
        self.key = key
        self.__doc__ = f'The item "{key}".'

    def __set_name__(self, owner, name):
        self.name = name

    def __get__(self, result, owner=None):
        if result is None:
            return self
        try:
            return dict.__getitem__(result, self.key)
        except KeyError:
            raise AttributeError(f"this {type(result).__name__} has no {self.key}") from None

    def __set__(self, result, value):
        raise AttributeError(f"{self.name} of a {type(result).__name__} can't be assigned")


def _short(value):
    if isinstance(value, np.ndarray):
        if value.size > 12:
            return f"array{value.shape}"
        return " ".join(np.array2string(value, precision=6, separator=", ").split())
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, (list, tuple)):
        if len(value) > 4:
            return f"[{len(value)} values]"
        text = ", ".join(map(_short, value))
        return f"[{text}]" if isinstance(value, list) else f"({text})"
    if isinstance(value, dict) and not isinstance(value, Result):
        return f"{{{', '.join(f'{key!r}: {_short(item)}' for key, item in value.items())}}}"
    return repr(value)


def _same(a, b):
    if isinstance(a, np.ndarray) or isinstance(b, np.ndarray):
        a, b = np.asarray(a), np.asarray(b)
        is_float = a.dtype.kind == b.dtype.kind == "f"
        return bool(np.array_equal(a, b, equal_nan=is_float))
    if isinstance(a, (list, tuple)) and isinstance(b, type(a)):
        return len(a) == len(b) and all(map(_same, a, b))
    return bool(a == b)


def _plain(value):
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return type(value)(_plain(item) for item in value)
    return value


class Result(Dict[str, Any]):
    """A result: its values are attributes, and items of a dict."""

    _keys: ClassVar[Dict[str, str]] = {}  # of attributes whose item has another name
    _kinds: ClassVar[Dict[str, type]] = {}  # of items that are results, or lists of results
    _shapes: ClassVar[Dict[str, Tuple[int, ...]]] = {}  # of items at one parameter

    def __init_subclass__(cls, **keywords):
        super().__init_subclass__(**keywords)
        cls.__module__ = "seamwright.results"  # where the classes are public
        for name in inspect.get_annotations(cls):
            if not name.startswith("_"):
                value = _Value(cls._keys.get(name, name))
                value.__set_name__(cls, name)
                setattr(cls, name, value)

    def __init__(self, *values: Any, **more: Any) -> None:
        super().__init__(*values, **more)
        for key, kind in self._kinds.items():
            value = self.get(key)
            if isinstance(value, list):
                self[key] = [item if item is None else kind(item) for item in value]
            elif value is not None:
                self[key] = kind(value)

    def __missing__(self, key: str) -> Any:
        if key in self._keys:
            return self[self._keys[key]]
        raise KeyError(key)

    def __contains__(self, key: object) -> bool:
        return super().__contains__(self._keys.get(key, key) if isinstance(key, str) else key)

    def get(self, key: str, default: Any = None) -> Any:
        """The item of that name, also by the name of its attribute; default if there is none."""
        return super().get(self._keys.get(key, key), default)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{name} of a {type(self).__name__} can't be assigned")

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, dict):
            return NotImplemented
        return self.keys() == other.keys() and all(_same(self[key], other[key]) for key in self)

    def __ne__(self, other: object) -> bool:
        equal = self.__eq__(other)
        return equal if equal is NotImplemented else not equal

    def __repr__(self) -> str:
        names = {key: name for name, key in self._keys.items()}
        values = ", ".join(f"{names.get(key, key)}={_short(self[key])}" for key in self)
        return f"{type(self).__name__}({values})"

    def copy(self):
        """A result of the same class with the same values."""
        return type(self)(self)

    def to_dict(self) -> Dict[str, Any]:
        """The items as a plain dict; results within it are plain dicts too."""
        return _plain(self)

    @classmethod
    def _plain_type(cls, key):
        """str or bool for items of that type, also where there are none; None for numbers."""
        names = {item: name for name, item in cls._keys.items()}
        annotation = str(inspect.get_annotations(cls)[names.get(key, key)])
        return next((kind for kind in (str, bool) if f"[{kind.__name__}," in annotation), None)

    @classmethod
    def _stacked(cls, results, shape):
        """One result whose items are arrays, from the results at an array of parameters.

        Numbers and vectors that do not exist are nan.
        """
        items = {}
        for key in cls._shapes:
            trailing = cls._shapes[key]
            values = [result[key] for result in results]
            plain = cls._plain_type(key)
            if plain is not None:
                items[key] = np.array(values, dtype=plain).reshape(shape)
                continue
            missing = np.full(trailing, np.nan)
            rows = [missing if value is None else value for value in values]
            items[key] = np.array(rows, dtype=float).reshape(shape + trailing)
        return cls(items)

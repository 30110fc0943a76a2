"""Reads what the commands of Alate write into NumPy arrays, and runs the commands.

    import alate
    run = alate.read("out/monarch")             # the folder of a run
    forces = run["forces"]                      # forces.csv
    forces["lift_n"], forces.units["lift_n"]    # an array, and "N"
    run.summary["twist_pp_deg"]                 # a number of summary.json

Needs NumPy alone. Table.frame() needs pandas, too.
"""

import csv
import json
import os
import struct
import subprocess
from pathlib import Path

import numpy as np

# Endings of the names of columns, the longest first where one ends with another.
_UNITS = [
    ("_per_s", "1/s"), ("_m2_s", "m²/s"), ("_rad_s", "rad/s"), ("_n_m2", "N m²"), ("_1_s", "1/s"),
    ("_m_s", "m/s"), ("_n_m", "N/m"), ("_deg", "°"), ("_pct", "%"), ("_m2", "m²"), ("_nm", "N m"),
    ("_hz", "Hz"), ("_mw", "mW"), ("_us", "µs"), ("_ms", "ms"), ("_n", "N"), ("_w", "W"),
    ("_m", "m"), ("_s", "s"),
]


def read(path):
    """Reads a folder of a run, or one CSV, JSON or GLB file of it.

    Returns a Run, a Table, what the JSON holds, or a Scene.
    """
    path = Path(path)
    if path.is_dir():
        return Run(path)
    kinds = {".csv": Table.read, ".json": _json, ".glb": Scene.read}
    kind = kinds.get(path.suffix.lower())
    if kind is None:
        raise ValueError(f"{path}: read takes a folder, or a file .csv, .json or .glb")
    return kind(path)


def _json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


class Run:
    """The files of one run of a command, each read when it is asked for first."""

    def __init__(self, folder):
        self.folder = Path(folder)
        if not self.folder.is_dir():
            raise FileNotFoundError(f"{folder} is no folder")
        self._read = {}

    @property
    def tables(self):
        """Names of its CSV files, without the ending."""
        return sorted(path.stem for path in self.folder.glob("*.csv"))

    @property
    def summary(self):
        """summary.json, as a dictionary."""
        return self._get("summary.json")

    def __getitem__(self, name):
        """The table NAME.csv."""
        if name not in self.tables:
            raise KeyError(f"{self.folder} has no {name}.csv, but {', '.join(self.tables) or 'no table'}")
        return self._get(name + ".csv")

    def scene(self, name):
        """The scene NAME.glb."""
        return self._get(name + ".glb")

    def _get(self, file):
        if file not in self._read:
            self._read[file] = read(self.folder / file)
        return self._read[file]


class Table:
    """Columns of a CSV file by name: arrays of numbers (nan where a cell is empty), or of text."""

    def __init__(self, columns):
        self._columns = columns

    @classmethod
    def read(cls, path):
        """Reads a CSV file with a line of names."""
        with open(path, encoding="utf-8", newline="") as file:
            names, *rows = csv.reader(file)
        if any(len(row) != len(names) for row in rows):
            raise ValueError(f"{path}: its rows have not all as many cells as its first line")
        cells = zip(*rows) if rows else ((),) * len(names)
        return cls({name: _column(column) for name, column in zip(names, cells)})

    @property
    def names(self):
        """Names of the columns."""
        return list(self._columns)

    @property
    def units(self):
        """Unit of each column, as its name ends; "" for one that is a number, a ratio or a text."""
        return {name: next((unit for end, unit in _UNITS if name.endswith(end)), "") for name in self}

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        """Number of rows."""
        return len(next(iter(self._columns.values()), ()))

    def __getitem__(self, name):
        if name not in self._columns:
            raise KeyError(f"no column {name}, but {', '.join(self)}")
        return self._columns[name]

    def where(self, **values):
        """The rows in which columns have these values: table.where(wing="wing", side="right")."""
        kept = np.ones(len(self), dtype=bool)
        for name, value in values.items():
            kept &= self[name] == value
        return Table({name: column[kept] for name, column in self._columns.items()})

    def grid(self, name, row, column):
        """A column as a map: values of ROW, values of COLUMN, and an array of their shape.

        It is nan where the table has no row of a pair; a pair that stands there twice is an error.
        """
        rows, at_row = np.unique(self[row], return_inverse=True)
        columns, at_column = np.unique(self[column], return_inverse=True)
        place = at_row * len(columns) + at_column
        if len(np.unique(place)) != len(place):
            raise ValueError(f"{row} and {column} do not tell the rows apart: choose some with where()")
        values = np.full(len(rows) * len(columns), np.nan)
        values[place] = self[name]
        return rows, columns, values.reshape(len(rows), len(columns))

    def frame(self):
        """The table as a pandas.DataFrame."""
        import pandas

        return pandas.DataFrame(self._columns)


def _column(cells):
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells], dtype=float)
    except ValueError:
        return np.array(cells, dtype=str)


class Scene:
    """Meshes of a GLB file and how they move; metres, x left, y up, z ahead, as glTF has it."""

    def __init__(self, head, data):
        self._head, self._data = head, data
        self._nodes = {node["name"]: k for k, node in enumerate(head["nodes"]) if "mesh" in node}

    @classmethod
    def read(cls, path):
        """Reads a GLB file, version 2."""
        with open(path, "rb") as file:
            raw = file.read()
        if len(raw) < 20 or struct.unpack_from("<II", raw) != (0x46546C67, 2):
            raise ValueError(f"{path} is no GLB file of version 2")
        length = struct.unpack_from("<I", raw, 12)[0]
        return cls(json.loads(raw[20:20 + length]), raw[28 + length:])

    @property
    def names(self):
        """Names of the parts that have a mesh."""
        return list(self._nodes)

    def mesh(self, name):
        """Positions of a part at rest (vertices × 3) and its triangles (triangles × 3)."""
        part = self._part(name)
        return self._array(part["attributes"]["POSITION"]), self._array(part["indices"]).reshape(-1, 3)

    def poses(self, name):
        """Seconds of the key frames, and positions of a part in each (frames × vertices × 3).

        Where the insect flies along a way, the positions are those beside it; way() has the way.
        """
        part = self._part(name)
        rest = self._array(part["attributes"]["POSITION"])
        times, weights = self._track(self._nodes[name], "weights")
        if times is None:
            return np.zeros(1), rest[np.newaxis]
        shapes = np.stack([self._array(target["POSITION"]) for target in part["targets"]])
        weights = weights.reshape(len(times), len(shapes))
        return times, rest + np.einsum("fs,svx->fvx", weights, shapes)

    def way(self):
        """Seconds, places and rotations (x, y, z, w) of an insect that flies along a way; None of one on the spot."""
        for node in range(len(self._head["nodes"])):
            times, places = self._track(node, "translation")
            if times is not None:
                return times, places, self._track(node, "rotation")[1]
        return None

    def _part(self, name):
        if name not in self._nodes:
            raise KeyError(f"no part {name}, but {', '.join(self._nodes)}")
        return self._head["meshes"][self._head["nodes"][self._nodes[name]]["mesh"]]["primitives"][0]

    def _track(self, node, path):
        for animation in self._head.get("animations", []):
            for channel in animation["channels"]:
                if channel["target"] == {"node": node, "path": path}:
                    sampler = animation["samplers"][channel["sampler"]]
                    return self._array(sampler["input"]), self._array(sampler["output"])
        return None, None

    def _array(self, accessor):
        accessor = self._head["accessors"][accessor]
        kind = {5121: "<u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}[accessor["componentType"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
        view = self._head["bufferViews"][accessor["bufferView"]]
        offset = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        values = np.frombuffer(self._data, kind, accessor["count"] * width, offset)
        return values if width == 1 else values.reshape(-1, width)


def command(*words, out):
    """Runs a command of Alate, such as command("fly", "monarch", "--speed", 1, out="fast").

    Returns its Run. The command line is that of the environment's ALATE_CLI, a built Alate.Cli.dll, or that of
    the checkout in which this file lies. What the command says of an error is the text of the RuntimeError.
    """
    cli = os.environ.get("ALATE_CLI")
    project = Path(__file__).resolve().parents[2] / "Headless~" / "Alate.Cli"
    call = ["dotnet", cli] if cli else ["dotnet", "run", "-c", "Release", "--project", str(project), "--"]
    done = subprocess.run(
        call + [str(word) for word in words] + ["--out", str(out)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip() or f"exit code {done.returncode}")
    return Run(out)

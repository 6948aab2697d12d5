"""The digest of a result file, by the rule that the reference page states, with plain h5py."""

import hashlib
import json
from pathlib import Path

import h5py
import numpy as np


def digest(path):
    """SHA-256 over everything in a file but the attribute `digest`."""
    arrays, head = {}, {"attributes": {}, "shapes": {}, "units": {}, "axes": {}}
    with h5py.File(path) as file:
        for name, value in file.attrs.items():
            if name != "digest":
                head["attributes"][name] = plain(value)
        scales = {file[name].id: name for name in file if isinstance(file[name], h5py.Dataset)}
        for place, dataset in datasets(file):
            arrays[place] = dataset[()]
            head["shapes"][place] = list(dataset.shape)
            head["units"][place] = plain(dataset.attrs.get("units", ""))
            if not dataset.is_scale:
                head["axes"][place] = [scales[axis[0].id] for axis in dataset.dims if len(axis)]
    text = json.dumps(head, sort_keys=True, separators=(",", ":"))
    data = b"".join(np.asarray(arrays[name], "<f8").tobytes() for name in sorted(arrays))
    return hashlib.sha256(text.encode() + data).hexdigest()


def datasets(file):
    """Every dataset with its path: scales at the top, the others in groups."""
    for name, item in file.items():
        if isinstance(item, h5py.Dataset):
            yield name, item
        else:
            yield from ((f"{name}/{inside}", dataset) for inside, dataset in item.items())


def plain(value):
    """Attribute as JSON holds it: floats as hexadecimal texts."""
    if isinstance(value, float):
        return float(value).hex()
    if isinstance(value, np.ndarray):
        return [str(item) for item in value]
    return value if isinstance(value, str) else value.item()


def resealed(path, change=lambda file: None):
    """Change a file with h5py and give it the digest of what it holds then."""
    with h5py.File(path, "a") as file:
        change(file)
    sealed = digest(path)
    with h5py.File(path, "a") as file:
        file.attrs["digest"] = sealed
    return Path(path)

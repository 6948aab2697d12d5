"""Time to store and to read a result, beside a run in a loaded program: `python -m benchmarks.storing`."""

from pathlib import Path
from tempfile import TemporaryDirectory

from threadpoolctl import threadpool_limits

from benchmarks.machine import describe, median_seconds
from flexbearing import read, run
from flexbearing.files import write
from flexbearing.results import hdf5_read
from flexbearing.results.hdf5_write import image

CASE = "configs/mao2016.toml"
CASES = {
    "rigid": ["outer.kind=rigid", "inner.kind=rigid"],
    "elastic rings, 8 iterations": [],
    "relaxed, 170 iterations": [
        "inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", "coupling.method=relaxed",
    ],
}  # fmt: skip
RUNS = 21


class Unheard:
    """Listens to nothing."""

    def stage(self, *_: object) -> None: ...

    def iteration(self, *_: object) -> None: ...


def main() -> None:
    print(describe())
    print(f"medians of {RUNS} [ms]")
    with TemporaryDirectory() as folder, threadpool_limits(limits=1, user_api="blas"):
        out = Path(folder) / "out.h5"
        for name, settings in CASES.items():
            whole = median_seconds(lambda s=settings: run(CASE, s, output=out, report=Unheard()), RUNS // 3)[
                0
            ]
            data = out.read_bytes()
            content, _ = hdf5_read.content(data)
            steps = {
                "run": whole,
                "bytes of the file": median_seconds(lambda c=content: image(c), RUNS)[0],
                "written, brought to the disk, checked": median_seconds(lambda d=data: write(out, d), RUNS)[
                    0
                ],
                "read and checked": median_seconds(lambda: read(out), RUNS)[0],
            }
            times = ", ".join(f"{step} {1e3 * seconds:.1f}" for step, seconds in steps.items())
            print(f"{name} ({len(data) / 1e3:.0f} kB): {times}")


if __name__ == "__main__":
    main()

"""Time of a rigid quasi-dynamic solve, cold start, warm interpreter: `python -m benchmarks.rigid_solve`."""

from dataclasses import replace

from threadpoolctl import threadpool_limits

from benchmarks.machine import describe, median_seconds
from flexbearing.case import read
from flexbearing.compute import assemble


def main() -> None:
    print(describe())
    model = assemble.bearing(read("configs/mao2016.toml"))

    def solve():
        replace(model).solve()  # a copy: nothing that an earlier solve prepared is used again

    with threadpool_limits(limits=1, user_api="blas"):
        median, fastest, slowest = median_seconds(solve, 41)
    steps = model.solve().step.number
    print(
        f"rigid solve, {model.bearing.rollers} rollers, {model.slices} slices, {steps} Newton steps: "
        f"median {median * 1e3:.1f} ms ({fastest * 1e3:.1f} to {slowest * 1e3:.1f} ms of 41 runs)"
    )


if __name__ == "__main__":
    main()

"""All measurements that have a page, by name."""

from evidence.measured import balls_and_rings, fast_balls, rollers
from evidence.measured.declared import Experiment

EXPERIMENTS: dict[str, Experiment] = {
    each.name: each for each in (*rollers.EXPERIMENTS, *balls_and_rings.EXPERIMENTS, *fast_balls.EXPERIMENTS)
}

"""Parts with a raceway that are not drawn."""

from fem.parts.bolted_ring import BoltedRing
from fem.parts.rings import OuterRing, RingOnShaft
from fem.parts.squirrel_cage import SquirrelCage

Part = SquirrelCage | OuterRing | RingOnShaft | BoltedRing

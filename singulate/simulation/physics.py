"""Physical constants of the scene."""

import math
from dataclasses import dataclass
from functools import cached_property


@dataclass(frozen=True)
class Physics:
    """How the table, the blocks and the pusher behave.

    The paper fixes the time step and the solver's iterations (section 4); the rest is chosen so
    that a block slides on by less than half a camera pixel once the pusher stops.

    Attributes:
        time_step: Simulation step [s] (paper, section 4).
        solver_iterations: Iterations of the contact solver a step (paper, section 4).
        gravity: Downward acceleration [m/s^2].
        push_speed: Constant speed of the pusher along a push [m/s]: an eighth of a camera pixel in
            each time step, so that pushes from the pixels of one line pass the same points.
        retract_speed: Speed at which the pusher is lifted after a push [m/s].
        retract_height: How far it is lifted before it leaves the scene [m].
        pusher_side: Width and depth of the pusher [m].
        pusher_height: Height of the pusher [m].
        pusher_clearance: Gap between the pusher and the table [m].
        pusher_mass: Mass of the pusher [kg], large against a block's (paper, section 4).
        block_density: Density of the blocks [kg/m^3]; a cube of 0.2 m weighs 0.5 kg.
        table_friction: Lateral friction coefficient; coefficients of a pair are multiplied.
        block_friction: As above.
        pusher_friction: As above.
        settle_speed: A block slower than this is still [m/s]; ten times this in [rad/s] for turns.
            Blocks slide for some seven steps once they are let go, and then creep for six more, by
            0.1 mm in the median, before all are slower than 0.002.
        max_settle_steps: Steps after which an unsettled scene is taken as it is.
        max_speed: A block faster than this means that the physics went wrong [m/s].
    """

    time_step: float = 0.01
    solver_iterations: int = 100
    gravity: float = 9.81
    push_speed: float = 0.390625
    retract_speed: float = 1.5
    retract_height: float = 0.3
    pusher_side: float = 0.06
    pusher_height: float = 0.12
    pusher_clearance: float = 0.01
    pusher_mass: float = 50.0
    block_density: float = 62.5
    table_friction: float = 1.0
    block_friction: float = 0.6
    pusher_friction: float = 0.5
    settle_speed: float = 5e-3
    max_settle_steps: int = 200
    max_speed: float = 10.0

    @cached_property
    def pusher_z(self) -> float:
        """Height of the pusher's centre while it pushes [m]."""
        return self.pusher_clearance + self.pusher_height / 2

    @cached_property
    def sliding_loss(self) -> float:
        """Speed that a block sliding over the table loses in a time step [m/s]."""
        return self.table_friction * self.block_friction * self.gravity * self.time_step

    @property
    def num_lift_steps(self) -> int:
        """Steps in which the pusher is lifted after a push."""
        return math.ceil(self.retract_height / (self.retract_speed * self.time_step))

    def num_push_steps(self, length: float) -> int:
        """Steps in which the pusher covers a length [m], at least one."""
        return max(1, round(length / (self.push_speed * self.time_step)))

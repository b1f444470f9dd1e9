# What an effect of a virtual rig is, and at which stage between actuator and log it acts.
# The strength of an effect is one number; everything else about it is drawn once.
"""Effects as data: a stage, a function, a range of strength."""
import dataclasses
from typing import Callable

# Order in which the stages act. Displacement: delay -> mount -> contact -> play -> specimen (base + parallel) -> factor;
# then what is added on the rig, then what the force transducer and its filter do.
STAGES = ("displacement", "mount", "contact", "play", "parallel", "factor", "added", "transducer")


@dataclasses.dataclass
class Effect:
    """An effect of one rig.

    stage: one of STAGES. By stage, `function` is called with
      displacement, play: (z, rate, strength) -> z            lists over the logs
      mount:              (force, strength) -> displacement of the mount, one log
      contact:            (z, inner, force, strength) -> the inner displacement closer to balance, one log
      parallel, added:    (z, rate) -> force share at strength 1, a list over the logs
      factor:             (z, elastic, rest, rate, strength) -> force, lists over the logs
      transducer:         (force, rate, strength) -> force, a list over the logs
    strongest: largest plausible strength.
    parameters: for the sealed label.
    name: as in the reports; for what is in no list, the prefix `unknown:` and what it is.
    law: the functional form.
    """

    stage: str
    function: Callable
    strongest: float
    parameters: dict
    name: str = ""
    law: str = ""


@dataclasses.dataclass
class Scale:
    """Sizes of a case that the laws are drawn by [SI]."""

    stiffness: float        # dynamic stiffness of the component
    amplitude: float        # largest displacement
    least_amplitude: float  # largest displacement of the log that moves least
    speed: float            # RMS of the velocity
    force: float            # typical standard deviation of the force
    top_frequency: float    # highest frequency of the actuator
    training: int           # the first logs, recorded one after the other on one specimen
    lengths: list           # samples of each log on the fine grid
    rate: float             # of the fine grid
    side: float = 1.0       # the sign of the force that the programme asks for, where it has one

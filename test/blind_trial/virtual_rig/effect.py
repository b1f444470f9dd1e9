# Effects of a virtual rig, and the stages between actuator and log at which they act. The strength of an effect is a
# single number. Its other parameters are drawn once.
"""Effects as data: a stage, a function and a range of strengths."""
import dataclasses
from typing import Callable

# The stages in order. The displacement passes delay, mount, contact, play, specimen (base + parallel) and factor. Then
# come forces added on the rig, and the force sensor with its filter.
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
    name: as in the reports; for unlisted effects, `unknown:` and a description.
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
    """Sizes of a case from which the laws are drawn [SI]."""

    stiffness: float        # dynamic stiffness of the component
    amplitude: float        # largest displacement
    least_amplitude: float  # largest displacement of the log with the least motion
    speed: float            # RMS of the velocity
    force: float            # typical standard deviation of the force
    top_frequency: float    # highest frequency of the actuator
    training: int           # number of logs recorded first, in order on one specimen
    lengths: list           # samples of each log on the fine grid
    rate: float             # sampling rate of the fine grid
    side: float = 1.0       # sign of the force in one-sided programmes

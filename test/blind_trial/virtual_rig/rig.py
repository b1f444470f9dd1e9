# A virtual rig: a base component, effects in their stages, and the search for the strength that gives a wanted gap.
"""Forces of a virtual rig for a displacement, and the search for strengths."""
import math

import numpy as np

from .effect import STAGES

LARGEST_GAP = 0.40  # largest gap of an effect before re-estimation


def gap(difference, force):
    """Return the RMS of the difference divided by the standard deviation of the force, over all logs."""
    return math.sqrt(np.mean([np.mean(d**2) / np.var(f) for d, f in zip(difference, force)]))


def decimated(logs, skip):
    return [x[::skip] for x in logs]


class Rig:
    """A base with effects. `force(strengths)` runs all stages. Forces that do not depend on a strength are cached."""

    def __init__(self, base, z, rate, effects):
        self.base, self.z, self.rate = base, z, rate
        self.effects = sorted(effects, key=lambda e: STAGES.index(e.stage))
        self._kept = {}

    def coarse(self, skip):
        """Return the same rig with every skip-th sample."""
        return Rig(self.base, decimated(self.z, skip), self.rate / skip, self.effects)

    def base_force(self):
        return self._keep("base", lambda: self.base.force(self.z, self.rate))

    def share(self, effect):
        """Return the force of a linear effect of strength 1 under the undisturbed displacement."""
        return self._keep(id(effect), lambda: effect.function(self.z, self.rate))

    def force(self, strengths):
        """Return the force of all logs with effect i at strengths[id(effect)]. Effects without a strength are off."""
        active = [(e, strengths[id(e)]) for e in self.effects if strengths.get(id(e), 0.0) > 0.0]
        z = self.z
        for effect, s in active:
            if effect.stage == "displacement":
                z = effect.function(z, self.rate, s)
        mount = [(e, s) for e, s in active if e.stage == "mount"]
        force = self._behind_mount(z, mount, active) if mount else self._specimen(z, active)
        for effect, s in active:
            if effect.stage == "added":
                force = [f + s * x for f, x in zip(force, self.share(effect))]
        for effect, s in active:
            if effect.stage == "transducer":
                force = effect.function(force, self.rate, s)
        return force

    def _behind_mount(self, z, mount, active):
        """Find the displacement behind the mount, which yields under the force, by iteration over whole logs."""
        inner, relax = z, 1.0 / (1.0 + sum(s for _, s in mount))
        size = max(float(np.max(np.abs(x))) for x in z)
        for _ in range(30):
            force = self._specimen(inner, active)
            change, following = 0.0, []
            for x, y, f in zip(z, inner, force):
                step = relax * (x - y - sum(e.function(f, s) for e, s in mount))
                change = max(change, float(np.max(np.abs(step))))
                following.append(y + step)
            inner = following
            if change < 2e-5 * size:
                break
        return self._specimen(inner, active)

    def _specimen(self, z, active):
        """Find the force of the specimen in series with opening contacts, by iteration over whole logs."""
        contacts = [(e, s) for e, s in active if e.stage == "contact"]
        inner, size = z, max(float(np.max(np.abs(x))) for x in z)
        for _ in range(60 if contacts else 0):
            following, force = inner, self._test_piece(inner, active)
            for effect, s in contacts:
                following = [effect.function(*log, s) for log in zip(z, following, force)]
            change = max(float(np.max(np.abs(x - y))) for x, y in zip(following, inner))
            inner = following
            if change < 2e-5 * size:
                break
        return self._test_piece(inner, active)

    def _test_piece(self, z, active):
        moved = z is not self.z
        for effect, s in active:
            if effect.stage == "play":
                z, moved = effect.function(z, self.rate, s), True
        if moved:
            elastic, rest = self.base.parts(z, self.rate)
        else:
            elastic, rest = self._keep("parts", lambda: self.base.parts(self.z, self.rate))
        for effect, s in active:
            if effect.stage == "parallel":
                share = effect.function(z, self.rate) if moved else self.share(effect)
                rest = [f + s * x for f, x in zip(rest, share)]
        force = [a + b for a, b in zip(elastic, rest)]
        for effect, s in active:
            if effect.stage == "factor":
                force = effect.function(z, elastic, rest, self.rate, s)
                elastic, rest = force, [np.zeros_like(f) for f in force]
        return force

    def _keep(self, key, make):
        if key not in self._kept:
            self._kept[key] = make()
        return self._kept[key]


class Ruler:
    """Measures gaps on a coarse grid: the full gap, and the visible gap that re-estimation of the base leaves.

    The visible gap is not fitted, but estimated by projection onto the tangent space of the parameters.
    """

    def __init__(self, rig, skip):
        self.rig = rig.coarse(skip)
        self.reference = self.rig.base_force()
        self._sub = 4 if len(self.rig.z[0]) > 12000 else 1
        self._tangent = [m[::self._sub] for m in self.rig.base.tangent(self.rig.z, self.rig.rate)]

    def gaps(self, strengths):
        """Return (full gap, visible gap) of effects with these strengths, relative to the base without effects."""
        force = self.rig.force(strengths)
        difference = [a - b for a, b in zip(force, self.reference)]
        return gap(difference, force), self.visible(difference, force)

    def visible(self, difference, force):
        scale = [1.0 / np.std(f) for f in force]
        lengths = np.sqrt([len(d) for d in difference])
        weights = [s / n for s, n in zip(scale, lengths)]
        matrix = np.concatenate([m * w for m, w in zip(self._tangent, weights)])
        norms = np.linalg.norm(matrix, axis=0)
        matrix = matrix / np.where(norms > 0.0, norms, 1.0)
        target = np.concatenate([d[::self._sub] * w for d, w in zip(difference, weights)])
        # With a small ridge, directions that the logs do not excite stay unchanged.
        normal = matrix.T @ matrix + 1e-9 * np.eye(matrix.shape[1])
        left = target - matrix @ np.linalg.solve(normal, matrix.T @ target)
        return float(np.linalg.norm(left) * math.sqrt(self._sub / len(difference)))

    def strength_for(self, effect, wanted, visible):
        """Return the strength for the wanted (visible) gap, or the largest plausible strength, with both gaps.

        If re-estimation of the base would hide most of an effect, the full gap is limited to LARGEST_GAP.
        """
        def measure(s):
            both = self.gaps({id(effect): s})
            return both, max(both[1] / wanted, both[0] / LARGEST_GAP) if visible else both[0] / wanted

        guess = effect.strongest
        both, ratio = measure(guess)
        low, high = guess * 1e-6, guess
        for _ in range(14):
            if abs(ratio - 1.0) < 0.02 or (guess == high == effect.strongest and ratio < 1.0):
                break
            step = guess / max(ratio, 1e-12)
            guess = step if low * 1.02 < step < high / 1.02 else math.sqrt(low * high)
            both, ratio = measure(guess)
            low, high = (guess, high) if ratio < 1.0 else (low, guess)
        return guess, both

"""That the numbers of a leg are others from a drop on, in words: since when, which, by how much."""

from math import hypot
from typing import TYPE_CHECKING

from exoid.cli.live.saying.words import rounded, title
from exoid.files.counted import counted

if TYPE_CHECKING:
    from collections.abc import Iterable

    from exoid.watching.board import Board
    from exoid.watching.estimate.moment import Change, Moment, Quantity

FAR = 3.0  # standard errors of their difference, from which on a number is told as another
HEAD = {
    True: "this is another leg, or it carries something else",
    False: "the leg, or what it carries, is not what it was",
}
WHAT = (
    "from {:.1f} s on {}: {}; these rest on {}, those before on {}: follow and fit two legs "
    "apart, and declare a mass that was put on or taken off (added_mass); where nothing was, the "
    "leg differs from drop to drop, or the model lacks something, which exoid diagnose of a "
    "recording (-o) tells"
)
MORE = "{}; it is the last of {} such changes"


def change(moment: "Moment", drops: int) -> str:
    """What the first drop of other numbers told beside those before, and on how many `drops` they
    rest by now; nothing where no number of it can be believed.
    """
    found = moment.change
    if found is None or not moment.believed:
        return ""
    rests = counted(drops, "drop") if drops else "a movement that has not ended"
    told = differing(found, moment.as_loaded)
    before = counted(found.drops, "drop")
    return WHAT.format(found.since, HEAD[found.another], told, rests, before)


def differing(found: "Change", now: "Iterable[Quantity]") -> str:
    """The numbers that are sure to be others, or the one that is farthest off."""
    each = [(was, one) for was in found.before for one in now if was.name == one.name]
    far = [pair for pair in each if errors(*pair) > FAR] or [max(each, key=lambda p: errors(*p))]
    return "; ".join(beside(*pair) for pair in far)


def errors(was: "Quantity", now: "Quantity") -> float:
    """How many standard errors they are apart."""
    both = hypot(was.error, now.error)
    return abs(now.value - was.value) / both if both > 0 else 0.0


def beside(was: "Quantity", now: "Quantity") -> str:
    """As damping over inertia 0.845 ± 0.001 before, 0.718 ± 0.001 1/s since (15 % less)."""
    (before, one), (value, other) = (rounded(each.value, each.error) for each in (was, now))
    said = f"{title(now.name)} {before} ± {one} before, {value} ± {other} {now.unit} since"
    share = 100 * (now.value / was.value - 1) if was.value > FAR * was.error else 0.0
    return said + (f" ({abs(share):.2g} % {'more' if share > 0 else 'less'})" if share else "")


def last_change(board: "Board") -> str:
    """Of all drops that count, or of the movement that goes on."""
    each = [drop.moment for drop in board.counted if drop.moment.change is not None]
    now = board.moment
    if now is not None and now.change is not None:
        each.append(now)
    if not each:
        return ""
    said = change(each[-1], 0 if each[-1] is now else len(board.ended))
    return said if len(each) == 1 else MORE.format(said, len(each))

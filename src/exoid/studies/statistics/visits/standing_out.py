"""The person of whom most of what visits differ by is."""

from scipy.stats import beta

from exoid.studies.statistics.tables.values import LEG, OCCASION, Values, means

CHANCE = 0.01  # that somebody of people who scatter alike has so large a share
MOST = 0.5  # of the squares


def standing_out(values: Values) -> str:
    """Who makes more than half of the squares by which visits of legs differ from their means,
    and more than chance gives anybody (Cochran 1941, Ann Eugen 11: 47-52); nobody as "".
    """
    visits = means(values, OCCASION)["value"]
    away = (visits - visits.groupby(level=LEG).transform("mean")) ** 2
    squares = away.groupby(level="person").sum()
    freedom = (
        away.groupby(level="person").size()
        - away.groupby(level=LEG).size().groupby(level="person").size()
    )
    whole, who = float(squares.sum()), squares.idxmax()
    own, of_all = float(freedom[who]), float(freedom.sum())
    if not whole > 0 or not 0 < own < of_all:
        return ""
    share = float(squares[who]) / whole
    p = len(squares) * float(beta.sf(share, own / 2, (of_all - own) / 2))
    return str(who) if share > MOST and p < CHANCE else ""

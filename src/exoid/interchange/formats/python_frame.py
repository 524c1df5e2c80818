"""What every exported script of Python has around the formulas of its model."""

FRAME = '''"""{title}

    J phi'' = tau_h(t) - m l g cos(phi + thigh) - c phi - d phi'{more}

phi is 0 with the knee extended and the shank horizontal, -pi/2 hanging; extension is positive.
Seconds are true ones: a second of the recording is CLOCK of them. Behind every number stand its
error, its unit and who told it: data, or a prior, which is anatomy.

Needs NumPy. `simulate()` gives time, angle and rate of the leg, and what encoder and gyro show.
Written by exoid.
"""

import numpy as np

{constants}

FIRST, LAST, INTERVAL = {times}  # s, of the recording's samples
LONGEST = {longest}  # s, of a step
PIECES = {pieces}  # of a step
ANGLE, RATE = {begun}  # rad and rad/s, where it begins
MEMORY = {memory}  # what the terms remember there


def sign(value):
    return float(value > 0) - float(value < 0)


def drive(time):
    """What muscles or a motor do [N m]."""
    {drive}


def acceleration(time, angle, rate, memory, push):
    """phi'' [rad/s^2] under the torque `push` [N m], but for dry friction."""
    {acceleration}


def friction(time, angle, rate, memory):
    """The level of dry friction [N m]."""
    {friction}


def memory_rate(time, angle, rate, memory, push):
    """How fast what the terms remember changes."""
    {memory_rate}


def memory_within(time, angle, rate, memory):
    """What the terms remember, brought back to where it can be."""
    {memory_within}


def shown(time, angle, rate, memory, push):
    """Angle [rad] and rate [rad/s] as encoder and gyro show them."""
    {shown}


def way(time, state, push):
    """Is it free to move, 1 or 0, and which way does it go? At rest the other than it is pulled."""
    pulled = acceleration(time, state[0], state[1], state[2:], push)
    level = friction(time, state[0], state[1], state[2:])
    stuck = state[1] == 0.0 and abs(pulled) * INERTIA <= level and level > 0.0
    return (0.0 if stuck else 1.0), (sign(state[1]) if state[1] != 0.0 else -sign(pulled))


def turned(begin, end, sense, rubbed, size):
    """The end of a step of a leg that comes to rest within: friction acts the other way then."""
    ahead = sense * begin[1]
    slowing = (ahead - sense * end[1]) / size
    if ahead >= size * slowing:
        return end
    later, back = size - ahead / slowing, max(slowing - rubbed, 0.0)
    more = sense * (slowing - back)
    return np.array([end[0] + more * later**2 / 2, end[1] + more * later, *end[2:]])


def step(time, size, state, begin, middle, end):
    """One step of Runge-Kutta of order four, within which dry friction turns over with the leg."""
    start = state
    free, sense = way(time, state, begin)

    def level(at, state):
        return friction(at, state[0], state[1], state[2:]) / INERTIA

    def slope(at, state, push):
        angle, rate, memory = state[0], state[1], state[2:]
        pulled = acceleration(at, angle, rate, memory, push) - sense * level(at, state)
        changes = memory_rate(at, angle, rate, memory, push)
        return np.array([free * rate, free * pulled, *changes])

    first = slope(time, state, begin)
    second = slope(time + size / 2, state + size / 2 * first, middle)
    third = slope(time + size / 2, state + size / 2 * second, middle)
    fourth = slope(time + size, state + size * third, end)
    state = state + size * (first + 2 * second + 2 * third + fourth) / 6
    rubbed = level(time, start) + level(time + size, state)
    if rubbed > 0.0:
        state = turned(start, state, sense, rubbed, size)
    return np.array([*state[:2], *memory_within(time + size, state[0], state[1], state[2:])])


def drawn(pushes, at):
    """The torque at a fraction of a step, through its begin, middle and end."""
    begin, middle, end = pushes
    return (1 - at) * (1 - 2 * at) * begin + 4 * at * (1 - at) * middle + at * (2 * at - 1) * end


def steps(begin, end):
    """Where the steps from one sample to the next begin, and how long they are [s]."""
    count = max(int(np.ceil((end - begin) / LONGEST - 1e-6)), 1)
    size = (end - begin) / count
    return [(begin + number * size, size) for number in range(count)]


def simulate(times=None):
    """Columns: time [s], angle [rad], rate [rad/s], shown angle [rad], shown rate [rad/s]."""
    if times is None:
        times = FIRST + np.arange(0.0, LAST - FIRST + INTERVAL / 2, INTERVAL)
    state, rows = np.array([ANGLE, RATE, *MEMORY]), []
    for number, time in enumerate(times):
        seen = shown(time, state[0], state[1], state[2:], drive(time))
        rows.append([time, state[0], state[1], *seen])
        if number + 1 == len(times):
            break
        for begin, size in steps(time, times[number + 1]):
            pushes = drive(begin), drive(begin + size / 2), drive(begin + size)
            for piece in range(PIECES):
                thirds = [drawn(pushes, (piece + part) / PIECES) for part in (0.0, 0.5, 1.0)]
                state = step(begin + piece / PIECES * size, size / PIECES, state, *thirds)
    return np.array(rows)


if __name__ == "__main__":
    print("time_s,angle_deg,rate_deg_s,shown_angle_deg,shown_rate_deg_s")
    for row in simulate():
        print("%.4f,%.4f,%.4f,%.4f,%.4f" % (row[0], *np.degrees(row[1:])))
'''

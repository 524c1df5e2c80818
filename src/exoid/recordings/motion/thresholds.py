"""Every threshold of the search for a movement, with its reason."""

import numpy as np

# A hold. A hand that keeps a leg still trembles and gives way by some degrees a second; beyond
# that a movement must be clear of the noise: 4.5 of its errors happen once in 10^5 windows.
QUIET = (4.5, np.radians(4.0))  # errors, rad/s
SPEED_ERROR = np.radians(1.0)  # rad/s, at which a window is long enough
WIDTHS = (0.05, 0.075, 0.1, 0.15, 0.2, 0.3)  # s; a leg's half swing takes 0.5 s

SWAY = np.radians(6.0)  # rad, from turn to turn: the farthest that a hand sways which keeps a leg
SWAYING = 4.0 * SWAY / 2  # rad/s, and how fast: at 4 rad/s, as slowly as a leg swings
SINCE = 1.5  # times that way over the speed after it, before which a leg fell: 2 of a fall from
# rest, 3 where the hand lets go ever more, less out of a sway
GREAT = 0.25  # of the greatest swing, above which one is a fall: what a hand keeps sways less
SWAYED = 1.0  # s in front of a fall in which a hand is looked at: half a turn at 0.5 Hz
CHANGE = np.radians(0.5)  # rad, from turn to turn, above which a hand has turned around
GROWN = (0.3, 0.6)  # of the greatest speed of a fall, between which it grows evenly enough
TURNED = 0.5  # of that growth, more than which no hand has as long as it keeps a leg

# Letting go. A hand takes 20 to 100 ms; the leg then falls freely.
WINDOWS = np.linspace(0.0, 0.12, 9)  # s, tried durations of letting go
FALL = 0.25  # s after the release that are followed
HELD = 0.5  # s of the hold in front that are compared with it
BLOCK = 0.003  # s over which faster samples are averaged; a leg bends by 1e-5 rad in it
COARSE = 0.008  # s between the instants that are tried at first
TRIED = (5e-4, 4e-3)  # s between them in the end, a sixtieth of those that remain within
LEGS = [(k, d) for k in (2.0, 20.0, 45.0, 75.0) for d in (0.0, 2.5, 6.0, 10.0)]  # 1/s^2, 1/s:
# what turns a fall, from a leg above the horizontal to a stiff one; healthy to spastic damping
GREATEST = 30.0  # rad/s^2, the first acceleration of a leg that is let go level
ODD = (0.03, 0.02, 0.01)  # rad, at FALL, in x^3, x^4, x^5: what such a leg does between these legs
WILFUL = (0.6, 0.5, 0.3)  # the same of a voluntary movement: its torque grows while it begins
SHAPE = 0.0015  # s by which hands that let go in other ways move the release
GONE = 0.99  # probability with which the hand is off the leg at the first free sample
MARGIN = 0.01  # s that are left to what no model of a hand and a leg has
# Chi-square a sample of both sensors, and the most of the angle alone, where the gyro shows the
# release at another time: behind a filter that takes 6 ms or more. What a leg does besides falling,
# a gyro sees better than an encoder, and neither fits.
CONTRARY, SOUND = 50.0, 2.0
TAIL = 0.4  # of the time of letting go that a hand may take longer than its ramp

# A recording that begins free. A leg whose hold is shorter than this was marked at its release:
# play and compliance keep the sensors at rest for 45 to 65 ms, and no hand waits that short.
MARKED = 0.075  # s
SHORTEST = 0.02  # s, the same where other drops of a recording show a hold: the hand's letting go
ODDS = 4.0  # chi-square by which a hold that nobody saw must be better than none

# A rest. At a turning point a leg is slow for a moment only.
REST = 0.3  # s, longer than any turning point of a swing of 3 degrees
HOLD = 0.1  # s; the least that can be told from the begin of a fall
ROCKING = (np.radians(3.0), 0.9)  # rad, s times the speed of stillness: the farthest that a leg of
# 4 rad/s still swings when it is that slow for 0.3 s
TRAVEL = np.radians(1.5)  # rad that a movement goes at least
CLEAR = 6.0  # times the noise of a smoothed angle

# A hand on a swinging leg. Swings of a free leg lie within each other.
BEYOND = np.radians(2.0)  # rad by which a turning point may lie outside the one before
SHARE = 0.05  # of that swing
SHORT = np.radians(5.0)  # rad by which a last swing may be shorter than its forerunners say
LATE = 0.08  # s before a hand is seen that it may have begun
KEPT = 3.0  # s at rest that are kept: more tells nothing but the sensor's drift
# A swing that a leg does not make by itself, of 385 drops with friction, stops, reflexes, feet:
HURRIED = (2.0, 0.8), (5.0, 0.9)  # times the least swing, from where on one that takes less than so
# much of what those before took is no leg's: 0.84 and 0.94 of those
UNSEEN = 0.1  # s without a sample, in which a swing may have turned
AHEAD = 2  # swings, within which a hand that is laid on a leg softly damps it
LOSING = 0.2  # of a swing, times those swings, that a leg loses more than it lost before: 0.15 of
# 1020 drops with friction, stops, reflexes, tissue that flows, by cameras of 25 Hz, too
STICKING = 1.4, 0.1  # the same where it then rests, as friction holds it: times the least swing,
# and of what it lost in the swing before: 1.2 of those
PUSH = 0.12  # of the greatest free acceleration, below which a hand is not told from a leg's own
GRIP, SEIZED = 0.35, 5.0  # of that acceleration, and times what the free parts leave: a hand that
# stops a leg within 0.15 s does more, and noise does not in 10^4 recordings
LEAN = 0.04  # of it, of a leg at rest: its mean is surer; dry friction holds less than that
SURE = 3.0  # errors that its mean must also be away, by how well the free part told the law
BRIEF = 0.15  # s, of a rest at the end of a record
ROUGH = 3.5  # times what the free part itself leaves: friction, a reflex
FEWEST = 8  # samples of a free part, for the four numbers of its law
USUAL = (0.95, 1.96)  # the share of what a law leaves that counts, in deviations
BLUR = (0.05, 0.1, 0.15, 0.2, 0.3)  # s over which accelerations are smoothed

# A reflex in the first swing. It throws the leg up, which then falls freely.
EARLY = 3  # the last turning point that lies outside for it: after release, halt and top
SWUNG_ON = 2  # half swings within each other after it, the last to its rest
CARRIED = 0.4  # of its free fall at the top: 0 to 0.3 of a leg that is thrown, 1 of one in a hand

# A voluntary cycle. Its onset may be as soft as the begin of a cosine.
TURN_OF_HOLD = 0.15  # s by which the onset may be before the leg is clear of its rest

# A continuous recording.
REST_KEPT = 0.5  # s of rest in front of each movement
TAKEN = 0.5  # s before a lift is seen that a hand may have taken the leg, and begun softly
PAUSE = 1.0  # s without a sample, over which nobody knows what the leg did
MINOR = 0.2  # of the farthest movement, below which one is a twitch or the last of a swing
ABOVE = 0.3  # of its travel by which a drop or a cycle rises above where it began at most
SWINGS = 2  # that no hand makes
LOST = 0.1  # of its travel, that a relaxed leg loses in its first swing: a fifth of a swing lightly
# damped, at a decrement of 0.2

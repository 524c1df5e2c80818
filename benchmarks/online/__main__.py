"""The live estimator: coverage and errors beside others', speed, changes of leg, false alarms.

python -m benchmarks.online [--legs 300] [--batch 4] [--hours 1]
"""

import argparse

from benchmarks.online import changes, coverage, speed


def main() -> None:
    said = argparse.ArgumentParser(description=__doc__)
    said.add_argument("--legs", type=int, default=300)
    said.add_argument("--batch", type=int, default=4, help="legs that the batch fit is asked of")
    said.add_argument("--hours", type=float, default=1.0, help="simulated, for false alarms")
    given = said.parse_args()
    for friction in (0.0, coverage.FRICTION):
        print(f"\n{given.legs} legs, friction {friction:g} 1/s^2 where it is asked for")
        every = [
            one
            for number in range(given.legs)
            for one in coverage.answers(number, friction, batch=number < given.batch)
        ]
        print(coverage.table(every))
        for name in ("batch", "batch, gyro's delay") if given.batch else ():
            first, third = (coverage.narrower(every[:], name, drops) for drops in (1, 3))
            print(f"errors over those of {name}: {first} after one drop, {third} after three")
    print(speed.report())
    print(changes.report(max(given.legs // 10, 5), given.hours))


if __name__ == "__main__":
    main()

"""The numbers of the firmware's Kalman filter."""

PROCESS_NOISE = (1e-8, 1e-5, 0.6)  # Q per step of 10 ms: rad^2, (rad/s)^2, (rad/s^2)^2
MEASUREMENT_NOISE = (8e-7, 1.2e-5)  # R: encoder rad^2, gyro (rad/s)^2
START_VARIANCE = (10.0, 100.0, 100.0)  # P before anything was measured, units of Q

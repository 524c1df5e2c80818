"""What every exported C header has around the formulas of its model."""

FRAME = """/*
{described}

 * Feed-forward, gravity and friction compensation for this one leg, in single precision and without
 * heap, globals or a mathematics library: C99 and C++11. Compile with -ffp-contract=off, and not
 * with -ffast-math, to have the last bit as exoid has it.
 *
 * THIS IS NO SAFETY FUNCTION. Nothing here watches a sensor, a person or itself. The limits below
 * keep one number small; they do not make a device safe. Put an independent, tested limit of
 * torque, speed and angle behind it, and a switch in the person's hand.
 *
 * Written by exoid.
 */
#ifndef EXOID_LEG_H
#define EXOID_LEG_H

/* Yours to set before this is included. */
#ifndef EXOID_LEG_TORQUE_LIMIT
#define EXOID_LEG_TORQUE_LIMIT {torque_limit} /* N m: exoid_leg_limited gives no more */
#endif
#ifndef EXOID_LEG_TORQUE_RATE_LIMIT
#define EXOID_LEG_TORQUE_RATE_LIMIT {rate_limit} /* N m/s: nor changes it faster */
#endif
#ifndef EXOID_LEG_STILL
#define EXOID_LEG_STILL 0.02f /* rad/s: slower than this no way is known, and friction is 0 */
#endif
#ifndef EXOID_LEG_THIGH_ANGLE
#define EXOID_LEG_THIGH_ANGLE {thigh_angle} /* rad, the knee above the hip, as recorded */
#endif

{constants}

{helpers}
{functions}

/* Of gravity [N m] on a leg at `angle` [rad]; extension is positive. */
static inline float exoid_leg_gravity(float angle)
{{
{gravity}
}}

/* Of the passive spring [N m]. */
static inline float exoid_leg_stiffness(float angle)
{{
{stiffness}
}}

/* Of the damper [N m] at `rate` [rad/s]. */
static inline float exoid_leg_damping(float rate)
{{
{damping}
}}

/* Of dry friction [N m]: its level against the way the leg goes, 0 below EXOID_LEG_STILL, where
   it is whatever holds the leg and no formula can say. */
static inline float exoid_leg_friction(float angle, float rate)
{{
{friction}
}}
{terms}
/* All that acts on the leg beside a motor and the muscles [N m]. */
static inline float exoid_leg_passive(float angle, float rate{memory})
{{
    float torque = exoid_leg_gravity(angle);
    torque = torque + exoid_leg_stiffness(angle);
    torque = torque + exoid_leg_damping(rate);
    torque = torque + exoid_leg_friction(angle, rate);
{added}    return torque;
}}

/* What moves the leg so [N m]: J `acceleration` [rad/s^2] less all that acts on it. */
static inline float exoid_leg_feed_forward(float angle, float rate, float acceleration{memory})
{{
    return EXOID_LEG_INERTIA * acceleration - exoid_leg_passive(angle, rate{passed});
}}

/* `wanted` [N m] within the limits, `seconds` after `before` [N m]; 0 where it is no number. */
static inline float exoid_leg_limited(float wanted, float before, float seconds)
{{
    const float step = EXOID_LEG_TORQUE_RATE_LIMIT * seconds;
    float torque = wanted;
    if (!(wanted == wanted) || !(before == before) || !(step >= 0.0f)) {{
        return 0.0f;
    }}
    torque = torque > before + step ? before + step : torque;
    torque = torque < before - step ? before - step : torque;
    torque = torque > EXOID_LEG_TORQUE_LIMIT ? EXOID_LEG_TORQUE_LIMIT : torque;
    return torque < -EXOID_LEG_TORQUE_LIMIT ? -EXOID_LEG_TORQUE_LIMIT : torque;
}}

#endif
"""

MEMORY = """
/* What the terms remember; begin with exoid_leg_begun. */
typedef struct {{
{members}
}} exoid_leg_memory;

static const exoid_leg_memory exoid_leg_begun = {{
{begun}
}};

/* What they remember `seconds` later: one step of Euler's method. Call it every 2 ms or oftener;
   the error of what is remembered goes with that time. */
static inline exoid_leg_memory exoid_leg_remembered(
    exoid_leg_memory memory, float angle, float rate, float seconds)
{{
    exoid_leg_memory next = memory;
    (void)angle;
{rates}
    memory = next;
{within}
    return next;
}}
"""

HELPERS = {
    "abs": """static inline float exoid_leg_abs(float x)
{
    return x > 0.0f ? x : 0.0f - x;
}
""",
    "sign": """static inline float exoid_leg_sign(float x)
{
    return (float)(x > 0.0f) - (float)(x < 0.0f);
}
""",
    "max": """static inline float exoid_leg_max(float x, float y)
{
    return x > y ? x : y;
}
""",
    "min": """static inline float exoid_leg_min(float x, float y)
{
    return x < y ? x : y;
}
""",
    "floor": """/* Of numbers below a million; others come back as they are. */
static inline float exoid_leg_floor(float x)
{
    float whole = x;
    if (x > -1e6f && x < 1e6f) {
        whole = (float)(int)x;
        whole = whole > x ? whole - 1.0f : whole;
    }
    return whole;
}
""",
    "round": """/* Half to even, of numbers below a million; others come back as they are. */
static inline float exoid_leg_round(float x)
{
    int whole = 0;
    float rest = 0.0f;
    if (!(x > -1e6f && x < 1e6f)) {
        return x;
    }
    whole = (int)x;
    whole = (float)whole > x ? whole - 1 : whole;
    rest = x - (float)whole;
    return (float)(rest > 0.5f || (rest == 0.5f && whole % 2 != 0) ? whole + 1 : whole);
}
""",
    "two_to": """/* Of a whole number from -126 to 127: exact. */
static inline float exoid_leg_two_to(float whole)
{
    float found = 1.0f;
    int left = (int)whole;
    for (; left > 0; --left) {
        found = found * 2.0f;
    }
    for (; left < 0; ++left) {
        found = found * 0.5f;
    }
    return found;
}
""",
}

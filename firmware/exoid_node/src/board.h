/// The board that the program is compiled for.

#pragma once

#if defined(__IMXRT1062__)
#include "board_teensy4.h"
#else
#include "board_samd21.h"
#endif

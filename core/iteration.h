// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The records of a run are those that the library gives out.
#include "core/api/include/foldless/iteration.h"

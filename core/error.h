// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One type of errors for the program and for those who link to the library.
#include "core/api/include/foldless/error.h"

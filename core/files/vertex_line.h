// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/polygon_soup.h"
#include "core/files/text_lines.h"

namespace foldless {

/// Adds the vertex that a line of a text file gives: x, y and, if it is there, z; words that
/// follow are ignored. A vertex with a word that is not a number goes to `unreadable`.
void read_vertex_line(Words words, int line, PolygonSoup& soup, Offenders& unreadable);

}  // namespace foldless

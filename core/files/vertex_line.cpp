// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/vertex_line.h"

namespace foldless {

void read_vertex_line(Words words, int line, PolygonSoup& soup, Offenders& unreadable) {
  const int v = static_cast<int>(soup.vertices.size());
  soup.source.vertex_lines.push_back(line);
  std::array<double, 3>& p = soup.vertices.emplace_back();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view word = words.next();
    if (k == 2 && word.empty()) return;  // a planar file
    const auto x = parse_number(word);
    p[k] = x.value_or(0);
    if (x) continue;
    unreadable.add([&] {
      return soup.source.at_vertex(v) +
             (word.empty() ? " has only " + counted(k, "coordinate")
                           : " has the coordinate " + in_quotes(word) + ", which is not a number");
    });
    return;
  }
}

}  // namespace foldless

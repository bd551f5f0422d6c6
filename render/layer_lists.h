// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace foldless {

/// Elements sorted by their layers, as they came within a layer.
struct LayerLists {
  std::vector<int> order;          ///< element by place
  std::vector<std::size_t> first;  ///< place where a layer begins, one past the last for the end
};

/// `layers`: in [0, count), of every element.
inline LayerLists layer_lists(const std::vector<int>& layers, std::size_t count) {
  LayerLists lists;
  lists.first.assign(count + 1, 0);
  for (const int layer : layers) ++lists.first[static_cast<std::size_t>(layer) + 1];
  for (std::size_t layer = 0; layer < count; ++layer) lists.first[layer + 1] += lists.first[layer];
  std::vector<std::size_t> next(lists.first.begin(), lists.first.end() - 1);
  lists.order.resize(layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i)
    lists.order[next[static_cast<std::size_t>(layers[i])]++] = static_cast<int>(i);
  return lists;
}

}  // namespace foldless

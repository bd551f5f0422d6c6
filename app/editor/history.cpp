// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/history.h"

#include <cassert>
#include <unordered_set>
#include <utility>

namespace foldless {
namespace {

std::size_t bytes_of(const Document& document, std::unordered_set<const void*>& counted) {
  std::size_t bytes = sizeof(HistoryStep) + document.handles.size() * sizeof(Handle);
  const auto add_part = [&](const auto& part, auto size) {
    if (part && counted.insert(part.get()).second) bytes += static_cast<std::size_t>(size(*part));
  };
  const auto matrix = [](const auto& m) {
    return m.size() * static_cast<Eigen::Index>(sizeof(*m.data()));
  };
  add_part(document.original,
           [&](const Shape& shape) { return matrix(shape.triangles) + matrix(shape.rest); });
  add_part(document.pose, [&](const Snapshot& pose) { return matrix(pose.deformed); });
  if (document.pose) {
    add_part(document.pose->triangles, matrix);
    add_part(document.pose->rest, matrix);
    add_part(document.pose->flipped_edges,
             [](const std::vector<Edge>& edges) { return edges.size() * sizeof(Edge); });
  }
  return bytes;
}

}  // namespace

History::History(std::size_t memory_cap) : memory_cap_(memory_cap) {
  reset("New", empty_document());
}

void History::reset(std::string label, Document document) {
  std::vector<HistoryStep> steps;
  steps.push_back({next_id_++, std::move(label), std::move(document)});
  steps_ = std::move(steps);
  current_ = 0;
}

void History::push(std::string label, Document document) {
  steps_.resize(current_ + 1);
  steps_.push_back({next_id_++, std::move(label), std::move(document)});
  ++current_;
  trim();
}

void History::refresh(Document document) { steps_[current_].document = std::move(document); }

const Document& History::jump(std::size_t index) {
  assert(index < steps_.size());
  current_ = index;
  return steps_[current_].document;
}

std::size_t History::bytes() const {
  std::unordered_set<const void*> counted;
  std::size_t bytes = 0;
  for (const HistoryStep& step : steps_) bytes += bytes_of(step.document, counted);
  return bytes;
}

void History::trim() {
  while (current_ > 1 && bytes() > memory_cap_) {
    steps_.erase(steps_.begin());
    --current_;
  }
}

}  // namespace foldless

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/svg_plot.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cstddef>
#include <string_view>

#include "app/export/svg_axis.h"
#include "app/export/xml_text.h"

namespace foldless {
namespace {

// Told apart by people who see few colours, too.
constexpr std::array<std::string_view, 8> kPalette{"#d62728", "#2ca02c", "#1f77b4", "#222222",
                                                   "#ff7f0e", "#9467bd", "#17becf", "#8c564b"};

/// The room inside the margins, pixels.
struct Frame {
  double left, top, width, height;
};

std::string pixels(double value) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::fixed, 1);
  return {buffer.data(), end.ptr};
}

std::string at(double x, double y) { return " x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\""; }

std::string line(double x1, double y1, double x2, double y2) {
  return "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2) +
         "\" y2=\"" + pixels(y2) + "\"";
}

std::string tick_text(const Tick& tick) {
  if (tick.exponent.empty()) return tick.text;
  return tick.text + "<tspan dy=\"-5\" font-size=\"9\">" + tick.exponent + "</tspan>";
}

/// The places of a series: its own, or 0, 1, 2 …
std::vector<double> places_of(const Series& series) {
  if (!series.x.empty()) return series.x;
  std::vector<double> x(series.y.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i);
  return x;
}

std::vector<double> all_of(const std::vector<Series>& series, bool of_x) {
  std::vector<double> values;
  for (const Series& s : series) {
    assert(s.x.empty() || s.x.size() == s.y.size());
    const std::vector<double> more = of_x ? places_of(s) : s.y;
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

/// Writes one plot from the back to the front.
class Writer {
 public:
  Writer(const std::vector<Series>& series, const PlotOptions& options)
      : series_(series),
        options_(options),
        x_(all_of(series, true), options.x.is_logarithmic),
        y_(all_of(series, false), options.y.is_logarithmic),
        frame_{72, 36, options.width - 72.0 - 18, options.height - 36.0 - 52} {}

  std::string text() {
    const std::string size = " width=\"" + std::to_string(options_.width) + "\" height=\"" +
                             std::to_string(options_.height) + "\"";
    text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + size + " viewBox=\"0 0 " +
            std::to_string(options_.width) + " " + std::to_string(options_.height) +
            "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222222\">\n<rect" + size +
            " fill=\"white\"/>\n";
    add_axes();
    for (std::size_t i = 0; i < series_.size(); ++i) add_curve(i);
    add_legend();
    return text_ + "</svg>\n";
  }

 private:
  double to_x(double value) const { return frame_.left + frame_.width * x_.fraction(value); }
  double to_y(double value) const { return frame_.top + frame_.height * (1 - y_.fraction(value)); }
  double bottom() const { return frame_.top + frame_.height; }

  std::string colour_of(std::size_t i) const {
    if (!series_[i].colour.empty()) return xml_escaped(series_[i].colour);
    return std::string(kPalette[i % kPalette.size()]);
  }

  void add_axes() {
    for (const Tick& tick : x_.ticks()) {
      text_ += line(to_x(tick.value), frame_.top, to_x(tick.value), bottom()) +
               " stroke=\"#dddddd\"/>\n<text" + at(to_x(tick.value), bottom() + 18) +
               " text-anchor=\"middle\">" + tick_text(tick) + "</text>\n";
    }
    for (const Tick& tick : y_.ticks()) {
      text_ += line(frame_.left, to_y(tick.value), frame_.left + frame_.width, to_y(tick.value)) +
               " stroke=\"#dddddd\"/>\n<text" + at(frame_.left - 8, to_y(tick.value) + 4) +
               " text-anchor=\"end\">" + tick_text(tick) + "</text>\n";
    }
    text_ += "<rect" + at(frame_.left, frame_.top) + " width=\"" + pixels(frame_.width) +
             "\" height=\"" + pixels(frame_.height) + "\" fill=\"none\" stroke=\"#222222\"/>\n";
    const double middle = frame_.left + frame_.width / 2;
    text_ += "<text" + at(middle, 22) + " text-anchor=\"middle\" font-size=\"14\">" +
             xml_escaped(options_.title) + "</text>\n<text" + at(middle, bottom() + 40) +
             " text-anchor=\"middle\">" + xml_escaped(options_.x.label) + "</text>\n";
    const std::string turned = pixels(frame_.top + frame_.height / 2);
    text_ += "<text transform=\"translate(18 " + turned +
             ") rotate(-90)\" text-anchor=\"middle\">" + xml_escaped(options_.y.label) +
             "</text>\n";
  }

  /// A polyline for every stretch without a gap; a lone point becomes a dot.
  void add_curve(std::size_t i) {
    const std::vector<double> x = places_of(series_[i]);
    std::string points;
    for (std::size_t k = 0; k <= x.size(); ++k) {
      if (k < x.size() && x_.holds(x[k]) && y_.holds(series_[i].y[k])) {
        points += pixels(to_x(x[k])) + "," + pixels(to_y(series_[i].y[k])) + " ";
      } else if (!points.empty()) {
        points.pop_back();
        text_ += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + colour_of(i) +
                 "\" stroke-width=\"1.6\" stroke-linejoin=\"round\" stroke-linecap=\"round\"/>\n";
        points.clear();
      }
    }
  }

  void add_legend() {
    std::size_t longest = 0;
    double rows = 0;
    for (const Series& s : series_) {
      longest = std::max(longest, s.name.size());
      rows += s.name.empty() ? 0 : 1;
    }
    if (rows == 0) return;
    const Frame box = emptiest_corner(42 + 7.0 * static_cast<double>(longest), 18 * rows + 6);
    text_ += "<rect" + at(box.left, box.top) + " width=\"" + pixels(box.width) + "\" height=\"" +
             pixels(box.height) + "\" fill=\"white\" fill-opacity=\"0.85\"/>\n";
    double y = box.top;
    for (std::size_t i = 0; i < series_.size(); ++i) {
      if (series_[i].name.empty()) continue;
      y += 18;
      text_ += line(box.left + 6, y - 4, box.left + 30, y - 4) + " stroke=\"" + colour_of(i) +
               "\" stroke-width=\"2\"/>\n<text" + at(box.left + 36, y) + ">" +
               xml_escaped(series_[i].name) + "</text>\n";
    }
  }

  /// A box of that size in the corner where it hides the fewest points.
  Frame emptiest_corner(double width, double height) const {
    constexpr double kGap = 8;
    const double right = frame_.left + frame_.width - width - kGap;
    const double low = bottom() - height - kGap;
    const double left = frame_.left + kGap;
    const double top = frame_.top + kGap;
    Frame best{};
    int fewest = -1;
    for (const Frame& box : {Frame{right, top, width, height}, Frame{right, low, width, height},
                             Frame{left, low, width, height}, Frame{left, top, width, height}}) {
      const int hidden = points_in(box);
      if (fewest >= 0 && hidden >= fewest) continue;
      fewest = hidden;
      best = box;
    }
    return best;
  }

  int points_in(const Frame& box) const {
    int count = 0;
    for (const Series& s : series_) {
      const std::vector<double> x = places_of(s);
      for (std::size_t k = 0; k < x.size(); ++k) {
        if (!x_.holds(x[k]) || !y_.holds(s.y[k])) continue;
        const double across = to_x(x[k]) - box.left;
        const double down = to_y(s.y[k]) - box.top;
        count += across >= 0 && across <= box.width && down >= 0 && down <= box.height ? 1 : 0;
      }
    }
    return count;
  }

  const std::vector<Series>& series_;
  const PlotOptions& options_;
  AxisScale x_;
  AxisScale y_;
  Frame frame_;
  std::string text_;
};

}  // namespace

std::string svg_plot(const std::vector<Series>& series, const PlotOptions& options) {
  return Writer(series, options).text();
}

}  // namespace foldless

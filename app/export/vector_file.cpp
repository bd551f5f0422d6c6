// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/vector_file.h"

#include <cctype>
#include <map>
#include <string_view>

#include "app/export/xml_text.h"
#include "core/error.h"

namespace foldless {
namespace {

constexpr double kPointsAPixel = 0.75;  // 72 and 96 an inch

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

CairoSurface make_surface(VectorFormat format, std::string& bytes, double width, double height) {
  if (format == VectorFormat::pdf)
    return CairoSurface(cairo_pdf_surface_create_for_stream(append, &bytes, kPointsAPixel * width,
                                                            kPointsAPixel * height));
  CairoSurface surface(cairo_svg_surface_create_for_stream(append, &bytes, width, height));
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  return surface;
}

std::string text_of(const ImageTexts& texts, const std::string& keyword) {
  const auto found = texts.find(keyword);
  return found == texts.end() ? "" : readable(found->second);
}

/// Everything that a figure says of itself in one line.
std::string all_of(const ImageTexts& texts) {
  std::string all;
  for (const auto& [keyword, text] : texts) {
    if (!all.empty()) all += "; ";
    all += keyword;
    all += ": ";
    all += readable(text);
  }
  return all;
}

void describe_pdf(cairo_surface_t* pdf, const ImageTexts& texts) {
  const auto set = [pdf](cairo_pdf_metadata_t what, const std::string& text) {
    cairo_pdf_surface_set_metadata(pdf, what, text.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, text_of(texts, "Scene"));
  set(CAIRO_PDF_METADATA_CREATOR, text_of(texts, "Software"));
  set(CAIRO_PDF_METADATA_SUBJECT, all_of(texts));
  set(CAIRO_PDF_METADATA_CREATE_DATE, "");
}

/// Title and description, which cairo does not write.
void describe_svg(std::string& svg, const ImageTexts& texts) {
  const std::size_t root = svg.find("<svg");
  const std::size_t end = svg.find('>', root);
  if (root == std::string::npos || end == std::string::npos) return;
  std::string words = "\n<title>";
  words += xml_escaped(text_of(texts, "Scene"));
  words += "</title>\n<desc>";
  words += xml_escaped(all_of(texts));
  words += "</desc>";
  svg.insert(end + 1, words);
}

/// cairo counts surfaces over the whole process and numbers ids by that; they become 1, 2, 3 … in
/// the order in which they come.
std::string with_own_numbers(const std::string& svg) {
  std::map<std::string_view, int> numbers;
  std::string result;
  result.reserve(svg.size());
  const std::string_view text(svg);
  for (std::size_t at = 0; at < text.size();) {
    std::size_t quote = text.find_first_of("\"#", at);
    if (quote == std::string_view::npos) quote = text.size() - 1;
    result += text.substr(at, quote + 1 - at);
    at = quote + 1;
    for (const std::string_view kind : {"surface", "image"}) {
      if (!text.substr(at).starts_with(kind)) continue;
      std::size_t end = at + kind.size();
      while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end]))) ++end;
      if (end == at + kind.size()) break;
      const int next = static_cast<int>(numbers.size()) + 1;
      result += kind;
      result += std::to_string(numbers.try_emplace(text.substr(at, end - at), next).first->second);
      at = end;
      break;
    }
  }
  return result;
}

}  // namespace

VectorFile::VectorFile(VectorFormat format, int width, int height)
    : format_(format),
      surface_(make_surface(format, bytes_, width, height)),
      cairo_(cairo_create(surface_.get())) {
  if (format == VectorFormat::pdf) cairo_scale(cairo_.get(), kPointsAPixel, kPointsAPixel);
}

std::string VectorFile::finish(const ImageTexts& texts) {
  if (format_ == VectorFormat::pdf) describe_pdf(surface_.get(), texts);
  cairo_status_t status = cairo_status(cairo_.get());
  cairo_show_page(cairo_.get());
  cairo_surface_finish(surface_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface_.get());
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(std::string("the figure cannot be drawn: ") + cairo_status_to_string(status));
  if (format_ == VectorFormat::pdf) return std::move(bytes_);
  describe_svg(bytes_, texts);
  return with_own_numbers(bytes_);
}

}  // namespace foldless

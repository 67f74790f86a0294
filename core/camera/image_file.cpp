#include "core/camera/image_file.h"

#include <fstream>
#include <iterator>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/camera/image_header.h"
#include "core/camera/image_integrity.h"
#include "core/camera/jpeg_decoder.h"
#include "core/camera/pixel_depth.h"
#include "core/camera/tiff_decoder.h"
#include "core/common/atomic_file.h"

namespace mirrorarm::camera {
namespace {

FromFile<std::vector<std::uint8_t>> readBytes(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed)) return unexpected(FileError{file, 0, "is missing"});
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in.good() && !in.eof()) return unexpected(FileError{file, 0, "cannot be read"});
  if (bytes.empty()) return unexpected(FileError{file, 0, "is empty"});
  return bytes;
}

/// Empty when the bytes are no image.
cv::Mat decode(const std::vector<std::uint8_t>& bytes) {
  try {
    return cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const std::exception&) {
    return {};
  }
}

cv::Mat toGrey(const cv::Mat& image) {
  if (image.channels() == 1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
  return grey;
}

GreyImage toImage(const cv::Mat& grey) {
  std::vector<std::uint8_t> pixels;
  pixels.reserve(grey.total());
  for (int y = 0; y < grey.rows; ++y) pixels.insert(pixels.end(), grey.ptr(y), grey.ptr(y) + grey.cols);
  return {grey.cols, grey.rows, std::move(pixels)};
}

/// What speaks against decoding the bytes at all; empty for nothing.
std::string objection(const std::vector<std::uint8_t>& bytes) {
  if (!formatOf(bytes)) return "is no PNG, JPEG, BMP, TIFF or binary PGM image";
  const auto size = promisedSize(bytes);
  if (size && size->width_px > 0 && size->height_px > kMostPixels / size->width_px)
    return "claims " + std::to_string(size->width_px) + "x" + std::to_string(size->height_px) +
           " pixels, more than any camera's image";
  return isWhole(bytes) ? std::string() : "is an image cut short or damaged";
}

Expected<GreyImage, std::string> decodeAny(const std::vector<std::uint8_t>& bytes) {
  if (formatOf(bytes) == ImageFormat::kJpeg) return decodeJpeg(bytes, kMostPixels);
  if (formatOf(bytes) == ImageFormat::kTiff) return decodeTiff(bytes, kMostPixels);
  const cv::Mat image = decode(bytes);
  if (image.empty()) return unexpected(std::string("is not an image that can be read"));
  if (image.depth() != CV_8U)
    return unexpected(tooDeep(8 * static_cast<unsigned>(image.elemSize1()), image.depth() >= CV_32F));
  if (image.channels() == 2) return unexpected(std::string("has two channels"));
  return toImage(toGrey(image));
}

}  // namespace

FromFile<GreyImage> readImage(const std::filesystem::path& file) {
  const auto bytes = readBytes(file);
  if (!bytes) return unexpected(bytes.error());
  const auto refusal = objection(*bytes);
  if (!refusal.empty()) return unexpected(FileError{file, 0, refusal});
  auto image = decodeAny(*bytes);
  if (!image) return unexpected(FileError{file, 0, image.error()});
  return std::move(*image);
}

Expected<void, std::string> writeImage(const std::filesystem::path& file, const GreyImage& image) {
  const auto view = image.view();
  if (view.empty()) return unexpected(file.string() + ": the image is empty");
  const cv::Mat borrowed(view.height_px, view.width_px, CV_8UC1, const_cast<std::uint8_t*>(view.data));
  std::vector<std::uint8_t> bytes;
  try {
    if (!cv::imencode(file.extension().string(), borrowed, bytes))
      return unexpected(file.string() + ": cannot be encoded");
  } catch (const cv::Exception&) {
    return unexpected(file.string() + ": no image format has this ending");
  }
  return writeWhole(file, [&](std::ostream& out) {
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace mirrorarm::camera

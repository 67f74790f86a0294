#include "core/camera/tiff_decoder.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <tiffio.h>
#include <vector>

#include "core/camera/pixel_depth.h"

namespace mirrorarm::camera {
namespace {

/// A file in memory, as libtiff asks for one.
struct Source {
  std::span<const std::uint8_t> bytes;
  std::uint64_t at = 0;
};

Source& sourceOf(thandle_t handle) { return *static_cast<Source*>(handle); }

tmsize_t read(thandle_t handle, void* to, tmsize_t wanted) {
  Source& source = sourceOf(handle);
  const std::uint64_t left = source.bytes.size() - std::min<std::uint64_t>(source.at, source.bytes.size());
  const auto count = std::min<std::uint64_t>(left, static_cast<std::uint64_t>(std::max<tmsize_t>(wanted, 0)));
  if (count > 0) std::memcpy(to, source.bytes.data() + source.at, count);
  source.at += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t write(thandle_t, void*, tmsize_t) { return -1; }

toff_t seek(thandle_t handle, toff_t to, int whence) {
  Source& source = sourceOf(handle);
  const std::uint64_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? source.at : source.bytes.size();
  return source.at = from + to;
}

int close(thandle_t) { return 0; }
toff_t size(thandle_t handle) { return sourceOf(handle).bytes.size(); }
int saysNothing(TIFF*, void*, const char*, const char*, va_list) { return 1; }

struct Close {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

std::unique_ptr<TIFF, Close> openQuietly(Source& source) {
  const std::unique_ptr<TIFFOpenOptions, Close> options(TIFFOpenOptionsAlloc());
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), saysNothing, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), saysNothing, nullptr);
  return std::unique_ptr<TIFF, Close>(TIFFClientOpenExt("image", "rm", &source, read, write, seek, close,
                                                        size, nullptr, nullptr, options.get()));
}

/// ITU-R BT.601, as for the other formats.
std::uint8_t greyOf(std::uint32_t abgr) {
  const double grey = 0.299 * TIFFGetR(abgr) + 0.587 * TIFFGetG(abgr) + 0.114 * TIFFGetB(abgr);
  return static_cast<std::uint8_t>(grey + 0.5);
}

}  // namespace

Expected<GreyImage, std::string> decodeTiff(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  Source source{bytes};
  const auto tiff = openQuietly(source);
  if (!tiff) return unexpected(std::string("is an image cut short or damaged"));
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 1, kind = SAMPLEFORMAT_UINT;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLEFORMAT, &kind);
  if (bits > 8) return unexpected(tooDeep(bits, kind == SAMPLEFORMAT_IEEEFP));
  const std::uint64_t pixels = std::uint64_t{width} * height;
  if (pixels == 0 || pixels > most_pixels) return unexpected(std::string("has no size that can be read"));
  std::vector<std::uint32_t> raster(pixels);
  constexpr int kStopAtDamage = 1;
  if (TIFFReadRGBAImageOriented(tiff.get(), width, height, raster.data(), ORIENTATION_TOPLEFT,
                                kStopAtDamage) == 0)
    return unexpected(std::string("is an image cut short or damaged"));
  std::vector<std::uint8_t> grey(raster.size());
  std::transform(raster.begin(), raster.end(), grey.begin(), greyOf);
  return GreyImage(static_cast<int>(width), static_cast<int>(height), std::move(grey));
}

}  // namespace mirrorarm::camera

#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace mirrorarm::camera {

/// The image formats that are read.
enum class ImageFormat { kPng, kJpeg, kBmp, kTiff, kGreyMap, kColourMap };

/// By the first bytes, whatever the file is called. Nothing for other formats, textual PGM among them.
[[nodiscard]] std::optional<ImageFormat> formatOf(std::span<const std::uint8_t> bytes);

/// A header's own word on the size of the picture, before anything is decoded.
struct PromisedSize {
  std::uint64_t width_px = 0;
  std::uint64_t height_px = 0;
};

/// Nothing where the header is cut short, and for JPEG, whose decoder reads it.
[[nodiscard]] std::optional<PromisedSize> promisedSize(std::span<const std::uint8_t> bytes);

/// Bytes that a PGM or PPM file's header and pixels take together. Nothing for a wrong header.
[[nodiscard]] std::optional<std::uint64_t> mapBytes(std::span<const std::uint8_t> bytes);

/// Bytes that a BMP file takes, by its size field and, uncompressed, by its pixels. Nothing for a wrong
/// header.
[[nodiscard]] std::optional<std::uint64_t> bmpBytes(std::span<const std::uint8_t> bytes);

}  // namespace mirrorarm::camera

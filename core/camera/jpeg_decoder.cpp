#include "core/camera/jpeg_decoder.h"

#include <csetjmp>
#include <cstdio>
#include <jpeglib.h>
#include <vector>

namespace mirrorarm::camera {
namespace {

/// libjpeg tells of trouble through calls that must not return: they jump out of the decoding.
struct Trouble {
  jpeg_error_mgr calls;  // first member: libjpeg's pointer to it is a pointer to Trouble
  std::jmp_buf way_out;
};

[[noreturn]] void leave(j_common_ptr decoder) {
  std::longjmp(reinterpret_cast<Trouble*>(decoder->err)->way_out, 1);
}

/// Warnings, below zero, tell of damaged data that libjpeg would fill up.
void hear(j_common_ptr decoder, int level) {
  if (level < 0) leave(decoder);
}

/// Nothing here but plain values: a jump passes no destructor.
struct Decoder {
  jpeg_decompress_struct jpeg{};
  Trouble trouble{};

  Decoder() {
    jpeg.err = jpeg_std_error(&trouble.calls);
    trouble.calls.error_exit = leave;
    trouble.calls.emit_message = hear;
    jpeg_create_decompress(&jpeg);
  }
  ~Decoder() { jpeg_destroy_decompress(&jpeg); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  [[nodiscard]] bool begin(std::span<const std::uint8_t> bytes) {
    if (setjmp(trouble.way_out) != 0) return false;
    jpeg_mem_src(&jpeg, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&jpeg, TRUE);
    jpeg.out_color_space = JCS_GRAYSCALE;
    return true;
  }
  [[nodiscard]] bool decode(std::uint8_t* pixels) {
    if (setjmp(trouble.way_out) != 0) return false;
    jpeg_start_decompress(&jpeg);
    while (jpeg.output_scanline < jpeg.output_height) {
      JSAMPROW row = pixels + std::size_t{jpeg.output_scanline} * jpeg.output_width;
      jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
    return true;
  }
};

}  // namespace

Expected<GreyImage, std::string> decodeJpeg(std::span<const std::uint8_t> bytes, std::uint64_t most_pixels) {
  Decoder decoder;
  if (!decoder.begin(bytes)) return unexpected(std::string("is an image cut short or damaged"));
  const auto& jpeg = decoder.jpeg;
  if (jpeg.num_components > 3) return unexpected(std::string("is in printing colours (CMYK)"));
  if (std::uint64_t{jpeg.image_width} * jpeg.image_height > most_pixels)
    return unexpected(std::string("is larger than any camera's image"));
  std::vector<std::uint8_t> pixels(std::size_t{jpeg.image_width} * jpeg.image_height);
  if (!decoder.decode(pixels.data())) return unexpected(std::string("is an image cut short or damaged"));
  return GreyImage(static_cast<int>(jpeg.image_width), static_cast<int>(jpeg.image_height),
                   std::move(pixels));
}

}  // namespace mirrorarm::camera

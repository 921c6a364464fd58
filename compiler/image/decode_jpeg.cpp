// JPEG through libjpeg: grey stays one channel, everything else becomes RGB (CMYK by multiplying with black). libjpeg reports
// errors by our jump, so the function that calls setjmp owns nothing that must be destroyed. A file that ends early is an
// error here, not the grey rest that libjpeg would supply; a file of endless scans over one image is stopped. Where no pixels
// are wanted, each block of 8 x 8 becomes one: all codes of the file are read, but hardly anything is computed from them.

#include <csetjmp>
#include <cstdio>  // jpeglib.h needs FILE

#include <jpeglib.h>

#include <jerror.h>

#include "image/decode_image.h"

namespace plugc {

namespace {

constexpr int kMaxScans = 200;  // real progressive files have about ten

struct JpegReading {
  jpeg_error_mgr errors;  // first, so that libjpeg's pointer to it is a pointer to this
  jpeg_progress_mgr progress;
  std::jmp_buf escape;
  char problem[JMSG_LENGTH_MAX] = {};
};

JpegReading& reading_of(j_common_ptr jpeg) {
  return *reinterpret_cast<JpegReading*>(jpeg->err);
}

[[noreturn]] void on_error(j_common_ptr jpeg) {
  jpeg->err->format_message(jpeg, reading_of(jpeg).problem);
  std::longjmp(reading_of(jpeg).escape, 1);
}

void on_message(j_common_ptr jpeg, int level) {
  if (level >= 0) return;  // only a trace
  if (jpeg->err->msg_code == JWRN_JPEG_EOF) on_error(jpeg);
}

void stop_endless_scans(j_common_ptr jpeg) {
  if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= kMaxScans) return;
  std::snprintf(reading_of(jpeg).problem, JMSG_LENGTH_MAX, "it has more than %d scans", kMaxScans);
  std::longjmp(reading_of(jpeg).escape, 1);
}

void install_callbacks(jpeg_decompress_struct& jpeg, JpegReading& reading) {
  jpeg.err = jpeg_std_error(&reading.errors);
  reading.errors.error_exit = on_error;
  reading.errors.emit_message = on_message;
}

// Adobe writes CMYK inverted: 255 is no ink, so each colour is its ink's rest times the rest of black.
void cmyk_to_rgb(const std::uint8_t* cmyk, std::uint8_t* rgb, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x, cmyk += 4, rgb += 3)
    for (int c = 0; c < 3; ++c) rgb[c] = static_cast<std::uint8_t>((cmyk[c] * cmyk[3] + 127) / 255);
}

void pass_over_rows(jpeg_decompress_struct& jpeg, std::vector<std::uint8_t>& line) {
  JSAMPROW target = line.data();
  while (jpeg.output_scanline < jpeg.output_height) jpeg_read_scanlines(&jpeg, &target, 1);
}

void read_rows(jpeg_decompress_struct& jpeg, Image& image, std::vector<std::uint8_t>& line) {
  const bool cmyk = jpeg.output_components == 4;
  while (jpeg.output_scanline < jpeg.output_height) {
    const std::size_t y = image.height - 1 - jpeg.output_scanline;
    std::uint8_t* row = image.pixels.data() + y * image.width * image.channels;
    JSAMPROW target = cmyk ? line.data() : row;
    jpeg_read_scanlines(&jpeg, &target, 1);
    if (cmyk) cmyk_to_rgb(line.data(), row, image.width);
  }
}

bool note_size_problem(const jpeg_decompress_struct& jpeg, JpegReading& reading, std::size_t file_bytes) {
  const std::string problem = size_problem(jpeg.image_width, jpeg.image_height, 3, file_bytes);
  std::snprintf(reading.problem, sizeof reading.problem, "%s", problem.c_str());
  return !problem.empty();
}

// Reads into `image` and `line`, which the caller owns; false after a jump or with a problem noted.
bool read_jpeg(jpeg_decompress_struct& jpeg, JpegReading& reading, std::string_view bytes, ImageDetail detail, Image& image,
               std::vector<std::uint8_t>& line) {
  if (setjmp(reading.escape)) return false;
  jpeg_create_decompress(&jpeg);
  reading.progress.progress_monitor = stop_endless_scans;
  jpeg.progress = &reading.progress;
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  jpeg_read_header(&jpeg, TRUE);
  if (note_size_problem(jpeg, reading, bytes.size())) return false;
  if (jpeg.num_components == 4)
    jpeg.out_color_space = JCS_CMYK;
  else if (jpeg.jpeg_color_space != JCS_GRAYSCALE)
    jpeg.out_color_space = JCS_RGB;
  if (detail == ImageDetail::facts) jpeg.scale_denom = DCTSIZE;
  jpeg_start_decompress(&jpeg);
  line.resize(std::size_t{jpeg.output_width} * 4);
  const std::size_t channels = jpeg.output_components == 1 ? 1 : 3;
  if (detail == ImageDetail::facts) {
    set_size(image, jpeg.image_width, jpeg.image_height, channels);
    pass_over_rows(jpeg, line);
  } else {
    allocate(image, jpeg.output_width, jpeg.output_height, channels);
    read_rows(jpeg, image, line);
  }
  jpeg_finish_decompress(&jpeg);
  return true;
}

}  // namespace

DecodedImage decode_jpeg(std::string_view bytes, ImageDetail detail) {
  JpegReading reading{};
  jpeg_decompress_struct jpeg{};
  Image image;
  std::vector<std::uint8_t> line;
  install_callbacks(jpeg, reading);
  const bool ok = read_jpeg(jpeg, reading, bytes, detail, image, line);
  jpeg_destroy_decompress(&jpeg);
  if (!ok) return {{}, reading.problem};
  return {std::move(image), {}};
}

}  // namespace plugc

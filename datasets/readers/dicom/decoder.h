// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "datasets/readers/dicom/codestream.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// One running palpate-decode: see datasets/decode/README.md. Ends it when it goes.
class Decoder {
 public:
  enum class Outcome {
    Decoded,
    Refused,    ///< the codec says that the frame is damaged
    Died,       ///< it crashed, asked for what it may not have, or answered nonsense
    TooLong,    ///< and was ended
    Cancelled,  ///< and was ended
  };

  /// Starts the program that lies beside the running one, with room for frames of so many bytes,
  /// coded and decoded. Thread-safe; starts by exec alone.
  static haptics::Expected<Decoder> start(std::size_t codestream_bytes, std::size_t pixel_bytes);
  ~Decoder();
  Decoder(Decoder&& other) noexcept;
  Decoder& operator=(Decoder&&) = delete;

  /// Decodes a frame that parseCodestream let pass. After anything but Decoded and Refused the
  /// program is gone.
  Outcome decode(const Codestream& codestream, std::span<const std::byte> bytes,
                 const CodedImage& image, const ReadProgress& progress);
  /// Those of the last frame that was decoded, until the next one: whole rows, values as bits.
  const std::byte* pixels() const { return memory_ + codestream_bytes_; }

 private:
  Decoder() = default;
  /// The next byte that the program says; none where it ended or the time was up.
  Outcome listen(std::byte& said, double seconds, const ReadProgress& progress);
  void end();

  pid_t process_ = -1;
  int socket_ = -1;
  std::byte* memory_ = nullptr;
  std::size_t codestream_bytes_ = 0, pixel_bytes_ = 0;
};

/// Decoders for the threads that read a series: one for each that decodes at a time.
class Decoders {
 public:
  /// Of frames no larger than so many bytes.
  Decoders(std::size_t codestream_bytes, std::size_t pixel_bytes)
      : codestream_bytes_{codestream_bytes}, pixel_bytes_{pixel_bytes} {}

  /// One that is free, or a new one.
  haptics::Expected<std::unique_ptr<Decoder>> take();
  /// For the next thread. One that is gone must not come back.
  void give(std::unique_ptr<Decoder> decoder);

 private:
  std::size_t codestream_bytes_, pixel_bytes_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Decoder>> free_;
};

}  // namespace datasets

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "datasets/readers/dicom/decode_protocol.h"
#include "datasets/readers/scan.h"
#include "haptics/core/error.h"

namespace datasets {

/// One running palpate-decode (datasets/decode/README.md). The destructor ends the process.
class Decoder {
 public:
  enum class Outcome {
    Decoded,
    Damaged,    ///< the codec says so
    Differs,    ///< the frame's own header is at odds with the request
    Died,       ///< it crashed, made a forbidden system call, or gave an invalid answer
    TooLong,    ///< it took too long and was ended
    Cancelled,  ///< the user cancelled and it was ended
  };

  /// Starts the palpate-decode of this installation (haptics::helperProgram()), with room for
  /// frames of these sizes, coded and decoded. Thread-safe; runs no code between fork and exec.
  static haptics::Expected<Decoder> start(std::size_t codestream_bytes, std::size_t pixel_bytes);
  ~Decoder();
  Decoder(Decoder&& other) noexcept;
  Decoder& operator=(Decoder&&) = delete;

  /// Decodes a frame that the DICOM header describes so; sets the size of the codestream in
  /// `frame`. The process goes on after Decoded, Damaged and Differs, and has ended otherwise.
  Outcome decode(decode::Request frame, std::span<const std::byte> bytes,
                 const ReadProgress& progress);
  /// After Differs: a clause, "its JPEG frame has 64 x 32 pixels and the header says 512 x 512".
  const haptics::Message& difference() const { return difference_; }
  /// Pixels of the last decoded frame, valid until the next one: whole rows, values as bits.
  const std::byte* pixels() const { return memory_ + codestream_bytes_; }

 private:
  Decoder() = default;
  /// Receives the program's next answer (Decoded). Died if the program ended, TooLong after
  /// `seconds`, Cancelled on Cancel.
  Outcome listen(decode::Answer& answer, double seconds, const ReadProgress& progress);
  void end();

  pid_t process_ = -1;
  int socket_ = -1;
  std::byte* memory_ = nullptr;
  std::size_t codestream_bytes_ = 0, pixel_bytes_ = 0;
  haptics::Message difference_;
};

/// Decoders for the threads that read a series: one for each thread that is decoding.
class Decoders {
 public:
  /// For frames no larger than these sizes.
  Decoders(std::size_t codestream_bytes, std::size_t pixel_bytes)
      : codestream_bytes_{codestream_bytes}, pixel_bytes_{pixel_bytes} {}

  /// Returns a free decoder, or starts a new one.
  haptics::Expected<std::unique_ptr<Decoder>> take();
  /// Returns a decoder to the pool. Its process must still run.
  void give(std::unique_ptr<Decoder> decoder);

 private:
  std::size_t codestream_bytes_, pixel_bytes_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Decoder>> free_;
};

}  // namespace datasets

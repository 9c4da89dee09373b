// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

struct lws;
struct lws_context;

/// A WebSocket service on loopback that speaks as the one of the Inverse3 does, or as badly as a
/// test wants. It serves one connection at a time, on a thread of its own and a port that is free.
class Inverse3Service {
 public:
  /// One message to the client.
  struct Reply {
    std::string text = {};
    std::chrono::milliseconds delay{0};
    bool binary = false;
    int fragments = 1;
    bool closes = false;  ///< instead of a message
  };
  /// What it answers to the nth command of a connection, from 0 on. Called on its thread.
  using Answers = std::function<std::vector<Reply>(int n)>;

  /// One command that came.
  struct Command {
    std::string text;
    double x = 0.0, y = 0.0, z = 0.0;  ///< N, in the service's axes
    bool pushes() const { return x != 0.0 || y != 0.0 || z != 0.0; }
  };

  Inverse3Service();
  ~Inverse3Service();
  Inverse3Service(const Inverse3Service&) = delete;
  Inverse3Service& operator=(const Inverse3Service&) = delete;

  std::uint16_t port() const { return port_; }
  void greetWith(std::vector<Reply> greeting);
  void answerWith(Answers answers);
  void refuse(bool refuses) { refuses_ = refuses; }

  /// All that came, of all connections.
  std::vector<Command> commands() const;
  int connections() const { return connections_; }
  bool isConnected() const { return connected_; }

  static int told(lws* socket, int reason, void* in, std::size_t length);

 private:
  struct Due {
    Reply reply;
    std::chrono::steady_clock::time_point at;
  };
  void run();
  void queue(const std::vector<Reply>& replies);
  void receive(const std::string& part, bool last);
  int writeNext();

  mutable std::mutex mutex_;  ///< of greeting_, answers_ and commands_
  std::vector<Reply> greeting_;
  Answers answers_;
  std::vector<Command> commands_;

  // the service's thread
  std::deque<Due> due_;
  lws* socket_ = nullptr;
  std::string partial_;
  int commands_here_ = 0;
  int fragment_ = 0;  ///< of the first that is due

  lws_context* context_ = nullptr;
  std::uint16_t port_ = 0;
  std::atomic<bool> ending_{false}, refuses_{false}, connected_{false};
  std::atomic<int> connections_{0};
  std::thread thread_;
};

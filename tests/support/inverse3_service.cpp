// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/inverse3_service.h"

#include <libwebsockets.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace {

using Clock = std::chrono::steady_clock;

int callback(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t length) {
  return Inverse3Service::told(socket, int(reason), in, length);
}

const lws_protocols kProtocols[] = {{"service", callback, 0, 8192, 0, nullptr, 0},
                                    {nullptr, nullptr, 0, 0, 0, nullptr, 0}};

}  // namespace

Inverse3Service::Inverse3Service() {
  lws_set_log_level(0, nullptr);
  lws_context_creation_info creation{};
  creation.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
  creation.iface = "127.0.0.1";
  creation.port = 0;
  creation.protocols = kProtocols;
  creation.uid = creation.gid = static_cast<unsigned>(-1);
  creation.fd_limit_per_thread = 64;
  creation.user = this;
  context_ = lws_create_context(&creation);
  lws_vhost* const vhost = context_ == nullptr ? nullptr : lws_create_vhost(context_, &creation);
  if (vhost == nullptr) throw std::runtime_error("no port on loopback");
  port_ = static_cast<std::uint16_t>(lws_get_vhost_listen_port(vhost));
  thread_ = std::thread{[this] { run(); }};
}

Inverse3Service::~Inverse3Service() {
  ending_ = true;
  thread_.join();
  lws_context_destroy(context_);
}

void Inverse3Service::greetWith(std::vector<Reply> greeting) {
  const std::lock_guard lock{mutex_};
  greeting_ = std::move(greeting);
}

void Inverse3Service::answerWith(Answers answers) {
  const std::lock_guard lock{mutex_};
  answers_ = std::move(answers);
}

std::vector<Inverse3Service::Command> Inverse3Service::commands() const {
  const std::lock_guard lock{mutex_};
  return commands_;
}

void Inverse3Service::run() {
  while (!ending_) {
    lws_service(context_, -1);
    if (socket_ != nullptr && !due_.empty() && due_.front().at <= Clock::now())
      lws_callback_on_writable(socket_);
    else
      std::this_thread::sleep_for(std::chrono::microseconds{100});
  }
}

void Inverse3Service::queue(const std::vector<Reply>& replies) {
  for (const Reply& reply : replies) due_.push_back({reply, Clock::now() + reply.delay});
}

void Inverse3Service::receive(const std::string& part, bool last) {
  partial_ += part;
  if (!last) return;
  Command command{.text = std::exchange(partial_, {})};
  const auto read = nlohmann::json::parse(command.text);  // what is no JSON ends the test
  const auto& vector = read.at("inverse3").at(0).at("commands").at("set_cursor_force").at("vector");
  command.x = vector.at("x");
  command.y = vector.at("y");
  command.z = vector.at("z");
  const std::lock_guard lock{mutex_};
  commands_.push_back(std::move(command));
  if (answers_) queue(answers_(commands_here_));
  ++commands_here_;
}

int Inverse3Service::writeNext() {
  if (due_.empty() || due_.front().at > Clock::now()) return 0;
  const Reply& reply = due_.front().reply;
  if (reply.closes) return -1;
  // the nth of its fragments
  const std::size_t size = reply.text.size(), count = std::size_t(reply.fragments);
  const std::size_t from = size * std::size_t(fragment_) / count,
                    to = size * std::size_t(fragment_ + 1) / count;
  std::vector<unsigned char> bytes(LWS_PRE + to - from);
  std::copy(reply.text.begin() + std::ptrdiff_t(from), reply.text.begin() + std::ptrdiff_t(to),
            bytes.begin() + LWS_PRE);
  const bool last = fragment_ + 1 == reply.fragments;
  int how =
      fragment_ > 0 ? LWS_WRITE_CONTINUATION : (reply.binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT);
  if (!last) how |= LWS_WRITE_NO_FIN;
  const int written =
      lws_write(socket_, bytes.data() + LWS_PRE, to - from, lws_write_protocol(how));
  if (written < int(to - from)) return -1;
  fragment_ = last ? 0 : fragment_ + 1;
  if (last) due_.pop_front();
  return 0;
}

int Inverse3Service::told(lws* socket, int reason, void* in, std::size_t length) {
  auto* const self = static_cast<Inverse3Service*>(lws_context_user(lws_get_context(socket)));
  switch (reason) {
    case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION:
      return self->refuses_ ? 1 : 0;
    case LWS_CALLBACK_ESTABLISHED: {
      self->socket_ = socket;
      self->due_.clear();
      self->partial_.clear();
      self->commands_here_ = self->fragment_ = 0;
      self->connected_ = true;
      ++self->connections_;
      const std::lock_guard lock{self->mutex_};
      self->queue(self->greeting_);
      break;
    }
    case LWS_CALLBACK_RECEIVE:
      if (socket == self->socket_)
        self->receive(std::string{static_cast<const char*>(in), length},
                      lws_is_final_fragment(socket) != 0);
      break;
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return socket == self->socket_ ? self->writeNext() : 0;
    case LWS_CALLBACK_CLOSED:
      if (socket != self->socket_) break;
      self->socket_ = nullptr;
      self->connected_ = false;
      break;
    default:
      break;
  }
  return 0;
}

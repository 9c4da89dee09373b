// SPDX-License-Identifier: BSD-3-Clause
#include <hdf5.h>

#include <cerrno>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "app/export/channels.h"
#include "app/export/export.h"
#include "app/export/facts.h"
#include "app/export/fivrs.h"
#include "app/export/hdf5_tables.h"
#include "app/export/selection.h"
#include "app/export/text.h"
#include "haptics/process/output_file.h"

namespace app::exporting {

using haptics::Output;
using haptics::Step;

namespace {

/// The values of one column.
class ColumnTable {
 public:
  virtual ~ColumnTable() = default;
  virtual void add(const RecordedStep& row) = 0;
  virtual bool flush() = 0;
  virtual bool sound() const = 0;

  static std::unique_ptr<ColumnTable> of(const StepColumn& column, hid_t file);
};

template <class T>
class TypedColumnTable final : public ColumnTable {
 public:
  TypedColumnTable(const StepColumn& column, hid_t file)
      : column_{column}, table_{file, column.path, 0, column.unit, column.meaning} {}
  void add(const RecordedStep& row) override {
    withValue(column_, row, [&](auto value) { table_.add(static_cast<T>(value)); });
  }
  bool flush() override { return table_.flush(); }
  bool sound() const override { return table_.sound(); }

 private:
  const StepColumn& column_;
  Table<T> table_;
};

std::unique_ptr<ColumnTable> ColumnTable::of(const StepColumn& column, hid_t file) {
  // the type is that of any step's value
  return withValue(column, {}, [&](auto value) -> std::unique_ptr<ColumnTable> {
    return std::make_unique<TypedColumnTable<decltype(value)>>(column, file);
  });
}

/// All that has a row per step.
struct StepTables {
  StepTables(hid_t file, const Recording& recording)
      : time{file, "time", 0, "ns", "time since the recording began"},
        step{file, "step", 0, "", "number of the tick since the recording began"},
        device_position{file, "device/position", 3, "m", "device as it was read: x, y, z"},
        device_orientation{file, "device/orientation", 4, "1", "unit quaternion w, x, y, z"},
        proxy_position{file, "proxy/position", 3, "m", "proxy after the tick: x, y, z"},
        proxy_orientation{file, "proxy/orientation", 4, "1", "unit quaternion w, x, y, z"},
        force{file, "force", 3, "N", "force sent to the hand"},
        torque{file, "torque", 3, "N.m", "torque sent to the hand, about the device's origin"},
        friction{file, "friction_force", 3, "N", kFrictionMeaning} {
    for (const StepColumn& column : stepColumns())
      if (column.path != nullptr) columns.push_back(ColumnTable::of(column, file));
    if (recording.isCut()) {
      removed = std::make_unique<Table<double>>(file, "removed_volume", 0, "m3", kRemovedMeaning);
      drill = std::make_unique<DrillForce>(file);
    }
    distances = nearnessColumns(recording);
    for (const NearnessColumn& column : distances)
      near.push_back(std::make_unique<Table<float>>(file, column.path.c_str(), 0, "m",
                                                    column.meaning.c_str()));
  }

  void add(const RecordedStep& row) {
    const Step& tick = row.step;
    time.add(tick.time_ns);
    step.add(tick.sequence);
    device_position.add(row.device.data());
    device_orientation.add(row.device.data() + 3);
    proxy_position.add(row.proxy.data());
    proxy_orientation.add(row.proxy.data() + 3);
    force.add(tick.sent_W.force);
    torque.add(tick.sent_W.torque);
    friction.add(frictionOf(tick));
    if (removed) removed->add(tick.removed);
    if (drill) drill->add(tick);
    for (const auto& column : columns) column->add(row);
    for (std::size_t n = 0; n < near.size(); ++n) near[n]->add(distances[n].of(tick));
  }
  /// Calls f with each.
  template <class F>
  void visit(F&& f) {
    f(time), f(step), f(device_position), f(device_orientation), f(proxy_position),
        f(proxy_orientation), f(force), f(torque), f(friction);
    for (const auto& column : columns) f(*column);
    for (const auto& table : near) f(*table);
    if (removed) f(*removed);
    if (drill) f(drill->wrench), f(drill->time);
  }

  Table<std::int64_t> time;
  Table<std::uint64_t> step;
  Table<double> device_position, device_orientation, proxy_position, proxy_orientation;
  Table<double> force, torque, friction;
  std::vector<std::unique_ptr<ColumnTable>> columns;
  std::vector<NearnessColumn> distances;
  std::vector<std::unique_ptr<Table<float>>> near;
  // null: nothing was cut
  std::unique_ptr<Table<double>> removed;
  std::unique_ptr<DrillForce> drill;
};

/// The contacts of all steps, one after another, and where those of a step begin.
struct ContactTables {
  explicit ContactTables(hid_t file)
      : first{file, "contacts/first", 0, "",
              "row of the step's first contact below; tick/contacts tells how many follow"},
        arm{file, "contacts/arm", 3, "m", "the point about the tool's origin"},
        normal{file, "contacts/normal", 3, "1", "unit normal, out of the solid"},
        push{file, "contacts/push", 0, "N", "along the normal, by the coupling's stiffness"} {}

  void add(const Step& step) {
    first.add(push.rows());
    for (const haptics::BearingContact& contact : step.contacts) {
      arm.add(contact.r_W);
      normal.add(contact.n_W);
      push.add(static_cast<float>(contact.push));
    }
  }
  template <class F>
  void visit(F&& f) {
    f(first), f(arm), f(normal), f(push);
  }

  Table<std::int64_t> first;
  Table<float> arm, normal, push;
};

/// A table of words; what it is given must live until it is flushed.
struct Words : Table<const char*> {
  Words(hid_t file, const char* path, const char* meaning)
      : Words{file, path, meaning, textType()} {}

 private:
  Words(hid_t file, const char* path, const char* meaning, Handle type)
      : Table<const char*>{file, path, 0, "", meaning, type}, type_{std::move(type)} {}
  Handle type_;
};

bool writeEvents(hid_t file, std::span<const RecordedEvent> events) {
  Table<std::int64_t> time{file, "events/time", 0, "ns", "time since the recording began"};
  Table<std::uint64_t> step{file, "events/step", 0, "", "the step at or before which it happened"};
  Table<double> value{file, "events/value", 0, "", "its number; not a number: it has none"};
  Words kind{file, "events/kind", "what happened"}, note{file, "events/note", "its words"};
  std::vector<std::string> texts;
  texts.reserve(2 * kChunk);
  const auto flush = [&] {
    const bool sound =
        time.flush() && step.flush() && value.flush() && kind.flush() && note.flush();
    texts.clear();
    return sound;
  };
  for (const RecordedEvent& event : events) {
    if (texts.size() + 2 > texts.capacity() && !flush()) return false;
    time.add(event.time_ns);
    step.add(event.sequence);
    value.add(event.value.value_or(std::nan("")));
    kind.add(texts.emplace_back(plain(event.kind)).c_str());
    note.add(texts.emplace_back(plain(event.text)).c_str());
  }
  return flush();
}

/// Numbers become int64 or double, truths uint8, lists of lists matrices.
void attachAll(hid_t object, const nlohmann::ordered_json& facts) {
  for (const auto& [name, fact] : facts.items()) {
    if (fact.is_string()) {
      attach(object, name.c_str(), fact.get<std::string>());
    } else if (fact.is_boolean()) {
      attach(object, name.c_str(), static_cast<std::uint8_t>(fact.get<bool>()));
    } else if (fact.is_number_float()) {
      attach(object, name.c_str(), fact.get<double>());
    } else if (fact.is_number()) {
      attach(object, name.c_str(), fact.get<std::int64_t>());
    } else if (fact.front().is_array()) {
      std::vector<double> numbers;
      for (const auto& row : fact)
        for (const auto& number : row) numbers.push_back(number.get<double>());
      attach(object, name.c_str(), numbers.data(), {fact.size(), fact.front().size()});
    } else if (fact.front().is_number_integer()) {
      const auto numbers = fact.get<std::vector<std::int64_t>>();
      attach(object, name.c_str(), numbers.data(), {numbers.size()});
    } else {
      const auto numbers = fact.get<std::vector<double>>();
      attach(object, name.c_str(), numbers.data(), {numbers.size()});
    }
  }
}

void writeFacts(hid_t file, const Recording& recording) {
  attachAll(file, factsOf(recording));
  const Handle scenes{H5Gcreate2(file, "scenes", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
  for (const RecordedScene& scene : recording.scenes()) {
    const Handle group{
        H5Gcreate2(scenes, std::to_string(scene.id).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Gclose};
    attachAll(group, factsOf(scene));
  }
}

}  // namespace

haptics::Expected<Exported> exportHdf5(Recording& recording, const std::filesystem::path& out,
                                       const ExportOptions& options) {
  // a file that could not be written stays open in the library, which crashes at exit over it
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  auto output = Output::at(out);
  if (!output) return tl::unexpected(output.error());
  Exported exported;
  exported.files = {out.string()};
  int why = 0;  // errno of the first failure
  const auto note = [&](bool sound) {
    if (!sound && why == 0) why = errno == 0 ? EIO : errno;
    return why == 0;
  };
  const auto unwritable = [&] {
    // the library has it open still: give back the room
    std::error_code ignored;
    std::filesystem::resize_file(output->part(), 0, ignored);
    return tl::unexpected(output->unwritable(why));
  };
  errno = 0;
  // chunks are written whole: there is nothing to keep of them
  const Handle access{H5Pcreate(H5P_FILE_ACCESS), H5Pclose};
  H5Pset_cache(access, 0, 0, 0, 0.0);
  Handle file{H5Fcreate(output->part().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose};
  if (!note(file >= 0)) return unwritable();
  {
    StepTables steps{file, recording};
    std::optional<ContactTables> contacts;
    if (options.contacts) contacts.emplace(file);
    const auto done = forEachChosen(recording, options, [&](const RecordedStep& row) {
      steps.add(row);
      steps.visit([&](const auto& table) { note(table.sound()); });
      if (contacts) {
        contacts->add(row.step);
        contacts->visit([&](const auto& table) { note(table.sound()); });
      }
      ++exported.steps;
      return why == 0;
    });
    if (!done) return tl::unexpected(done.error());
    steps.visit([&](auto& table) { note(table.flush()); });
    if (contacts) contacts->visit([&](auto& table) { note(table.flush()); });
  }
  if (why == 0 && recording.isCut()) {
    const auto drilled = writeDrilling(file, recording, options, exported);
    if (!drilled) return tl::unexpected(drilled.error());
    note(*drilled);
  }
  const auto events = eventsChosen(recording, options);
  exported.events = static_cast<std::int64_t>(events.size());
  if (why == 0) note(writeEvents(file, events));
  if (why == 0) writeFacts(file, recording);
  note(file.close());
  if (why != 0) return unwritable();
  auto bytes = output->finish();
  if (!bytes) return tl::unexpected(bytes.error());
  exported.bytes = *bytes;
  return exported;
}

}  // namespace app::exporting

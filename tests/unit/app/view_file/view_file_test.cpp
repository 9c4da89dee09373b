// SPDX-License-Identifier: BSD-3-Clause
#include "app/view_file/view_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"
#include "tests/support/sentence.h"

namespace {

using app::ViewFile;
using nlohmann::json;

ViewFile someView() {
  ViewFile view;
  view.grid.dims = {512, 512, 361};
  view.grid.spacing = {0.45e-3, 0.45e-3, 0.8e-3};
  view.grid.origin = {-0.1152, -0.1152 / 3.0, 0.0};
  view.grid.direction = haptics::Vec3{1.0, -1.0, 1.0}.asDiagonal();  // left-handed
  view.type = haptics::ScalarType::Int16;
  view.hash.emplace();
  for (std::size_t i = 0; i < view.hash->size(); ++i)
    (*view.hash)[i] = static_cast<std::uint8_t>(7 * i);
  view.place = "../scans/head.nrrd";
  view.edits = {datasets::Crop{{{10, 20, 0}, {400, 500, 361}}}, datasets::RemoveHolder{300.1}};
  view.isovalue = 300.1;
  view.tool = "probe";
  view.tool_file = view.hash;
  view.tool_unit = "cm";
  view.X_WP = haptics::poseOf({0.01, -0.02, 0.125}, haptics::Quat{0.5, 0.5, -0.5, 0.5});
  view.marks = {
      {ui::MeasureKind::Distance, "Distance 1", {{1.0, 2.0, 3.0}, {4.0, 5.5, -6.25}}},
      {ui::MeasureKind::Angle, "Angle 1", {{0, 0, 0}, {10, 0, 0}, {10, 20, 0}}},
      {ui::MeasureKind::Point, "Canal", {{0.125, 0, 0}}},
      {ui::MeasureKind::Note, "Wall is thin here: ±1 mm, \xc3\xa4 \"x\" <b>", {{7, 8, 9}}}};
  view.look = {.eye_mm = {0, -600, 12},
               .focus_mm = {0, 0, 12},
               .up = {0, 0, 1},
               .parallel = true,
               .half_height_mm = 120.0,
               .colours = ui::SurfaceColours::Vessels,
               .second = -299.9,
               .second_opacity = 0.75,
               .cross_mm = {1, 2, 3},
               .grey_level = 200.0,
               .grey_width = 1600.0,
               .slices = {{{2.5, {3.0, -4.0}}, {1.0, {0, 0}}, {8.0, {0.5, 0}}, {3.0, {-6, 7}}}},
               .voxels = {.interpolation = ui::Interpolation::Nearest,
                          .slab = ui::SlabKind::Mean,
                          .thickness_mm = 7.3},
               .tool_plane = {.along = true, .depth_mm = -12.5},
               .layout = {.arrangement = ui::Arrangement::FourUp,
                          .tool_view = true,
                          .active = 4,
                          .alone = true,
                          .shares = {{1.25, 0.5, 1.5}, {0.75, 1, 1}, {1, 1}}}};
  return view;
}

std::string refusal(const std::string& text) {
  const auto view = app::viewFileFrom(text, "x.palpate-view");
  return view ? std::string("opened") : sentence(view.error());
}

TEST(ViewFile, ComesBackAsItWasSaved) {
  const support::ScratchFolder folder;
  const auto path = folder / "a.palpate-view";
  const ViewFile view = someView();
  ASSERT_TRUE(app::writeViewFile(path, view));
  const auto read = app::readViewFile(path);
  ASSERT_TRUE(read) << sentence(read.error());
  EXPECT_EQ(read->grid.dims, view.grid.dims);
  EXPECT_EQ(read->grid.spacing, view.grid.spacing);  // to the bit: geometry is compared exactly
  EXPECT_EQ(read->grid.origin, view.grid.origin);
  EXPECT_EQ(read->grid.direction, view.grid.direction);
  EXPECT_EQ(read->type, view.type);
  EXPECT_EQ(read->hash, view.hash);
  EXPECT_EQ(read->place, view.place);
  ASSERT_EQ(read->edits.size(), view.edits.size());
  for (std::size_t i = 0; i < view.edits.size(); ++i)
    EXPECT_EQ(datasets::textOf(read->edits[i]), datasets::textOf(view.edits[i]));
  EXPECT_EQ(read->isovalue, view.isovalue);
  EXPECT_EQ(read->tool, view.tool);
  EXPECT_EQ(read->tool_file, view.tool_file);
  EXPECT_EQ(read->tool_unit, "cm");
  ASSERT_TRUE(read->X_WP);
  EXPECT_EQ(read->X_WP->matrix(), view.X_WP->matrix());
  ASSERT_EQ(read->marks.size(), view.marks.size());
  for (std::size_t i = 0; i < view.marks.size(); ++i) {
    EXPECT_EQ(read->marks[i].kind, view.marks[i].kind);
    EXPECT_EQ(read->marks[i].text, view.marks[i].text);
    ASSERT_EQ(read->marks[i].places_mm.size(), view.marks[i].places_mm.size());
    for (std::size_t p = 0; p < view.marks[i].places_mm.size(); ++p)
      EXPECT_LT((read->marks[i].places_mm[p] - view.marks[i].places_mm[p]).norm(), 1e-12);  // mm
  }
  EXPECT_LT((read->look.eye_mm - view.look.eye_mm).norm(), 1e-9);
  EXPECT_LT((read->look.focus_mm - view.look.focus_mm).norm(), 1e-9);
  EXPECT_EQ(read->look.up, view.look.up);
  EXPECT_EQ(read->look.parallel, view.look.parallel);
  EXPECT_NEAR(read->look.half_height_mm, view.look.half_height_mm, 1e-9);
  EXPECT_LT((read->look.cross_mm - view.look.cross_mm).norm(), 1e-9);
  EXPECT_EQ(read->look.grey_level, view.look.grey_level);
  EXPECT_EQ(read->look.grey_width, view.look.grey_width);
  EXPECT_EQ(read->look.colours, ui::SurfaceColours::Vessels);
  EXPECT_EQ(read->look.second, -299.9);
  EXPECT_EQ(read->look.second_opacity, 0.75);
  EXPECT_EQ(read->look.voxels.interpolation, ui::Interpolation::Nearest);
  EXPECT_EQ(read->look.voxels.slab, ui::SlabKind::Mean);
  EXPECT_NEAR(read->look.voxels.thickness_mm, 7.3, 1e-9);
  EXPECT_TRUE(read->look.tool_plane.along);
  EXPECT_NEAR(read->look.tool_plane.depth_mm, -12.5, 1e-9);
  EXPECT_EQ(read->look.layout.arrangement, ui::Arrangement::FourUp);
  EXPECT_TRUE(read->look.layout.tool_view);
  EXPECT_EQ(read->look.layout.active, 4U);
  EXPECT_TRUE(read->look.layout.alone);
  EXPECT_EQ(read->look.layout.shares, view.look.layout.shares);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(read->look.slices[i].zoom, view.look.slices[i].zoom);
    EXPECT_LT((read->look.slices[i].shift_mm - view.look.slices[i].shift_mm).norm(), 1e-9);
  }
}

TEST(ViewFile, NamesNoPlaceAndNoToolUnlessItIsToldTo) {
  ViewFile view = someView();
  view.place.clear();
  view.tool.clear();
  view.hash.reset();
  const json words = json::parse(app::textOf(view));
  EXPECT_FALSE(words["scan"].contains("place"));
  EXPECT_FALSE(words.contains("tool"));
  const auto read = app::viewFileFrom(app::textOf(view), "x");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->place.empty());
  EXPECT_FALSE(read->hash);
}

TEST(ViewFile, KeepsEveryWordAndTheEndsOfTheThickness) {
  ViewFile view = someView();
  const auto again = [&] {
    const auto read = app::viewFileFrom(app::textOf(view), "x");
    EXPECT_TRUE(read) << sentence(read.error());
    return read ? read->look : ui::ViewLook{};
  };
  for (const auto arrangement : {ui::Arrangement::One, ui::Arrangement::FourUp,
                                 ui::Arrangement::VolumeLarge, ui::Arrangement::SlicesLarge}) {
    view.look.layout = {.arrangement = arrangement};
    EXPECT_EQ(again().layout.arrangement, arrangement);
    EXPECT_TRUE(again().layout.shares.empty());
  }
  for (const auto colours : {ui::SurfaceColours::Ivory, ui::SurfaceColours::Tissue}) {
    view.look.colours = colours;
    EXPECT_EQ(again().colours, colours);
  }
  view.look.voxels.interpolation = ui::Interpolation::Linear;
  EXPECT_EQ(again().voxels.interpolation, ui::Interpolation::Linear);
  for (const auto slab : {ui::SlabKind::None, ui::SlabKind::Maximum, ui::SlabKind::Minimum}) {
    view.look.voxels.slab = slab;
    EXPECT_EQ(again().voxels.slab, slab);
  }
  for (const double mm : {ui::SliceLook::kThinnest_mm, ui::SliceLook::kThickest_mm}) {
    view.look.voxels.thickness_mm = mm;
    EXPECT_NEAR(again().voxels.thickness_mm, mm, 1e-9);
  }
  view.look.second.reset();
  EXPECT_FALSE(again().second);
}

struct Damage {
  const char* what;
  std::function<void(json&)> done;
  const char* named;  ///< what the sentence names
};

TEST(ViewFile, RefusesEveryDamageByNameAndTakesNothing) {
  const std::vector<Damage> damages = {
      {"a later version", [](json& v) { v["palpate_view"] = 3; }, "later Palpate"},
      {"an earlier version", [](json& v) { v["palpate_view"] = 1; }, "earlier Palpate"},
      {"no version", [](json& v) { v.erase("palpate_view"); }, "no view of Palpate's"},
      {"version as text", [](json& v) { v["palpate_view"] = "1"; }, "palpate_view"},
      {"half a version", [](json& v) { v["palpate_view"] = 1.5; }, "palpate_view"},
      {"a field too many", [](json& v) { v["patient"] = "x"; }, "no view of Palpate's"},
      {"a field too many, deep", [](json& v) { v["view"]["grey"]["x"] = 1; },
       "no view of Palpate's"},
      {"no isovalue", [](json& v) { v.erase("isovalue"); }, "\"isovalue\" is missing"},
      {"isovalue as text", [](json& v) { v["isovalue"] = "300"; }, "\"isovalue\""},
      {"no isovalue but null", [](json& v) { v["isovalue"] = nullptr; }, "\"isovalue\""},
      {"no marks", [](json& v) { v.erase("marks"); }, "\"marks\" is missing"},
      {"scan is a list", [](json& v) { v["scan"] = json::array(); }, "\"scan\""},
      {"two sizes",
       [](json& v) {
         v["scan"]["dims"] = {5, 5};
       },
       "scan.dims"},
      {"no voxels", [](json& v) { v["scan"]["dims"][2] = 0; }, "scan.dims[2]"},
      {"absurd size", [](json& v) { v["scan"]["dims"][0] = 9'000'000'000; }, "scan.dims[0]"},
      {"huge unsigned", [](json& v) { v["scan"]["dims"][0] = ~std::uint64_t{0}; }, "scan.dims[0]"},
      {"half a voxel", [](json& v) { v["scan"]["dims"][1] = 5.5; }, "scan.dims[1]"},
      {"no spacing", [](json& v) { v["scan"]["spacing_m"][1] = 0.0; }, "scan.spacing_m"},
      {"spacing backwards", [](json& v) { v["scan"]["spacing_m"][1] = -1e-3; }, "scan.spacing_m"},
      {"far away", [](json& v) { v["scan"]["origin_m"][1] = 1e9; }, "scan.origin_m[1]"},
      {"axes askew", [](json& v) { v["scan"]["direction"][1] = 0.5; }, "scan.direction"},
      {"tool askew", [](json& v) { v["tool_place"]["axes"][1] = 0.5; }, "tool_place.axes"},
      {"tool mirrored",
       [](json& v) {
         for (json& x : v["tool_place"]["axes"]) x = -x.get<double>();
       },
       "tool_place.axes"},
      {"tool far away", [](json& v) { v["tool_place"]["at_m"][0] = 1e4; }, "tool_place.at_m[0]"},
      {"hash of a tool", [](json& v) { v["tool_file"]["hash"] = "ff"; }, "tool_file.hash"},
      {"eight of nine", [](json& v) { v["scan"]["direction"].erase(8); }, "scan.direction"},
      {"unknown voxels", [](json& v) { v["scan"]["scalar"] = "int64"; }, "scan.scalar"},
      {"short hash", [](json& v) { v["scan"]["hash"] = "00ff"; }, "scan.hash"},
      {"hash of other digits", [](json& v) { v["scan"]["hash"] = std::string(80, 'G'); },
       "scan.hash"},
      {"whole path", [](json& v) { v["scan"]["place"] = "/home/x/a.nrrd"; }, "scan.place"},
      {"empty path", [](json& v) { v["scan"]["place"] = ""; }, "scan.place"},
      {"path with a zero", [](json& v) { v["scan"]["place"] = std::string("a\0b", 3); },
       "scan.place"},
      {"edit is no text", [](json& v) { v["edits"][0] = 5; }, "edits[0]"},
      {"unknown edit", [](json& v) { v["edits"][1] = "{}"; }, "edits[1]"},
      {"too many edits", [](json& v) { v["edits"] = json(1001, "x"); }, "\"edits\""},
      {"unknown mark", [](json& v) { v["marks"][0]["kind"] = "volume"; }, "marks[0].kind"},
      {"one end", [](json& v) { v["marks"][0]["places_m"].erase(1); }, "marks[0].places_m"},
      {"three ends",
       [](json& v) {
         v["marks"][0]["places_m"].push_back({0, 0, 0});
       },
       "marks[0].places_m"},
      {"flat place",
       [](json& v) {
         v["marks"][1]["places_m"][2] = {0, 0};
       },
       "marks[1].places_m[2]"},
      {"place far away", [](json& v) { v["marks"][2]["places_m"][0][2] = 1e6; },
       "marks[2].places_m[0][2]"},
      {"mark without text", [](json& v) { v["marks"][3].erase("text"); },
       "\"marks[3].text\" is missing"},
      {"empty note", [](json& v) { v["marks"][3]["text"] = ""; }, "marks[3].text"},
      {"line feed in a note", [](json& v) { v["marks"][3]["text"] = "a\nb"; }, "marks[3].text"},
      {"bell in a note", [](json& v) { v["marks"][3]["text"] = "a\x07"; }, "marks[3].text"},
      {"control of the second set", [](json& v) { v["marks"][3]["text"] = "a\xc2\x9b"; },
       "marks[3].text"},
      {"line separator", [](json& v) { v["marks"][3]["text"] = "a\xe2\x80\xa8"; }, "marks[3].text"},
      {"long note", [](json& v) { v["marks"][3]["text"] = std::string(4001, 'a'); },
       "marks[3].text"},
      {"eye at the focus",
       [](json& v) { v["view"]["camera"]["focus_m"] = v["view"]["camera"]["eye_m"]; },
       "view.camera.focus_m"},
      {"no up",
       [](json& v) {
         v["view"]["camera"]["up"] = {0, 0, 0};
       },
       "view.camera.up"},
      {"up along the view",
       [](json& v) {
         v["view"]["camera"]["up"] = {0, 1, 0};
       },
       "view.camera.up"},
      {"parallel as number", [](json& v) { v["view"]["camera"]["parallel"] = 1; },
       "view.camera.parallel"},
      {"no height", [](json& v) { v["view"]["camera"]["half_height_m"] = 0; },
       "view.camera.half_height_m"},
      {"no grey", [](json& v) { v["view"]["grey"]["width"] = 0; }, "view.grey.width"},
      {"three slices", [](json& v) { v["view"]["slices"].erase(2); }, "view.slices"},
      {"no zoom", [](json& v) { v["view"]["slices"][1]["zoom"] = 0; }, "view.slices[1].zoom"},
      {"layout is a number", [](json& v) { v["view"]["layout"] = 4; }, "view.layout"},
      {"no layout", [](json& v) { v["view"].erase("layout"); }, "\"view.layout\" is missing"},
      {"unknown arrangement", [](json& v) { v["view"]["layout"]["arrangement"] = "six"; },
       "view.layout.arrangement"},
      {"a view too many", [](json& v) { v["view"]["layout"]["active"] = 5; }, "view.layout.active"},
      {"half a view", [](json& v) { v["view"]["layout"]["active"] = 1.5; }, "view.layout.active"},
      {"alone as text", [](json& v) { v["view"]["layout"]["alone"] = "no"; }, "view.layout.alone"},
      {"tool view as number", [](json& v) { v["view"]["layout"]["tool_view"] = 1; },
       "view.layout.tool_view"},
      {"no share", [](json& v) { v["view"]["layout"]["shares"][1][0] = 0; },
       "view.layout.shares[1][0]"},
      {"a huge share", [](json& v) { v["view"]["layout"]["shares"][0][2] = 11; },
       "view.layout.shares[0][2]"},
      {"a column without views", [](json& v) { v["view"]["layout"]["shares"][2] = {1.0}; },
       "view.layout.shares[2]"},
      {"six columns",
       [](json& v) {
         v["view"]["layout"]["shares"] = json(6, {1.0, 1.0});
       },
       "view.layout.shares"},
      {"no voxels' look", [](json& v) { v["view"].erase("voxels"); }, "\"view.voxels\" is missing"},
      {"unknown interpolation", [](json& v) { v["view"]["voxels"]["interpolation"] = "cubic"; },
       "view.voxels.interpolation"},
      {"unknown slab", [](json& v) { v["view"]["voxels"]["slab"] = 1; }, "view.voxels.slab"},
      {"slab without a thickness", [](json& v) { v["view"]["voxels"]["thickness_m"] = 0.0; },
       "view.voxels.thickness_m"},
      {"slab of a metre", [](json& v) { v["view"]["voxels"]["thickness_m"] = 1.0; },
       "view.voxels.thickness_m"},
      {"plane as text", [](json& v) { v["view"]["tool_plane"]["along"] = "yes"; },
       "view.tool_plane.along"},
      {"plane far away", [](json& v) { v["view"]["tool_plane"]["depth_m"] = 101; },
       "view.tool_plane.depth_m"},
      {"unknown colours", [](json& v) { v["view"]["surface"]["colours"] = "red"; },
       "view.surface.colours"},
      {"second as text", [](json& v) { v["view"]["surface"]["second"] = "skin"; },
       "view.surface.second"},
      {"second too large", [](json& v) { v["view"]["surface"]["second"] = 1e39; },
       "view.surface.second"},
      {"opacity above 1", [](json& v) { v["view"]["surface"]["second_opacity"] = 1.01; },
       "view.surface.second_opacity"},
      {"invisible", [](json& v) { v["view"]["surface"]["second_opacity"] = 0.0; },
       "view.surface.second_opacity"},
      {"no second", [](json& v) { v["view"]["surface"].erase("second"); },
       "\"view.surface.second\" is missing"},
      {"crosshair is text", [](json& v) { v["view"]["cross_m"][0] = "1"; }, "view.cross_m[0]"},
      {"a list",
       [](json& v) {
         v = json::array({1, 2});
       },
       "no view of Palpate's"},
      {"a number", [](json& v) { v = 5; }, "no view of Palpate's"},
  };
  const json sound = json::parse(app::textOf(someView()));
  ASSERT_EQ(refusal(sound.dump()), "opened");
  for (const Damage& damage : damages) {
    SCOPED_TRACE(damage.what);
    json damaged = sound;
    damage.done(damaged);
    const std::string words = refusal(damaged.dump());
    EXPECT_NE(words.find(damage.named), std::string::npos) << words;
    EXPECT_NE(words.find("x.palpate-view"), std::string::npos) << words;
  }
}

TEST(ViewFile, RefusesTextThatIsNoJsonOrNotWhole) {
  const std::string sound = app::textOf(someView());
  for (const std::string& text :
       {std::string{}, std::string("{"), sound.substr(0, sound.size() / 2), sound + "{}",
        std::string("\x89PNG\r\n"), std::string(100'000, '['), std::string("nan")})
    EXPECT_NE(refusal(text).find("no view of Palpate's"), std::string::npos) << text.substr(0, 20);
  const auto with = [&](const char* number) {
    std::string text = sound;
    const std::string before = "\"isovalue\": 300.1";
    text.replace(text.find(before), before.size(), std::string("\"isovalue\": ") + number);
    return refusal(text);
  };
  EXPECT_EQ(with("300.1"), "opened");
  for (const char* number : {"NaN", "Infinity", "1e999", "300.", ".5", "0x10", "1e", "-"})
    EXPECT_NE(with(number).find("no view of Palpate's"), std::string::npos) << number;
  EXPECT_NE(with("1e300").find("isovalue"), std::string::npos);
  // a text that is not UTF-8
  std::string broken = sound;
  broken.replace(broken.find("Canal"), 1, "\xff");
  EXPECT_NE(refusal(broken).find("no view of Palpate's"), std::string::npos);
}

TEST(ViewFile, RefusesWhatIsTooLargeAndWhatCannotBeRead) {
  const support::ScratchFolder folder;
  const auto large = folder.write("large.palpate-view", std::string(app::kMostViewBytes + 1, ' '));
  EXPECT_NE(sentence(app::readViewFile(large).error()).find("64 MB"), std::string::npos);
  EXPECT_NE(
      sentence(app::readViewFile(folder / "none.palpate-view").error()).find("cannot be opened"),
      std::string::npos);
  EXPECT_FALSE(app::readViewFile(folder.folder()));
  // 10,000 marks are read, one more is not
  json many = json::parse(app::textOf(someView()));
  json mark = {{"kind", "point"}, {"text", "p"}};
  mark["places_m"] = json::array({json::array({0, 0, 0})});
  many["marks"] = json(10'000, mark);
  EXPECT_EQ(refusal(many.dump()), "opened");
  many["marks"].push_back(mark);
  EXPECT_NE(refusal(many.dump()).find("\"marks\""), std::string::npos);
}

TEST(ViewFile, IsWrittenWholeOrNotAtAll) {
  const support::ScratchFolder folder;
  const auto path = folder.write("kept.palpate-view", "before");
  ViewFile view = someView();
  // too large: what was there stays
  view.marks.assign(7'000, {ui::MeasureKind::Note, std::string(10'000, 'n'), {{0, 0, 0}}});
  const auto refused = app::writeViewFile(path, view);
  ASSERT_FALSE(refused);
  EXPECT_NE(sentence(refused.error()).find("was not saved"), std::string::npos);
  std::ifstream in(path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "before");
  EXPECT_FALSE(app::writeViewFile(folder / "no/folder.palpate-view", someView()));
  EXPECT_EQ(folder.names().size(), 1u);
}

}  // namespace

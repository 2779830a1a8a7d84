// What goes into a page: text that cannot end its script, base64, and the tables of a sweep.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "sim/html/assets.h"
#include "sim/html/csv_file.h"
#include "sim/html/page.h"
#include "sim/html/run_data.h"
#include "sim/report/file.h"
#include "traces/error.h"
#include "unit/sim/temp_folder.h"

namespace artu::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Html, Base64IsThatOfTheStandard) {
  // RFC 4648, section 10.
  const char* const vectors[][2] = {{"", ""},
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64(std::string("\0\xff\xfe", 3)), "AP/+");
}

TEST(Html, JsonKeepsItsValueAndEndsNoScript) {
  const nlohmann::ordered_json data = {
      {"</script><!--", "<script>&amp;\xe2\x80\xa8\xe2\x80\xa9 \"quoted\" \\ \n \xc3\xa9 \xe2\x80\xa6"}, {"n", 1.5}};
  const std::string text = json_in_html(data);
  for (const char* wrong : {"<", ">", "&", "\xe2\x80\xa8", "\xe2\x80\xa9"}) EXPECT_THAT(text, Not(HasSubstr(wrong)));
  EXPECT_EQ(nlohmann::ordered_json::parse(text), data);
}

TEST(Html, WhatIsNoUtf8IsReplaced) {
  const std::string text = json_in_html({{"name", "\xff\xfe"}});
  EXPECT_EQ(nlohmann::json::parse(text)["name"], "\xef\xbf\xbd\xef\xbf\xbd");
}

TEST(Html, ThePageNamesNothingOutsideAndEscapesItsTitle) {
  const std::string page = html_page("</title><b>\"&", {{"runs", nlohmann::json::array()}});
  EXPECT_THAT(page, HasSubstr("<title>&lt;/title&gt;&lt;b&gt;&quot;&amp;</title>"));
  EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:; script-src 'sha256-"));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"")));
}

TEST(Html, AnAssetIsKnownByItsName) {
  EXPECT_THAT(std::string(html_asset("report.css")), HasSubstr("prefers-color-scheme"));
  EXPECT_EQ(html_asset("none.js"), "");
}

TEST(RunPictures, AreLeftOutEvenlyWhereTheyAreTooMany) {
  const test::TempFolder temporary;
  const std::string& folder = temporary.path();
  for (int frame = 5; frame < 13; ++frame) {
    for (const char* kind : {"frame", "class"}) {
      write_file(fmt::format("{}/{}_{:04}.png", folder, kind, frame), std::string(1000, 'x'));
    }
  }
  for (const char* other : {"strip_0005.png", "animation.png", "frame_x.png", "frame_0005.txt", "report.html"}) {
    write_file(folder + "/" + other, std::string(100000, 'x'));
  }
  const auto frames = [&](std::uint64_t bytes) {
    nlohmann::ordered_json run = {{"pictures", nlohmann::ordered_json::array()}};
    const std::size_t left_out = add_pictures(run, folder, bytes);
    std::vector<int> kept;
    for (const auto& picture : run["pictures"]) {
      if (picture["kind"] == "frame") kept.push_back(picture["frame"]);
    }
    EXPECT_EQ(run["pictures"].size(), 2 * kept.size());
    EXPECT_EQ(left_out, 8 - kept.size());
    EXPECT_LE(1000 * run["pictures"].size(), bytes);
    return kept;
  };
  EXPECT_THAT(frames(16000), ElementsAre(5, 6, 7, 8, 9, 10, 11, 12));
  EXPECT_THAT(frames(15999), ElementsAre(5, 7, 9, 11));
  EXPECT_THAT(frames(6000), ElementsAre(5, 8, 11));
  EXPECT_THAT(frames(5999), ElementsAre(5, 9));
  EXPECT_THAT(frames(1999), ElementsAre());
  EXPECT_THAT(frames(0), ElementsAre());
}

TEST(Csv, TakesQuotesCommasAndLineEndsInCells) {
  const test::TempFolder folder;
  const std::string file = folder.path("a.csv");
  write_file(file, "a,\"b \"\"c\"\"\",d\r\n1,\"2,\n3\",\n,,\n");
  const CsvFile csv = read_csv(file);
  EXPECT_THAT(csv.columns, ElementsAre("a", "b \"c\"", "d"));
  EXPECT_THAT(csv.rows, ElementsAre(ElementsAre("1", "2,\n3", ""), ElementsAre("", "", "")));
  write_file(file, "a,b\n\"1\n2\",3\n4\n");
  try {
    read_csv(file);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(".csv:4: has 1 cells; 2"));
  }
}

}  // namespace
}  // namespace artu::sim

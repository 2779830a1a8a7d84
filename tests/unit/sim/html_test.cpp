// What goes into a page: text that cannot end its script, base64, and the tables of a sweep.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim/html/assets.h"
#include "sim/html/csv_file.h"
#include "sim/html/page.h"
#include "sim/report/file.h"
#include "traces/error.h"

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

TEST(Csv, TakesQuotesCommasAndLineEndsInCells) {
  const std::string file = ::testing::TempDir() + "artu_html_test.csv";
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
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace artu::sim

#include "unit/sim/import_fixture.h"

namespace artu::sim::test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class GltfMaterial : public ImportTest {
 protected:
  traces::Material only(const Json& material) {
    g.j["materials"] = Json::array({material});
    g.j["nodes"] = Json::array();
    g.j["scenes"] = {{{"nodes", Json::array()}}};
    return open(g).scene().materials.at(0);
  }
  static Json pbr(double metallic, double roughness, const Json& color = {0.5, 0.25, 1, 1}) {
    return {{"baseColorFactor", color}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}};
  }
  void add_texture(const Json& sampler = nullptr) {
    g.add("images", {{"uri", "data:image/png;base64," + base64(png_2x1())}});
    Json texture = {{"source", 0}};
    if (!sampler.is_null()) {
      g.add("samplers", sampler);
      texture["sampler"] = 0;
    }
    g.add("textures", texture);
  }
  Gltf g;
};

TEST_F(GltfMaterial, ARoughDielectricIsDiffuse) {
  const auto m = only({{"name", "wall"}, {"pbrMetallicRoughness", pbr(0, 1)}});
  EXPECT_EQ(m.name, "wall");
  EXPECT_THAT(xyz(m.diffuse), near({0.5, 0.25, 1}));
  EXPECT_THAT(xyz(m.mirror), near({0, 0, 0}));
  EXPECT_EQ(m.specular_log2, 0u);
  EXPECT_FALSE(m.tint);
}

TEST_F(GltfMaterial, ASmoothMetalIsATintedMirror) {
  const auto m = only({{"pbrMetallicRoughness", pbr(1, 0)}});
  EXPECT_THAT(xyz(m.diffuse), near({0, 0, 0}));
  EXPECT_THAT(xyz(m.mirror), near({0.5, 0.25, 1}));
  EXPECT_EQ(m.specular_log2, 10u);
  EXPECT_TRUE(m.tint);
}

TEST_F(GltfMaterial, ARoughMetalIsNotBlack) {
  const auto m = only({{"pbrMetallicRoughness", pbr(1, 0.8)}});
  EXPECT_THAT(xyz(m.diffuse), near({0.4, 0.2, 0.8}));
  EXPECT_THAT(xyz(m.mirror), near({0.02, 0.01, 0.04}));
}

TEST_F(GltfMaterial, TheMetallicRoughnessTextureCountsByItsAverage) {
  add_texture();  // G: 0 and 128, mean 64; B: 0 and 255, mean 127.5
  Json p = pbr(1, 1, {1, 1, 1, 1});
  p["metallicRoughnessTexture"] = {{"index", 0}};
  const auto m = only({{"pbrMetallicRoughness", p}});
  const float rough = 64 / 255.0f, metal = 0.5f;
  EXPECT_THAT(xyz(m.diffuse), near({1 - metal + metal * rough, 1 - metal + metal * rough, 1 - metal + metal * rough}));
  EXPECT_THAT(log, Contains(HasSubstr("metallic-roughness texture is reduced")));
}

TEST_F(GltfMaterial, GlassWithAnIorBends) {
  const auto m = only(
      {{"pbrMetallicRoughness", pbr(0, 0)},
       {"extensions",
        {{"KHR_materials_transmission", {{"transmissionFactor", 0.75}}}, {"KHR_materials_ior", {{"ior", 1.33}}}}}});
  EXPECT_THAT(xyz(m.transmission), near({0.375, 0.1875, 0.75}));
  EXPECT_THAT(xyz(m.diffuse), near({0.125, 0.0625, 0.25}));
  EXPECT_FLOAT_EQ(m.ior, 1.33f);
}

TEST_F(GltfMaterial, GlassWithoutVolumeIsAThinSheet) {
  const auto m = only({{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}}},
                       {"pbrMetallicRoughness", pbr(0, 0.2)}});
  EXPECT_EQ(m.ior, 1.0f);
  EXPECT_THAT(log, Contains(HasSubstr("thin sheet")));
}

TEST_F(GltfMaterial, BlendBecomesTransmission) {
  const auto m = only({{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", pbr(0, 1, {1, 1, 1, 0.25})}});
  EXPECT_THAT(xyz(m.transmission), near({0.75, 0.75, 0.75}));
  EXPECT_THAT(xyz(m.diffuse), near({0.25, 0.25, 0.25}));
  EXPECT_EQ(m.ior, 1.0f);
  EXPECT_THAT(log, Contains(HasSubstr("alphaMode BLEND")));
}

TEST_F(GltfMaterial, MaskIsOpaque) {
  EXPECT_THAT(xyz(only({{"alphaMode", "MASK"}}).transmission), near({0, 0, 0}));
  EXPECT_THAT(log, Contains(HasSubstr("MASK")));
}

TEST_F(GltfMaterial, EmissionHasAStrength) {
  const auto m = only({{"emissiveFactor", {1, 0.5, 0}},
                       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}});
  EXPECT_THAT(xyz(m.emission), near({4, 2, 0}));
}

TEST_F(GltfMaterial, UnlitWithoutATextureShines) {
  const auto m = only({{"pbrMetallicRoughness", pbr(0, 1)}, {"extensions", {{"KHR_materials_unlit", Json::object()}}}});
  EXPECT_THAT(xyz(m.emission), near({0.5, 0.25, 1}));
  EXPECT_THAT(xyz(m.diffuse), near({0, 0, 0}));
}

TEST_F(GltfMaterial, SpecularGlossinessIsRead) {
  const auto m =
      only({{"extensions",
             {{"KHR_materials_pbrSpecularGlossiness",
               {{"diffuseFactor", {0.5, 0.5, 0, 1}}, {"specularFactor", {0.5, 0.5, 0.5}}, {"glossinessFactor", 1}}}}}});
  EXPECT_THAT(xyz(m.diffuse), near({0.25, 0.25, 0}));
  EXPECT_THAT(xyz(m.mirror), near({0.5, 0.5, 0.5}));
}

TEST_F(GltfMaterial, TexturesKeepTexelsAndWrapModes) {
  add_texture({{"wrapS", 33071}, {"wrapT", 33648}});
  Json p = pbr(0, 1);
  p["baseColorTexture"] = {{"index", 0}};
  const auto m = only({{"pbrMetallicRoughness", p}});
  ASSERT_EQ(m.texture, 0);
  const traces::Texture& t = source->scene().textures.at(0);
  EXPECT_EQ(t.wrap_u, traces::Wrap::clamp);
  EXPECT_EQ(t.wrap_v, traces::Wrap::mirror);
  EXPECT_THAT(t.rgba, ElementsAre(255, 0, 0, 255, 0, 128, 255, 255));
}

}  // namespace
}  // namespace artu::sim::test

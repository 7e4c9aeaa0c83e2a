#include "models/hard_files.h"

#include "models/program_runner.h"

#include "test_paths.h"

#include "image/image_writer.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace softgl::test {
namespace {

// The square from -1 to 1.
const std::string kSquare = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";
const std::string kCoordinates = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const std::string kFace = "f 1 2 3 4\n";
const std::string kTextured = "f 1/1 2/2 3/3 4/4\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string format(const char* pattern, double a, double b) {
  char text[120];
  std::snprintf(text, sizeof text, pattern, a, b);
  return text;
}

std::string ring(int corners) {
  std::string text, face = "f";
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    text += format("v %.7f %.7f 0\n", std::cos(angle), std::sin(angle));
    face += " " + std::to_string(i + 1);
  }
  return text + face + "\n";
}

std::string utf16(const std::string& text) {
  std::string wide = "\xff\xfe";
  for (const char c : text) (wide += c) += '\0';
  return wide;
}

std::string rubbish() {
  std::string bytes;
  for (int i = 0; i < 5000; ++i) bytes += char((i * 151 + 29) % 256);
  return bytes;
}

std::string squares_of_materials(const std::vector<std::string>& materials, const std::string& face) {
  std::string text;
  for (size_t i = 0; i < materials.size(); ++i) {
    const std::string x = std::to_string(i), next = std::to_string(i + 1);
    text += "v " + x + " 0 0\nv " + next + " 0 0\nv " + next + " 1 0\nv " + x + " 1 0\nusemtl " +
            materials[i] + "\n" + face;
  }
  return text;
}

std::string many_unknown_materials() {
  std::string text = "mtllib red.mtl\n" + kSquare;
  for (int i = 0; i < 20000; ++i)
    text += "usemtl red\nf 1 2 3\nusemtl stranger" + std::to_string(i) + "\nf 1 3 4\n";
  return text;
}

HardFile good(const char* name, std::string text, uint64_t triangles, std::vector<std::string> warnings = {},
              double area = -1) {
  HardFile file;
  file.name = name;
  file.text = std::move(text);
  file.triangles = triangles;
  file.warnings = std::move(warnings);
  file.area = area;
  return file;
}

HardFile bad(const char* name, std::string text, const char* error, std::vector<std::string> warnings = {}) {
  HardFile file = good(name, std::move(text), 0, std::move(warnings));
  file.exit_code = 3;
  file.error = error;
  return file;
}

HardFile elements(const char* name, std::string text, uint64_t segments, uint64_t points) {
  HardFile file = good(name, std::move(text), 0);
  file.segments = segments;
  file.points = points;
  return file;
}

std::vector<HardFile> make_files() {
  const std::string square_face = kSquare + kFace, red = "mtllib red.mtl\n" + kSquare;
  const auto textured = [](const char* material) {
    return "mtllib maps.mtl\n" + kSquare + kCoordinates + "usemtl " + material + "\n" + kTextured;
  };
  std::string control_points;
  for (int i = 0; i < 16; ++i)
    control_points += "v " + std::to_string(i % 4) + " " + std::to_string(i / 4) + " 0.5\n";
  return {
      good("01_negative_indices", kSquare + "f -4 -3 -2\nf -4 -2 -1\nv 2 -1 0\nv 2 1 0\nf -5 -2 -1 -4\n", 4),
      good("02_quads", square_face, 2, {}, 4),
      good("03_ngon_convex", ring(16), 14),
      good("04_concave_arrow", "v -1 -1 0\nv 0 -0.3 0\nv 1 -1 0\nv 0 1 0\n" + kFace, 2, {}, 1.3),
      good("05_concave_comb",
           "v 0 0 0\nv 5 0 0\nv 5 3 0\nv 4 3 0\nv 4 1 0\nv 3 1 0\nv 3 3 0\nv 2 3 0\nv 2 1 0\nv 1 1 0\nv 1 3 "
           "0\nv 0 3 0\n"
           "f 1 2 3 4 5 6 7 8 9 10 11 12\n",
           10, {}, 11),
      good("06_hole_bridged",
           "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\n",
           8, {}, 12),
      good("07_nonplanar_quad", "v -1 -1 0\nv 1 -1 1\nv 1 1 0\nv -1 1 1\n" + kFace, 2),
      good("08_degenerate_faces", kSquare + "f 1\nf 1 2\nf 1 1 2\nf 1 2 3\nf\n", 2,
           {"08_degenerate_faces.obj:5: ", "three corners"}, 2),
      good("09_no_normals_cube",
           "v -1 -1 -1\nv -1 -1 1\nv -1 1 -1\nv -1 1 1\nv 1 -1 -1\nv 1 -1 1\nv 1 1 -1\nv 1 1 1\n"
           "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n",
           12, {}, 24),
      good("10_partial_normals", kSquare + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n", 2),
      good("11_zero_normals", kSquare + "vn 0 0 0\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n", 2,
           {":5: this normal has no direction"}),
      good("12_unnormalized_normals", kSquare + "vn 0 0 5\nvn 0 0 0.01\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n",
           2),
      good("13_mtllib_missing", "mtllib nowhere.mtl\n" + kSquare + "usemtl red\n" + kFace, 2,
           {":1: material library \"nowhere.mtl\" not found", "\"red\" is unknown"}),
      good("14_usemtl_unknown", red + "usemtl stranger\nf 1 2 3\nusemtl red\nf 1 3 4\n", 2,
           {":6: material \"stranger\" is unknown"}),
      good("15_usemtl_no_mtllib", kSquare + "usemtl red\n" + kFace, 2, {"\"red\" is unknown"}),
      good("16_crlf", replaced("mtllib red_crlf.mtl\n" + kSquare + "usemtl red\n" + kFace, "\n", "\r\n"), 2),
      good("17_cr_only", replaced(square_face, "\n", "\r"), 2),
      good("18_line_continuation", "v -1 \\\n-1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 \\\n 3 4\n", 2),
      good("19_line_continuation_crlf", replaced(kSquare + "f 1 2 \\\n3 4\n", "\n", "\r\n"), 2),
      good("20_no_final_newline", kSquare + "f 1 2 3 4", 2),
      good("21_tabs_spaces",
           "\t v\t-1   -1\t0  \n  v 1 -1 0\nv  1\t1 0\t\nv -1 1 0\n\n\n f\t1  2   3\t4   \n", 2),
      good("22_bom", "\xef\xbb\xbf" + square_face, 2),
      bad("23_utf16_unmarked", utf16(square_face).substr(2), "UTF-16"),
      good("23_utf16le", utf16(square_face), 2),
      bad("24_freeform_curve",
          "v 0 0 0\nv 1 2 0\nv 2 -2 0\nv 3 0 0\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n",
          "no geometry", {"free-form geometry ignored"}),
      good("25_freeform_surface_plus_mesh",
           square_face + control_points +
               "cstype bspline\ndeg 3 3\nsurf 0 1 0 1 5 6 7 8 9 10 \\\n 11 12 13 14 15 16 17 18 19 20\n"
               "parm u 0 0 0 0 1 1 1 1\nparm v 0 0 0 0 1 1 1 1\nend\n",
           2, {"free-form geometry ignored"}),
      elements("26_lines", kSquare + "l 1 2 3 4 1\n", 4, 0),
      elements("27_points", kSquare + "p 1 2 3 4\n", 0, 4),
      good("28_vertex_colors", "v -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 1 1 0 0 0 1\nv -1 1 0 1 1 1\n" + kFace, 2),
      good("29_vertex_w", replaced(kSquare, "0\n", "0 1.0\n") + kFace, 2),
      good("30_index_out_of_range", kSquare + "f 1 2 3\nf 1 2 9\nf 1 2 -9\n", 1,
           {":6: a corner names a vertex", ":7: a corner names a vertex"}),
      good("31_index_zero", kSquare + "f 1 2 3\nf 0 1 2\n", 1, {":6: "}),
      good("32_index_huge",
           kSquare + "f 1 2 3\nf 1 2 99999999999999999999\nf 1 2 4294967297\nf 1 2 2147483648\n", 1,
           {":6: ", ":7: ", ":8: "}),
      good(
          "33_nan_inf",
          "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv nan 1 0\nv inf 1 0\nv 1 -inf 0\nf 1 2 3\nf 1 3 4\nf 1 3 5\nf 1 3 "
          "6\n",
          1,
          {":4: this vertex is not a finite place", ":8: a corner names a vertex that is not a finite place"},
          2),
      good("34_number_formats",
           "v -1. -1.0e0 +0\nv +1 -1E+00 .0\nv 1.000000000000000000000001 1 -0.0\nv -1 100e-2 0e5\n" + kFace,
           2, {}, 4),
      good("35_number_garbage", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv 0x1 abc --3\nv 1,5 2,5 0\nv\nf 1 2 3\n", 1,
           {":4: a vertex needs three numbers", ":5: ", ":6: "}),
      good("36_smoothing_groups",
           "v -1 0 0\nv 1 0 0\nv -1 0 -1\nv 1 0 -1\nv -1 1 -2\nv 1 1 -2\nv -1 2 -2\nv 1 2 -2\ns 1\nf 1 2 4 "
           "3\nf 3 4 6 5\ns 2\nf 5 6 8 7\n",
           6),
      good("37_smoothing_off_vs_on",
           "v -1 0 0\nv 1 0 0\nv -1 0 -1\nv 1 0 -1\nv -1 1 -1\nv 1 1 -1\ns off\nf 1 2 4 3\nf 3 4 6 5\ns 0\nf "
           "1 2 4 3\n",
           6),
      good("38_mtllib_with_spaces", "mtllib name with spaces.mtl\n" + kSquare + "usemtl red\n" + kFace, 2),
      good("39_mtllib_multiple",
           "mtllib first.mtl second.mtl\n" + kSquare + "usemtl first\nf 1 2 3\nusemtl second\nf 1 3 4\n", 2),
      good("40_map_options", textured("options"), 2),
      good("41_map_spaces", textured("spaces"), 2),
      good("42_map_backslash", textured("backslash"), 2),
      good("43_map_missing_file", replaced(textured("missing"), "maps.mtl", "missing_map.mtl"), 2,
           {"missing_map.mtl:3: picture \"nowhere.png\" not found"}),
      good("44_map_bump_opts", textured("bump"), 2),
      good("45_tr_vs_d",
           "mtllib transparency.mtl\n" + kSquare +
               "v 2 -1 0\nv 2 1 0\nusemtl m1\nf 1 2 3\nusemtl m2\nf 1 3 4\nusemtl m3\nf 2 5 6\nusemtl m4\nf "
               "2 6 3\n",
           4),
      good("46_pbr_ext", "mtllib pbr.mtl\n" + kSquare + kCoordinates + "usemtl p\n" + kTextured, 2),
      good("47_illum_and_ns",
           "mtllib illum.mtl\n" +
               squares_of_materials({"i0", "i1", "i2", "i3", "i4", "i5", "i6", "i7", "i8", "i9", "i10"},
                                    "f -4 -3 -2 -1\n"),
           22, {"illum.mtl:", "needs a number"}),
      good("48_kd_forms",
           "mtllib kd.mtl\n" +
               squares_of_materials({"one", "none", "spec", "xyz", "big", "indented"}, "f -4 -3 -2\n"),
           6,
           {"kd.mtl:", "\"Kd\" needs one or three numbers", "outside 0..1", "defined again",
            "newmtl needs a name"}),
      good("49_usemtl_before_mtllib", "usemtl red\n" + kSquare + "f 1 2 3\nmtllib red.mtl\nf 1 3 4\n", 2),
      good("50_forward_reference", kFace + kSquare, 2),
      bad("51_empty", "", "no geometry; the file is empty"),
      bad("52_only_comments", "# nothing\n#\n", "no geometry"),
      good("53_inline_comments", "v -1 -1 0 # a\nv 1 -1 0#b\nv 1 1 0\nv -1 1 0\nf 1 2 3 4 # quad\n", 2),
      good("54_face_10000", ring(10000), 9998),
      good("55_groups_objects",
           "o first thing\ng a b c\n" + kSquare + "f 1 2 3\ng\no second\nf 1 3 4\ng default off\n", 2),
      good("56_call_csh", "csh touch executed.txt\ncall other.obj\ncsh -rm -rf executed\n" + square_face, 2,
           {"\"csh\" is never executed (2 times)", "\"call\" is never executed"}),
      good("57_mtllib_traversal",
           "mtllib ../../../../../../../../etc/hostname\nmtllib /etc/passwd\n" + square_face, 2,
           {":1: material library \"../../../../../../../../etc/hostname\" not found in the model's folder",
            ":2: material library \"/etc/passwd\" not found in the model's folder"}),
      good("58_scale_huge", replaced(kSquare, "1 ", "1e30 ") + kFace, 2),
      good("59_scale_tiny", replaced(kSquare, "1 ", "1e-30 ") + kFace, 2),
      good("60_far_from_origin",
           "v 500000 5400000 100\nv 500001 5400000 100\nv 500001 5400001 100\nv 500000 5400001 101\n" + kFace,
           2),
      good("61_flat_bbox", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n", 1, {}, 0),
      good("62_winding_mixed", kSquare + "f 1 2 3\nf 1 4 3\n", 2),
      good("63_uv_wrap",
           "mtllib maps.mtl\n" + kSquare +
               "vt -1.5 -1.5\nvt 2.5 -1.5\nvt 2.5 2.5 0\nvt 0.5\nusemtl options\n" + kTextured,
           2),
      good("64_slash_forms",
           kSquare + kCoordinates +
               "vn 0 0 1\nf 1/ 2/ 3/\nf 1// 3// 4//\nf 1/1/ 2/2/ 3/3/\nf 1//1 2//1 3//1\nf 1/1/1 2/2/1 "
               "3/3/1\nf 1/1 2 3//1\n",
           6),
      good("65_uv_index_bad", kSquare + kCoordinates + "f 1/1 2/2 3/9\nf 1/1 3/3 4/-9\n", 2,
           {":9: a corner names a texture coordinate that does not exist", ":10: "}),
      bad("66_binary_garbage", rubbish(), "no geometry"),
      good("67_nul_bytes", replaced(square_face, "v 1 1", std::string("v\0 1 1", 6)), 2),
      good("68_unknown_statements",
           kSquare +
               "lod 1\nmaplib x.map\nusemap off\nshadow_obj s.obj\ntrace_obj t.obj\nctech cparm 1\nbevel "
               "on\nbevel off\nc_interp on\nd_interp on\nmg 1 0.5\n" +
               kFace,
           2, {":5: unknown statement \"lod\"", "\"bevel\" ignored (2 times)", "\"mg\""}),
      good("69_fo_old_face", kSquare + "fo 1 2 3 4\n", 2),
      bad("70_html_404", "<!DOCTYPE html>\n<html><body>404 Not Found</body></html>\n",
          "no geometry; file looks like HTML"),
      bad("71_lfs_pointer", "version https://git-lfs.github.com/spec/v1\noid sha256:0000\nsize 12345\n",
          "no geometry; file is a Git LFS pointer"),
      good("72_long_line", "# " + std::string(2000000, 'x') + "\n" + square_face, 2),
      good("73_many_unknown_materials", many_unknown_materials(), 40000,
           {":8: material \"stranger0\" is unknown", "19997 more times"}),
      good("74_unicode_names",
           "mtllib gr\xc3\xbcn.mtl\n" + kSquare + "g W\xc3\xbcrfel\nusemtl gr\xc3\xbcn\n" + kFace, 2),
  };
}

std::string checker_png() {
  cli::Picture picture;
  picture.width = picture.height = 16;
  uint8_t* out = picture.pixels.extend(16 * 16 * 3);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const bool white = (x / 4 + y / 4) % 2;
      *out++ = white ? 255 : 200;
      *out++ = white ? 255 : 30;
      *out++ = white ? 255 : 30;
    }
  const auto bytes = cli::encode_image(picture, "png", cli::PngEffort::kDefault);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<std::pair<std::string, std::string>> make_companions() {
  std::string illum;
  const char* shininess[] = {"10", "0", "128", "1000", "-5", "1e6", "", "x", "10", "10", "10"};
  for (int i = 0; i <= 10; ++i)
    illum += "newmtl i" + std::to_string(i) + "\nKa .1 .1 .1\nKd .6 .3 .1\nKs 1 1 1\nNs " + shininess[i] +
             "\nillum " + std::to_string(i) + "\n";
  return {
      {"red.mtl", "newmtl red\nKa 0.1 0 0\nKd 0.8 0.1 0.1\nKs 1 1 1\nNs 50\n"},
      {"red_crlf.mtl", "newmtl red\r\nKd 0.8 0.1 0.1\r\n"},
      {"name with spaces.mtl", "newmtl red\nKd 0.8 0.1 0.1\n"},
      {"first.mtl", "newmtl first\nKd 1 0 0\n"},
      {"second.mtl", "newmtl second\nKd 0 1 0\n"},
      {"checker.png", checker_png()},
      {"my checker 01.png", checker_png()},
      {"maps.mtl",
       "newmtl options\nKd 1 1 1\nmap_Kd -s 2 2 1 -o 0.25 0 0 -mm 0 1 -clamp off -blendu on -texres 16 "
       "checker.png\n"
       "newmtl spaces\nKd 1 1 1\nmap_Kd my checker 01.png\nnewmtl backslash\nKd 1 1 1\nmap_Kd "
       ".\\checker.png\n"
       "newmtl bump\nKd 1 1 1\nmap_Bump -bm 0.5 checker.png\nbump checker.png\nmap_Kd checker.png\n"},
      {"missing_map.mtl", "newmtl missing\nKd 0 0 1\nmap_Kd nowhere.png\n"},
      {"transparency.mtl", "newmtl m1\nKd 1 0 0\nd 1.0\nTr 0.0\nnewmtl m2\nKd 0 1 0\nTr 1.0\nd 1.0\nnewmtl "
                           "m3\nKd 0 0 1\nTr 0.5\nnewmtl m4\nKd 1 1 0\nd -halo 0.5\n"
                           "newmtl lone\nKd 1 1 1\nTr 1.000000\n"},
      {"pbr.mtl", "newmtl p\nKd 0.8 0.4 0.1\nPr 0.3\nPm 0.9\nPs 0.1\nPc 0.5\nPcr 0.1\naniso 0.2\nanisor "
                  "0.1\nmap_Pr checker.png\nmap_Pm checker.png\nnorm checker.png\nKe 0.1 0 0\n"},
      {"illum.mtl", illum},
      {"kd.mtl", "newmtl one\nKd 0.5\nnewmtl none\nKd\nnewmtl spec\nKd spectral foo.rfl 1.0\nnewmtl xyz\nKd "
                 "xyz 0.3 0.3 0.3\nnewmtl big\nKd 5 -1 255\n"
                 "newmtl one\nKd 0 1 0\n  newmtl indented\n\tKd 0 0 1\nnewmtl\nKd 1 0 1\nKD 1 1 0\nMAP_KD "
                 "checker.png\n"},
      {"gr\xc3\xbcn.mtl", "newmtl gr\xc3\xbcn\nKd 0.1 0.8 0.1\n"},
  };
}

} // namespace

const std::vector<HardFile>& hard_files() {
  static const std::vector<HardFile> files = make_files();
  return files;
}

const HardFile& hard_file(const std::string& name) {
  for (const HardFile& file : hard_files())
    if (file.name == name) return file;
  throw std::runtime_error("no hard file " + name);
}

const std::vector<std::pair<std::string, std::string>>& hard_file_companions() {
  static const auto companions = make_companions();
  return companions;
}

std::string write_hard_files() {
  const std::string folder = output_folder("hard-files");
  const auto write = [&folder](const std::string& name, const std::string& bytes) {
    std::ofstream(folder + name, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  };
  for (const auto& [name, bytes] : hard_file_companions()) write(name, bytes);
  for (const HardFile& file : hard_files()) write(file.name + ".obj", file.text);
  return folder;
}

} // namespace softgl::test

#include "common/drawings/write_drawing.h"

#include <gtest/gtest.h>

#include <string>

#include "common/files/file_error.h"

namespace kerf::core::drawings {
namespace {

/// A square of 10 units with a square hole of 4, and a chain.
Drawing some_drawing()
{
    Drawing drawing;
    DrawnLayer& layer = drawing.layers.emplace_back();
    layer.height = 0.5;
    layer.paths.push_back(
        {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{0, 0, 5}, {10, 0, 5}, {10, 10, 5}, {0, 10, 5}}, true, false, 0});
    layer.paths.push_back(
        {{{3, 3}, {3, 7}, {7, 7}, {7, 3}}, {{3, 3, 5}, {3, 7, 5}, {7, 7, 5}, {7, 3, 5}}, true, true, 0});
    layer.paths.push_back({{{-2, 1}, {-1, 4}}, {{-2, 1, 5}, {-1, 4, 5}}, false, false, 2});
    return drawing;
}

std::size_t count_of(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(Drawings, OfSvgHaveTheirTrueSizeAndAPathForEachShape)
{
    const std::string svg = drawing_bytes(some_drawing(), "svg");
    EXPECT_NE(svg.find("width=\"12mm\" height=\"10mm\" viewBox=\"-2 -10 12 10\""), std::string::npos) << svg;
    EXPECT_EQ(count_of(svg, "<path"), 2u) << "the hole belongs to its loop";
    EXPECT_NE(svg.find("M0 0L10 0L10 -10L0 -10Z\nM3 -3L3 -7L7 -7L7 -3Z"), std::string::npos) << "y points upwards";
    EXPECT_NE(svg.find("fill-rule=\"evenodd\""), std::string::npos);
    EXPECT_NE(svg.find("data-height=\"0.5\""), std::string::npos);
    EXPECT_NE(svg.find("M-2 -1L-1 -4\""), std::string::npos);
}

TEST(Drawings, OfSeveralLayersInSvgAreContours)
{
    Drawing drawing = some_drawing();
    EXPECT_EQ(count_of(drawing_bytes(drawing, "svg"), "fill=\"#333\""), 1u);
    drawing.layers.push_back(drawing.layers.front());
    const std::string svg = drawing_bytes(drawing, "svg");
    EXPECT_EQ(count_of(svg, "fill=\"#333\""), 0u) << "no layer hides another";
    EXPECT_EQ(count_of(svg, "fill=\"none\" stroke=\"#333\" stroke-width=\"0.012\""), 2u) << svg;
}

TEST(Drawings, AreInMillimetresWhateverTheUnit)
{
    Drawing drawing = some_drawing();
    drawing.millimetres = 25.4;
    drawing.unit = "in";
    const std::string svg = drawing_bytes(drawing, "svg"), dxf = drawing_bytes(drawing, "dxf");
    EXPECT_NE(svg.find("height=\"254mm\""), std::string::npos);
    EXPECT_NE(svg.find("1 in"), std::string::npos);
    EXPECT_NE(dxf.find("\n254\n"), std::string::npos);
}

TEST(Drawings, OfDxfHaveAPolylineForEachPath)
{
    const std::string dxf = drawing_bytes(some_drawing(), "dxf");
    EXPECT_EQ(count_of(dxf, "\nPOLYLINE\n"), 3u);
    EXPECT_EQ(count_of(dxf, "\nVERTEX\n"), 10u);
    EXPECT_EQ(count_of(dxf, "\nSEQEND\n"), 3u);
    EXPECT_EQ(count_of(dxf, "\n70\n1\n0\nVERTEX"), 2u) << "closed";
    EXPECT_NE(dxf.find("AC1009"), std::string::npos);
    EXPECT_EQ(dxf.substr(dxf.size() - 6), "0\nEOF\n");
    // A code and a value in turn.
    EXPECT_EQ(count_of(dxf, "\n") % 2, 0u);
}

TEST(Drawings, SeveralSectionsStandAboveOneAnother)
{
    Drawing drawing = some_drawing();
    EXPECT_EQ(drawing_bytes(drawing, "dxf").find("\n30\n0.5\n"), std::string::npos) << "one is flat";
    drawing.layers.push_back(drawing.layers.front());
    drawing.layers.back().height = 2.5;
    const std::string dxf = drawing_bytes(drawing, "dxf");
    EXPECT_NE(dxf.find("\n30\n0.5\n"), std::string::npos);
    EXPECT_NE(dxf.find("\n30\n2.5\n"), std::string::npos);
    EXPECT_EQ(count_of(drawing_bytes(drawing, "svg"), "<g "), 2u);
}

TEST(Drawings, OfObjAreLinesInSpace)
{
    const std::string obj = drawing_bytes(some_drawing(), "obj");
    EXPECT_EQ(count_of(obj, "\nv "), 10u);
    EXPECT_NE(obj.find("\nl 1 2 3 4 1\n"), std::string::npos);
    EXPECT_NE(obj.find("\nl 9 10\n"), std::string::npos);
    EXPECT_NE(obj.find("v 3 3 5\n"), std::string::npos);
}

TEST(Drawings, OfAStraightLineHaveAPageWithWidthAndHeight)
{
    Drawing drawing;
    drawing.layers.push_back({0.0, {{{{0, 0}, {0, 10}}, {{0, 0, 0}, {0, 10, 0}}, false, false, 0}}});
    EXPECT_NE(drawing_bytes(drawing, "svg").find("width=\"0.01mm\" height=\"10mm\""), std::string::npos);
}

TEST(Drawings, NumbersKeepWhatAFloatTells)
{
    EXPECT_EQ(number_text(-0.0), "0");
    EXPECT_EQ(number_text(10.0), "10");
    EXPECT_EQ(number_text(double(0.1f)), "0.1");
    EXPECT_EQ(number_text(1e300), "1e+300");
    EXPECT_EQ(number_text(1e-20), "1e-20");
}

TEST(Drawings, OfAnUnknownFormatAreRefused)
{
    EXPECT_THROW(drawing_bytes(some_drawing(), "png"), io::FileError);
}

}  // namespace
}  // namespace kerf::core::drawings

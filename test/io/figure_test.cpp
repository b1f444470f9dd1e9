// Figures are drawn for light and dark pages, and errors of drawing are reported.
#include "rubber_suspension/io/figure.h"

#include "support/files.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

io::Figure exampleFigure() {
  io::Axes curves;
  curves.title = "stiffness & <loss>";
  curves.x_label = "frequency [Hz]";
  curves.y_label = "stiffness [kN/mm]";
  curves.log_x = true;
  curves.curves.push_back({"measured", {0.5, 1, 2, 4}, {3.1, 3.4, 3.8, 4.2}, "o", 0});
  curves.curves.push_back({"simulated", {0.5, 1, 2, 4}, {3.0, std::nan(""), 3.7, 4.1}, "-", 1});
  io::Axes map;
  map.title = "share of the gap";
  map.maps.push_back({{0, 1, 2}, {0, 1, 2}, {0.1, 0.2, std::numeric_limits<double>::quiet_NaN(), 0.4}, "share [-]"});
  io::Figure figure;
  figure.title = "example";
  figure.axes = {curves, map};
  return figure;
}

TEST(DrawFigure, SvgFollowsLightAndDark) {
  const TemporaryFile file("figure.svg", "");
  io::drawFigure(exampleFigure(), file.path());
  const std::string svg = contentOf(file.path());
  EXPECT_THAT(svg, StartsWith("<?xml"));
  EXPECT_THAT(svg, HasSubstr("prefers-color-scheme:dark"));
  EXPECT_THAT(svg, HasSubstr("currentColor"));
  EXPECT_THAT(svg, HasSubstr("stiffness &amp; &lt;loss&gt;"));
  EXPECT_THAT(svg, Not(HasSubstr("#010203")));
  EXPECT_THAT(svg, Not(HasSubstr("#000000")));
  EXPECT_THAT(svg, Not(HasSubstr("#ffffff")));
  io::drawFigure(exampleFigure(), file.path());
  EXPECT_EQ(contentOf(file.path()), svg);  // the bytes are reproducible, so that reports can be compared
}

TEST(DrawFigure, Png) {
  const TemporaryFile file("figure.png", "");
  io::drawFigure(exampleFigure(), file.path());
  EXPECT_THAT(contentOf(file.path()), StartsWith("\x89PNG"));
}

// The axis has names instead of numbers. The offset moves a value down from the middle of its row.
TEST(DrawFigure, RowsOfNames) {
  io::Axes axes;
  axes.rows = {"first work", "second work"};
  io::addSpreads(axes, "ratio", {{1.0, 0.9, 1.2}, {2.0, 1.5, 3.0}}, 0.1, 4);
  ASSERT_EQ(axes.curves.size(), 2U);
  const io::Curve& lines = axes.curves[0];
  const io::Curve& markers = axes.curves[1];
  EXPECT_EQ(markers.x, (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(markers.y, (std::vector<double>{0.1, 1.1}));
  EXPECT_EQ(lines.x[3], 1.5);
  EXPECT_EQ(lines.x[4], 3.0);
  EXPECT_TRUE(std::isnan(lines.x[2]));  // NaN separates the lines of two rows
  const TemporaryFile file("rows.svg", "");
  io::drawFigure({"", {axes}, 1}, file.path());
  const std::string svg = contentOf(file.path());
  EXPECT_THAT(svg, HasSubstr("first work"));
  EXPECT_THAT(svg, HasSubstr("second work"));
}

TEST(DrawFigure, AcceptsTwoKindsOfFile) {
  EXPECT_TRUE(io::isFigurePath("a.svg"));
  EXPECT_TRUE(io::isFigurePath("/folder/a.png"));
  EXPECT_FALSE(io::isFigurePath("a.pdf"));
  EXPECT_FALSE(io::isFigurePath("svg"));
  EXPECT_FALSE(io::isFigurePath(""));
}

TEST(DrawFigure, MuchDataPassesThrough) {
  io::Figure figure = exampleFigure();
  for (int i = 0; i < 20000; ++i) {  // more bytes than fit into the buffer of a pipe
    figure.axes[0].curves[0].x.push_back(4.0 + i);
    figure.axes[0].curves[0].y.push_back(std::sin(i));
  }
  EXPECT_THROW(io::drawFigure(
                   [&] {
                     io::Figure uneven = figure;
                     uneven.axes[0].curves[0].x.push_back(0.0);
                     return uneven;
                   }(),
                   "unused.svg"),
               io::FigureError);
  const TemporaryFile file("much.svg", "");
  io::drawFigure(figure, file.path());
  EXPECT_GT(contentOf(file.path()).size(), 100000u);
}

TEST(DrawFigure, TellsWhatIsWrong) {
  const TemporaryFile file("figure.pdf", "");
  EXPECT_THROW(io::drawFigure(exampleFigure(), file.path()), io::FigureError);
  EXPECT_THAT(messageOf<io::FigureError>([&] { io::drawFigure(exampleFigure(), "/nonexistent/figure.svg"); }),
              HasSubstr("/nonexistent/figure.svg: cannot be written: No such file or directory"));
  const TemporaryFile svg("figure.svg", "");
  io::Figure bad = exampleFigure();
  bad.axes[1].maps[0].values.pop_back();
  EXPECT_THROW(io::drawFigure(bad, svg.path()), io::FigureError);
  bad = exampleFigure();
  bad.axes[0].curves[0].style = "no such style";
  EXPECT_THROW(io::drawFigure(bad, svg.path()), io::FigureError);
}

// A module named matplotlib that fails to import hides the real one, as if Matplotlib were not installed.
TEST(DrawFigure, NamesAMissingMatplotlib) {
  const TemporaryFile module("matplotlib.py", "raise ImportError('none here')\n");
  setenv("PYTHONPATH", module.folder().c_str(), 1);
  const TemporaryFile file("figure.svg", "");
  const std::string message = messageOf<io::FigureError>([&] { io::drawFigure(exampleFigure(), file.path()); });
  EXPECT_THAT(message, HasSubstr("figures need Matplotlib (none here); install python3-matplotlib"));
  unsetenv("PYTHONPATH");
}

}  // namespace
}  // namespace rubber_suspension

// The figures of the paper that the models come from, computed with its example.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/response/settled_loop.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

/// One curve of a figure: a sweep, or a loop.
struct PaperCurve {
  std::string label;
  std::vector<response::SweepPoint> points;
  response::SettledLoop loop;
};

struct PaperFigure {
  int number;         ///< in the paper
  std::string title;  ///< what is shown, and at what frequency and amplitude
  std::vector<PaperCurve> curves;
  io::Figure figure;
};

/// Figures 3, 4, 5, 6 and 8 of Polach (IAVSD 2015), from its example: K_st = 3 kN/mm, f_n = 4 Hz, A_n = 2 mm,
/// K_n = 4.2 kN/mm, D_n = 5 %, P = 8 mm Hz.
///   3: M2 for several break frequencies, over frequency       4: M1 to M6 over frequency at A = P/f
///   5: M1 to M6 over amplitude at f_n                         6: loops of M1 to M6 at the working point
///   8: M2 with three and five Maxwell elements beside M6, over frequency at A = P/f
/// What is reconstructed: the choice of curves and axes, which follows the text; the low frequency of figure 8, as Eq.
/// 22 is illegible (f_l = n_M f_h/10^(n_M-1)); and the inputs of figure 8, f_h = 25 Hz and K_max = 4.9 kN/mm. With
/// these the two curves pass through the working point and differ between three and five elements as the text says.
std::vector<PaperFigure> paperFigures();

/// The files that writePaperFigures writes into the folder.
std::vector<std::string> paperFigurePaths(const std::string& folder);

/// Write figure_N.svg, figure_N.png and figure_N.csv into a folder, which is made if missing; returns the paths.
/// CSV in SI units: curve,frequency_hz,amplitude_m,stiffness_n_per_m,loss_angle_rad or curve,displacement_m,force_n.
/// Throws FigureError or std::runtime_error with the path that cannot be written.
std::vector<std::string> writePaperFigures(const std::vector<PaperFigure>& figures, const std::string& folder);

}  // namespace rubber_suspension::command

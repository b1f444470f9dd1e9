// The figures of the paper that the models come from, computed with its example.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/io/figure.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {

/// One curve or one surface of a figure.
struct PaperCurve {
  std::string label;
  std::vector<response::SweepPoint> points;  ///< of a surface row by row, the frequency varies within a row
};

struct PaperFigure {
  int number;         ///< in the paper
  std::string title;  ///< what is shown, and at what frequency and amplitude
  std::vector<PaperCurve> curves;
  io::Figure figure;
};

/// Figures 3, 4, 5, 6 and 8 of Polach (IAVSD 2015), from its example: K_st = 3 kN/mm, f_n = 4 Hz, A_n = 2 mm,
/// K_n = 4.2 kN/mm, D_n = 5 %, P = 8 mm Hz.
///   3: surfaces of stiffness and loss angle over frequency and amplitude for M1, M2, M4 and M6
///   4: M1 to M6 over frequency at A_n, then over amplitude at f_n       5: M1 to M6 over frequency at A = P/f
///   6: M2 for break frequencies from 0.5 to 8 Hz over frequency, 1.43 Hz among them
///   8: M2 with one, three and five Maxwell elements and M6 over frequency at A = P/f
/// The reconstructed parts: ranges of the axes; surfaces are drawn as maps; the low frequency of figure 8, as Eq. 22 is
/// illegible (f_l = n_M f_h/10^(n_M-1)); and the inputs of figure 8, f_h = 25 Hz and K_max = 4.9 kN/mm, with which one
/// element is M2 from K_max. All curves then pass through the working point and differ as the text says.
std::vector<PaperFigure> paperFigures();

/// The files that writePaperFigures writes into the folder.
std::vector<std::string> paperFigurePaths(const std::string& folder);

/// Write figure_N.svg, figure_N.png and figure_N.csv into a folder, which is made if missing; returns the paths.
/// CSV in SI units: curve,frequency_hz,amplitude_m,stiffness_n_per_m,loss_angle_rad.
/// Throws FigureError or std::runtime_error with the path that cannot be written.
std::vector<std::string> writePaperFigures(const std::vector<PaperFigure>& figures, const std::string& folder);

}  // namespace rubber_suspension::command

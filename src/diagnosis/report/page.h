// The parts of a report's page, and how the page looks: on a wide screen, at 400 px, in the dark, on paper.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "diagnosis/report/report_figures.h"
#include "rubber_suspension/diagnosis/could_show.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

/// The style sheet. Colours of text and their backgrounds stand in variables, for both schemes, with the contrast that
/// WCAG 2 asks for at level AA.
extern const char* const kPageStyle;

/// A whole page of that style; the title is text, the body HTML.
std::string page(const std::string& title, const std::string& body);

/// The report's page with its figures, those of reportFigures().
std::string reportPage(const Diagnosis& diagnosis, const std::vector<ReportFigure>& figures);

/// What a reader sees first: where, which, how far, how sure, what next. `figures`: loops of a bench to be checked;
/// empty for all others, which have pictures.
std::string firstScreen(const Diagnosis& diagnosis, const std::string& figures = "");

/// Pictures of the first screen: the residual over frequency and amplitude, before and after, the largest place framed;
/// a bar from the gap as configured over those re-estimated and augmented to the noise, with the share of each effect;
/// the probabilities of the sets of effects.
std::string whereMaps(const Diagnosis& diagnosis);
std::string gapBars(const Diagnosis& diagnosis);
std::string probabilityBars(const Diagnosis& diagnosis);

/// How the experiment that is proposed can be played; empty where none is.
std::string howToPlay(const Diagnosis& diagnosis);

/// The candidates of 1 % and more or named, the others folded with the reason.
std::string candidateSection(const Diagnosis& diagnosis);

/// Why a candidate is not named, in half a sentence; empty where it is.
std::string whyOut(const Diagnosis& diagnosis, const CandidateResult& candidate);

/// What no table shows, and every row of the table, measured and simulated.
std::string tableSection(const Diagnosis& diagnosis);

/// Effects that the logs could have shown, without a heading: what would be found of each, and what would be taken for
/// what.
std::string couldShowHtml(const CouldShow& could_show);

/// The same for programs. Sizes as shares of the force's standard deviation; a size that no effect of all of the force
/// reaches is null.
nlohmann::ordered_json toJson(const CouldShow& could_show);

/// "12 found, 3 out of reach": how many effects have each outcome.
std::string outcomesInNumbers(const CouldShow& could_show);

/// The meaning of a finding about the rig, and how to mend it at the bench.
struct FindingAdvice {
  std::string meaning;
  std::string remedy;
};

/// By the name that reports write. Of a name without an entry both are empty: the finding's own text says it.
const FindingAdvice& adviceOn(const std::string& finding);

}  // namespace rubber_suspension::diagnosis::report

// How the report's page looks: on a wide screen, at 400 px, in the dark, on paper.
#pragma once

#include <string>

namespace rubber_suspension::diagnosis {

/// The style sheet. Colours of text and their backgrounds stand in variables, for both schemes, with the contrast that
/// WCAG 2 asks for at level AA.
extern const char* const kPageStyle;

/// A whole page of that style; the title is text, the body HTML.
std::string page(const std::string& title, const std::string& body);

}  // namespace rubber_suspension::diagnosis

// How the report's page looks: on a wide screen, at 400 px, in the dark, on paper.
#pragma once

namespace rubber_suspension::diagnosis {

/// The style sheet. Colours of text and their backgrounds stand in variables, for both schemes, with the contrast that
/// WCAG 2 asks for at level AA.
extern const char* const kPageStyle;

}  // namespace rubber_suspension::diagnosis

// How the report's page looks.
#include <fmt/format.h>

#include "diagnosis/report/page.h"
#include "diagnosis/words/text.h"

namespace rubber_suspension::diagnosis::report {

const char* const kPageStyle = R"(
:root { color-scheme: light dark; --ink: #1d2125; --paper: #ffffff; --soft: #f1f3f5; --note: #555c63; --link: #0b5cad;
  --mark: #0b5cad; --line: #c9ced3; --added: #1a6b34; --removed: #a3262c; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e6e8; --paper: #1b1b1b; --soft: #282a2d; --note: #a9b0b7;
  --link: #7db8f2; --mark: #7db8f2; --line: #4a4e53; --added: #74cf91; --removed: #f2959a; } }
* { box-sizing: border-box; }
body { font: 15px/1.45 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 72rem;
  margin: 0 auto; padding: .8rem 1rem 2rem; overflow-wrap: anywhere; }
a { color: var(--link); }
h1 { font-size: 1.28rem; line-height: 1.35; margin: .2rem 0 .6rem; border-left: .35rem solid var(--mark);
  padding-left: .8rem; }
h2 { font-size: 1.1rem; margin: 1.8rem 0 .4rem; border-bottom: 1px solid var(--line); }
h3 { font-size: 1rem; margin: 1rem 0 .3rem; }
p { margin: .4rem 0; }
.note, .kicker { color: var(--note); font-size: .87em; }
.first { display: grid; grid-template-columns: 7fr 6fr; gap: 0 1.4rem; align-items: start; }
.first figure { margin: 0; }
dl { margin: 0; }
dt { color: var(--note); font-size: .8em; text-transform: uppercase; letter-spacing: .04em; }
dd { margin: 0 0 .5rem; }
figure { margin: 0; break-inside: avoid; min-width: 0; }
figcaption { color: var(--note); font-size: .87em; }
svg { display: block; width: 100%; height: auto; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 22rem), 1fr)); gap: .6rem 1rem; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 28rem), 1fr)); gap: 0 1.6rem; }
table { border-collapse: collapse; width: 100%; font-size: .89em; margin: .4rem 0; }
th, td { text-align: left; padding: .2rem .5rem; border-bottom: 1px solid var(--line); vertical-align: top; }
th { color: var(--note); font-weight: 600; }
th, td { overflow-wrap: break-word; } td code { overflow-wrap: anywhere; }
td.n, td:first-child { white-space: nowrap; }
td:first-child:has(.note) { white-space: normal; }
td.n, th.n { text-align: right; font-variant-numeric: tabular-nums; }
.bar { display: inline-block; height: .6rem; background: var(--mark); vertical-align: middle; }
.track { display: inline-block; width: 6rem; max-width: 100%; }
pre, code { font: .85em/1.4 ui-monospace, monospace; background: var(--soft); white-space: pre-wrap;
  overflow-wrap: anywhere; }
pre { padding: .6rem; margin: .4rem 0; }
code { padding: 0 .2rem; }
ins, .added { color: var(--added); text-decoration: none; }
del, .removed { color: var(--removed); text-decoration: none; }
details { margin: .4rem 0; }
summary { cursor: pointer; color: var(--link); }
@media screen and (max-width: 44rem) {
  .first { grid-template-columns: 1fr; }
  .first figure { order: -1; margin-bottom: .6rem; }
  table, tbody, tr, td { display: block; }
  thead { display: none; }
  tr { border-bottom: 1px solid var(--line); padding: .3rem 0; }
  td, td.n, td:first-child { white-space: normal; overflow-wrap: anywhere; border: 0; text-align: left; padding: .05rem 0; }
  td:not(:empty)::before { content: attr(data-title) ": "; color: var(--note); }
  td[data-title=""]::before { content: ""; }
}
@page { size: A4; margin: 13mm 14mm; }
@media print {
  :root { color-scheme: light; --ink: #000000; --paper: #ffffff; --soft: #f1f3f5; --note: #444a50; --link: #0b5cad;
    --mark: #0b5cad; --line: #b5babf; --added: #1a6b34; --removed: #a3262c; }
  body { font-size: 8.6pt; line-height: 1.3; padding: 0; max-width: none; }
  h1 { font-size: 11.5pt; } h2 { font-size: 10pt; margin: 2.6mm 0 1mm; break-after: avoid; }
  .first { grid-template-columns: 1fr 1fr; gap: 0 5mm; }
  .figures { grid-template-columns: repeat(4, 1fr); gap: 1mm 3mm; }
  .pair { grid-template-columns: 1fr 1fr; gap: 0 5mm; }
  table { font-size: 7.6pt; margin: 1mm 0; }
  tr { break-inside: avoid; }
  td, th { padding: .3mm 1mm; }
  p { margin: 1mm 0; }
  dd { margin-bottom: 1mm; }
  .track { width: 20mm; }
  .value { white-space: nowrap; }
  details, .screen { display: none; }
  pre { padding: 1mm; }
}
)";

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
             "<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport "
             "content=\"width=device-width\"><title>{}</title><style>{}</style></head><body>\n",
             words::escape(title), kPageStyle) +
         body + "</body></html>\n";
}

}  // namespace rubber_suspension::diagnosis::report

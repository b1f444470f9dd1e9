// How the report's page looks.
#include <fmt/format.h>

#include "diagnosis/report/page.h"
#include "diagnosis/words/text.h"

namespace rubber_suspension::diagnosis::report {

const char* const kPageStyle = R"(
:root { color-scheme: light dark; --ink: #1d2125; --paper: #ffffff; --soft: #f1f3f5; --note: #555c63; --link: #0b5cad;
  --mark: #0b5cad; --line: #c9ced3; --added: #1a6b34; --removed: #a3262c;
  --s1: #e3edf7; --s2: #c3d9ee; --s3: #a1c4e3; --s4: #82b0d9; --s5: #629cce; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e6e8; --paper: #1b1b1b; --soft: #282a2d; --note: #a9b0b7;
  --link: #7db8f2; --mark: #7db8f2; --line: #4a4e53; --added: #74cf91; --removed: #f2959a;
  --s1: #20303f; --s2: #253f58; --s3: #2a4d70; --s4: #2f5b87; --s5: #33679b; } }
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
.first { display: grid; grid-template-columns: 7fr 6fr; gap: 0 1.6rem; align-items: start; }
.first > * { min-width: 0; }
.words { font-size: .93em; margin: 0 0 .6rem; }
.picture { margin: 0 0 .7rem; }
.picture h3 { margin: 0 0 .2rem; }
.maps { display: grid; grid-template-columns: 1fr 1fr; gap: .3rem .8rem; }
table.map { font-size: .72em; table-layout: fixed; margin: 0; }
.map caption { text-align: left; color: var(--note); font-size: 1.1em; }
.map th, .map td { padding: .15rem .1rem; border: 1px solid var(--line); text-align: center; white-space: normal;
  overflow-wrap: normal; line-height: 1.15; }
.map th { font-weight: 400; }
.map th:first-child { width: 3.9em; }
.map .s1 { background: var(--s1); } .map .s2 { background: var(--s2); } .map .s3 { background: var(--s3); }
.map .s4 { background: var(--s4); } .map .s5 { background: var(--s5); }
.map .largest { outline: 3px solid var(--ink); outline-offset: -2px; font-weight: 700; }
.row { display: grid; grid-template-columns: 8.5rem 1fr 4.6rem; gap: .5rem; align-items: center; font-size: .89em;
  padding: .12rem 0; }
.row .n { text-align: right; font-variant-numeric: tabular-nums; }
.rail { position: relative; display: flex; height: 1rem; border-left: 1px solid var(--ink); }
.rail i, .key i { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
.rail i { display: block; height: 100%; flex: none; }
.whisker { box-shadow: 0 0 0 1px var(--paper); position: absolute; top: 20%; height: 60%; border: solid var(--ink); border-width: 0 2px; min-width: 4px;
  background: linear-gradient(var(--ink), var(--ink)) center/100% 2px no-repeat; }
.keys { font-size: .87em; margin: .2rem 0; }
.key { white-space: nowrap; margin-right: .6rem; display: inline-block; }
.key i { display: inline-block; width: 1.4em; height: .9em; vertical-align: -.1em; margin-right: .3em; }
.rail i, .key i { border: 1px solid var(--ink); }
.p0 { background: #0072b2; }
.p1 { background: repeating-linear-gradient(45deg, #e69f00 0 4px, #fff 4px 6px); }
.p2 { background: repeating-linear-gradient(90deg, #009e73 0 3px, #fff 3px 6px); }
.p3 { background: radial-gradient(#d55e00 2px, #fff 2.4px) 0 0/6px 6px; }
.p4 { background: repeating-linear-gradient(0deg, #cc79a7 0 3px, #fff 3px 5px); }
.rest { background: repeating-linear-gradient(-45deg, #777 0 1px, #fff 1px 5px); }
.floor { background: #fff; }
.plain { background: #999; }
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
pre, code { font: .85em/1.4 ui-monospace, monospace; background: var(--soft); white-space: pre-wrap;
  overflow-wrap: anywhere; }
pre { padding: .6rem; margin: .4rem 0; }
code { padding: 0 .2rem; }
ins, .added { color: var(--added); text-decoration: none; }
del, .removed { color: var(--removed); text-decoration: none; }
details { margin: .4rem 0; }
summary { cursor: pointer; color: var(--link); }
@media screen and (max-width: 44rem) {
  .first, .maps { grid-template-columns: 1fr; }
  .row { grid-template-columns: 6.4rem 1fr 4rem; }
  table:not(.map), :not(.map) > tbody, :not(.map) > tbody > tr, :not(.map) > tbody > tr > td { display: block; }
  :not(.map) > thead { display: none; }
  :not(.map) > tbody > tr { border-bottom: 1px solid var(--line); padding: .3rem 0; }
  :not(.map) > tbody > tr > td { white-space: normal; overflow-wrap: anywhere; border: 0; text-align: left;
    padding: .05rem 0; }
  td:not(:empty)::before { content: attr(data-title) ": "; color: var(--note); }
  td[data-title=""]::before { content: ""; }
}
@page { size: A4; margin: 13mm 14mm; }
@media print {
  :root { color-scheme: light; --ink: #000000; --paper: #ffffff; --soft: #f1f3f5; --note: #444a50; --link: #0b5cad;
    --mark: #0b5cad; --line: #b5babf; --added: #1a6b34; --removed: #a3262c;
    --s1: #e3edf7; --s2: #c3d9ee; --s3: #a1c4e3; --s4: #82b0d9; --s5: #629cce; }
  .map td { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .row { grid-template-columns: 24mm 1fr 14mm; font-size: 7.6pt; padding: 0; } .rail { height: 3mm; }
  table.map { font-size: 6.6pt; } .words { margin-bottom: 1.5mm; } .picture { margin-bottom: 1.5mm; }
  body { font-size: 8.6pt; line-height: 1.3; padding: 0; max-width: none; }
  h1 { font-size: 11.5pt; } h2 { font-size: 10pt; margin: 2.6mm 0 1mm; break-after: avoid; }
  .first { grid-template-columns: 1fr 1fr; gap: 0 5mm; }
  .figures { grid-template-columns: repeat(5, 1fr); gap: 1mm 2mm; }
  .pair { grid-template-columns: 1fr 1fr; gap: 0 5mm; }
  table { font-size: 7.6pt; margin: 1mm 0; }
  tr { break-inside: avoid; }
  td, th { padding: .3mm 1mm; }
  p { margin: 1mm 0; }
  dd { margin-bottom: 1mm; }
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

// The look of report.html.
#pragma once

namespace isocast::bench {

inline constexpr const char* kReportStyle = R"css(
:root { --ink: #26262e; --soft: #666a78; --line: #e4e2dc; --paper: #fbfaf7; --card: #ffffff; --accent: #0b6e8a }
* { box-sizing: border-box }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif }
main, header { max-width: 1280px; margin: 0 auto; padding: 0 24px }
header { padding-top: 36px }
h1 { font-size: 30px; font-weight: 650; margin: 0 0 4px; letter-spacing: -.01em }
h2 { font-size: 22px; font-weight: 620; margin: 44px 0 10px }
h3 { font-size: 17px; font-weight: 620; margin: 26px 0 6px }
p { margin: 6px 0 }
a { color: var(--accent); text-decoration: none }
a:hover { text-decoration: underline }
.soft { color: var(--soft); font-size: 14px }
.findings { counter-reset: n; list-style: none; padding: 0; margin: 22px 0;
  display: grid; grid-template-columns: repeat(6, 1fr); gap: 14px }
.findings li { counter-increment: n; background: var(--card); border: 1px solid var(--line); border-radius: 10px;
  padding: 14px 16px 14px 48px; position: relative }
.findings li { grid-column: span 2 }
.findings li:nth-child(-n+2) { grid-column: span 3 }
.findings li::before { content: counter(n); position: absolute; left: 14px; top: 12px; font-size: 24px; font-weight: 650;
  color: var(--accent) }
.card { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 14px 16px; margin: 12px 0 }
.plots { display: grid; grid-template-columns: 760fr 420fr; gap: 20px }
.plots.single { grid-template-columns: minmax(0, 860px) }
svg { width: 100%; height: auto; display: block }
.pictures { display: flex; flex-wrap: wrap; gap: 14px; margin: 6px 0 }
figure { margin: 0; width: 152px }
figure img { width: 152px; height: auto; image-rendering: pixelated; border-radius: 6px; display: block }
figcaption { font-size: 13px; color: var(--soft); margin-top: 3px }
.scroll { overflow-x: auto }
table { border-collapse: collapse; font-size: 14px; font-variant-numeric: tabular-nums; width: 100% }
th { text-align: left; font-weight: 600; color: var(--soft); line-height: 1.25; vertical-align: bottom }
th, td { padding: 4px 10px 4px 0; border-bottom: 1px solid var(--line) }
td.name { white-space: nowrap; padding-right: 14px }
td.number, th.number { text-align: right }
td.number { white-space: nowrap }
td.zero { color: #b5b3ad }
td.bad { color: #c4123f; font-weight: 600 }
td img { width: 56px; height: 56px; object-fit: cover; image-rendering: pixelated; border-radius: 6px; display: block }
.dot { display: inline-block; width: 10px; height: 10px; border-radius: 5px; margin-right: 7px }
.tag { display: inline-block; border-radius: 9px; padding: 0 9px; font-size: 13px; background: #e6f1f3; color: #0b5b73 }
.tag.good { background: #e0f2e3; color: #1c6b34; white-space: nowrap }
.tag.refuted { background: #fbe3e8; color: #b0123b }
.tag.none { background: #eeece6; color: #5d6070; white-space: nowrap }
.tag.double { background: #f6e7d4; color: #8a4b00 }
summary { cursor: pointer; color: var(--accent); margin: 10px 0 }
.ramp { display: inline-block; width: 180px; height: 12px; border-radius: 3px; vertical-align: -1px; margin: 0 8px }
.swatch { display: inline-block; width: 12px; height: 12px; border-radius: 3px; vertical-align: -1px; margin: 0 5px 0 14px }
footer { max-width: 1280px; margin: 50px auto 30px; padding: 0 24px }
@media (max-width: 900px) { .plots { grid-template-columns: 1fr } svg.condition { max-width: 460px; margin: 0 auto }
  .findings { grid-template-columns: 1fr } .findings li:nth-child(n) { grid-column: auto } main, header, footer { padding-left: 16px; padding-right: 16px }
  figure, figure img { width: 132px } .wide { display: none } h1 { font-size: 25px } }
)css";

}  // namespace isocast::bench

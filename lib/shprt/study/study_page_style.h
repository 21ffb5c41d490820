// How the page of a study looks. Internal to the room.
#pragma once

namespace shprt {

// Holds none of < > &, which XML and HTML would read in different ways.
inline constexpr const char* kStudyPageStyle = R"css(
:root{--ground:#fff;--ink:#1c1e21;--soft:#5c636b;--line:#d8dce0;--card:#f5f6f8;--accent:#0b62a8;--note:#fff4d6}
@media(prefers-color-scheme:dark){:root{--ground:#181818;--ink:#e4e4e4;--soft:#a0a6ad;--line:#3a3d41;--card:#222426;
--accent:#6cb6f5;--note:#3b321a}}
*{box-sizing:border-box}
html{scroll-behavior:smooth}
body{margin:0;background:var(--ground);color:var(--ink);font:16px/1.55 system-ui,sans-serif}
main{max-width:54rem;margin:0 auto;padding:1.5rem 1rem 4rem}
h1{font-size:1.9rem;line-height:1.2;margin:.5rem 0 1rem}
h2{font-size:1.3rem;margin:0 0 .6rem}
section{border-top:1px solid var(--line);margin-top:2.2rem;padding-top:1.6rem}
p{max-width:46rem;margin:.6rem 0}
a{color:var(--accent)}
dl{margin:1rem 0}
dt{color:var(--soft);font-size:.85rem}
dd{margin:0;overflow-wrap:anywhere}
.facts{display:grid;grid-template-columns:repeat(auto-fill,minmax(14rem,1fr));gap:.5rem 1.2rem}
.headlines{display:grid;grid-template-columns:repeat(auto-fill,minmax(11rem,1fr));gap:.8rem}
.headlines div{background:var(--card);border:1px solid var(--line);border-radius:.5rem;padding:.6rem .8rem}
.headlines dd{font-size:1.5rem;font-variant-numeric:tabular-nums}
nav{background:var(--card);border-radius:.5rem;padding:.8rem 1rem;margin:1.2rem 0}
nav h2{font-size:1rem;margin:0}
nav ol{margin:.4rem 0 0;padding-left:1.4rem}
.missing{background:var(--note);border-radius:.4rem;padding:.6rem .8rem}
figure{margin:1.4rem 0}
figcaption,caption{font-weight:600;text-align:left;padding:0 0 .4rem}
svg{display:block;width:100%}
.scroll{overflow-x:auto;margin:1rem 0}
table{border-collapse:collapse;font-size:.9rem;font-variant-numeric:tabular-nums}
th,td{text-align:left;vertical-align:top;padding:.3rem .9rem .3rem 0;border-bottom:1px solid var(--line)}
thead th{color:var(--soft);font-weight:500}
.number{text-align:right}
td,td code{white-space:nowrap}
code{font:.85em ui-monospace,monospace;background:var(--card);border-radius:.3rem;padding:.1rem .35rem;
overflow-wrap:anywhere;user-select:all;-webkit-user-select:all;cursor:pointer}
details{margin:.6rem 0}
summary{color:var(--soft);cursor:pointer;font-size:.9rem}
@media print{body{font-size:10pt}main{max-width:none;padding:0}nav,details{display:none}
figure,tr,.headlines div{break-inside:avoid}h2{break-after:avoid}.scroll{overflow:visible}}
)css";

}  // namespace shprt

// A study for machines: every number of it, as JSON.
#pragma once

#include <string>

#include "shprt/study/study.h"

namespace shprt {

// {
//   "format": "shprt-study", "version": 1,
//   "title": "...",
//   "facts": {"name": "text", ...},              what was studied, on what machine, with which settings
//   "headlines": {"name": number, ...},
//   "sections": [{
//     "id": "...", "title": "...",
//     "text": "...",                             paragraphs end in a newline
//     "missing": "...",                          only where the section has nothing to show: why
//     "charts": [{
//       "id": "...", "title": "...",
//       "x": {"label": "...", "logarithmic": true}, "y": {the same},
//       "curves": [{"name": "...", "slope": number or null, "points": [[x, y], ...]}]
//     }],
//     "tables": [{"id": "...", "title": "...", "columns": ["..."], "rows": [["..."], ...]}],
//     "figures": {"name": number, ...}           the section's numbers, in the order of their making
//   }]
// }
// Numbers are written so that reading them gives the same double; what is infinite or NaN is null. Of two
// facts, headlines or figures of one name the last counts. Bytes that are no UTF-8 become U+FFFD.
std::string studyToJson(const Study& study);

}  // namespace shprt

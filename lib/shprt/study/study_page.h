// A study as a page to read: one HTML file that needs nothing else, on screens of any size and on paper.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "shprt/report/gnuplot.h"
#include "shprt/study/study.h"

namespace shprt {

// The charts of a study, drawn.
struct StudyDrawings {
  std::vector<std::string> svgs;  // one per chart, through the sections in their order; "" where not drawn
  std::string missing;            // why charts are not drawn and what to do about it; "" where all are
};

// A gnuplot that is missing, fails or hangs is not asked a second time.
StudyDrawings drawStudy(const Study& study, const Gnuplot& gnuplot = {});

// The page. Charts that are not drawn show as tables of their points. Cells that begin with "shprt " are
// command lines: a click selects all of one. The page is well-formed XML, too. Equal input gives equal bytes.
std::string formatStudyPage(const Study& study, const StudyDrawings& drawings);

struct StudyFiles {
  std::filesystem::path page, json;
  std::string missing;  // as in StudyDrawings
};

// Writes index.html (with the charts in it) and study.json into the folder, which is made if there is none;
// each appears whole or not at all, in place of what was there. Throws Error when that fails.
StudyFiles writeStudy(const std::filesystem::path& folder, const Study& study, const Gnuplot& gnuplot = {});

}  // namespace shprt

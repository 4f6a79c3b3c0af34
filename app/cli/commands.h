#pragma once
// One function per command. Each throws nacre::Error on failure.

#include <iosfwd>

#include "app/cli/options.h"

namespace nacre::app {

void renderCommand(const PictureDescription& options);
void movieCommand(const MovieOptions& options);
/// Reports to `out`, line by line. @returns whether all jobs succeeded
bool batchCommand(const BatchOptions& options, std::ostream& out);
void figureCommand(const FigureOptions& options);
void looksCommand(const LooksOptions& options, std::ostream& out);
void exportCommand(const ExportCommandOptions& options);
void benchCommand(const BenchOptions& options, std::ostream& out);
void planCommand(const PlanOptions& options, std::ostream& out);
void infoCommand(const InfoOptions& options, std::ostream& out);
void devicesCommand(const DevicesOptions& options, std::ostream& out);
void versionCommand(std::ostream& out);

}  // namespace nacre::app

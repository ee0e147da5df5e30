using System.Diagnostics;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Sequencing;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>A trajectory with the name of its file.</summary>
/// <param name="Source">Handle of its first entity; null if that has none, and for an offset.</param>
/// <param name="Seconds">Computation time.</param>
public sealed record NamedTrajectory(string FileName, TrajectoryFile File, string? Source, double Seconds);

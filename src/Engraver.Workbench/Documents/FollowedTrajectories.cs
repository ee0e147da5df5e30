using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Sidecars;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Documents;

/// <summary>The trajectories of a document that replace the drawing in a job.</summary>
/// <param name="Drawing">Drawing of the document.</param>
/// <param name="Settings">Settings of the document.</param>
/// <param name="Trajectories">In run order.</param>
public sealed record FollowedTrajectories(Drawing Drawing, DrawingSettings Settings, IReadOnlyList<DocumentTrajectory> Trajectories);

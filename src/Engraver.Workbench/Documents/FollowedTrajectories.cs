using Engraver.Core.Drawings;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Documents;

/// <summary>The trajectories of a document that replace the drawing in a job.</summary>
/// <param name="Drawing">Drawing of the document.</param>
/// <param name="Settings">Settings of the document.</param>
/// <param name="Trajectories">In run order.</param>
public sealed record FollowedTrajectories(Drawing Drawing, DrawingSettings Settings, IReadOnlyList<DocumentTrajectory> Trajectories);

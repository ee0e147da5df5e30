using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Documents;

/// <summary>A trajectory of a document as files: its own points for controllers of splines, what it follows for those of lines and arcs or of
/// velocities.</summary>
public static class TrajectoryExport
{
    /// <param name="machine">Feed, acceleration and travel are those of the formats that say or limit them.</param>
    /// <returns>One file, or several where a controller must stop at corners; none when the format has no heights or cannot keep the error.</returns>
    public static IReadOnlyList<TrajectoryFile> Files(DocumentTrajectory one, TrajectoryFormat format, MachineProfile machine)
    {
        ArgumentNullException.ThrowIfNull(one);
        var motion = TrajectoryMotion.Of(machine);
        if (format == TrajectoryFormat.Sace) return [SplineText.Sace(one.Curve)];
        if (format == TrajectoryFormat.XpsSpline) return [SplineText.Xps(one.Curve, motion)];
        if (one.IsHelix) return [];
        var made = TrajectoryFiles.Write(one.Curve.Source, one.Curve.Closed, new TrajectoryOptions(one.MaxErrorMm) { Z = one.Curve.Z }, format, motion);
        return made.Unproven.Count > 0 ? [] : made.Files;
    }

    /// <summary>Those whose equal steps do not keep the error that was asked for: nothing is written or run of them unless that is asked for all the
    /// same.</summary>
    public static IEnumerable<Diagnostic> NotKept(IEnumerable<DocumentTrajectory> trajectories) => trajectories
        .Where(one => one.SegmentLengthMm is not null && one.Curve.VerifiedBound > one.MaxErrorMm)
        .Select(one => TrajectoryRules.StepsRefused.At(default, one.Name, FactText.Of(one.Curve.VerifiedBound), FactText.Of(one.MaxErrorMm)));
}

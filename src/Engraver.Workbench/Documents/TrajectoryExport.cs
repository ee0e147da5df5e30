using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Documents;

/// <summary>A trajectory of a document as files: spline points, or its source curve for formats with lines and arcs or velocities.</summary>
public static class TrajectoryExport
{
    /// <param name="machine">Feed, acceleration and travel are used by formats that contain or limit them.</param>
    /// <returns>One file, or several if the controller must stop at corners; none if the format has no heights or cannot keep the error.</returns>
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

    /// <summary>Findings for trajectories whose equal steps exceed the requested error: they are not written or run unless the operator confirms it.</summary>
    public static IEnumerable<Diagnostic> ErrorsExceeded(IEnumerable<DocumentTrajectory> trajectories) => trajectories
        .Where(one => one.SegmentLengthMm is not null && one.Curve.VerifiedBound > one.MaxErrorMm)
        .Select(one => TrajectoryRules.StepsRefused.At(default, one.Name, FactText.Of(one.Curve.VerifiedBound), FactText.Of(one.MaxErrorMm)));
}

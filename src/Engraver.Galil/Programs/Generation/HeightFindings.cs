using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Galil.Programs.Generation;

/// <summary>The heights of a toolpath on a machine whose tool is moved by an axis: findings for those that cannot be cut, and the passes for the
/// others.</summary>
internal static class HeightFindings
{
    private static readonly double[] s_atDepth = [0.0];

    /// <summary>Errors for curves that rise and for heights that are not below the retract height or cannot be expressed in counts; a warning when the tool
    /// removes no material.</summary>
    public static IEnumerable<Diagnostic> Findings(Toolpath toolpath, HeightDrive drive, CountsScale scale, Func<int, SourceRef> source)
    {
        var (reported, isAnyCut, isAnyBelow) = (new HashSet<int>(), false, false);
        foreach (var move in toolpath.Strokes.SelectMany(stroke => stroke.Moves))
        {
            if (Finding(move, drive, scale, source) is { } finding)
            {
                if (reported.Add(move.EntityIndex)) yield return finding;
            }

            (isAnyCut, isAnyBelow) = (true, isAnyBelow || !(Math.Min(move.StartZ, move.EndZ) >= drive.CutDepth));
        }

        if (isAnyCut && !isAnyBelow) yield return MotionRules.NoDepth.At(default);
    }

    /// <summary>Height of each pass of a stroke above its depth, millimetres, the highest first.</summary>
    public static IReadOnlyList<double> Lifts(ToolpathStroke stroke, MachineProfile profile) => profile.Height is { } drive ? [.. CutHeights.PassHeights(stroke, drive)] : s_atDepth;

    private static Diagnostic? Finding(in StrokeMove move, HeightDrive drive, CountsScale scale, Func<int, SourceRef> source)
    {
        var (low, high) = (Math.Min(move.StartZ, move.EndZ) - drive.CutDepth, Math.Max(move.StartZ, move.EndZ) - drive.CutDepth);
        if (scale.Z.CountsOf(Math.Max(Math.Abs(low), Math.Abs(high))) >= int.MaxValue / 4.0) return MotionRules.HeightOutsideCounts.At(source(move.EntityIndex), FactText.Of(Math.Abs(low) > Math.Abs(high) ? low : high), FactText.Of(scale.Z.CountsPerMillimetre));
        return CutHeights.Finding(move, drive, source(move.EntityIndex));
    }
}

using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Motion;

/// <summary>The heights of a toolpath on a machine whose tool is moved by an axis, for every form in which it is written: the passes in which it is cut, and
/// the parts that cannot be cut.</summary>
public static class CutHeights
{
    /// <summary>Height of each pass of a stroke above its depth, millimetres, the highest first; the last is 0. Whole multiples of the depth of a
    /// pass.</summary>
    public static IEnumerable<double> PassHeights(ToolpathStroke stroke, HeightDrive drive)
    {
        ArgumentNullException.ThrowIfNull(stroke);
        ArgumentNullException.ThrowIfNull(drive);
        if (drive.DepthPerPass is not { } step) return [0.0];
        var passes = drive.Passes(stroke.Moves.Min(move => Math.Min(move.StartZ, move.EndZ)) - drive.CutDepth);
        return Enumerable.Range(1, passes).Select(pass => (passes - pass) * step);
    }

    /// <summary>The finding for a curve that rises, or a cut that is not below the retract height; null when the move can be cut.</summary>
    public static Diagnostic? Finding(in StrokeMove move, HeightDrive drive, SourceRef source)
    {
        ArgumentNullException.ThrowIfNull(drive);
        if (double.IsNaN(move.StartZ)) return MotionRules.RisingCurve.At(source);
        var high = Math.Max(move.StartZ, move.EndZ) - drive.CutDepth;
        return high < drive.RetractHeight ? null : MotionRules.AboveRetract.At(source, FactText.Of(high), FactText.Of(drive.CutDepth), FactText.Of(drive.RetractHeight));
    }
}

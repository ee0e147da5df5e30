using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Verification;

/// <summary>Gaps that a stroke crosses within the join tolerance, straight from the true end of one move to the true start of the next. In the middle of a gap
/// the tool is half its length from either end, where no segment is drawn.</summary>
public static class BridgedGaps
{
    /// <summary>The gaps as lines, millimetres, in the order of cutting: those in which the tool can be farther from the drawing than
    /// <paramref name="deviation"/>.</summary>
    public static IReadOnlyList<StrokeMove> LargerThan(Toolpath toolpath, double deviation) => [.. All(toolpath).Where(gap => gap.Segment.Length > 2.0 * deviation)];

    /// <summary>The length of the widest gap in a stroke, millimetres; 0 when no stroke has a gap.</summary>
    public static double Widest(Toolpath toolpath) => All(toolpath).Select(gap => gap.Segment.Length).DefaultIfEmpty().Max();

    /// <summary>Null when no gap takes the tool farther from the drawing than rounding and curve error do.</summary>
    /// <param name="deviation">Distance of the tool from the drawing that rounding and curve error can cause, millimetres.</param>
    public static Diagnostic? Warning(Toolpath toolpath, double deviation, Func<int, SourceRef> sourceOf)
    {
        var gaps = LargerThan(toolpath, deviation);
        if (gaps.Count == 0) return null;
        var widest = gaps.MaxBy(gap => gap.Segment.Length);
        var (length, place) = (widest.Segment.Length, widest.Segment.Start);
        return MotionRules.GapsBridged.At(sourceOf(widest.EntityIndex), gaps.Count.ToString(CultureInfo.InvariantCulture), NumberText.Rounded(length / 2.0, 5), NumberText.Rounded(length, 5), NumberText.Rounded(place.X, 5), NumberText.Rounded(place.Y, 5));
    }

    private static IEnumerable<StrokeMove> All(Toolpath toolpath)
    {
        foreach (var stroke in toolpath.Strokes)
        {
            var (isFirst, from, height) = (true, default(Point2D), 0.0);
            foreach (var move in stroke.Moves)
            {
                var to = move.Segment.Start;
                if (!isFirst && from != to) yield return new StrokeMove(Segment.FromLine(from, to), move.EntityIndex, height, move.StartZ);
                (isFirst, from, height) = (false, move.Segment.End, move.EndZ);
            }
        }
    }
}

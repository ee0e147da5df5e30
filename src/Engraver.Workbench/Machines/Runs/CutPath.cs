using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Verification;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The path of a program up to a position, as samples with the tool on.</summary>
internal static class CutPath
{
    /// <summary>Maximum distance of a chord from its arc, counts.</summary>
    private const double Sagitta = 0.2;

    /// <summary>Part of the first segment before its second sample; judges ignore a gap of this size.</summary>
    private const double NearStart = 1e-5;

    public static IEnumerable<TraceSample> SamplesBefore(MotionProgram program, JobPosition place)
    {
        var (left, scale) = (place.Segments, program.Profile.Scale);
        foreach (var stroke in program.Strokes)
        {
            if (left < 0 || (left == 0 && place.Along == 0.0)) yield break;
            yield return Sample(scale, new Point2D(stroke.Start.X, stroke.Start.Y), Math.Max(program.Profile.Height?.RetractHeight ?? 0.0, scale.ToMillimetres(stroke.Start.Z)), cutting: false);
            var isFirst = true;
            foreach (var sequence in stroke.Sequences)
            {
                var start = sequence.Start;
                foreach (var segment in sequence.Segments)
                {
                    var length = left > 0 ? segment.Length : left == 0 ? place.Along : 0.0;
                    if (length > 0.0)
                    {
                        foreach (var sample in Samples(scale, start, segment, length, isFirst)) yield return sample;
                    }

                    left--;
                    (start, isFirst) = (segment.End, IsVertical(start, segment));
                }
            }
        }
    }

    private static IEnumerable<TraceSample> Samples(CountsScale scale, CountsPoint start, VectorSegment segment, double length, bool isFirst)
    {
        if (!IsVertical(start, segment)) return Points(new SegmentPath(start, segment), segment, length, isFirst).Select(at => Sample(scale, at, scale.ToMillimetres(HeightOf(start, segment, at)), cutting: true));
        double[] heights = [start.Z, start.Z + ((segment.End.Z - start.Z) * length / segment.Length)];
        return heights.Select(height => Sample(scale, new Point2D(start.X, start.Y), scale.ToMillimetres(height), cutting: true));
    }

    private static bool IsVertical(CountsPoint start, in VectorSegment segment) => segment.Kind == VectorSegmentKind.Line && start.X == segment.End.X && start.Y == segment.End.Y;

    /// <summary>Two samples at one place are a move straight up or down: a segment begins with the end of the one before. The first segment, and one after such
    /// a move, has a second sample near its start, from which the path is followed.</summary>
    /// <param name="isFirst">True for these segments.</param>
    private static IEnumerable<Point2D> Points(SegmentPath course, VectorSegment segment, double length, bool isFirst)
    {
        if (isFirst) yield return course.At(0.0);
        if (isFirst) yield return course.At(length * NearStart);
        var chords = segment.Kind == VectorSegmentKind.Line ? 1 : Math.Max(1, (int)Math.Ceiling(length / Math.Sqrt(8.0 * Sagitta * segment.Radius)));
        for (var i = 1; i <= chords; i++) yield return course.At(length * i / chords);
    }

    /// <summary>Z position, counts, interpolated linearly.</summary>
    private static double HeightOf(CountsPoint start, in VectorSegment segment, Point2D at)
    {
        if (start.Z == segment.End.Z) return start.Z;
        var (from, to) = (new Point2D(start.X, start.Y), new Point2D(segment.End.X, segment.End.Y));
        return start.Z + (((double)segment.End.Z - start.Z) * (from == to ? 1.0 : Math.Min(1.0, from.DistanceTo(at) / from.DistanceTo(to))));
    }

    private static TraceSample Sample(CountsScale scale, Point2D at, double height, bool cutting)
    {
        var place = scale.ToMillimetres(at.X, at.Y);
        return new TraceSample(0.0, place.X, place.Y, cutting, height);
    }
}

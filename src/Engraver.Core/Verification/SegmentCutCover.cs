using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>The parts of a drawn line or arc within reach of a cut along a line or an arc.</summary>
/// <remarks>The places at exactly the reach are on the cut's offsets to both sides and on circles around its ends; between two of them one place decides for
/// all.</remarks>
internal static class SegmentCutCover
{
    private const int MaxMarks = 24;

    /// <summary>Any segment and any cut; for curves, nearly straight pieces.</summary>
    public static void CoverAny(in Segment drawn, in Segment cut, double reach, CoveredParts covered)
    {
        if (drawn.IsFreeCurve || cut.IsFreeCurve) CurveCutCover.Cover(drawn, cut, reach, covered);
        else if (drawn.Kind == SegmentKind.Line && cut.Kind == SegmentKind.Line) CoverLine(drawn.Line, cut.Line, reach, covered);
        else Cover(drawn, cut, reach, covered);
    }

    /// <summary>A line covered by a line: one interval, because both the line and the area within reach of the cut are convex.</summary>
    public static void CoverLine(LineSegment drawn, LineSegment cut, double reach, CoveredParts covered)
    {
        var length = Math.Sqrt((drawn.End - drawn.Start).LengthSquared);
        if (length == 0.0) return;
        var along = (drawn.End - drawn.Start) * (1.0 / length);
        var (from, to) = (double.PositiveInfinity, double.NegativeInfinity);
        IncludeDisc(drawn.Start, along, cut.Start, reach, ref from, ref to);
        IncludeDisc(drawn.Start, along, cut.End, reach, ref from, ref to);
        if (Math.Sqrt((cut.End - cut.Start).LengthSquared) is > 0.0 and var cutLength) IncludeStrip(drawn.Start, along, cut.Start, (cut.End - cut.Start) * (1.0 / cutLength), cutLength, reach, ref from, ref to);
        if (from <= to && from <= length && to >= 0.0) covered.Add(from / length, to / length);
    }

    /// <summary>A line or an arc covered by a line or an arc.</summary>
    public static void Cover(in Segment drawn, in Segment cut, double reach, CoveredParts covered)
    {
        if (drawn.Length == 0.0) return;
        Span<double> marks = stackalloc double[MaxMarks];
        var count = 0;
        marks[count++] = 0.0;
        marks[count++] = 1.0;
        AddDisc(drawn, cut.Start, reach, marks, ref count);
        AddDisc(drawn, cut.End, reach, marks, ref count);
        if (cut.Kind == SegmentKind.Line)
        {
            AddOffset(drawn, cut.Line, reach, marks, ref count);
            AddOffset(drawn, cut.Line, -reach, marks, ref count);
        }
        else
        {
            AddDisc(drawn, cut.Arc.Centre, cut.Arc.Radius + reach, marks, ref count);
            AddDisc(drawn, cut.Arc.Centre, cut.Arc.Radius - reach, marks, ref count);
        }

        marks = marks[..count];
        marks.Sort();
        var from = double.NaN;
        for (var i = 1; i < count; i++)
        {
            var isNear = cut.DistanceTo(drawn.PointAt((marks[i - 1] + marks[i]) / 2.0)) <= reach;
            if (isNear && double.IsNaN(from)) from = marks[i - 1];
            if (!isNear && !double.IsNaN(from)) covered.Add(from, marks[i - 1]); // whole at once: parts of it would not touch the interval covered before them
            if (!isNear) from = double.NaN;
        }

        if (!double.IsNaN(from)) covered.Add(from, 1.0);
    }

    private static void IncludeDisc(Point2D origin, Vector2D along, Point2D centre, double reach, ref double from, ref double to)
    {
        var spoke = centre - origin;
        var (foot, beside) = (spoke.Dot(along), along.Cross(spoke));
        if (Math.Abs(beside) > reach) return;
        var half = Math.Sqrt((reach * reach) - (beside * beside));
        (from, to) = (Math.Min(from, foot - half), Math.Max(to, foot + half));
    }

    private static void IncludeStrip(Point2D origin, Vector2D along, Point2D cutStart, Vector2D way, double length, double reach, ref double from, ref double to)
    {
        var spoke = origin - cutStart;
        var (low, high) = (double.NegativeInfinity, double.PositiveInfinity);
        Clip(spoke.Dot(way), along.Dot(way), 0.0, length, ref low, ref high);
        Clip(way.Cross(spoke), way.Cross(along), -reach, reach, ref low, ref high);
        if (low <= high) (from, to) = (Math.Min(from, low), Math.Max(to, high));
    }

    /// <summary>Keeps the parameters at which start + slope x parameter is between two values.</summary>
    private static void Clip(double start, double slope, double least, double most, ref double low, ref double high)
    {
        if (slope == 0.0)
        {
            if (start < least || start > most) (low, high) = (1.0, 0.0);
            return;
        }

        var (first, last) = ((least - start) / slope, (most - start) / slope);
        low = Math.Max(low, Math.Min(first, last));
        high = Math.Min(high, Math.Max(first, last));
    }

    /// <summary>Marks where the drawn segment crosses a circle.</summary>
    private static void AddDisc(in Segment drawn, Point2D centre, double radius, Span<double> marks, ref int count)
    {
        if (radius <= 0.0) return;
        if (drawn.Kind == SegmentKind.Line)
        {
            var length = drawn.Length;
            var along = (drawn.End - drawn.Start) * (1.0 / length);
            var (from, to) = (double.PositiveInfinity, double.NegativeInfinity);
            IncludeDisc(drawn.Start, along, centre, radius, ref from, ref to);
            Mark(from / length, marks, ref count);
            Mark(to / length, marks, ref count);
            return;
        }

        var arc = drawn.Arc;
        var spoke = centre - arc.Centre;
        var distance = spoke.Length;
        var (gap, sum) = (distance - arc.Radius, distance + arc.Radius);
        MarkAngles(arc, Math.Atan2(spoke.Y, spoke.X), (radius - gap) * (radius + gap), (sum - radius) * (sum + radius), marks, ref count);
    }

    /// <summary>Marks where the drawn segment crosses the line beside a cut, to its left for a positive offset.</summary>
    private static void AddOffset(in Segment drawn, LineSegment cut, double offset, Span<double> marks, ref int count)
    {
        var length = cut.Length;
        if (length == 0.0) return;
        var way = (cut.End - cut.Start) * (1.0 / length);
        if (drawn.Kind == SegmentKind.Line)
        {
            var chord = drawn.End - drawn.Start;
            if (way.Cross(chord) is not 0.0 and var slope) Mark((offset - way.Cross(drawn.Start - cut.Start)) / slope, marks, ref count);
            return;
        }

        // The height of the arc above the cut is that of its centre plus radius times the cosine from the normal.
        var arc = drawn.Arc;
        var height = offset - way.Cross(arc.Centre - cut.Start);
        MarkAngles(arc, Math.Atan2(way.X, -way.Y), arc.Radius - height, arc.Radius + height, marks, ref count);
    }

    /// <summary>Marks the two places at equal angles from a direction. The angle is given by the squares of the sine and the cosine of its half, in any common
    /// unit: with the cosine of the angle, an arc of kilometres would have a resolution of only a tenth of a millimetre.</summary>
    private static void MarkAngles(ArcSegment arc, double direction, double sineSquared, double cosineSquared, Span<double> marks, ref int count)
    {
        if (!(sineSquared >= 0.0 && cosineSquared >= 0.0) || sineSquared + cosineSquared == 0.0) return;
        var half = 2.0 * Math.Atan2(Math.Sqrt(sineSquared), Math.Sqrt(cosineSquared));
        MarkAngle(arc, direction - half, marks, ref count);
        MarkAngle(arc, direction + half, marks, ref count);
    }

    private static void MarkAngle(ArcSegment arc, double angle, Span<double> marks, ref int count)
    {
        var sweep = arc.Sweep.Radians;
        var ahead = Math.IEEERemainder(angle - arc.Start.Radians, 2.0 * Math.PI) * Math.Sign(sweep);
        Mark((ahead < 0.0 ? ahead + (2.0 * Math.PI) : ahead) / Math.Abs(sweep), marks, ref count);
    }

    private static void Mark(double fraction, Span<double> marks, ref int count)
    {
        if (fraction is > 0.0 and < 1.0) marks[count++] = fraction;
    }
}

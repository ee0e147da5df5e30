using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>A check behind the mapping that shares nothing with it: how long a curve is by the numbers of its record, compared with how long it became. A visible curve never vanishes or shrinks without an error.</summary>
/// <remarks>Lengths in space, in the units of the record. Both are estimates that are never much too short (chords), for only a difference of orders of magnitude is looked for.</remarks>
internal static class WrittenLength
{
    /// <summary>A curve that became shorter than this part of what was written is lost.</summary>
    private const double Smallest = 1e-6;

    /// <summary>Angles and parameters nearer than this are equal: nothing is written between them.</summary>
    private const double Equal = 1e-9;

    /// <summary>Chords that stand for a curve; an odd number, so that the ends of a quarter turn are not all of them.</summary>
    private const int Chords = 17;

    /// <returns>Both lengths where the curve is lost; null where it is as long as it was written, or nothing was written.</returns>
    public static (double Written, double Read)? Lost(EntityRecord record, CurveShape shape)
    {
        var written = shape.Type switch
        {
            CurveType.Line => (record.Point(11) - record.Point(10)).Length,
            CurveType.Circle => Math.Tau * Math.Abs(record.Number(40, 0.0)),
            CurveType.Arc => Math.Abs(record.Number(40, 0.0)) * Span((record.Number(51, 0.0) - record.Number(50, 0.0)) * Math.PI / 180.0),
            CurveType.Ellipse => OfEllipse(record),
            CurveType.LwPolyline or CurveType.Spline => OfPoints(record),
            _ => 0.0,
        };
        if (!double.IsFinite(written) || written == 0.0) return null;
        var read = Read(shape);
        return read < Smallest * written ? (written, read) : null;
    }

    /// <summary>Angle that a curve covers by its two angles as they are written, radians: at most a turn.</summary>
    private static double Span(double raw) => Math.Abs(raw) <= Equal ? 0.0 : Math.Min(Math.Abs(raw), Math.Tau);

    /// <summary>Chords of a cos, b sin over what is written.</summary>
    private static double OfEllipse(EntityRecord record)
    {
        var (major, start) = (record.Point(11).Length, record.Number(41, 0.0));
        var (minor, span, length) = (major * record.Number(40, 0.0), Span(record.Number(42, Math.Tau) - start), 0.0);
        if (span == 0.0) return 0.0;
        for (var i = 1; i <= Chords; i++)
        {
            var (from, to) = (start + (span * (i - 1) / Chords), start + (span * i / Chords));
            length += double.Hypot(major * (Math.Cos(to) - Math.Cos(from)), minor * (Math.Sin(to) - Math.Sin(from)));
        }

        return length;
    }

    /// <summary>The largest extent of the points of a sequence in X or Y: a curve through or near them is not shorter by orders of magnitude.</summary>
    private static double OfPoints(EntityRecord record)
    {
        var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
        var (bottom, top) = (double.PositiveInfinity, double.NegativeInfinity);
        foreach (var (code, value) in record.Sequence)
        {
            if (code == 10) (low, high) = (Math.Min(low, value), Math.Max(high, value));
            else if (code == 20) (bottom, top) = (Math.Min(bottom, value), Math.Max(top, value));
        }

        return high < low || top < bottom ? 0.0 : Math.Max(high - low, top - bottom);
    }

    private static double Read(CurveShape shape)
    {
        var length = 0.0;
        foreach (ref readonly var part in shape.Parts) length += part.IsFreeCurve ? OfCurve(shape.Curves[part.CurveIndex]) : part.SpaceLength;
        return length;
    }

    /// <summary>The extent of the control points in space, which the curve does not leave.</summary>
    private static double OfCurve(RationalCurve curve)
    {
        var (low, high) = (new Vector3D(double.MaxValue, double.MaxValue, double.MaxValue), new Vector3D(double.MinValue, double.MinValue, double.MinValue));
        foreach (var span in curve.Spans)
        {
            for (var i = 0; i <= span.Degree; i++)
            {
                var (point, z) = (span.Control(i), span.Z(i));
                low = new Vector3D(Math.Min(low.X, point.X), Math.Min(low.Y, point.Y), Math.Min(low.Z, z));
                high = new Vector3D(Math.Max(high.X, point.X), Math.Max(high.Y, point.Y), Math.Max(high.Z, z));
            }
        }

        return (high - low).Length;
    }
}

using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>Converts between the unit of a drawing and millimetres: the only place where this unit changes. It belongs to a drawing, which gets it when it is
/// opened or created and keeps it whatever unit is set for the next drawing.</summary>
/// <remarks>Lengths, radii and heights are numbers. <c>default</c> is not a valid scale.</remarks>
/// <param name="MillimetresPerUnit">Above 0. To be shown and written; calculations use the methods.</param>
public readonly record struct DrawingScale(double MillimetresPerUnit)
{
    /// <summary>The scale of a drawing in millimetres, and where no drawing is open.</summary>
    public static DrawingScale Millimetres { get; } = new(1.0);

    /// <summary>The map of the plane from millimetres to drawing units.</summary>
    public Transform2D MapToDrawing => Transform2D.ScaleFrom(Point2D.Origin, 1.0 / MillimetresPerUnit);

    public double ToMillimetres(double drawn) => drawn * MillimetresPerUnit;

    public Point2D ToMillimetres(Point2D drawn) => new(drawn.X * MillimetresPerUnit, drawn.Y * MillimetresPerUnit);

    public Bounds2D ToMillimetres(Bounds2D drawn) => new(ToMillimetres(drawn.MinX), ToMillimetres(drawn.MinY), ToMillimetres(drawn.MaxX), ToMillimetres(drawn.MaxY));

    public RationalCurve ToMillimetres(RationalCurve drawn)
    {
        ArgumentNullException.ThrowIfNull(drawn);
        return drawn.Scaled(MillimetresPerUnit);
    }

    public double ToDrawing(double millimetres) => millimetres / MillimetresPerUnit;

    public Point2D ToDrawing(Point2D millimetres) => new(millimetres.X / MillimetresPerUnit, millimetres.Y / MillimetresPerUnit);

    public RationalCurve ToDrawing(RationalCurve millimetres)
    {
        ArgumentNullException.ThrowIfNull(millimetres);
        return millimetres.Scaled(1.0 / MillimetresPerUnit);
    }

    public Segment ToDrawing(Segment millimetres)
    {
        if (millimetres.Kind == SegmentKind.Line) return Segment.FromLine(ToDrawing(millimetres.Start), ToDrawing(millimetres.End));
        if (millimetres.IsFreeCurve) return Segment.FromCurve(ToDrawing(millimetres.Curve));
        return Segment.FromArc(millimetres.Arc with { Centre = ToDrawing(millimetres.Arc.Centre), Radius = ToDrawing(millimetres.Arc.Radius) });
    }

    public Bounds2D ToDrawing(Bounds2D millimetres) =>
        new(ToDrawing(millimetres.MinX), ToDrawing(millimetres.MinY), ToDrawing(millimetres.MaxX), ToDrawing(millimetres.MaxY));
}

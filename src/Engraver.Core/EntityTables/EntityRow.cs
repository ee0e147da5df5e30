using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>Read-only view of one row: a directed segment in millimetres. Valid as long as its table.</summary>
public readonly ref struct EntityRow
{
    internal EntityRow(ReadOnlySpan<double> slots, int entityIndex, RationalCurve? curve)
    {
        Slots = slots;
        EntityIndex = entityIndex;
        Curve = curve;
    }

    /// <summary>The 16 slots, see <see cref="EntitySlot"/>.</summary>
    public ReadOnlySpan<double> Slots { get; }

    /// <summary>The drawing entity the row came from.</summary>
    public int EntityIndex { get; }

    /// <summary>The exact curve of kind 4 or 5 in the row's direction; null for the others.</summary>
    public RationalCurve? Curve { get; }

    public double this[int slot] => Slots[slot];

    public SegmentKind Kind => (SegmentKind)(int)Slots[EntitySlot.Kind];

    public Point2D StartPoint => new(Slots[EntitySlot.StartX], Slots[EntitySlot.StartY]);

    public Point2D EndPoint => new(Slots[EntitySlot.EndX], Slots[EntitySlot.EndY]);

    public Point2D Centre => new(Slots[EntitySlot.CentreX], Slots[EntitySlot.CentreY]);

    public double Radius => Slots[EntitySlot.Radius];

    public Angle StartAngle => Angle.FromDegrees(Slots[EntitySlot.StartAngle]);

    public Angle EndAngle => Angle.FromDegrees(Slots[EntitySlot.EndAngle]);

    /// <summary>1 is cut first; 0 means not sequenced.</summary>
    public int SequenceNumber => (int)Slots[EntitySlot.SequenceNumber];

    /// <summary>Signed sweep, counter-clockwise positive; 0 before analysis and for lines.</summary>
    public double SweepDegrees => Slots[EntitySlot.Sweep];

    /// <summary>The directed segment of an analysed row, in plan. Its ends are exactly those of slots 1, 2 and 4, 5.</summary>
    public Segment ToSegment()
    {
        if (Kind == SegmentKind.Line) return Segment.FromLine(StartPoint, EndPoint);
        return Curve is null
            ? Segment.FromArc(new ArcSegment(Centre, Radius, StartAngle, Angle.FromDegrees(SweepDegrees)), StartPoint, EndPoint)
            : Segment.FromCurve(Curve);
    }
}

using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>Read-only view of one row: a directed segment in millimetres. Valid as long as its table.</summary>
public readonly ref struct EntityRow
{
    private readonly SlotRows.SlotChunk _chunk;
    private readonly int _place;

    internal EntityRow(SlotRows.SlotChunk chunk, int place, int entityIndex, RationalCurve? curve)
    {
        (_chunk, _place) = (chunk, place);
        EntityIndex = entityIndex;
        Curve = curve;
    }

    /// <summary>A copy of the 16 slots, see <see cref="EntitySlot"/>.</summary>
    public ReadOnlySpan<double> Slots
    {
        get
        {
            var slots = new double[EntitySlot.Count];
            for (var slot = 0; slot < slots.Length; slot++) slots[slot] = this[slot];
            return slots;
        }
    }

    /// <summary>The drawing entity the row came from.</summary>
    public int EntityIndex { get; }

    /// <summary>The exact curve of kind 4 or 5 in the row's direction; null for the others.</summary>
    public RationalCurve? Curve { get; }

    public double this[int slot] => _chunk[_place, slot];

    public SegmentKind Kind => (SegmentKind)(int)this[EntitySlot.Kind];

    public Point2D StartPoint => new(this[EntitySlot.StartX], this[EntitySlot.StartY]);

    public Point2D EndPoint => new(this[EntitySlot.EndX], this[EntitySlot.EndY]);

    public Point2D Centre => new(this[EntitySlot.CentreX], this[EntitySlot.CentreY]);

    public double Radius => this[EntitySlot.Radius];

    public Angle StartAngle => Angle.FromDegrees(this[EntitySlot.StartAngle]);

    public Angle EndAngle => Angle.FromDegrees(this[EntitySlot.EndAngle]);

    /// <summary>1 is cut first; 0 means not sequenced.</summary>
    public int SequenceNumber => (int)this[EntitySlot.SequenceNumber];

    /// <summary>Signed sweep, counter-clockwise positive; 0 before analysis and for lines.</summary>
    public double SweepDegrees => this[EntitySlot.Sweep];

    /// <summary>The directed segment of an analysed row, in plan. Its ends are exactly those of slots 1, 2 and 4, 5.</summary>
    public Segment ToSegment()
    {
        if (Kind == SegmentKind.Line) return Segment.FromLine(StartPoint, EndPoint);
        return Curve is null
            ? Segment.FromArc(new ArcSegment(Centre, Radius, StartAngle, Angle.FromDegrees(SweepDegrees)), StartPoint, EndPoint)
            : Segment.FromCurve(Curve);
    }
}

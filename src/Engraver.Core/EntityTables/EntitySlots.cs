using System.Runtime.CompilerServices;
using Engraver.Core.Geometry;

namespace Engraver.Core.EntityTables;

/// <summary>The 16 doubles of one row while it is being written: 128 bytes, two cache lines.</summary>
[InlineArray(EntitySlot.Count)]
internal struct EntitySlots
{
    private double _first;

    public Point2D Centre => new(this[EntitySlot.CentreX], this[EntitySlot.CentreY]);

    /// <summary>The slots of an analysed row for a line or an arc at one height.</summary>
    public static EntitySlots Of(in Segment segment, double z)
    {
        var slots = default(EntitySlots);
        slots[EntitySlot.Kind] = (int)segment.Kind;
        slots.SetStart(segment.Start, z);
        slots.SetEnd(segment.End, z);
        if (segment.Kind == SegmentKind.Line) return slots;
        var arc = segment.Arc;
        slots.SetCentre(arc.Centre, z);
        slots[EntitySlot.Radius] = arc.Radius;
        slots[EntitySlot.StartAngle] = arc.Start.Degrees;
        slots[EntitySlot.EndAngle] = arc.Start.Degrees + arc.Sweep.Degrees;
        slots[EntitySlot.Sweep] = arc.Sweep.Degrees;
        if (segment.Kind == SegmentKind.Circle) slots.StartCircleAt(arc.Start);
        return slots;
    }

    /// <summary>The same points in the opposite direction: ends swapped, angles swapped, sweep negated.</summary>
    public void Reverse()
    {
        for (var axis = 0; axis < 3; axis++) Swap(EntitySlot.StartX + axis, EntitySlot.EndX + axis);
        Swap(EntitySlot.StartAngle, EntitySlot.EndAngle);
        if (this[EntitySlot.Sweep] != 0.0) this[EntitySlot.Sweep] = -this[EntitySlot.Sweep];
    }

    /// <summary>Makes a circle start and end in the direction <paramref name="start"/> from its centre; its direction of travel does not change.</summary>
    public void StartCircleAt(Angle start)
    {
        var place = Centre + Vector2D.FromPolar(this[EntitySlot.Radius], start);
        SetStart(place, this[EntitySlot.CentreZ]);
        SetEnd(place, this[EntitySlot.CentreZ]);
        var backwards = this[EntitySlot.Sweep] < 0.0;
        this[EntitySlot.StartAngle] = backwards ? start.Degrees + 360.0 : start.Degrees;
        this[EntitySlot.EndAngle] = backwards ? start.Degrees : start.Degrees + 360.0;
    }

    public void SetStart(Point2D place, double z) => SetTriple(EntitySlot.StartX, place, z);

    public void SetEnd(Point2D place, double z) => SetTriple(EntitySlot.EndX, place, z);

    public void SetCentre(Point2D place, double z) => SetTriple(EntitySlot.CentreX, place, z);

    private void SetTriple(int first, Point2D place, double z)
    {
        this[first] = place.X;
        this[first + 1] = place.Y;
        this[first + 2] = z;
    }

    private void Swap(int left, int right) => (this[left], this[right]) = (this[right], this[left]);
}

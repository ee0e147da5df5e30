using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Dxf.Tags;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Mapping;

/// <summary>Converts a POINT into a placed point. Its position is in world coordinates whatever its extrusion (DXF reference, "POINT"), inside a block in the
/// block's.</summary>
internal static class PlacedPoints
{
    /// <summary>The point of a record; null when it has no position, or one out of range.</summary>
    public static PlacedPoint? Map(EntityRecord record) =>
        record.Has(10) && record.Has(20) && InRange(record.PointOrOrigin(10)) ? new PlacedPoint(record.PointOrOrigin(10), record.Layer, record.Colour, record.Invisible) { Linetype = record.Linetype, Handle = record.Handle, SourceLine = record.Line } : null;

    public static bool InRange(Vector3D place) => Fits(place.X) && Fits(place.Y) && Fits(place.Z);

    private static bool Fits(double value) => Math.Abs(value) <= DxfNumber.Largest;
}

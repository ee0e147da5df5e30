namespace Engraver.Core.Drawings;

/// <summary>The DXF type a curve was written as; an arc in a block stays an Arc here whatever the block's scale makes of it.</summary>
public enum CurveType : byte
{
    Line,
    Arc,
    Circle,
    Ellipse,
    Spline,
    LwPolyline,
    Polyline,
}

using System.Diagnostics;

namespace Engraver.Core.Drawings;

/// <summary>The DXF spelling of a curve type, and which of them are letters.</summary>
public static class CurveTypeName
{
    /// <summary>True for the letters of a text: the ends of their strokes are ends as written, not gaps.</summary>
    public static bool IsLetters(this CurveType type) => type is CurveType.Text or CurveType.MText or CurveType.Attribute;

    /// <summary>"LINE", "LWPOLYLINE" ...</summary>
    public static string ToDxfName(this CurveType type) => type switch
    {
        CurveType.Line => "LINE",
        CurveType.Arc => "ARC",
        CurveType.Circle => "CIRCLE",
        CurveType.Ellipse => "ELLIPSE",
        CurveType.Spline => "SPLINE",
        CurveType.LwPolyline => "LWPOLYLINE",
        CurveType.Polyline => "POLYLINE",
        CurveType.Hatch => "HATCH",
        CurveType.MLine => "MLINE",
        CurveType.Leader => "LEADER",
        CurveType.Helix => "HELIX",
        CurveType.Solid => "SOLID",
        CurveType.Trace => "TRACE",
        CurveType.Face3D => "3DFACE",
        CurveType.Text => "TEXT",
        CurveType.MText => "MTEXT",
        CurveType.Attribute => "ATTRIB",
        CurveType.Point => "POINT",
        CurveType.Insert => "INSERT",
        _ => throw new UnreachableException(),
    };
}

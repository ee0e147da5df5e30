using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>The plane of an MTEXT: x along the lines, y up, the insertion point at its origin.</summary>
internal static class ParagraphPlane
{
    /// <summary>The sine of an angle that is taken as zero.</summary>
    private const double Parallel = 1e-9;

    /// <summary>From the plane to the drawing. The direction of the lines is in the system of the block, the rotation in that of the extrusion; a direction
    /// that is not perpendicular to the extrusion is projected (DXF reference, "MTEXT", groups 11, 50, 210).</summary>
    public static Placement Of(PlacedText text)
    {
        var written = text.Written;
        var own = written.Extrusion == default ? Placement.Identity : Placement.FromExtrusion(written.Extrusion);
        var x = Along(written.Paragraphs?.XAxis, own.ZAxis) ?? own.ApplyToDirection(new Vector3D(written.Rotation.Cos(), written.Rotation.Sin(), 0.0));
        return text.Inserts.After(new Placement(x, own.ZAxis.Cross(x), own.ZAxis, written.Insertion));
    }

    /// <summary>Null for a direction that is not stated, or is that of the extrusion.</summary>
    private static Vector3D? Along(Vector3D? stated, Vector3D normal)
    {
        if (stated is not { } axis || axis == default) return null;
        var unit = axis.Unit();
        var flat = unit - (normal * unit.Dot(normal));
        return flat.Length > Parallel ? flat.Unit() : null;
    }
}

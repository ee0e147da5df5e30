using Engraver.Core.Geometry;
using Engraver.Fonts;
using Engraver.Fonts.Finding;

namespace Engraver.Workbench.Lettering;

/// <summary>A character at its place.</summary>
/// <param name="Font">The font that has its shape.</param>
/// <param name="CodePoint">The character; 0 for the box that stands for a character without a shape.</param>
/// <param name="Map">From font units to the plane of the layout: drawing units, x along the line, y up.</param>
public sealed record GlyphPlace(FoundFont Font, int CodePoint, GlyphCurves Curves, Placement Map)
{
    /// <summary>The character moved in the plane of the layout.</summary>
    public GlyphPlace MovedBy(double x, double y) => this with { Map = Map.MovedBy(new Vector3D(x, y, 0.0)) };
}

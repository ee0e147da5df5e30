using Engraver.Core.Geometry;

namespace Engraver.Workbench.Lettering;

/// <summary>The characters of a text at their places.</summary>
/// <param name="Plane">From the plane of the layout to the drawing: the text's own system and the inserts around it.</param>
/// <param name="Glyphs">In reading order.</param>
/// <param name="Rules">Lines that are drawn with the letters.</param>
/// <param name="Notes">Each once.</param>
public sealed record TextLayout(Placement Plane, IReadOnlyList<GlyphPlace> Glyphs, IReadOnlyList<LayoutRule> Rules, IReadOnlyList<LayoutNote> Notes);

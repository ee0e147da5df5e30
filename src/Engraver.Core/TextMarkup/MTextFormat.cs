using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.TextMarkup;

/// <summary>The format of characters of an MTEXT. What is null comes from the entity or its style.</summary>
public sealed record MTextFormat
{
    public static MTextFormat Initial { get; } = new();

    /// <summary>\H: in drawing units or as a multiple.</summary>
    public MTextValue Height { get; init; } = MTextValue.Inherited;

    /// <summary>\W: relative width of the letters.</summary>
    public MTextValue Width { get; init; } = MTextValue.Inherited;

    /// <summary>\T: distance of the letters as a multiple of the font's.</summary>
    public double Tracking { get; init; } = 1.0;

    /// <summary>\Q: slant, clockwise positive.</summary>
    public Angle? Oblique { get; init; }

    /// <summary>\C an index, \c a true colour.</summary>
    public DrawingColour? Colour { get; init; }

    public MTextFont? Font { get; init; }

    /// <summary>\L, \O, \K.</summary>
    public LineMarks Marks { get; init; }

    /// <summary>\A: place of lower letters and stacks in the height of the line.</summary>
    public LineAlignment Alignment { get; init; }
}

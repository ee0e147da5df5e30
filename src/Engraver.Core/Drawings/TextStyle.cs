using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>A row of the STYLE table. DXF reference, "STYLE".</summary>
/// <param name="Name">Group 2, as spelled in the table; texts refer to it in any case.</param>
public sealed record TextStyle(string Name)
{
    private const int Bold = 0x02000000;
    private const int Italic = 0x01000000;

    /// <summary>Group 3: the font file; "" where it is not stated.</summary>
    public string FontFile { get; init; } = "";

    /// <summary>Group 4: the font file of Asian characters; "" for none.</summary>
    public string BigFontFile { get; init; } = "";

    /// <summary>Group 40: the height of every text of the style; 0 when it is not fixed.</summary>
    public double FixedHeight { get; init; }

    /// <summary>Group 41.</summary>
    public double WidthFactor { get; init; } = 1.0;

    /// <summary>Group 50.</summary>
    public Angle Oblique { get; init; }

    /// <summary>Group 71.</summary>
    public TextGeneration Generation { get; init; }

    /// <summary>Group 70, bit 4: the letters are below each other.</summary>
    public bool IsVertical { get; init; }

    /// <summary>Group 1000 of the extended data of ACAD: the family of a TrueType font; "" where it is not stated.</summary>
    public string Family { get; init; } = "";

    /// <summary>Group 1071 of the extended data of ACAD: pitch and family (bits 0 to 7), character set (8 to 15), italic (24), bold (25).</summary>
    public int FamilyFlags { get; init; }

    public bool IsBold => (FamilyFlags & Bold) != 0;

    public bool IsItalic => (FamilyFlags & Italic) != 0;
}

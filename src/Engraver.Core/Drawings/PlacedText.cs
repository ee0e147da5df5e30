using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>A text of the drawing, decoded and placed, in drawing units: a summary to show, and what the file states (<see cref="Written"/>), from which it
/// can be drawn exactly. It is not yet a curve.</summary>
public sealed record PlacedText
{
    /// <summary>TEXT, MTEXT or ATTRIB.</summary>
    public required string Type { get; init; }

    /// <summary>The readable text: codes resolved, formatting removed, lines separated by LF.</summary>
    public required string Content { get; init; }

    /// <summary>The reference point of the alignment.</summary>
    public required Vector3D Position { get; init; }

    /// <summary>The other end of an aligned or fitted text; null for every other alignment.</summary>
    public Vector3D? End { get; init; }

    /// <summary>Height of capital letters.</summary>
    public required double Height { get; init; }

    public required Angle Rotation { get; init; }

    /// <summary>Width of the letters as a multiple of the font's.</summary>
    public double WidthFactor { get; init; } = 1.0;

    /// <summary>Slant of the letters, clockwise positive.</summary>
    public Angle Oblique { get; init; }

    /// <summary>True when the letters are mirrored (a mirrored block, a negative extrusion).</summary>
    public bool Mirrored { get; init; }

    /// <summary>Width of the frame in which an MTEXT wraps; 0 when it does not wrap.</summary>
    public double FrameWidth { get; init; }

    /// <summary>Line distance of an MTEXT as a multiple of the standard distance.</summary>
    public double LineSpacing { get; init; } = 1.0;

    public TextColumnAlignment Column { get; init; }

    public TextRowAlignment Row { get; init; }

    public required string Style { get; init; }

    /// <summary>Font file of the style; "" when the drawing does not state one.</summary>
    public required string Font { get; init; }

    /// <summary>What the file states, from which the other values of this record are derived.</summary>
    public required WrittenText Written { get; init; }

    /// <summary>The inserts around the text, and edits since it was read: from the system of its block to the drawing.</summary>
    public Placement Inserts { get; init; } = Placement.Identity;

    /// <summary>As stated, "by block" resolved; by layer where none is stated.</summary>
    public DrawingColour Colour { get; init; }

    /// <summary>Lineweight as stated, hundredths of a millimetre or one of <see cref="Drawings.Lineweight"/>; "by block" resolved.</summary>
    public int Lineweight { get; init; } = Drawings.Lineweight.ByLayer;

    /// <summary>Index into <see cref="Drawing.BlockPaths"/>; 0 for a text of model space.</summary>
    public int BlockPath { get; init; }

    /// <summary>Index into <see cref="Drawing.Layers"/>.</summary>
    public required int Layer { get; init; }

    public ulong Handle { get; init; }

    public long SourceLine { get; init; }

    /// <summary>Its place in the file.</summary>
    public SourceRef Source => new(SourceLine, Handle == 0 ? null : Handle.ToString("X", CultureInfo.InvariantCulture));

    /// <summary>Invisible itself, or through its insert.</summary>
    public bool Hidden { get; init; }

    /// <summary>The text under a similarity of the plane; its height above the plane is scaled with it. Mirrored text is mirror-inverted.</summary>
    public PlacedText Transformed(Transform2D map) => this with
    {
        Position = Position.Transformed(map),
        End = End?.Transformed(map),
        Height = Height * map.Scale,
        FrameWidth = FrameWidth * map.Scale,
        Rotation = (map.Mirrored ? map.Turn - Rotation : map.Turn + Rotation).Positive(),
        Mirrored = Mirrored ^ map.Mirrored,
        Inserts = Placement.FromPlane(map).After(Inserts),
    };

    /// <summary>False if it is hidden, or its layer is off or frozen.</summary>
    public bool IsVisibleIn(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return !Hidden && drawing.Layers[Layer] is { On: true, Frozen: false };
    }
}

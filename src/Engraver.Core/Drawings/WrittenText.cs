using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>A text as its record in the file states it, with codes unresolved and no value folded into another, in drawing units. The copies of a block share
/// one; <see cref="PlacedText.Inserts"/> places each of them. DXF reference, "TEXT", "ATTRIB", "ATTDEF", "MTEXT".</summary>
public sealed record WrittenText
{
    /// <summary>Group 1; of an MTEXT groups 3 and 1 joined. Bytes are decoded, codes such as %%c, \U+XXXX and \P are not resolved.</summary>
    public required string Raw { get; init; }

    /// <summary>The first group whose number cannot be used, so that the place or form of the text is not known; 0 if all can.</summary>
    public int DamagedGroup { get; init; }

    /// <summary>Groups 10, 20, 30: of an MTEXT in the system of its block, of other texts in the system of their extrusion.</summary>
    public Vector3D Insertion { get; init; }

    /// <summary>Groups 11, 21, 31 of a TEXT: the second alignment point; null where it is not stated.</summary>
    public Vector3D? Second { get; init; }

    /// <summary>Group 40: height of capital letters; 0 where it is not stated.</summary>
    public double Height { get; init; }

    /// <summary>Group 41 of a TEXT: relative width of the letters; 1 where it is not stated.</summary>
    public double WidthFactor { get; init; } = 1.0;

    /// <summary>Group 51.</summary>
    public Angle Oblique { get; init; }

    /// <summary>Group 50, measured in the plane of the extrusion.</summary>
    public Angle Rotation { get; init; }

    /// <summary>Group 71 of a TEXT.</summary>
    public TextGeneration Generation { get; init; }

    /// <summary>Group 72 of a TEXT: 0 left, 1 centre, 2 right, 3 aligned, 4 middle, 5 fit.</summary>
    public int Horizontal { get; init; }

    /// <summary>Group 73 of a TEXT, 74 of an attribute: 0 baseline, 1 bottom, 2 middle, 3 top.</summary>
    public int Vertical { get; init; }

    /// <summary>Groups 210, 220, 230; 0,0,1 where they are not stated. The zero vector, which some programs write, means 0,0,1.</summary>
    public Vector3D Extrusion { get; init; }

    /// <summary>Group 2 of an attribute; "" for other texts.</summary>
    public string Tag { get; init; } = "";

    /// <summary>Group 3 of an ATTDEF: its prompt; "" for other texts.</summary>
    public string Prompt { get; init; } = "";

    /// <summary>Group 73 of an attribute: its field length, which AutoCAD does not use.</summary>
    public int FieldLength { get; init; }

    /// <summary>Group 70 of an attribute: 1 invisible, 2 constant, 4 verify, 8 preset.</summary>
    public int AttributeFlags { get; init; }

    /// <summary>What only an MTEXT states; null for other texts.</summary>
    public WrittenParagraphs? Paragraphs { get; init; }

    /// <summary>From the system of <see cref="Insertion"/> and <see cref="Second"/> to that of the block, or of the drawing outside blocks.</summary>
    public Placement OwnSystem => Paragraphs is not null || Extrusion == default ? Placement.Identity : Placement.FromExtrusion(Extrusion);
}

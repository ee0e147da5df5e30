namespace Engraver.Core.TextMarkup;

/// <summary>The format of a paragraph (\p). Lengths are multiples of the height of the entity.</summary>
public sealed record ParagraphFormat
{
    public static ParagraphFormat Initial { get; } = new();

    /// <summary>i: of the first line, from <see cref="Left"/>; may be negative.</summary>
    public double Indent { get; init; }

    /// <summary>l: of all lines.</summary>
    public double Left { get; init; }

    /// <summary>r.</summary>
    public double Right { get; init; }

    /// <summary>b.</summary>
    public double SpaceBefore { get; init; }

    /// <summary>a.</summary>
    public double SpaceAfter { get; init; }

    /// <summary>q; as the attachment of the entity where it is not stated.</summary>
    public ParagraphAlignment Alignment { get; init; }

    /// <summary>s with e (exactly), a (at least) or m (multiple); as the entity where it is not stated.</summary>
    public ParagraphSpacing Spacing { get; init; }

    /// <summary>The number of s.</summary>
    public double SpacingValue { get; init; }

    /// <summary>t, in the order in which they are written.</summary>
    public IReadOnlyList<TabStop> Tabs { get; init; } = [];
}

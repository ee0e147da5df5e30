using Engraver.Core.Drawings;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>The justifications of a TEXT, as AutoCAD names them.</summary>
/// <param name="Name">The option; its capital letters are the short form.</param>
/// <param name="Horizontal">Group 72.</param>
/// <param name="Vertical">Group 73.</param>
internal sealed record TextJustification(string Name, int Horizontal, int Vertical)
{
    public static TextJustification Left { get; } = new("Left", 0, 0);

    /// <summary>Those of an MTEXT, in the order of its group 71: top, middle and bottom with left, centre and right.</summary>
    public static IReadOnlyList<TextJustification> Corners { get; } = [.. from row in "TMB" from column in "LCR" select new TextJustification($"{row}{column}", "LCR".IndexOf(column, StringComparison.Ordinal), 3 - "TMB".IndexOf(row, StringComparison.Ordinal))];

    /// <summary>In AutoCAD's order.</summary>
    public static IReadOnlyList<TextJustification> All { get; } =
    [
        Left, new("Center", 1, 0), new("Right", 2, 0), new("Align", 3, 0), new("Middle", 4, 0), new("Fit", 5, 0),
        .. Corners,
    ];

    /// <summary>Between two points, which give the direction.</summary>
    public bool IsBetween => Horizontal is 3 or 5;

    public bool IsAligned => Horizontal == 3;

    /// <summary>Group 71 of an MTEXT.</summary>
    public int Attachment => 1 + Horizontal + (3 * (3 - Vertical));

    /// <summary>The insertion point is that of the alignment.</summary>
    public bool IsLeft => (Horizontal, Vertical) == (0, 0);

    /// <summary>The option for the present language.</summary>
    public string Shown => new Keyword(Name).Shown;

    /// <summary>That of a text.</summary>
    public static TextJustification Of(PlacedText text)
    {
        if (text.Written.Paragraphs is { } paragraphs) return Corners[Math.Clamp(paragraphs.Attachment, 1, 9) - 1];
        var (across, up) = (Math.Clamp(text.Written.Horizontal, 0, 5), text.Written.Horizontal > 2 ? 0 : Math.Clamp(text.Written.Vertical, 0, 3));
        return All.First(one => (one.Horizontal, one.Vertical) == (across, up));
    }
}

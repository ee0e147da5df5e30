namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>What is set side by side in a line. Its own plane begins at the pen, with the baseline at y = 0.</summary>
/// <param name="Advance">From the pen before it to the pen after it; 0 for a tab and for breaks.</param>
/// <param name="Body">The height that is aligned in the line: of capital letters, or of the whole stack.</param>
internal sealed record LineItem(LineItemKind Kind, SetFormat Format, double Advance, double Body)
{
    /// <summary>Its characters; for a stack the sign of an object.</summary>
    public string Text { get; init; } = Kind == LineItemKind.Stack ? "\uFFFC" : " ";

    /// <summary>A part of the text is written from right to left.</summary>
    public bool HasRightToLeft { get; init; }

    public IReadOnlyList<GlyphPlace> Glyphs { get; init; } = [];

    /// <summary>The bar of a fraction.</summary>
    public IReadOnlyList<LayoutRule> Rules { get; init; } = [];

    /// <summary>Around its curves and rules; the slant of the letters is not considered.</summary>
    public InkBox Ink { get; init; } = InkBox.None;

    public bool HasInk => !Ink.IsEmpty;

    /// <summary>A line may be wrapped after it.</summary>
    public bool IsGap => Kind is LineItemKind.Blank or LineItemKind.Tab;
}

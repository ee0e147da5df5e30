namespace Engraver.Workbench.Lettering.Paragraphs;

internal enum LineItemKind : byte
{
    /// <summary>Letters of one format, between which a line is not wrapped.</summary>
    Letters,

    /// <summary>A fraction or tolerance.</summary>
    Stack,

    /// <summary>One blank.</summary>
    Blank,

    /// <summary>A blank at which a line is not wrapped.</summary>
    FixedBlank,

    Tab,

    /// <summary>The line ends, the paragraph does not.</summary>
    LineBreak,

    /// <summary>The line ends; the next one is in the next column.</summary>
    ColumnBreak,
}

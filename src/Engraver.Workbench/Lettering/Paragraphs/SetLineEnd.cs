namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>Why a line ends.</summary>
internal enum SetLineEnd : byte
{
    Paragraph,
    Wrapped,
    LineBreak,
    ColumnBreak,
}

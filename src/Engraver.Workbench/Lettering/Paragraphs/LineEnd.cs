namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>Why a line ends.</summary>
internal enum LineEnd : byte
{
    Paragraph,
    Wrapped,
    LineBreak,
    ColumnBreak,
}

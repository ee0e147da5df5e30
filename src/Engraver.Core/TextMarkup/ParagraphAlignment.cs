namespace Engraver.Core.TextMarkup;

public enum ParagraphAlignment : byte
{
    Default,
    Left,
    Right,
    Centre,
    Justified,

    /// <summary>The letters of every line are spread over the width.</summary>
    Distributed,
}

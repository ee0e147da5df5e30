namespace Engraver.Core.TextMarkup;

public enum MTextPieceKind : byte
{
    Text,

    /// <summary>^I: to the next tab stop.</summary>
    Tab,

    /// <summary>\N: the next column begins.</summary>
    ColumnBreak,

    /// <summary>\X: what follows is below the line of a dimension.</summary>
    DimensionLineBreak,

    /// <summary>\S: a fraction or a tolerance.</summary>
    Stack,
}

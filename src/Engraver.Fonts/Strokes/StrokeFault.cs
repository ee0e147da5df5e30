namespace Engraver.Fonts.Strokes;

/// <summary>What is wrong in a line of a stroke font.</summary>
public enum StrokeFault : byte
{
    /// <summary>Not a line of the format: a colon, an equals sign or a word is missing, or one is too many.</summary>
    Malformed,

    /// <summary>Not a character and not U+ with hexadecimal digits.</summary>
    NotACharacter,

    /// <summary>Not a finite number within 100 000.</summary>
    NotANumber,

    UnknownCommand,

    /// <summary>A command that needs a point or a piece before it or after it, or a stroke without pieces.</summary>
    Misplaced,

    /// <summary>A piece from a point to the same point, a quarter oval without width or height, or an arc of a whole turn or more.</summary>
    NoPiece,

    /// <summary>The character has two shapes, or the metrics are listed twice.</summary>
    Duplicate,

    /// <summary>The shape that is referred to does not exist, or it is a mark where a glyph is needed, or a glyph where a mark is needed.</summary>
    NoSuchShape,

    /// <summary>The shape refers to itself, directly or through others.</summary>
    Circular,

    /// <summary>No shape before the mark has the anchor.</summary>
    NoSuchAnchor,

    /// <summary>The file has no metrics, or they are not positive.</summary>
    NoMetrics,

    /// <summary>The advance is not positive.</summary>
    NoAdvance,
}

namespace Engraver.Shaping;

/// <summary>How a character takes part in the direction of a line (Unicode Standard Annex 9, table 4).</summary>
internal enum BidiClass : byte
{
    /// <summary>Left to right: L.</summary>
    LeftToRight,

    /// <summary>Hebrew and its neighbours: R.</summary>
    RightToLeft,

    /// <summary>Arabic and its neighbours: AL.</summary>
    ArabicLetter,

    /// <summary>EN.</summary>
    EuropeanNumber,

    /// <summary>A sign between or before numbers: ES.</summary>
    NumberSign,

    /// <summary>A unit or currency beside a number: ET.</summary>
    NumberUnit,

    /// <summary>AN.</summary>
    ArabicNumber,

    /// <summary>A point or comma in a number: CS.</summary>
    NumberSeparator,

    /// <summary>A mark on the character before it: NSM.</summary>
    Mark,

    /// <summary>Blanks and everything else: WS, ON.</summary>
    Neutral,
}

namespace Engraver.Workbench.Lettering;

/// <summary>What the layout of a text reports.</summary>
public enum LayoutNoteKind : byte
{
    /// <summary>The font has no such character: the stroke font's shape is used.</summary>
    GlyphSubstituted,

    /// <summary>No font has such a character: a box is cut.</summary>
    GlyphMissing,

    /// <summary>The glyph of a font cannot be read: as a missing character.</summary>
    GlyphBroken,

    /// <summary>A code without a meaning, or a field without a value.</summary>
    UnknownCode,

    /// <summary>A form of layout that is not carried out: the letters are cut without it.</summary>
    FormIgnored,

    /// <summary>A script whose letters change with their neighbours; they are cut as separate characters.</summary>
    Unshaped,
}

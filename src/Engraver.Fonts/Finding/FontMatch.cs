namespace Engraver.Fonts.Finding;

public enum FontMatch : byte
{
    /// <summary>The font that was requested.</summary>
    Exact,

    /// <summary>The substitution table names this font for the requested one.</summary>
    ByTable,

    /// <summary>Another font, because neither the requested one nor one of the table can be used.</summary>
    Substitute,
}

namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>Opens the outlines of a face in the format that it has.</summary>
public static class GlyphOutlines
{
    public static bool IsIn(FontFile file) => file.Has("glyf") || file.Has("CFF ");

    /// <exception cref="BrokenFontException">The face has no outlines, or their tables are invalid.</exception>
    public static IGlyphOutlines Read(FontFile file) => file.Has("glyf") ? new GlyfOutlines(file) : new CffOutlines(file);
}

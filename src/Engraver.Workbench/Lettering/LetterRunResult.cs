namespace Engraver.Workbench.Lettering;

/// <summary>Characters of one font and format in a line.</summary>
/// <param name="Advance">From the origin of the first character to that of the next run, drawing units.</param>
public sealed record LetterRunResult(IReadOnlyList<GlyphPlace> Glyphs, double Advance);

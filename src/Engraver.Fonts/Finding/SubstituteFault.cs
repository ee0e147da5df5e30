namespace Engraver.Fonts.Finding;

/// <summary>A line of a user's table of substitutes that cannot be used.</summary>
/// <param name="Line">1 for the first; 0 if the file cannot be read.</param>
public sealed record SubstituteFault(string Path, int Line, string Text);

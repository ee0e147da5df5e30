namespace Engraver.Galil.Programs.Posting;

/// <summary>One program of a posted file.</summary>
/// <param name="FirstLine">Its first line in the file, from 1.</param>
/// <param name="Lines">At least one.</param>
public sealed record ReadBackChunk(int FirstLine, IReadOnlyList<string> Lines)
{
    public string Text => string.Join('\n', Lines) + "\n";
}

namespace Engraver.Fonts.Strokes;

/// <summary>A stroke font cannot be read: the file, the line and the words of the line that are wrong.</summary>
public sealed class StrokeFontException(StrokeFault fault, string file, int line, string found) : FormatException($"{file}:{line}: {fault}: {found}")
{
    public StrokeFault Fault { get; } = fault;

    public string File { get; } = file;

    /// <summary>The first one is 1; 0 for the whole file.</summary>
    public int Line { get; } = line;

    /// <summary>As the file has it.</summary>
    public string Found { get; } = found;
}

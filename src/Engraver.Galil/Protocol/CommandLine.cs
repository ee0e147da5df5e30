namespace Engraver.Galil.Protocol;

/// <summary>The rules of one line to the controller: its length and its parts (galil-dmc.md A.3).</summary>
public static class CommandLine
{
    /// <summary>Maximum number of characters of a line, including parts and semicolons.</summary>
    public const int MaximumLength = 80;

    /// <summary>The commands of a line; a semicolon in quotes does not separate. A line of n parts gives n prompts.</summary>
    public static IReadOnlyList<string> Parts(string line)
    {
        ArgumentNullException.ThrowIfNull(line);
        var parts = new List<string>();
        var start = 0;
        var quoted = false;
        for (var i = 0; i < line.Length; i++)
        {
            if (line[i] == '"') quoted = !quoted;
            if (line[i] != ';' || quoted) continue;
            parts.Add(line[start..i]);
            start = i + 1;
        }

        parts.Add(line[start..]);
        return parts;
    }

    /// <summary>The line without a trailing semicolon: whether that gives a separate prompt is not known (galil-dmc.md L.2), so it is never sent.</summary>
    /// <exception cref="ArgumentException">Too long, or with characters that end a line or a download.</exception>
    internal static string Checked(string line)
    {
        if (line.EndsWith(';')) line = line[..^1];
        if (line.Length > MaximumLength) throw new ArgumentException($"'{line}' is longer than {MaximumLength} characters.", nameof(line));
        if (line.AsSpan().ContainsAny('\r', '\n', '\\')) throw new ArgumentException("A command cannot contain a line end or a backslash.", nameof(line));
        return line;
    }
}

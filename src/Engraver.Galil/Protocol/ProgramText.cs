using System.Text;

namespace Engraver.Galil.Protocol;

/// <summary>Converts program text to and from the form of the controller's memory (galil-dmc.md A.6).</summary>
public static class ProgramText
{
    /// <summary>Lines ended with CR; an empty line becomes a comment, because the controller does not store empty lines.</summary>
    /// <exception cref="ArgumentException">A line is longer than the controller accepts, or contains a character that would end the download.</exception>
    public static string ForDownload(string program)
    {
        var text = new StringBuilder();
        foreach (var line in Lines(program))
        {
            if (line.Length > CommandLine.MaximumLength) throw new ArgumentException($"Program line '{line}' is longer than {CommandLine.MaximumLength} characters.", nameof(program));
            if (line.AsSpan().ContainsAny("\\\x04\x11\x1A")) throw new ArgumentException($"Program line '{line}' holds a character that ends a download.", nameof(program));
            text.Append(line.Length == 0 ? "'" : line).Append('\r');
        }

        return text.ToString();
    }

    /// <summary>The lines as uploaded, separated by LF, without the end mark and without the empty line before it.</summary>
    public static string FromUpload(string data) => string.Join('\n', Lines(data.TrimEnd('\x1A', '\\')));

    /// <summary>True when both have the same lines; line ends and trailing blanks are ignored.</summary>
    public static bool AreEquivalent(string left, string right) => Lines(ForComparison(left)).SequenceEqual(Lines(ForComparison(right)));

    private static string ForComparison(string program) => string.Join('\n', Lines(program).Select(line => line.Length == 0 ? "'" : line.TrimEnd()));

    private static List<string> Lines(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var lines = text.Replace("\r\n", "\n", StringComparison.Ordinal).Replace('\r', '\n').Split('\n').ToList();
        while (lines.Count > 0 && lines[^1].Trim().Length == 0) lines.RemoveAt(lines.Count - 1);
        return lines;
    }
}

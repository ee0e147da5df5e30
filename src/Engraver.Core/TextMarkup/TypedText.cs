namespace Engraver.Core.TextMarkup;

/// <summary>Converts between what an operator types and the strings of a file. Typed characters stand for themselves, except for %% codes, as in
/// AutoCAD.</summary>
public static class TypedText
{
    /// <summary>The string of a TEXT, in which a caret is followed by a blank.</summary>
    public static string ToLine(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return typed.Replace("^", "^ ", StringComparison.Ordinal);
    }

    /// <summary>A string of a file as it is typed: control characters with a caret are resolved, the other codes remain.</summary>
    public static string FromRaw(string raw)
    {
        ArgumentNullException.ThrowIfNull(raw);
        return raw.Replace("^ ", "^", StringComparison.Ordinal);
    }

    /// <summary>The string of an MTEXT of these lines: its codes are escaped.</summary>
    public static string ToParagraphs(IEnumerable<string> lines) =>
        string.Join(@"\P", lines.Select(line => ToLine(line.Replace(@"\", @"\\", StringComparison.Ordinal).Replace("{", @"\{", StringComparison.Ordinal).Replace("}", @"\}", StringComparison.Ordinal))));
}

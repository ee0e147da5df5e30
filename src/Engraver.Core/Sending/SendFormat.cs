using System.Globalization;

namespace Engraver.Core.Sending;

/// <summary>Text before and after a program on the line, and its line ends.</summary>
public sealed record SendFormat
{
    /// <summary>Maximum number of NULs before or after a program: 2 m of tape are 800.</summary>
    public const int MaxNuls = 10_000;

    public static SendFormat Default { get; } = new();

    /// <summary>Line end after every line: CR LF unless the control needs a different one.</summary>
    public string LineEnd { get; init; } = "\r\n";

    /// <summary>Number of NULs before all other characters, the blank leader of a tape.</summary>
    public int LeaderNuls { get; init; }

    /// <summary>Sent unchanged before the first line, with a line end if it contains one; for example <c>%</c> and CR LF.</summary>
    public string Start { get; init; } = "";

    /// <summary>Sent unchanged after the last line.</summary>
    public string End { get; init; } = "";

    /// <summary>Number of NULs after all other characters.</summary>
    public int TrailerNuls { get; init; }

    /// <summary>True when every character of the texts can be sent in that frame.</summary>
    public bool Fits(CharacterFrame frame) => $"{Start}{End}".All(letter => letter <= frame.Largest());

    /// <summary>A text in which <c>\r</c>, <c>\n</c>, <c>\t</c>, <c>\\</c> and <c>\x1A</c> stand for characters that cannot be typed; null when a backslash is
    /// before any other character.</summary>
    public static string? Unescape(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var plain = new System.Text.StringBuilder();
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] != '\\')
            {
                plain.Append(text[i]);
                continue;
            }

            var next = i + 1 < text.Length ? text[++i] : '\0';
            var meant = next switch { 'r' => '\r', 'n' => '\n', 't' => '\t', '\\' => '\\', _ => '\0' };
            if (meant != '\0') plain.Append(meant);
            else if (next == 'x' && i + 2 < text.Length && byte.TryParse(text.AsSpan(i + 1, 2), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out var code)) (plain, i) = (plain.Append((char)code), i + 2);
            else return null;
        }

        return plain.ToString();
    }
}

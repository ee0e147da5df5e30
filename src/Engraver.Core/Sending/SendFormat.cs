using System.Globalization;

namespace Engraver.Core.Sending;

/// <summary>What stands around a program on the line, and how its lines end.</summary>
public sealed record SendFormat
{
    /// <summary>Most NULs before or after a program: 2 m of tape are 800.</summary>
    public const int MostNuls = 10_000;

    public static SendFormat Default { get; } = new();

    /// <summary>Behind every line: CR LF unless the control wants another.</summary>
    public string LineEnd { get; init; } = "\r\n";

    /// <summary>NULs before everything, the blank leader of a tape.</summary>
    public int LeaderNuls { get; init; }

    /// <summary>Sent before the first line, as it stands, with its own line end if it has one; for example <c>%</c> and CR LF.</summary>
    public string Start { get; init; } = "";

    /// <summary>Sent behind the last line, as it stands.</summary>
    public string End { get; init; } = "";

    /// <summary>NULs behind everything.</summary>
    public int TrailerNuls { get; init; }

    /// <summary>Whether every character of the texts can be sent in that frame.</summary>
    public bool Fits(CharacterFrame frame) => $"{Start}{End}".All(letter => letter <= frame.Largest());

    /// <summary>A text in which <c>\r</c>, <c>\n</c>, <c>\t</c>, <c>\\</c> and <c>\x1A</c> stand for what cannot be typed; null when a backslash stands before something else.</summary>
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

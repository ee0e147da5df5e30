using Engraver.Core.Machines;

namespace Engraver.Galil.Language;

/// <summary>Lines of several segments for a serial line: one exchange for all of them (galil-dmc.md A.3), and short, because a stop waits for the line under
/// way.</summary>
internal static class StreamLines
{
    /// <summary>Longest transmission time of a line with more than one statement, seconds.</summary>
    private const double LongestSeconds = 0.02;

    /// <summary>Most characters of a line with more than one statement, without its CR.</summary>
    public static int Room(SerialLine line) => Math.Min(DmcLimits.LineLength, (int)(LongestSeconds / line.ByteSeconds) - 1);

    /// <summary>True if one line takes both statements.</summary>
    public static bool Fit(SerialLine line, string first, string second) => first.Length + 1 + second.Length <= Room(line);

    /// <summary>The statements of the next line, at least one.</summary>
    /// <param name="inFront">A statement that goes out before them; null for none.</param>
    public static List<string> Next(SerialLine line, string? inFront, IEnumerable<string> statements)
    {
        List<string> taken = inFront is null ? [] : [inFront];
        var length = inFront?.Length ?? -1;
        foreach (var statement in statements)
        {
            length += 1 + statement.Length;
            if (taken.Count > 0 && length > Room(line)) break;
            taken.Add(statement);
        }

        return taken;
    }
}

using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Posting;

/// <summary>The line of a posted program that commands each segment: its VP, CR and LI, or its calls of #LINEAR, #CIRC and #SLOPE, are in the order of
/// cutting.</summary>
public static class SegmentLines
{
    private static readonly SearchStarts s_segments = new("VP ", "CR ", "LI ");
    private static readonly SearchStarts s_calls = new("JS" + Subprograms.Linear, "JS" + Subprograms.Circular, "JS" + Subprograms.Slope);

    /// <returns>Line numbers from 1, one for each segment.</returns>
    public static int[] Map(string text, MotionStyle style) => Map([text], style);

    /// <param name="chunks">In order, each terminated by a line end.</param>
    /// <param name="style">Style of the motion program.</param>
    /// <returns>Line numbers in the whole text from 1, one for each segment.</returns>
    public static int[] Map(IReadOnlyList<string> chunks, MotionStyle style)
    {
        ArgumentNullException.ThrowIfNull(chunks);
        var starts = style == MotionStyle.Calls ? s_calls : s_segments;
        var lines = new List<int>();
        var number = 0;
        foreach (var chunk in chunks)
        {
            foreach (var line in WithoutLastEnd(chunk).EnumerateLines())
            {
                number++;
                for (var count = Commands(line, starts); count > 0; count--) lines.Add(number);
            }
        }

        return [.. lines];
    }

    private static ReadOnlySpan<char> WithoutLastEnd(string chunk) => chunk.EndsWith('\n') ? chunk.AsSpan(0, chunk.Length - 1) : chunk;

    private static int Commands(ReadOnlySpan<char> line, SearchStarts starts)
    {
        var count = 0;
        foreach (var part in line.Split(';'))
        {
            var command = line[part];
            if (command.StartsWith(starts.Line, StringComparison.Ordinal) || command.StartsWith(starts.Arc, StringComparison.Ordinal) || command.StartsWith(starts.Slope, StringComparison.Ordinal)) count++;
        }

        return count;
    }

    /// <summary>First characters of the commands of each kind of segment.</summary>
    private sealed record SearchStarts(string Line, string Arc, string Slope);
}

namespace Engraver.Galil.Programs.Posting;

/// <summary>Which line of a posted program commands each segment: the VP and CR of the text stand in the order of cutting.</summary>
public static class SegmentLines
{
    /// <returns>Line numbers from 1, one for each VP and CR of the text.</returns>
    public static int[] Map(string text)
    {
        var lines = new List<int>();
        var number = 0;
        foreach (var line in text.AsSpan().EnumerateLines())
        {
            number++;
            for (var count = Commands(line); count > 0; count--) lines.Add(number);
        }

        return [.. lines];
    }

    private static int Commands(ReadOnlySpan<char> line)
    {
        var count = 0;
        foreach (var part in line.Split(';'))
        {
            var command = line[part];
            if (command.StartsWith("VP ", StringComparison.Ordinal) || command.StartsWith("CR ", StringComparison.Ordinal)) count++;
        }

        return count;
    }
}

using System.Globalization;
using System.Text;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts.Agie;

/// <summary>Blocks as text in the tab-sequential form of paper 000, Table 1: fields separated by one tab, the first for the % mark at the program's
/// start.</summary>
internal static class AgieText
{
    /// <summary>Largest block number that three digits hold.</summary>
    public const int MaxBlocks = 999;

    /// <summary>Cuts a job into programs of at most <see cref="MaxBlocks"/>, between strokes where that is possible.</summary>
    /// <returns>Number of blocks of each program.</returns>
    public static IReadOnlyList<int> Parts(IReadOnlyList<AgieStep> steps)
    {
        var parts = new List<int>();
        var held = 0;
        foreach (var stroke in steps.GroupBy(step => step.Stroke).Select(group => group.Count()))
        {
            if (held > 0 && held + stroke > MaxBlocks)
            {
                parts.Add(held);
                held = 0;
            }

            for (held += stroke; held > MaxBlocks; held -= MaxBlocks) parts.Add(MaxBlocks);
        }

        if (held > 0) parts.Add(held);
        return parts;
    }

    /// <summary>The programs, and a warning when there are several.</summary>
    /// <param name="parts">Number of steps of each program.</param>
    /// <param name="ownLine">True when the start mark is on a separate line.</param>
    public static PostOutput Programs(IReadOnlyList<AgieStep> steps, IReadOnlyList<int> parts, bool ownLine)
    {
        var (chunks, written) = (new List<string>(), 0);
        foreach (var part in parts)
        {
            chunks.Add(Program(steps.Skip(written).Take(part), ownLine));
            written += part;
        }

        return new PostOutput(chunks, parts.Count <= 1 ? [] : [PostRules.ProgramParted.At(default, NumberText.Whole(steps.Count), NumberText.Whole(MaxBlocks), NumberText.Whole(parts.Count))]);
    }

    /// <summary>One program; each line ends with LF.</summary>
    private static string Program(IEnumerable<AgieStep> steps, bool ownLine)
    {
        var text = new StringBuilder(ownLine ? "%\n" : "%");
        var number = 0;
        foreach (var (block, _, _, _) in steps)
        {
            if (number > 0) text.Append('\n');
            text.Append(CultureInfo.InvariantCulture, $"\t{++number:000}\t{(int)block.Motion:00}\t{block.StartDegrees:000}\t{block.WorkDegrees:000}\t{block.X:+000000;-000000}\t{block.Y:+000000;-000000}\t{(block.Cutting ? "02" : "01")}");
        }

        return text.Append("\t02\n").ToString();
    }
}

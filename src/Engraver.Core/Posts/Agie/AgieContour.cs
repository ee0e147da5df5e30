using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;

namespace Engraver.Core.Posts.Agie;

/// <summary>The program of one contour, read from a file to be linked with others (paper 000, LINK).</summary>
/// <param name="Start">Machine position before its first block, drawing millimetres: the format does not contain it.</param>
/// <param name="Blocks">Blocks, at least one.</param>
public sealed partial record AgieContour(Point2D Start, IReadOnlyList<AgieBlock> Blocks)
{
    /// <summary>Number of stretches that are cut without interruption: a file may hold those of several contours.</summary>
    public int Cuts => Blocks.Where((block, i) => block.Cutting && (i == 0 || !Blocks[i - 1].Cutting)).Count();

    /// <summary>Reads the blocks of a text; consecutive programs are one contour.</summary>
    /// <param name="fault">The line that is not a block, or the fact that there is no block; null when all blocks were read.</param>
    /// <returns>Null when there is a fault.</returns>
    public static AgieContour? Read(string text, Point2D start, out Diagnostic? fault)
    {
        ArgumentNullException.ThrowIfNull(text);
        var (blocks, line, expected, isEnded) = (new List<AgieBlock>(), 0, 1, true);
        foreach (var row in text.Split('\n').Select(row => row.TrimEnd('\r')))
        {
            line++;
            if (row is "" or "%") continue;
            if (isEnded) expected = 1;
            if (BlockForm().Match(row) is not { Success: true } form || Number(form, "number") != expected || Block(form) is not { } block)
            {
                fault = PostRules.BlockUnreadable.At(new SourceRef(line), line.ToString(CultureInfo.InvariantCulture), Wording.Get("AgieContour.BlockExpected", expected.ToString("000", CultureInfo.InvariantCulture)));
                return null;
            }

            blocks.Add(block);
            (isEnded, expected) = (form.Groups["end"].Success, expected + 1);
        }

        fault = blocks.Count == 0 ? VerificationRules.ProgramEmpty.At(default) : isEnded ? null : PostRules.BlockUnreadable.At(new SourceRef(line), line.ToString(CultureInfo.InvariantCulture), Wording.Get("AgieContour.LastBlockDoesNotEnd"));
        return fault is null ? new AgieContour(start, blocks) : null;
    }

    private static AgieBlock? Block(Match form)
    {
        var (motion, start, work, x, y, isCutting) = ((AgieMotion)Number(form, "motion"), Number(form, "start"), Number(form, "work"), Number(form, "x"), Number(form, "y"), form.Groups["mode"].Value == "02");
        if (motion == AgieMotion.Line) return start == 0 && work == 0 ? AgieBlock.Line(x, y, isCutting) : null;
        return start < 360 && work is > 0 and < 360 && x == y && x > 0 && isCutting ? AgieBlock.Arc(motion == AgieMotion.Clockwise, start, work, x) : null;
    }

    private static int Number(Match form, string field) => int.Parse(form.Groups[field].ValueSpan, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture);

    [GeneratedRegex(@"^%?\t(?<number>[0-9]{3})\t(?<motion>0[123])\t(?<start>[0-9]{3})\t(?<work>[0-9]{3})\t(?<x>[+-][0-9]{6})\t(?<y>[+-][0-9]{6})\t(?<mode>0[12])(?<end>\t02)?\z")]
    private static partial Regex BlockForm();
}

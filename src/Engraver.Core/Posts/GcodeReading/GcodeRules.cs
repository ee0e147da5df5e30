namespace Engraver.Core.Posts.GcodeReading;

/// <summary>Checks a line before any part of it is executed.</summary>
internal static class GcodeRules
{
    private const int LongestLine = 255;
    private const int LongestLineOfGrbl = 79;

    /// <summary>The reason why the controller refuses the line; null when it accepts it.</summary>
    public static string? Check(GcodeBlock block, GcodeController controller)
    {
        var isGrbl = controller == GcodeController.Grbl;
        var longest = isGrbl ? LongestLineOfGrbl : LongestLine;
        if (block.Length > longest) return Wording.Get("GcodeReader.LineTooLong", longest);
        if (block['N'] is { } number && !(number >= 0.0 && number <= (isGrbl ? 9_999_999.0 : 99_999.0) && number == Math.Floor(number))) return Wording.Get("GcodeReader.BadLineNumber", NumberText.Rounded(number, 3));
        return Codes(block, 'G', controller) ?? Codes(block, 'M', controller) ?? Values(block, isGrbl);
    }

    private static string? Codes(GcodeBlock block, char letter, GcodeController controller)
    {
        var groups = new HashSet<int>();
        foreach (var word in block.Words.Where(word => word.Letter == letter))
        {
            var code = (int)Math.Round(Math.Clamp(word.Value, -1.0, 1000.0) * 10.0);
            var group = Math.Abs((word.Value * 10.0) - code) > 1e-6 ? -1 : GcodeCodes.GroupOf(letter, code, controller);
            if (group < 0) return Wording.Get("GcodeReader.CodeNotSupported", letter + NumberText.Rounded(word.Value, 3));
            if (!groups.Add(group)) return Wording.Get("GcodeReader.SameGroup", letter + NumberText.Rounded(word.Value, 3));
        }

        return null;
    }

    private static string? Values(GcodeBlock block, bool isGrbl)
    {
        var codes = block.Codes('G').ToList();
        var (dwells, switches, blends, isArc) = (codes.Contains(GcodeCodes.Dwell), block.Codes('M').Any(code => code is >= 620 and <= 650), codes.Contains(GcodeCodes.Blending), !block.Codes('G').Any(code => code is 0 or 10 or GcodeCodes.NoMotion));
        if (block['T'] is { } tool && (isGrbl || !(tool >= 0.0 && tool == Math.Floor(tool)))) return Wording.Get("GcodeReader.WordNotSupported", "T");
        if (block.Has("K")) return Wording.Get("GcodeReader.PlaneNotSupported");
        if (block.Has("IJR") && !isArc) return Wording.Get("GcodeReader.ArcWordsWithoutArc");
        foreach (var letter in "FS") if (block[letter] is < 0.0) return Wording.Get("GcodeReader.Negative", letter);
        if (dwells && block['P'] is not >= 0.0) return Wording.Get("GcodeReader.DwellTime");
        if (block.Has("Q") && !blends) return Wording.Get("GcodeReader.WordNotSupported", "Q");
        if (blends && (block['P'] is < 0.0 || block['Q'] is < 0.0)) return Wording.Get("GcodeReader.NegativeTolerance");
        if (switches && !(block['P'] is { } output and >= 0.0 && output == Math.Floor(output))) return Wording.Get("GcodeReader.OutputNumber");
        if ((dwells ? 1 : 0) + (switches ? 1 : 0) + (blends ? 1 : 0) > 1) return Wording.Get("GcodeReader.TwoCodesWithP");
        if (block.Has("P") && !(dwells || switches || blends) && (isGrbl || !isArc || block['P'] != 1.0)) return Wording.Get("GcodeReader.ArcWithTurns");
        if (dwells && block.Has("XYZIJR")) return Wording.Get("GcodeReader.DwellWithAxisOrArcWords");
        return block.Has("F") && codes.Any(code => code is GcodeCodes.Inch or GcodeCodes.Millimetre) ? Wording.Get("GcodeReader.UnitAndFeed") : null;
    }
}

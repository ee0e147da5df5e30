using System.Globalization;
using System.Runtime.InteropServices;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Engraver.SoftwarePlatform.Tests.Headless;
using Engraver.TestKit;

namespace Engraver.SoftwarePlatform.Tests.Text;

/// <summary>The order of mixed text, which Avalonia computes, with the shaper of this platform: cases of BidiCharacterTest.txt of the Unicode Character
/// Database (https://www.unicode.org/Public/15.0.0/ucd/BidiCharacterTest.txt).</summary>
[Collection(DesktopCollection.Name)]
public sealed class BidiTests(DesktopFixture fixture)
{
    public const string ConformanceFile = "/usr/share/unicode/BidiCharacterTest.txt";

    private const char ParagraphSeparator = '\u2029';

    /// <summary>Lines of the file: character codes; direction of the paragraph; its level; levels of the characters; their order as seen.</summary>
    public static TheoryData<string> Chosen { get; } =
    [
        "05D0 05D1 0028 05D2 05D3 005B 0026 0065 0066 005D 002E 0029 0067 0068;0;0;1 1 0 1 1 0 0 0 0 0 0 0 0 0;1 0 2 4 3 5 6 7 8 9 10 11 12 13",
        "05D0 05D1 0028 05D2 05D3 005B 0026 0065 0066 005D 002E 0029 0067 0068;1;1;1 1 1 1 1 1 1 2 2 1 1 1 2 2;12 13 11 10 9 7 8 6 5 4 3 2 1 0",
        "0061 0062 0063 0020 0028 0064 0065 0066 0020 0627 0628 062C 0029 0020 05D0 05D1 05D2;1;1;2 2 2 1 1 2 2 2 1 1 1 1 1 1 1 1 1;16 15 14 13 12 11 10 9 8 5 6 7 4 3 0 1 2",
        "05D0 05D1 05D2 0020 0028 0627 0628 062C 0020 0064 0065 0066 0029 0020 0061 0062 0063;0;0;1 1 1 0 0 1 1 1 0 0 0 0 0 0 0 0 0;2 1 0 3 4 7 6 5 8 9 10 11 12 13 14 15 16",
        "0627 0628 062C 0020 0062 006F 006F 006B 0028 0073 0029;1;1;1 1 1 1 2 2 2 2 2 2 2;4 5 6 7 8 9 10 3 2 1 0",
        "202D 0661 202B 0662 202C 2068 0663 2069 202B 0664 202C 0665 202C;0;0;x 2 x 4 x 2 6 2 x 4 x 2 x;1 3 5 6 7 9 11",
    ];

    [Theory]
    [MemberData(nameof(Chosen))]
    public Task Mixed_text_is_ordered_as_Unicode_requires(string line) => fixture.Runner.RunAsync(() =>
    {
        Assert.Null(Difference(BidiCase.Parse(line)));
        return Task.CompletedTask;
    });

    /// <summary>Without the cases whose direction follows from the text, because a text of Avalonia has a direction, and those with a paragraph separator
    /// before the end, because it ends the line. Avalonia orders ten cases differently: a combining mark after a bracket does not get the level of the
    /// bracket (rule N0).</summary>
    [BidiFileFact]
    public Task The_cases_of_the_conformance_file_are_ordered_as_Unicode_requires_except_for_marks_on_brackets() => fixture.Runner.RunAsync(() =>
    {
        var cases = File.ReadLines(ConformanceFile).Where(line => line.Contains(';', StringComparison.Ordinal) && !line.StartsWith('#')).Select(BidiCase.Parse)
            .Where(one => one.Direction < 2 && one.Text.IndexOf(ParagraphSeparator) is var end && (end < 0 || end == one.Text.Length - 1)).ToList();

        Assert.True(cases.Count > 50_000, $"{cases.Count} cases");
        var different = cases.Where(one => Difference(one) is not null).ToList();
        Assert.Equal(10, different.Count);
        Assert.All(different, one => Assert.Matches(@"[()\[\]][\u200B\u200D]*[\u0331-\u0333\u20D6]", one.Text));
        return Task.CompletedTask;
    });

    /// <summary>What differs between the case and a line of text; null: nothing.</summary>
    private static string? Difference(BidiCase one)
    {
        using var layout = new TextLayout(one.Text, new Typeface(FontFamily.Default), 12, Brushes.Black, flowDirection: (FlowDirection)one.Direction);
        var levels = new string?[one.Text.Length];
        var seen = new List<int>();
        foreach (var run in layout.TextLines[0].TextRuns.OfType<ShapedTextRun>())
        {
            Assert.True(MemoryMarshal.TryGetString(run.Text, out _, out var start, out var length));
            var places = Enumerable.Range(start, length).Where(place => one.Levels[place] != "x").ToList();
            foreach (var place in places) levels[place] = run.BidiLevel.ToString(CultureInfo.InvariantCulture);
            if (!run.ShapedBuffer.IsLeftToRight) places.Reverse();
            seen.AddRange(places);
        }

        return seen.SequenceEqual(one.Order) ? null : $"{one.Line}: levels {string.Join(' ', levels.Select(level => level ?? "x"))}, order {string.Join(' ', seen)}";
    }
}

/// <summary>A line of the conformance file.</summary>
/// <param name="Direction">0: left to right, 1: right to left, 2: that of the text.</param>
/// <param name="Levels">Resolved level of each character; x: removed.</param>
/// <param name="Order">Indices of the characters from left to right, without those removed.</param>
internal sealed record BidiCase(string Line, string Text, int Direction, IReadOnlyList<string> Levels, IReadOnlyList<int> Order)
{
    public static BidiCase Parse(string line)
    {
        var fields = line.Split(';');
        var text = string.Concat(fields[0].Split(' ').Select(code => (char)int.Parse(code, NumberStyles.HexNumber, CultureInfo.InvariantCulture)));
        var order = fields[4].Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(index => int.Parse(index, CultureInfo.InvariantCulture));
        return new BidiCase(line, text, int.Parse(fields[1], CultureInfo.InvariantCulture), fields[3].Split(' '), [.. order]);
    }
}

/// <summary>A test of the full run that reads the conformance file of the Debian package unicode-data.</summary>
[AttributeUsage(AttributeTargets.Method)]
public sealed class BidiFileFactAttribute : FullRunFactAttribute
{
    public BidiFileFactAttribute()
    {
        if (!File.Exists(BidiTests.ConformanceFile)) Skip = $"Not installed: {BidiTests.ConformanceFile} (apt-get install unicode-data).";
    }
}

using System.Text.RegularExpressions;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Tests.Diagnostics;

public class DiagnosticTests
{
    [Fact]
    public void Facts_fill_the_names_by_their_place_in_the_rule_and_the_advice_follows()
    {
        var diagnostic = VerificationRules.CutBesideDrawing.At(new SourceRef(7, "1A"), "0.5", "12", "7", "0.01");

        Assert.Equal("The program deviates from the drawing by 0.5 mm at 12, 7; allowed: 0.01 mm. Compare the program with the drawing at that position.", diagnostic.Message);
        Assert.Equal("VER0008", diagnostic.Id);
    }

    [Fact]
    public void A_missing_fact_shows() =>
        Assert.Equal("The program deviates from the drawing by 0.5 mm at ?, ?; allowed: ? mm.", VerificationRules.CutBesideDrawing.At(default, "0.5").Sentence);

    /// <summary>A fact may come from a damaged file: its control characters are made visible and not sent to the terminal.</summary>
    [Theory]
    [InlineData("\u0003 30", @"'\x03 30'")]
    [InlineData("\u001B[2J", @"'\x1B[2J'")]
    [InlineData("1\0\u009A0", @"'1\x00\x9A0'")]
    [InlineData(" 2\u00D7", "' 2\u00D7'")]
    public void Control_characters_of_a_fact_are_shown_by_their_number(string found, string shown) =>
        Assert.Contains(shown, DxfRules.DamagedRecord.At(default, "LINE", "line 5", found).Message, StringComparison.Ordinal);

    [Fact]
    public void Every_rule_names_the_facts_that_its_sentence_shows_in_the_order_of_English()
    {
        var shown = DiagnosticTable.All.Select(rule => $"{rule.Id} {string.Join(' ', Regex.Matches(rule.Sentence, @"\{(\w+)\}").Select(fact => fact.Groups[1].Value).Distinct())}");

        Assert.Equal(shown, DiagnosticTable.All.Select(rule => $"{rule.Id} {string.Join(' ', rule.FactNames)}"));
    }
}

using System.Text.RegularExpressions;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Tests.Diagnostics;

public class DiagnosticTests
{
    [Fact]
    public void Facts_fill_the_names_by_their_place_in_the_rule_and_the_advice_follows()
    {
        var diagnostic = VerificationRules.CutBesideDrawing.At(new SourceRef(7, "1A"), "0.5", "12", "7", "0.01");

        Assert.Equal("The program cuts 0.5 mm beside the drawing at 12, 7; 0.01 mm are allowed. Compare the program with the drawing there.", diagnostic.Message);
        Assert.Equal("VER0008", diagnostic.Id);
    }

    [Fact]
    public void A_missing_fact_shows() =>
        Assert.Equal("The program cuts 0.5 mm beside the drawing at ?, ?; ? mm are allowed.", VerificationRules.CutBesideDrawing.At(default, "0.5").Sentence);

    [Fact]
    public void Every_rule_names_the_facts_that_its_sentence_shows_in_the_order_of_English()
    {
        var shown = DiagnosticTable.All.Select(rule => $"{rule.Id} {string.Join(' ', Regex.Matches(rule.Sentence, @"\{(\w+)\}").Select(fact => fact.Groups[1].Value).Distinct())}");

        Assert.Equal(shown, DiagnosticTable.All.Select(rule => $"{rule.Id} {string.Join(' ', rule.FactNames)}"));
    }
}

using Engraver.Core.Diagnostics;
using Engraver.Galil.Language;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Settings;

public class SettingWordingTests
{
    [Fact]
    public void No_advice_at_the_command_line_names_an_option_of_the_runner()
    {
        Assert.Contains(DiagnosticTable.All, rule => rule.Advice.Contains('[', StringComparison.Ordinal));
        Assert.All(DiagnosticTable.All, rule => Assert.DoesNotMatch("--[a-z]|engraver [a-z]+|\\[", SettingWording.AtCommandLine(rule.At(default)).Advice));
    }

    [Fact]
    public void No_rule_spells_an_option_or_a_command_and_the_console_spells_every_key()
    {
        Assert.All(DiagnosticTable.All, rule => Assert.DoesNotMatch("--[a-z]|\\bCNC[A-Z]", rule.Sentence + rule.Advice));
        Assert.All(DiagnosticTable.All, rule => Assert.DoesNotMatch("\\[[-+]?[a-z]|CNC(?!GOTO)", SettingWording.OnConsole(rule.At(default)).Advice));
        Assert.Equal("Close the gap in the drawing, or set --join-tolerance above the gap.", SettingWording.OnConsole(SequencingRules.SmallGap.At(default)).Advice);
    }

    [Fact]
    public void Every_setting_with_a_command_has_that_command_and_the_page_is_the_table()
    {
        var catalog = Engraver.Workbench.Commands.CommandCatalog.Built();

        Assert.All(SettingTable.All, setting => Assert.NotNull(catalog.Find(setting.Command!)));
        Assert.Equal(SettingTable.All.Count, SettingTable.All.Select(setting => setting.Key).Distinct().Count());
        TestKit.GoldenFile.Check(Path.Combine(TestKit.RepositoryFolder.Root, "docs", "settings.md"), SettingTable.ToMarkdown());
    }

    [Fact]
    public void Every_command_that_an_advice_names_is_built()
    {
        var catalog = Engraver.Workbench.Commands.CommandCatalog.Built();
        var named = DiagnosticTable.All.Select(rule => SettingWording.AtCommandLine(rule.At(default))).Where(found => found.Advice != found.Rule.Advice)
            .SelectMany(found => System.Text.RegularExpressions.Regex.Matches(found.Advice, "\\b(CNC[A-Z]+|LAYER|CHECK|OPEN)\\b").Select(match => match.Value)).Distinct().ToList();

        Assert.Contains("CNCJOINTOL", named);
        Assert.All(named, name => Assert.NotNull(catalog.Find(name)));
    }

    [Fact]
    public async Task A_finding_in_the_command_window_and_in_the_derived_document_says_CNCJOINTOL()
    {
        await using var talk = new CommandTestSession();
        var drawing = new TestKit.DrawingBuilder().Line(0, 0, 10, 0).Line(10.25, 0, 90, 0).Build();
        talk.Session.Document.Commit("OPEN", new Engraver.Workbench.Documents.DocumentState { Drawing = drawing });
        await talk.TypeAsync("CHECK");
        var derived = Engraver.Workbench.Documents.DerivedDocument.Create(talk.State, JobMode.Stream.Strategy(), CancellationToken.None);

        Assert.Contains("warning SEQ0003: The contour is open at 10, 0: the nearest other open end is 0.25 mm away, on entity A2. Close the gap in the drawing, or set CNCJOINTOL above the gap.", talk.Said, StringComparison.Ordinal);
        Assert.EndsWith("\n0 errors, 2 warnings.", talk.Said, StringComparison.Ordinal);
        Assert.Contains(derived.Findings, found => found.Message.EndsWith("or set CNCJOINTOL above the gap.", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData(0, "Error", "0 errors")]
    [InlineData(1, "Error", "1 error")]
    [InlineData(2, "Entity", "2 entities")]
    [InlineData(1, "Entity", "1 entity")]
    [InlineData(1234, "Segment", "1234 segments")]
    public void One_is_singular(int count, string noun, string text) => Assert.Equal(text, CountText.Format(count, noun));
}

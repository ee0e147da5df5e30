using System.Text.RegularExpressions;
using Engraver.Core.Diagnostics;
using Engraver.Core.Dxf;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Diagnostics;

public partial class DiagnosticTableTests
{
    [Fact]
    public void No_id_is_given_twice_and_all_have_the_form_of_three_letters_and_four_digits()
    {
        var ids = DiagnosticTable.All.Select(rule => rule.Id).ToArray();

        Assert.Equal(ids.Length, ids.Distinct().Count());
        Assert.All(ids, id => Assert.Matches(IdForm(), id));
    }

    [Fact]
    public void Every_rule_says_what_and_what_to_do_as_sentences() => Assert.All(DiagnosticTable.All, rule =>
    {
        Assert.EndsWith(".", rule.Sentence, StringComparison.Ordinal);
        Assert.EndsWith(".", rule.Advice, StringComparison.Ordinal);
    });

    [Fact]
    public void The_page_of_diagnostics_is_what_the_table_says() =>
        GoldenFile.Check(Path.Combine(RepositoryFolder.Root, "docs", "diagnostics.md"), DiagnosticTable.ToMarkdown(DxfReader.TypeHandling));

    [GeneratedRegex("^[A-Z]{3}[0-9]{4}$")]
    private static partial Regex IdForm();
}

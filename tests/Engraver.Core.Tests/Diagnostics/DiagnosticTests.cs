using Engraver.Core.Diagnostics;

namespace Engraver.Core.Tests.Diagnostics;

public class DiagnosticTests
{
    private static readonly DiagnosticRule s_rule = new("TST0001", Severity.Warning, "{type} at line {line} has {count} of {type}.", "Do this.");

    [Fact]
    public void Facts_fill_the_names_in_the_order_in_which_they_first_appear()
    {
        var diagnostic = s_rule.At(new SourceRef(7, "1A"), "LINE", "7", "3");

        Assert.Equal("LINE at line 7 has 3 of LINE. Do this.", diagnostic.Message);
        Assert.Equal("TST0001", diagnostic.Id);
    }

    [Fact]
    public void A_missing_fact_shows_and_a_brace_without_partner_stays()
    {
        Assert.Equal("LINE at line ? has ? of LINE. Do this.", s_rule.At(default, "LINE").Message);
        Assert.Equal("open { brace x", new DiagnosticRule("TST0002", Severity.Info, "open { brace", "x").At(default).Message);
    }
}

using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Languages;

namespace Engraver.Core.Tests.Languages;

public class PseudoLanguageTests
{
    [Theory]
    [InlineData("Lead-in", "⟦Ļéåð-îñ⟧")]
    [InlineData("{0} of [max-error]", "⟦{0} öƒ [max-error]⟧")]
    [InlineData("a {type} a", "⟦å {type} å⟧")]
    public void A_text_has_accents_but_for_the_places_of_facts_and_settings(string english, string expected) => Assert.Equal(expected, PseudoLanguage.Write(english));

    [Theory]
    [InlineData("LINE", "‹LINE›")]
    [InlineData("12.5", "12.5")]
    [InlineData("⟦ļîñé⟧ 5", "⟦ļîñé⟧ 5")]
    public void A_fact_with_letters_is_marked_unless_it_is_a_text(string fact, string expected) => Assert.Equal(expected, PseudoLanguage.Mark(fact));

    [Theory]
    [InlineData("⟦Ļéåð⟧ ‹LINE ‹X›› 5 [Yes/No]", "")]
    [InlineData("⟦Ļéåð⟧ line of text", "line|of|text")]
    [InlineData("x⟦ļ⟧y", "x|y")]
    public void Plain_letters_outside_of_marks_are_found(string shown, string expected) => Assert.Equal(expected, string.Join('|', PseudoLanguage.UnmarkedWords(shown)));

    [Fact]
    public void Every_diagnostic_speaks_the_language_of_now()
    {
        PseudoText.InPseudoLanguage(() => Assert.All(DiagnosticTable.All, rule =>
            Assert.Empty(PseudoLanguage.UnmarkedWords(rule.At(new SourceRef(1), [.. rule.FactNames.Select(_ => "LINE")]).Message))));
    }

    [Fact]
    public void A_finding_that_was_made_before_is_told_in_the_language_in_which_it_is_read()
    {
        var finding = DxfRules.EmptyFile.At(default);

        Assert.Equal("The file is empty.", finding.Sentence);
        PseudoText.InPseudoLanguage(() => Assert.Equal("⟦Ţĥé ƒîļé îš éɱþţý.⟧", finding.Sentence));
    }

    private static class PseudoText
    {
        public static void InPseudoLanguage(Action act)
        {
            var before = CultureInfo.CurrentUICulture;
            CultureInfo.CurrentUICulture = new CultureInfo(PseudoLanguage.CultureName);
            try
            {
                act();
            }
            finally
            {
                CultureInfo.CurrentUICulture = before;
            }
        }
    }
}

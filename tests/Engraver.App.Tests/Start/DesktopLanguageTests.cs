using System.Globalization;
using Engraver.App.Start;
using Engraver.App.Texts;

namespace Engraver.App.Tests.Start;

public sealed class DesktopLanguageTests
{
    [Theory]
    [InlineData(null, null, "de_DE.UTF-8", "de")]
    [InlineData(null, null, "C.UTF-8", "")]
    [InlineData(null, null, "fr_FR.UTF-8", "")]
    [InlineData(null, null, null, "")]
    [InlineData(null, "en", "de_DE.UTF-8", "")]
    [InlineData(null, "de", "en_GB.UTF-8", "de")]
    [InlineData("en", "de", "de_DE", "")]
    [InlineData("de-AT", "en", "C", "de")]
    [InlineData("qps-ploc", null, "de", "qps-ploc")]
    public void What_is_asked_comes_before_what_is_kept_and_that_before_the_system(string? asked, string? kept, string? system, string spoken) =>
        Assert.Equal(spoken, DesktopLanguage.Choose(asked, kept, [null, "", system]));

    [Fact]
    public async Task Every_thread_speaks_it_until_it_ends()
    {
        var before = CultureInfo.CurrentUICulture;
        using (DesktopLanguage.Apply("de"))
        {
            Assert.Equal("de", CultureInfo.CurrentUICulture.Name);
            Assert.Equal("Sprache", await Task.Run(() => Text.Get("Command.LANGUAGE")));
        }

        Assert.Equal(before, CultureInfo.CurrentUICulture);
    }
}

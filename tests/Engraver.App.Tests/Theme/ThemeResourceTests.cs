using System.Text.RegularExpressions;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Styling;
using Engraver.TestKit;

namespace Engraver.App.Tests.Theme;

[Collection(DesktopCollection.Name)]
public sealed class ThemeResourceTests(DesktopFixture fixture)
{
    [Fact]
    public Task No_resource_that_is_named_is_missing_in_either_theme() => fixture.WithOperator(here =>
    {
        var app = Path.Combine(RepositoryFolder.Root, "src", "Engraver.App");
        var named = from file in Directory.EnumerateFiles(app, "*.*", SearchOption.AllDirectories)
                    let pattern = Path.GetExtension(file) switch { ".axaml" => """Resource ([A-Za-z.]+)}""", ".cs" => "\"([A-Za-z.]+(?:Brush|Icon))\"", _ => "(?!)" }
                    from Match match in Regex.Matches(File.ReadAllText(file), pattern)
                    select match.Groups[1].Value;
        var missing = from name in named.Distinct()
                      from theme in new[] { ThemeVariant.Dark, ThemeVariant.Light }
                      where !Application.Current!.TryGetResource(name, theme, out _)
                      select $"{name} in {theme}";

        Assert.Empty(missing);
        Assert.True(named.Distinct().Count() > 30, "the scan found too few");
    });

    /// <summary>WCAG 2: 4.5 for running text.</summary>
    [Theory]
    [InlineData("TextBrush", "ChromeBrush")]
    [InlineData("TextBrush", "StripBrush")]
    [InlineData("TextBrush", "PanelBrush")]
    [InlineData("TextBrush", "SelectedBrush")]
    [InlineData("QuietTextBrush", "PanelBrush")]
    [InlineData("QuietTextBrush", "ChromeBrush")]
    [InlineData("QuietTextBrush", "StripFieldBrush")]
    [InlineData("QuietTextBrush", "StripBrush")]
    [InlineData("ErrorTextBrush", "PanelBrush")]
    [InlineData("WarningTextBrush", "PanelBrush")]
    [InlineData("StartKeyTextBrush", "StartKeyBrush")]
    [InlineData("StopKeyTextBrush", "StopKeyBrush")]
    [InlineData("TextBrush", "GreyKeyBrush")]
    public Task Text_stands_out_from_its_ground(string text, string ground) => fixture.WithOperator(here =>
    {
        foreach (var theme in new[] { ThemeVariant.Dark, ThemeVariant.Light })
        {
            var contrast = Contrast(ColourOf(text, theme), ColourOf(ground, theme));
            Assert.True(contrast >= 4.5, FormattableString.Invariant($"{text} on {ground} in {theme}: {contrast:0.00}"));
        }
    });

    [Fact]
    public Task Stop_never_looks_like_an_emergency_stop() => fixture.WithOperator(here =>
    {
        foreach (var theme in new[] { ThemeVariant.Dark, ThemeVariant.Light })
        {
            var stop = ColourOf("StopKeyBrush", theme);
            Assert.True(Math.Max(stop.R, Math.Max(stop.G, stop.B)) - Math.Min(stop.R, Math.Min(stop.G, stop.B)) < 16, "STOP is black or grey (EN 60204-1)");
        }
    });

    private static Color ColourOf(string name, ThemeVariant theme) => Application.Current!.TryGetResource(name, theme, out var found) ? ((ISolidColorBrush)found!).Color : throw new KeyNotFoundException(name);

    private static double Contrast(Color one, Color other)
    {
        var (light, dark) = (Math.Max(Luminance(one), Luminance(other)), Math.Min(Luminance(one), Luminance(other)));
        return (light + 0.05) / (dark + 0.05);
    }

    private static double Luminance(Color colour) => (0.2126 * Linear(colour.R)) + (0.7152 * Linear(colour.G)) + (0.0722 * Linear(colour.B));

    private static double Linear(byte channel) => channel / 255.0 is var part && part <= 0.03928 ? part / 12.92 : Math.Pow((part + 0.055) / 1.055, 2.4);
}

using System.Text.RegularExpressions;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Media;
using Avalonia.Styling;
using Engraver.App.Canvas.Colours;
using Engraver.App.Theme;
using Engraver.TestKit;

namespace Engraver.App.Tests.Theme;

[Collection(DesktopCollection.Name)]
public sealed class ThemeResourceTests(DesktopFixture fixture)
{
    private static readonly ThemeVariant[] s_themes = [ThemeVariant.Dark, ThemeVariant.Light, DesktopThemes.HighContrast];

    [Fact]
    public Task No_resource_that_is_named_is_missing_in_any_theme() => fixture.WithOperator(here =>
    {
        var app = Path.Combine(RepositoryFolder.Root, "src", "Engraver.App");
        var named = from file in Directory.EnumerateFiles(app, "*.*", SearchOption.AllDirectories)
                    let pattern = Path.GetExtension(file) switch { ".axaml" => """Resource ([A-Za-z.]+)}""", ".cs" => "\"([A-Za-z.]+(?:Brush|Icon))\"", _ => "(?!)" }
                    from Match match in Regex.Matches(File.ReadAllText(file), pattern)
                    select match.Groups[1].Value;
        var missing = from name in named.Distinct()
                      from theme in s_themes
                      where !Application.Current!.TryGetResource(name, theme, out _)
                      select $"{name} in {theme}";

        Assert.Empty(missing);
        Assert.True(named.Distinct().Count() > 30, "the scan found too few");
    });

    /// <summary>WCAG 2: 4.5 for running text (AA), 7 in the theme of high contrast (AAA).</summary>
    [Theory]
    [InlineData("TextBrush", "ChromeBrush StripBrush StripFieldBrush PanelBrush PanelHeadBrush FieldBrush HoverBrush PressedBrush SelectedBrush GreyKeyBrush CanvasBrush")]
    [InlineData("QuietTextBrush", "ChromeBrush StripBrush StripFieldBrush PanelBrush PanelHeadBrush FieldBrush")]
    [InlineData("DisabledTextBrush", "StripBrush")] // disabled keys
    [InlineData("ErrorTextBrush", "PanelBrush FieldBrush ChromeBrush")]
    [InlineData("WarningTextBrush", "PanelBrush FieldBrush ChromeBrush")]
    [InlineData("NoteTextBrush", "PanelBrush FieldBrush")]
    [InlineData("EchoTextBrush", "PanelBrush FieldBrush")]
    [InlineData("AccentBrush", "PanelBrush")] // options of a prompt
    [InlineData("DangerLampBrush", "PanelBrush")] // alarms
    [InlineData("AbnormalLampBrush", "StripFieldBrush")] // an override that is not 100 %
    [InlineData("NeutralLampBrush", "StripFieldBrush")]
    [InlineData("ChromeBrush", "DangerLampBrush")] // the number of pending alarms
    [InlineData("StartKeyTextBrush", "StartKeyBrush")]
    [InlineData("StopKeyTextBrush", "StopKeyBrush")]
    public Task Text_stands_out_from_its_ground(string text, string grounds) => fixture.WithOperator(here =>
    {
        var weak = from theme in s_themes
                   from ground in grounds.Split(' ')
                   let contrast = Contrast(ColourOf(text, theme), ColourOf(ground, theme))
                   where contrast < MinContrast(theme)
                   select FormattableString.Invariant($"{text} on {ground} in {theme}: {contrast:0.00}");
        Assert.Empty(weak);
    });

    [Fact]
    public Task The_word_simulation_stands_out_from_its_ground() => fixture.WithOperator(here =>
        Assert.All(s_themes, theme => Assert.True(Contrast(Colors.White, ColourOf("SimulationBrush", theme)) >= MinContrast(theme), theme.ToString())));

    /// <summary>A disabled key is readable and distinguishable from an enabled one.</summary>
    [Theory]
    [InlineData("DisabledTextBrush")]
    [InlineData("FaintTextBrush")]
    [InlineData("ButtonForegroundDisabled")]
    [InlineData("MenuFlyoutItemForegroundDisabled")]
    public Task What_cannot_be_used_is_read_in_high_contrast_and_told_from_the_rest(string text) => fixture.WithOperator(here =>
    {
        var theme = DesktopThemes.HighContrast;
        Assert.True(Contrast(ColourOf(text, theme), ColourOf("StripBrush", theme)) >= MinContrast(theme));
        Assert.True(Contrast(ColourOf(text, theme), ColourOf("TextBrush", theme)) >= 2.0);
        Assert.True(Contrast(ColourOf("KeyBorderBrush", theme), ColourOf("LineBrush", theme)) >= 2.0);
    });

    /// <summary>Order numbers, start points and machine have the contrast of text.</summary>
    [Fact]
    public void Marks_of_the_canvas_stand_out_from_it()
    {
        foreach (var (theme, least) in new[] { (CanvasTheme.Dark, 3.0), (CanvasTheme.Light, 3.0), (CanvasTheme.HighContrast, 7.0) }) // 3: WCAG 2 for graphics
        {
            uint[] marks = [theme.Foreground, theme.Crosshair, theme.Selected, theme.ClosedContour, theme.InsideContour, theme.OpenContour, theme.Direction, theme.Start, theme.Machine, theme.Finding, theme.Engraved, theme.Tool];
            Assert.All(marks, mark => Assert.True(Contrast(Color.FromUInt32(mark), Color.FromUInt32(theme.Background)) >= least, FormattableString.Invariant($"{mark:X8} on {theme.Background:X8}: {Contrast(Color.FromUInt32(mark), Color.FromUInt32(theme.Background)):0.00}")));
        }
    }

    /// <summary>Black on white is 21, a colour on itself 1, and grey 767676 on white 4.54 (the examples of WCAG).</summary>
    [Theory]
    [InlineData(0xFF000000, 0xFFFFFFFF, 21.0)]
    [InlineData(0xFF336699, 0xFF336699, 1.0)]
    [InlineData(0xFF767676, 0xFFFFFFFF, 4.54)]
    public void Contrast_is_the_one_of_wcag(uint one, uint other, double expected) => Assert.Equal(expected, Contrast(Color.FromUInt32(one), Color.FromUInt32(other)), 2);

    [Fact]
    public Task High_contrast_is_chosen_by_theme_and_shown() => fixture.WithOperator(here =>
    {
        here.Enter("THEME", "HC");
        here.Until(() => here.Window.Canvas.IsUpToDate);

        Assert.Equal(DesktopThemes.HighContrast, Application.Current!.ActualThemeVariant);
        Assert.Equal(Colors.Black, ((ISolidColorBrush)here.Find<Border>("CanvasPlace").Background!).Color);
        here.Enter("THEME", "Dark");
    });

    [Fact]
    public Task Stop_never_looks_like_an_emergency_stop() => fixture.WithOperator(here =>
    {
        foreach (var theme in s_themes)
        {
            var stop = ColourOf("StopKeyBrush", theme);
            Assert.True(Math.Max(stop.R, Math.Max(stop.G, stop.B)) - Math.Min(stop.R, Math.Min(stop.G, stop.B)) < 16, "STOP is black or grey (EN 60204-1)");
        }
    });

    private static double MinContrast(ThemeVariant theme) => theme == DesktopThemes.HighContrast ? 7.0 : 4.5;

    private static Color ColourOf(string name, ThemeVariant theme) => Application.Current!.TryGetResource(name, theme, out var found) ? ((ISolidColorBrush)found!).Color : throw new KeyNotFoundException(name);

    private static double Contrast(Color one, Color other)
    {
        var (light, dark) = (Math.Max(Luminance(one), Luminance(other)), Math.Min(Luminance(one), Luminance(other)));
        return (light + 0.05) / (dark + 0.05);
    }

    private static double Luminance(Color colour) => (0.2126 * Linear(colour.R)) + (0.7152 * Linear(colour.G)) + (0.0722 * Linear(colour.B));

    private static double Linear(byte channel) => channel / 255.0 is var part && part <= 0.03928 ? part / 12.92 : Math.Pow((part + 0.055) / 1.055, 2.4);
}

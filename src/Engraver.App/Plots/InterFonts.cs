using Avalonia.Platform;
using ScottPlot;
using SkiaSharp;
using PlotFonts = ScottPlot.Fonts;

namespace Engraver.App.Plots;

/// <summary>Gives ScottPlot the Inter font of the window for every name, so that plots look the same on every system, also on one without fonts.</summary>
internal sealed class InterFonts : IFontResolver
{
    private const string Family = "Inter";

    private readonly Lazy<SKTypeface> _regular = new(() => Load("Regular"));
    private readonly Lazy<SKTypeface> _bold = new(() => Load("Bold"));

    private static readonly Lazy<bool> s_installed = new(Install);

    /// <summary>Makes Inter the font of all plots; later calls do nothing.</summary>
    public static void Use() => _ = s_installed.Value;

    public SKTypeface CreateTypeface(string fontName, bool bold, bool italic) => bold ? _bold.Value : _regular.Value;

    public SKTypeface CreateTypeface(string fontName, FontWeight weight, FontSlant slant, FontSpacing spacing) => weight >= FontWeight.SemiBold ? _bold.Value : _regular.Value;

    private static bool Install()
    {
        PlotFonts.FontResolvers.Clear();
        PlotFonts.FontResolvers.Add(new InterFonts());
        PlotFonts.Default = PlotFonts.Sans = PlotFonts.Serif = PlotFonts.Monospace = Family;
        return true;
    }

    private static SKTypeface Load(string style)
    {
        using var font = AssetLoader.Open(new Uri($"avares://Avalonia.Fonts.Inter/Assets/Inter-{style}.ttf"));
        return SKTypeface.FromStream(font);
    }
}

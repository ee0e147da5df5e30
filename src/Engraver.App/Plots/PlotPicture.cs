using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Workbench.Plots;
using ScottPlot;
using ScottPlot.AxisRules;
using ScottPlot.DataSources;
using ScottPlot.Plottables;
using ScottPlot.TickGenerators;
using AvaloniaColor = Avalonia.Media.Color;
using Text = Engraver.App.Texts.Text;

namespace Engraver.App.Plots;

/// <summary>Builds the stacked plots of a content with ScottPlot: one row for each panel, with a common horizontal axis.</summary>
internal static class PlotPicture
{
    /// <summary>Size of the numbers, in units of the window.</summary>
    public const float FontSize = 11.0f;

    /// <summary>Height at which the curves of a plot can still be read, units of the window.</summary>
    public const double MinRowHeight = 84.0;

    /// <summary>Height of the numbers and the title of the common axis, units of the window.</summary>
    public const float AxisHeight = 30.0f;

    private const float TitleSize = 12.0f;
    private const float TopHeight = 4.0f;
    private const float BottomHeight = 6.0f;

    /// <summary>Width of the numbers at the left: equal in all rows, so that their axes are aligned.</summary>
    private const float LeftWidth = 52.0f;

    private const float RightWidth = 14.0f;
    private const float LineWidth = 1.3f;
    private const byte LegendOpacity = 200;

    /// <summary>A limit above this many times the largest value does not widen the vertical axis.</summary>
    private const double MaxLimitRatio = 3.0;

    /// <summary>Empty part of the vertical axis above and below the curves.</summary>
    private const double Margin = 0.06;

    /// <param name="scale">Pixels for each unit of the window.</param>
    /// <param name="hasLegend">Each plot has a legend; in the window the page has one for all.</param>
    public static Multiplot Create(PlotContent content, PlotColours colours, double scale, bool hasLegend)
    {
        InterFonts.Use();
        var rows = new Multiplot { Layout = new AlignedRows((float)(AxisHeight * scale)) };
        while (rows.Subplots.Count > 0) rows.Subplots.RemoveAt(0);
        foreach (var panel in content.Panels) rows.Subplots.Add(PlotOf(content, panel, colours, scale, hasLegend));
        rows.SharedAxes.ShareX(rows.Subplots.GetPlots());
        return rows;
    }

    private static Plot PlotOf(PlotContent content, PlotPanel panel, PlotColours colours, double scale, bool hasLegend)
    {
        var plot = new Plot { ScaleFactor = scale };
        var (low, high) = RangeOf(content, panel);
        AddCurves(plot, content, panel, colours);
        AddLimits(plot, content, panel, colours, low, high);
        StyleAxes(plot, content.Axis, colours, isLast: ReferenceEquals(panel, content.Panels[^1]));
        AddTitle(plot, TitleOf(content, panel), colours);
        if (hasLegend) ShowLegend(plot, colours);
        else plot.HideLegend(); // named curves show one otherwise
        plot.Axes.SetLimits(0.0, Math.Max(content.End, double.Epsilon), low, high);
        plot.Axes.Rules.Add(new LockedVertical(plot.Axes.Left, low, high));
        plot.Axes.Rules.Add(new MaximumBoundary(plot.Axes.Bottom, plot.Axes.Left, new AxisLimits(0.0, content.End, low, high)));
        return plot;
    }

    /// <summary>Title with the unit and the largest limit of the plot.</summary>
    private static string TitleOf(PlotContent content, PlotPanel panel)
    {
        var title = Text.Get("PlotTitle." + panel.Key);
        var limits = content.Limits.Where(limit => panel.Quantities.Contains(limit.Quantity)).Select(limit => limit.Value).ToList();
        return limits.Count == 0 ? title : Text.Get("Plots.TitleWithLimit", title, Text.Get("PlotLimit." + panel.Key, Number(Math.Round(limits.Max(), 4))));
    }

    private static void ShowLegend(Plot plot, PlotColours colours)
    {
        var legend = plot.ShowLegend(Alignment.UpperRight, Orientation.Horizontal);
        (legend.BackgroundColor, legend.FontColor, legend.OutlineColor, legend.FontSize) = (Of(colours.Field).WithAlpha(LegendOpacity), Of(colours.Text), Colors.Transparent, FontSize);
        (legend.ShadowColor, legend.Padding, legend.Margin, legend.TightHorizontalWrapping) = (Colors.Transparent, new PixelPadding(4.0f, 1.0f), new PixelPadding(4.0f, 2.0f), true);
    }

    /// <summary>The title is inside the field, so that low rows keep most of their height for the curves.</summary>
    private static void AddTitle(Plot plot, string text, PlotColours colours)
    {
        var title = plot.Add.Annotation(text, Alignment.UpperLeft);
        (title.LabelFontSize, title.LabelFontColor, title.LabelBackgroundColor, title.LabelBorderWidth, title.LabelShadowColor) = (TitleSize, Of(colours.Text), Of(colours.Field).WithAlpha(LegendOpacity), 0.0f, Colors.Transparent);
        (title.OffsetX, title.OffsetY, title.LabelPadding) = (3.0f, 2.0f, 2.0f);
    }

    /// <summary>The vertical range of a plot: all values of its curves and the limits near them, with a margin; zero is included.</summary>
    private static (double Low, double High) RangeOf(PlotContent content, PlotPanel panel)
    {
        var (low, high) = (0.0, 0.0);
        foreach (var extremes in panel.Quantities.SelectMany(quantity => content.Series.Select(series => series.Motion.Extremes(quantity)))) (low, high) = (Math.Min(low, extremes.Low), Math.Max(high, extremes.High));

        var largest = Math.Max(high, -low);
        foreach (var limit in content.Limits.Where(limit => panel.Quantities.Contains(limit.Quantity) && Math.Abs(limit.Value) <= MaxLimitRatio * largest)) (low, high) = (Math.Min(low, limit.Value), Math.Max(high, limit.Value));
        var margin = high > low ? Margin * (high - low) : 1.0;
        return (low < 0.0 ? low - margin : low, high + margin);
    }

    private static void AddCurves(Plot plot, PlotContent content, PlotPanel panel, PlotColours colours)
    {
        foreach (var series in content.Series)
        {
            var along = series.Motion.Along(content.Axis);
            for (var curve = 0; curve < panel.Quantities.Count; curve++)
            {
                var quantity = panel.Quantities[curve];
                foreach (var (number, range) in series.Motion.KnownRanges(quantity).Index())
                {
                    var source = new SignalXYSourceDoubleArray(along, series.Motion.Of(quantity)!) { MinimumIndex = range.Start.Value, MaximumIndex = range.End.Value - 1 };
                    plot.Add.Plottable(new SignalXY(source)
                    {
                        Color = Of(colours.Of(series.Role, curve)),
                        LineWidth = LineWidth,
                        MarkerStyle = MarkerStyle.None,
                        LegendText = number == 0 ? NameOf(series, panel, curve) : "",
                    });
                }
            }
        }
    }

    /// <summary>Name of a curve: its motion, with the axis where the plot has a curve for each axis.</summary>
    /// <param name="curve">Index of the quantity in its plot.</param>
    public static string NameOf(PlotSeries series, PlotPanel panel, int curve)
    {
        var motion = series.Role == PlotRole.Compared ? series.Name : Text.Get("PlotMotion." + series.Role);
        return panel.Quantities.Count > 1 ? Text.Get("Plots.CurveOfAxis", motion, MachineAxes.Names[curve]) : motion;
    }

    private static void AddLimits(Plot plot, PlotContent content, PlotPanel panel, PlotColours colours, double low, double high)
    {
        foreach (var value in content.Limits.Where(limit => panel.Quantities.Contains(limit.Quantity)).Select(limit => limit.Value).Distinct().Where(value => value >= low && value <= high))
            plot.Add.HorizontalLine(value, LineWidth, Of(colours.Limit), LinePattern.Dashed);
    }

    private static void StyleAxes(Plot plot, PlotAxis axis, PlotColours colours, bool isLast)
    {
        (plot.FigureBackground.Color, plot.DataBackground.Color) = (Of(colours.Background), Of(colours.Field));
        plot.Axes.Color(Of(colours.Text));
        plot.Grid.MajorLineColor = Of(colours.Grid);
        (plot.Axes.Left.MinimumSize, plot.Axes.Left.MaximumSize) = (LeftWidth, LeftWidth);
        (plot.Axes.Right.MinimumSize, plot.Axes.Right.MaximumSize) = (RightWidth, RightWidth);
        (plot.Axes.Top.MinimumSize, plot.Axes.Top.MaximumSize) = (TopHeight, TopHeight);
        (plot.Axes.Bottom.MinimumSize, plot.Axes.Bottom.MaximumSize) = isLast ? (BottomHeight + AxisHeight, BottomHeight + AxisHeight) : (BottomHeight, BottomHeight);
        plot.Axes.Left.TickLabelStyle.FontSize = FontSize;
        plot.Axes.Bottom.TickLabelStyle.FontSize = FontSize;
        plot.Axes.Left.TickGenerator = new NumericAutomatic { LabelFormatter = Number };
        if (axis == PlotAxis.Time) plot.Axes.Bottom.TickGenerator = new TimeTicks();
        else plot.Axes.Bottom.TickGenerator = new NumericAutomatic { LabelFormatter = Number };
        if (isLast) plot.XLabel(Text.Get("PlotOver." + axis), FontSize);
        else plot.Axes.Bottom.TickLabelStyle.IsVisible = false;
        plot.Axes.Bottom.Label.Bold = false;
    }

    private static string Number(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);

    private static Color Of(AvaloniaColor colour) => new(colour.R, colour.G, colour.B, colour.A);
}

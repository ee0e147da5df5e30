using Engraver.Core.Plots;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Plots;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>Every system variable; the names are AutoCAD's where AutoCAD has one. All of them are kept between sessions.</summary>
public static class SystemVariables
{
    private static readonly IReadOnlyList<(SystemVariable Variable, Func<ViewState, double, ViewState>? InView)> s_table =
    [
        InSettings("CURSORSIZE", 5, 1, 100),
        InSettings("PICKBOX", 5, 1, 50),
        InSettings("APERTURE", 10, 1, 50),
        InSettings("ZOOMFACTOR", 60, 3, 100),
        InSettings("ZOOMWHEEL", 0, 0, 1),
        InSettings("FILEDIA", 1, 0, 1),
        InSettings("CMDECHO", 1, 0, 1),
        InSettings("MIRRTEXT", 0, 0, 1),
        InSettings(Luprec, 4, 0, 8),
        InSettings(Auprec, 2, 0, 8),
        InSettings(CncTraceColor, 1, 0, 2),
        InSettings(AutoWalk, 0, 0, 1),
        InSettings(PlotPanels, PlotPanel.DefaultMask, 0, PlotPanel.FullMask),
        InSettings(PlotOver, 0, 0, 1),
        InView("OSMODE", 55, 0, 32767, true, v => v.ObjectSnapModes, (v, x) => v with { ObjectSnapModes = (int)x }),
        InView("ORTHOMODE", 0, 0, 1, true, v => v.Ortho ? 1 : 0, (v, x) => v with { Ortho = x != 0.0, Polar = v.Polar && x == 0.0 }),
        InView("POLARTRACK", 0, 0, 1, true, v => v.Polar ? 1 : 0, (v, x) => v with { Polar = x != 0.0, Ortho = v.Ortho && x == 0.0 }),
        InView("POLARANG", 90, 0.1, 180, false, v => v.PolarAngle, (v, x) => v with { PolarAngle = x }),
        InView("GRIDMODE", 1, 0, 1, true, v => v.Grid ? 1 : 0, (v, x) => v with { Grid = x != 0.0 }),
        InView("GRIDUNIT", 10, 1e-6, 1e6, false, v => v.GridSpacing, (v, x) => v with { GridSpacing = x }),
        InView("SNAPMODE", 0, 0, 1, true, v => v.Snap ? 1 : 0, (v, x) => v with { Snap = x != 0.0 }),
        InView("SNAPUNIT", 10, 1e-6, 1e6, false, v => v.SnapSpacing, (v, x) => v with { SnapSpacing = x }),
        InView("DYNMODE", 1, 0, 1, true, v => v.DynamicInput ? 1 : 0, (v, x) => v with { DynamicInput = x != 0.0 }),
    ];

    /// <summary>What the colour of a run shows, in the order of <see cref="RunMeasure"/>.</summary>
    internal const string CncTraceColor = "CNCTRACECOLOR";

    /// <summary>AUTOSEQUENCE asks at each discontinuity whether it continues from there.</summary>
    internal const string AutoWalk = "AUTOWALK";

    /// <summary>The visible plots: the sum of the numbers of <see cref="PlotPanel.Mask"/>.</summary>
    internal const string PlotPanels = "CNCPLOTS";

    /// <summary>What plots are drawn over, in the order of <see cref="PlotAxis"/>.</summary>
    internal const string PlotOver = "CNCPLOTAXIS";

    /// <summary>Decimals of lengths, as in AutoCAD.</summary>
    private const string Luprec = "LUPREC";

    /// <summary>Decimals of angles; AutoCAD begins with 0, which is too coarse for an engraving.</summary>
    private const string Auprec = "AUPREC";

    /// <summary>How lengths and angles are printed.</summary>
    public static DisplayPrecision Figures(this DesktopSettings settings) => new((int)Variable(settings, Luprec), (int)Variable(settings, Auprec));

    /// <summary>What the colour of a run shows.</summary>
    public static RunMeasure TraceColour(this DesktopSettings settings) => (RunMeasure)(int)Variable(settings, CncTraceColor);

    /// <summary>The plots that the operator has chosen.</summary>
    public static IReadOnlyList<PlotPanel> ChosenPlots(this DesktopSettings settings) => [.. PlotPanel.All.Where(panel => ((int)Variable(settings, PlotPanels) & panel.Mask) != 0)];

    /// <summary>The settings with one plot chosen or not.</summary>
    public static DesktopSettings WithPlot(this DesktopSettings settings, PlotPanel panel, bool isChosen)
    {
        ArgumentNullException.ThrowIfNull(panel);
        var now = (int)Variable(settings, PlotPanels);
        return settings.WithVariable(PlotPanels, isChosen ? now | panel.Mask : now & ~panel.Mask);
    }

    /// <summary>What plots are drawn over.</summary>
    public static PlotAxis PlotAxis(this DesktopSettings settings) => (PlotAxis)(int)Variable(settings, PlotOver);

    /// <summary>The settings with plots over another axis.</summary>
    public static DesktopSettings WithPlotAxis(this DesktopSettings settings, PlotAxis axis) => settings.WithVariable(PlotOver, (int)axis);

    internal static IEnumerable<SystemVariable> All => s_table.Select(row => row.Variable);

    /// <param name="name">One of <see cref="All"/>.</param>
    internal static SystemVariable Find(string name) => All.First(variable => variable.Name == name);

    /// <summary>The value of a system variable: the kept one, else that of the first start.</summary>
    public static double Variable(this DesktopSettings settings, string name) => settings.Variables.TryGetValue(name, out var kept) && Find(name) is var variable && kept >= variable.Min && kept <= variable.Max ? kept : Find(name).First;

    /// <summary>The view as it was left: switches, spacings, theme.</summary>
    public static ViewState Restore(ViewState view, DesktopSettings settings) => s_table
        .Where(row => row.InView is not null)
        .Aggregate(view with { Theme = settings.Theme }, (state, row) => row.InView!(state, Variable(settings, row.Variable.Name)));

    /// <summary>It belongs to the view: a drafting aid.</summary>
    internal static bool IsInView(string name) => s_table.First(row => row.Variable.Name == name).InView is not null;

    private static (SystemVariable Variable, Func<ViewState, double, ViewState>? InView) InSettings(string name, double first, double min, double max) =>
        (new SystemVariable(name, first, min, max, IsInteger: true, context => Variable(context.Settings.Current, name), (context, value) => Save(context, name, value)), null);

    private static (SystemVariable Variable, Func<ViewState, double, ViewState>? InView) InView(
        string name, double first, double least, double most, bool whole, Func<ViewState, double> read, Func<ViewState, double, ViewState> write) =>
        (new SystemVariable(name, first, least, most, whole, context => read(context.View.Current), (context, value) =>
        {
            context.View.Change(view => write(view, value));
            Save(context, name, value);
        }), write);

    private static void Save(CommandContext context, string name, double value) => context.Settings.Change(settings => settings.WithVariable(name, value));
}

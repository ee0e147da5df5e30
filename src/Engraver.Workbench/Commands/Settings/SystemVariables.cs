using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>The system variables there are: AutoCAD's names where AutoCAD has one. All of them are kept between sessions.</summary>
public static class SystemVariables
{
    private static readonly IReadOnlyList<(SystemVariable Variable, Func<ViewState, double, ViewState>? InView)> s_table =
    [
        Kept("CURSORSIZE", "Length of the crosshair, percent of the canvas.", 5, 1, 100),
        Kept("PICKBOX", "Half the side of the pick box, pixels.", 5, 1, 50),
        Kept("APERTURE", "How near the crosshair must come to an object snap, pixels.", 10, 1, 50),
        Kept("ZOOMFACTOR", "How far one step of the wheel zooms, 3 to 100.", 60, 3, 100),
        Kept("ZOOMWHEEL", "1: the wheel turned forward zooms out.", 0, 0, 1),
        Kept("FILEDIA", "1: dialogs ask for files; 0: the command line does.", 1, 0, 1),
        Kept("CMDECHO", "1: what is typed is repeated in the history.", 1, 0, 1),
        Seen("OSMODE", "Object snaps: 1 end, 2 middle, 4 centre, 16 quadrant, 32 intersection, added together.", 55, 0, 32767, true, v => v.ObjectSnapModes, (v, x) => v with { ObjectSnapModes = (int)x }),
        Seen("ORTHOMODE", "1: points go straight across or straight up.", 0, 0, 1, true, v => v.Ortho ? 1 : 0, (v, x) => v with { Ortho = x != 0.0 }),
        Seen("GRIDMODE", "1: the grid is shown.", 1, 0, 1, true, v => v.Grid ? 1 : 0, (v, x) => v with { Grid = x != 0.0 }),
        Seen("GRIDUNIT", "Distance of grid lines, drawing units.", 10, 1e-6, 1e6, false, v => v.GridSpacing, (v, x) => v with { GridSpacing = x }),
        Seen("SNAPMODE", "1: the crosshair jumps to the raster.", 0, 0, 1, true, v => v.Snap ? 1 : 0, (v, x) => v with { Snap = x != 0.0 }),
        Seen("SNAPUNIT", "Distance of the places of the raster, drawing units.", 10, 1e-6, 1e6, false, v => v.SnapSpacing, (v, x) => v with { SnapSpacing = x }),
        Seen("DYNMODE", "1: what is asked and where the crosshair stands is shown beside it.", 1, 0, 1, true, v => v.DynamicInput ? 1 : 0, (v, x) => v with { DynamicInput = x != 0.0 }),
    ];

    internal static IEnumerable<SystemVariable> All => s_table.Select(row => row.Variable);

    /// <param name="name">One of <see cref="All"/>.</param>
    internal static SystemVariable Find(string name) => All.First(variable => variable.Name == name);

    /// <summary>The value of a system variable that is kept: as it was set, else its first one.</summary>
    public static double Variable(this DesktopSettings settings, string name) => settings.Variables.TryGetValue(name, out var kept) && Find(name) is var variable && kept >= variable.Least && kept <= variable.Most ? kept : Find(name).First;

    /// <summary>The view as it was left: switches, spacings, theme.</summary>
    public static ViewState Restore(ViewState view, DesktopSettings settings) => s_table
        .Where(row => row.InView is not null)
        .Aggregate(view with { Theme = settings.Theme }, (state, row) => row.InView!(state, Variable(settings, row.Variable.Name)));

    private static (SystemVariable Variable, Func<ViewState, double, ViewState>? InView) Kept(string name, string summary, double first, double least, double most) =>
        (new SystemVariable(name, summary, first, least, most, Whole: true, context => Variable(context.Settings.Current, name), (context, value) => Keep(context, name, value)), null);

    private static (SystemVariable Variable, Func<ViewState, double, ViewState>? InView) Seen(
        string name, string summary, double first, double least, double most, bool whole, Func<ViewState, double> read, Func<ViewState, double, ViewState> write) =>
        (new SystemVariable(name, summary, first, least, most, whole, context => read(context.View.Current), (context, value) =>
        {
            context.View.Change(view => write(view, value));
            Keep(context, name, value);
        }), write);

    private static void Keep(CommandContext context, string name, double value) => context.Settings.Change(settings => settings.WithVariable(name, value));
}

/// <summary>A value that is typed by its name, as in AutoCAD.</summary>
/// <param name="Summary">One sentence for the help.</param>
/// <param name="First">Its value at the first start.</param>
/// <param name="Whole">Only whole numbers.</param>
internal sealed record SystemVariable(
    string Name, string Summary, double First, double Least, double Most, bool Whole, Func<CommandContext, double> Read, Action<CommandContext, double> Write);

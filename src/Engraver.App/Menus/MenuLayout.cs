using Engraver.Workbench.Commands;

namespace Engraver.App.Menus;

/// <summary>The commands of each menu. Every command of the catalogue has a place: those that are not named here come at the end of the menu of their group.</summary>
public static class MenuLayout
{
    private const string Separator = "";

    private static readonly IReadOnlyList<MenuSection> s_sections =
    [
        new("File", ["NEW", "OPEN", "RECENT", "HISTORY", "CLOSE", Separator, "QSAVE", "SAVEAS", "EXPORT", Separator, "SCRIPT", "REINIT", "OPTIONS", Separator, "Window.Exit"]),
        new("Edit", ["U", "UNDO", "REDO", Separator, "SELECT", "Window.SelectAll", Separator, "ERASE", "MOVE", "COPY", "ROTATE", "SCALE", "MIRROR", "ARRAY", "GRIPEDIT", "STRETCH", "EXPLODE", "REVERSE", Separator, "TRIM", "EXTEND", "BREAK", "FILLET", "CHAMFER", "MATCHPROP", Separator, "HIDEOBJECTS", "UNISOLATEOBJECTS"]),
        new("View", ["ZOOM", "PAN", "REGEN", Separator, "GRID", "SNAP", "ORTHO", "POLAR", "OSNAP", "DYNAMICINPUT", Separator, "SHOW", Separator, "Window.Palettes", "Window.Pages", "Window.Clean", "Window.History"]),
        new("Drawing", ["LINE", "PLINE", "CIRCLE", "ARC", "RECTANG", "POLYGON", "ELLIPSE", Separator, "LAYER", "CLAYER", "PROPERTIES", "CHPROP", "LIST", Separator, "DIST", "ID", "AREA", "LUPREC", "AUPREC", Separator, "CHECK", "DISCONTINUITIES", "OVERKILL", "JOIN", Separator, "ORIGIN", Separator, "CNCUNITS", "CNCCUT", Separator, "OSMODE", "APERTURE", "POLARANG", "POLARTRACK"]),
        new("Toolpath", ["AUTOSEQUENCE", "CNCORDER", "ENTER", "TOOLSTART", "LINK", Separator, "OFFSET", "POCKET", "KERF", Separator, "PLAYBACK", Separator, "CNCMAXERR", "CNCJOINTOL", "CNCDUPLICATES", "CNCRECOVER"]),
        new("Trajectory", ["SACEPATH", "SACEOFFSET", "SACEUNIFORMOFFSET", "SACECONSTANTOFFSETS", "SACEDEEPENGRAVING", "SACEHELICALDRILL", Separator, "SACESHOWTRAJECTORIES", "SACEEDITTRAJECTORY", "SACEUPDATETRAJECTORIES", "SACEDELETELASTTRAJECTORY", "SACEDELETEALLTRAJECTORIES", Separator, "SACESIMULATE", "SACEEXPORTTRAJECTORIES", Separator, "SACESETMAXERROR", "SACETOGGLEDYNAMICDENSITY", "SACESETSTATICSEGMENTLENGTH", "SACECORNERS", "SACESETZPLANE"]),
        new("Machine", ["CNCCONNECT", "CNCDISCONNECT", "CNCPROFILE", "CNCCOMMISSION", "CNCSTATUS", Separator, "CNCMOTORS", "CNCSIM", Separator, "CNCFRAME", "CNCARM", "CNCRUN", "CNCHOME", "CNCJOG", "CNCGOTO", "CNCZERO", "CNCORIGIN", "CNCHOLD", "CNCRESUME", "CNCOVERRIDE", "CNCSTOP", "CNCABORT", "CNCOUTPUT", Separator, "CNCTRACE", "ALARMS", "CNCTERMINAL", Separator, "CNCFINISH", "CNCFEED", "CNCVS", "CNCRAPID", "CNCVA"]),
        new("Plot", ["PLOT", "POST", "AGIEPOST", "VERIFY", "CERTIFY", "SEND", Separator, "REPORT", "TABLE"]),
        new("Settings", ["THEME", "LANGUAGE"]),
        new("Help", ["HELP"]),
    ];

    /// <summary>The right button on the canvas while nothing is selected.</summary>
    public static IReadOnlyList<string> OnCanvas { get; } = ["ZOOM", "PAN", "REGEN", Separator, "SELECT", "Window.SelectAll", Separator, "U", "REDO", Separator, "OPTIONS"];

    /// <summary>The same while objects are selected.</summary>
    public static IReadOnlyList<string> OnSelection { get; } = ["ERASE", "MOVE", "COPY", "ROTATE", "SCALE", "MIRROR", Separator, "HIDEOBJECTS", "UNISOLATEOBJECTS", Separator, "ENTER", "TOOLSTART", Separator, "ZOOM", "PAN", Separator, "LIST", "PROPERTIES"];

    /// <summary>The menus of what is built.</summary>
    public static IReadOnlyList<MenuSection> For(CommandCatalog catalog)
    {
        var named = s_sections.SelectMany(section => section.Entries).ToHashSet(StringComparer.Ordinal);
        var homeless = catalog.All.Where(info => !named.Contains(info.Name)).GroupBy(info => HomeOf(info.Group)).ToDictionary(group => group.Key, group => group.Select(info => info.Name).ToList());
        return [.. s_sections.Select(section => section with { Entries = Tidy([.. section.Entries.Where(entry => IsBuilt(catalog, entry)), Separator, .. homeless.GetValueOrDefault(section.Key, [])]) })];
    }

    private static bool IsBuilt(CommandCatalog catalog, string entry) => entry.Length == 0 || entry.Contains('.', StringComparison.Ordinal) || catalog.Find(entry) is not null;

    private static string HomeOf(CommandGroup group) => group switch
    {
        CommandGroup.File => "File",
        CommandGroup.Ask => "Drawing",
        CommandGroup.Drawing => "Edit",
        CommandGroup.Sequence => "Toolpath",
        CommandGroup.Trajectory => "Trajectory",
        CommandGroup.Output => "Plot",
        CommandGroup.Machine => "Machine",
        CommandGroup.Setting => "Settings",
        CommandGroup.View => "View",
        _ => "View",
    };

    /// <summary>No separator at an end or beside another.</summary>
    private static List<string> Tidy(IReadOnlyList<string> entries)
    {
        var tidy = new List<string>();
        foreach (var entry in entries)
        {
            if (entry.Length > 0 || (tidy.Count > 0 && tidy[^1].Length > 0)) tidy.Add(entry);
        }

        if (tidy.Count > 0 && tidy[^1].Length == 0) tidy.RemoveAt(tidy.Count - 1);
        return tidy;
    }
}

/// <summary>One top-level menu.</summary>
/// <param name="Key">Name of its text (<c>Menu.File</c>).</param>
/// <param name="Entries">Names of commands; empty is a separator; a name with a dot is an act of the window itself (<c>Window.Exit</c>).</param>
public sealed record MenuSection(string Key, IReadOnlyList<string> Entries);

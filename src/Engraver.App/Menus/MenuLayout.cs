using Engraver.Workbench.Commands;

namespace Engraver.App.Menus;

/// <summary>The commands of each menu. Every command of the catalogue is included: those that are not listed here are added to the end of the menu of their
/// group.</summary>
public static class MenuLayout
{
    private const string Separator = "";

    private static readonly IReadOnlyList<MenuSection> s_sections =
    [
        new("File", ["NEW", "OPEN", "RECENT", "HISTORY", "CLOSE", Separator, "QSAVE", "SAVEAS", "EXPORT", Separator, "SCRIPT", "REINIT", "OPTIONS", Separator, "QUIT"]),
        new("Edit", ["U", "UNDO", "REDO", Separator, "SELECT", "Window.SelectAll", Separator, "ERASE", "MOVE", "COPY", "ROTATE", "SCALE", "MIRROR", "ARRAY", "Menu.Reshape", Separator, "HIDEOBJECTS", "UNISOLATEOBJECTS"])
        {
            Submenus = [new("Reshape", ["STRETCH", "GRIPEDIT", Separator, "TRIM", "EXTEND", "BREAK", "FILLET", "CHAMFER", Separator, "EXPLODE", "REVERSE"])],
        },
        new("View", ["ZOOM", "PAN", "REGEN", Separator, "Menu.DraftingAids", "SHOW", Separator, "Window.Palettes", "Window.Pages", "Window.Clean", "Window.History"])
        {
            Submenus = [new("DraftingAids", ["GRID", "SNAP", "ORTHO", "POLAR", "OSNAP", "DYNAMICINPUT", Separator, "OSMODE", "APERTURE", "POLARANG", "POLARTRACK"])],
        },
        new("Drawing", ["LINE", "PLINE", "CIRCLE", "ARC", "RECTANG", "POLYGON", "ELLIPSE", "Menu.Text", Separator, "Menu.ObjectProperties", "Menu.Measure", Separator, "CHECK", "DISCONTINUITIES", "OVERKILL", "JOIN", Separator, "ORIGIN", "CNCPLACE", "Menu.Reading"])
        {
            Submenus =
            [
                new("Text", ["TEXT", "MTEXT", Separator, "DDEDIT", "TXTEXP", Separator, "STYLE", "MIRRTEXT", Separator, "CNCTEXT"]),
                new("ObjectProperties", ["LAYER", "CLAYER", Separator, "PROPERTIES", "CHPROP", "MATCHPROP", "LIST"]),
                new("Measure", ["DIST", "ID", "AREA", Separator, "LUPREC", "AUPREC"]),
                new("Reading", ["CNCUNITS", "CNCCUT"]),
            ],
        },
        new("Toolpath", ["AUTOSEQUENCE", "Menu.Order", "ENTER", "TOOLSTART", "LINK", Separator, "OPERATION", Separator, "OFFSET", "POCKET", "KERF", Separator, "PLAYBACK", Separator, "CNCMAXERR", "CNCCORNER", "CNCFITARCS", "CNCJOINTOL", "CNCDUPLICATES", "CNCRECOVER"])
        {
            Submenus = [new("Order", ["CNCORDER", "CNCORDERCOST", "CNCORDERTIME"])],
        },
        new("Trajectory", ["SACEPATH", "SACEOFFSET", "SACEUNIFORMOFFSET", "SACECONSTANTOFFSETS", "SACEDEEPENGRAVING", "SACEHELICALDRILL", Separator, "SACESHOWTRAJECTORIES", "SACEEDITTRAJECTORY", "SACEUPDATETRAJECTORIES", "SACEDELETELASTTRAJECTORY", "SACEDELETEALLTRAJECTORIES", Separator, "SACESIMULATE", "SACEEXPORTTRAJECTORIES", Separator, "Menu.TrajectorySettings"])
        {
            Submenus = [new("TrajectorySettings", ["SACESETMAXERROR", "SACETOGGLEDYNAMICDENSITY", "SACESETSTATICSEGMENTLENGTH", "SACECORNERS", "SACESETZPLANE"])],
        },
        new("Machine", ["CNCCONNECT", "CNCDISCONNECT", "CNCSTATUS", Separator, "CNCPLATE", "CNCSIM", "CNCFRAME", "CNCARM", "CNCRUN", "CNCHOLD", "CNCRESUME", "CNCCONTINUE", "CNCSTOP", "CNCABORT", Separator, "Menu.ByHand", "Menu.Feeds", "Menu.Watch", "Menu.Setup"])
        {
            Submenus =
            [
                new("ByHand", ["CNCMOTORS", "CNCHOME", Separator, "CNCJOG", "CNCGOTO", Separator, "CNCZERO", "CNCORIGIN", Separator, "CNCOUTPUT"]),
                new("Feeds", ["CNCOVERRIDE", Separator, "CNCFEED", "CNCVS", "CNCRAPID", "CNCVA", Separator, "CNCFINISH"]),
                new("Watch", ["ALARMS", "CNCTRACE", "PLOTCOMPARE", "CNCTERMINAL"]),
                new("Setup", ["CNCPROFILE", "CNCCOMMISSION"]),
            ],
        },
        new("Plot", ["PLOT", "POST", "AGIEPOST", "VERIFY", "CERTIFY", "SEND", Separator, "PLOTEXPORT", "REPORT", "TABLE"]),
        new("Settings", ["THEME", "LANGUAGE"]),
        new("Help", ["HELP"]),
    ];

    /// <summary>The context menu of the canvas without a selection.</summary>
    public static IReadOnlyList<string> OnCanvas { get; } = ["ZOOM", "PAN", "REGEN", Separator, "SELECT", "Window.SelectAll", Separator, "U", "REDO", Separator, "OPTIONS"];

    /// <summary>The same with selected objects.</summary>
    public static IReadOnlyList<string> OnSelection { get; } = ["ERASE", "MOVE", "COPY", "ROTATE", "SCALE", "MIRROR", Separator, "DDEDIT", "TXTEXP", Separator, "HIDEOBJECTS", "UNISOLATEOBJECTS", Separator, "ENTER", "TOOLSTART", Separator, "ZOOM", "PAN", Separator, "LIST", "PROPERTIES"];

    /// <summary>The menus of the existing commands.</summary>
    public static IReadOnlyList<MenuSection> For(CommandCatalog catalog)
    {
        ArgumentNullException.ThrowIfNull(catalog);
        var named = s_sections.SelectMany(section => section.Commands).ToHashSet(StringComparer.Ordinal);
        var homeless = catalog.All.Where(info => !named.Contains(info.Name)).GroupBy(info => MenuOf(info.Group)).ToDictionary(group => group.Key, group => group.Select(info => info.Name).ToList());
        return [.. s_sections.Select(section => Built(catalog, section, homeless.GetValueOrDefault(section.Key, [])))];
    }

    private static MenuSection Built(CommandCatalog catalog, MenuSection section, IReadOnlyList<string> more)
    {
        var submenus = section.Submenus.Select(submenu => Built(catalog, submenu, [])).Where(submenu => submenu.Entries.Count > 0).ToList();
        return section with { Submenus = submenus, Entries = Tidy([.. section.Entries.Where(entry => IsBuilt(catalog, submenus, entry)), Separator, .. more]) };
    }

    private static bool IsBuilt(CommandCatalog catalog, IReadOnlyList<MenuSection> submenus, string entry) =>
        entry.StartsWith(MenuSection.SubmenuPrefix, StringComparison.Ordinal) ? submenus.Any(submenu => submenu.Name == entry) : entry.Length == 0 || entry.Contains('.', StringComparison.Ordinal) || catalog.Find(entry) is not null;

    private static string MenuOf(CommandGroup group) => group switch
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

    /// <summary>Removes separators at the ends and next to each other.</summary>
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

/// <summary>One menu of the menu bar, or a submenu.</summary>
/// <param name="Key">Name of its text (<c>Menu.File</c>).</param>
/// <param name="Entries">Names of commands; empty is a separator; <c>Menu.KEY</c> is a submenu; another name with a dot is an action of the window
/// (<c>Window.Palettes</c>).</param>
public sealed record MenuSection(string Key, IReadOnlyList<string> Entries)
{
    internal const string SubmenuPrefix = "Menu.";

    /// <summary>The submenus that the entries name.</summary>
    public IReadOnlyList<MenuSection> Submenus { get; init; } = [];

    /// <summary>Name of its text, and of its entry in the parent menu.</summary>
    public string Name => SubmenuPrefix + Key;

    /// <summary>The commands in the menu and its submenus.</summary>
    public IEnumerable<string> Commands => Entries.Where(entry => entry.Length > 0 && !entry.Contains('.', StringComparison.Ordinal)).Concat(Submenus.SelectMany(submenu => submenu.Commands));
}
